#!/usr/bin/env bash
# Has programs that no one here wrote judge what leaves: Khronos' validator, three.js in headless Chromium, and OpenUSD.
# Needs Node 20 with npm, jq, and Python 3 with venv; without Chromium, three.js is left out. The exports and pictures stay in
# OUT_FOLDER. Blender reads the same exports by hand: tests/judges/blender.py says how.
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

# Second at which clouds are looked at once more.
later=20
exports=()
counted=()
names=()
for scene in assets/scenes/*.cloudscene; do
  name=$(basename "$scene" .cloudscene)
  info=$("$program" info --json "$scene")
  echo "$info" >"$out/$name.info.json"
  names+=("$name")
  counts=$(jq -r '"\(.total.sprites):\((.cameras | length) + (.paths | length))"' <<<"$info")
  for plain in no yes; do
    file="$out/$name-plain-$plain.glb"
    "$program" export "$scene" -o "$file" --set plain=$plain 2>/dev/null
    exports+=("$file")
    counted+=("$file:$counts")
  done
  for file in "$name.usda" "$name.usdz" "$name.sprites.json"; do
    "$program" export "$scene" -o "$out/$file" 2>/dev/null
  done
  "$program" export "$scene" -o "$out/$name-volumes.usda" --set volumes=yes 2>/dev/null
  "$program" export "$scene" -o "$out/$name.sprites-$later.json" --at "$later" 2>/dev/null
done
node "$modules/gltf.mjs" "${exports[@]}"
if command -v chromium >/dev/null; then
  node "$modules/three.mjs" "$out" "${counted[@]}"
else
  echo "there is no Chromium: three.js is left out"
fi

python3 -m venv "$modules/venv"
"$modules/venv/bin/pip" install --quiet --disable-pip-version-check usd-core==26.11
"$modules/venv/bin/python" tests/judges/usd.py "$out" "$later" "${names[@]}"
