#!/usr/bin/env bash
# Has programs that no one here wrote judge what leaves: Khronos' validator, and three.js in headless Chromium.
# Needs Node 20 with npm, and jq; without Chromium, three.js is left out. The exports and pictures stay in OUT_FOLDER.
# usage: tests/judges.sh PROGRAM OUT_FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
program=$1
out=$2
mkdir -p "$out"

modules=$(mktemp -d)
trap 'rm -rf "$modules"' EXIT
cp tests/judges/* "$modules"
(cd "$modules" && npm install --silent --no-audit --no-fund)

exports=()
counted=()
for scene in assets/scenes/*.cloudscene; do
  name=$(basename "$scene" .cloudscene)
  info=$("$program" info --json "$scene")
  counts=$(jq -r '"\(.total.sprites):\((.cameras | length) + (.paths | length))"' <<<"$info")
  for plain in no yes; do
    file="$out/$name-plain-$plain.glb"
    "$program" export "$scene" -o "$file" --set plain=$plain 2>/dev/null
    exports+=("$file")
    counted+=("$file:$counts")
  done
done
node "$modules/gltf.mjs" "${exports[@]}"
if command -v chromium >/dev/null; then
  node "$modules/three.mjs" "$out" "${counted[@]}"
else
  echo "there is no Chromium: three.js is left out"
fi
