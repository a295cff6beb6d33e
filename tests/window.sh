#!/usr/bin/env bash
# Opens the editor in a real window on a screen without a screen, looks at it, and closes it.
# usage: tests/window.sh PROGRAM OUT_FOLDER
set -euo pipefail
program=$1
out=$2
mkdir -p "$out"

# A display that nobody has.
number=77
while [ -e "/tmp/.X11-unix/X$number" ]; do number=$((number + 1)); done
export DISPLAY=":$number"
Xvfb "$DISPLAY" -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1 &
screen=$!
trap 'kill "$screen" 2>/dev/null || true' EXIT
for _ in $(seq 50); do xdpyinfo >/dev/null 2>&1 && break; sleep 0.2; done

"$program" assets/scenes/fair_weather.cloudscene >"$out/window.log" 2>&1 &
editor=$!
trap 'kill "$editor" "$screen" 2>/dev/null || true' EXIT
window=$(timeout 60 xdotool search --sync --onlyvisible --pid "$editor" | head -1)
# The first picture is there when the screen's middle holds more than one colour.
colors=0
for _ in $(seq 60); do
  sleep 0.5
  import -window "$window" "$out/window.png" 2>/dev/null || continue
  colors=$(convert "$out/window.png" -gravity center -crop 400x300+0+0 +repage -format %k info:)
  [ "$colors" -gt 500 ] && break
done
kill -0 "$editor" || { echo "the editor ended by itself:"; cat "$out/window.log"; exit 1; }
[ "$colors" -gt 500 ] || { echo "the viewport shows only $colors colours: see $out/window.png"; exit 1; }
echo "window shows $colors colours: $out/window.png"
