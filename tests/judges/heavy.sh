#!/usr/bin/env bash
# Has large programs judge what leaves: Blender reads each export that tests/judges.sh has left in OUT_FOLDER, OpenVDB and
# Blender a volume, Mitsuba draws one cloud, and Open Job Description's program draws a flight in tasks. By hand: Python
# 3.11 with venv, 600 MB to fetch, some ten minutes on two cores. Volume and pictures stay in OUT_FOLDER.
# usage: tests/judges.sh PROGRAM OUT_FOLDER && tests/judges/heavy.sh PROGRAM OUT_FOLDER
set -euo pipefail
program=$(realpath "$1")
out=$(realpath "$2")
cd "$(dirname "$0")/../.."

tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
python3 -m venv "$tools/blender"
"$tools/blender/bin/pip" install --quiet "bpy==5.0.1" "numpy<2"
python3 -m venv "$tools/mitsuba"
"$tools/mitsuba/bin/pip" install --quiet mitsuba numpy pillow

names=()
for scene in assets/scenes/*.cloudscene; do names+=("$(basename "$scene" .cloudscene)"); done
"$tools/blender/bin/python" tests/judges/blender.py "$out" "${names[@]}" | grep -v " INFO: "
cloud=assets/scenes/single_cumulus.cloudscene
for ending in vol vdb; do "$program" export "$cloud" -o "$out/clouds.$ending" 2>/dev/null; done
"$program" export "$cloud" -o "$out/clouds.usda" --set volumes=yes 2>/dev/null
"$tools/blender/bin/python" tests/judges/openvdb.py "$out/clouds.vdb"
"$tools/mitsuba/bin/python" tests/judges/path_tracer.py "$program" "$cloud" "$out/traced" --spp 16 --width 160
tests/judges/queue.sh "$program" "$out/queue"
