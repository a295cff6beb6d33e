#!/usr/bin/env bash
# Has Open Job Description's own program check the job template, and draw a flight in two tasks, each a session of its
# own: their frames are, byte for byte, those of a whole run. Needs Python 3.9 with venv. The frames stay in OUT_FOLDER.
# usage: tests/judges/queue.sh PROGRAM OUT_FOLDER
set -euo pipefail
program=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
cd "$(dirname "$0")/../.."
template=assets/queue/fly.openjd.yaml
scene=$PWD/assets/scenes/fair_weather.cloudscene

tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
python3 -m venv "$tools"
"$tools/bin/pip" install --quiet openjd-cli
"$tools/bin/openjd" check "$template"

rm -rf "$out/tasks" "$out/whole"
mkdir "$out/tasks"
for chunk in 0-4 5-9; do
  "$tools/bin/openjd" run "$template" --step Fly --tasks "[{\"Frames\": \"$chunk\"}]" \
    -p Scene="$scene" -p Name=through -p Frames=0-9 -p ChunkSize=5 -p Size=320x180 -p Format=exr \
    -p Output="$out/tasks" -p Program="$program"
done
"$program" fly "$scene" --path through --frames 0..10 --size 320x180 --format exr --renderer cpu -o "$out/whole"
diff -r "$out/tasks" "$out/whole"
echo "10 frames of two tasks are those of a whole run"
