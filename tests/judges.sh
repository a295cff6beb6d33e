#!/usr/bin/env bash
# Has programs that no one here wrote judge what leaves: Khronos' validator, three.js in headless Chromium, Chromium itself
# with a web page beside our own pictures, compared by the published ꟻLIP, and OpenUSD.
# Needs Node 20 with npm, jq, and Python 3 with venv; without Chromium, three.js and the page are left out. The exports and
# pictures stay in OUT_FOLDER. Blender reads the same exports by hand: tests/judges/heavy.sh.
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
python3 -m venv "$modules/venv"
"$modules/venv/bin/pip" install --quiet --disable-pip-version-check usd-core==26.11
"$modules/venv/bin/python" tests/judges/usd.py "$out" "$later" "${names[@]}"

if ! command -v chromium >/dev/null; then
  echo "there is no Chromium: three.js and the web page are left out"
  exit
fi
node "$modules/three.mjs" "$out" "${counted[@]}"
"$modules/venv/bin/pip" install --quiet --disable-pip-version-check flip-evaluator==1.7 numpy pillow
size=640x360
pages=()
pairs=()
for scene in fair_weather overcast front single_cumulus; do
  file="assets/scenes/$scene.cloudscene"
  "$program" export "$file" -o "$out/$scene.html" 2>/dev/null
  for time in 12:00 20:00; do
    name="$out/$scene-${time%:00}"
    # Aircraft are not in a page, and the CPU draws none.
    "$program" render "$file" -o "$name-ours.png" --camera main --time $time --size $size --renderer cpu 2>/dev/null
    pages+=("$out/$scene.html:camera=main&time=$time&clock=0&still=1:$name-page.png")
    pairs+=("$name-ours.png:$name-page.png")
  done
done
node "$modules/web.mjs" $size "${pages[@]}"
"$modules/venv/bin/python" "$modules/flip.py" 0.05 "${pairs[@]}"
