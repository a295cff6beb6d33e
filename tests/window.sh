#!/usr/bin/env bash
# Opens the editor in a real window on a screen without a screen: looks at it, places a box with the pointer, saves with
# the keyboard, and finds the box in the saved file. The screenshots stay in OUT_FOLDER.
# usage: tests/window.sh PROGRAM OUT_FOLDER
set -euo pipefail
program=$1
out=$2
mkdir -p "$out"

# A display that nobody has.
number=77
while [ -e "/tmp/.X11-unix/X$number" ]; do number=$((number + 1)); done
export DISPLAY=":$number"
Xvfb "$DISPLAY" -screen 0 2560x1440x24 -nolisten tcp >/dev/null 2>&1 &
screen=$!
trap 'kill "$screen" 2>/dev/null || true' EXIT
for _ in $(seq 50); do xdpyinfo >/dev/null 2>&1 && break; sleep 0.2; done

# What the editor remembers between starts is not this user's.
home=$(mktemp -d)
export XDG_CONFIG_HOME="$home/config" XDG_STATE_HOME="$home/state" XDG_DATA_HOME="$home/data" XDG_CACHE_HOME="$home/cache"

editor=""
cleanup() { kill $editor "$screen" 2>/dev/null || true; rm -rf "$home"; }
trap cleanup EXIT

# open SCENE WIDTH HEIGHT: the editor's window, with a picture in it.
open() {
  "$program" "$1" >"$out/window.log" 2>&1 &
  editor=$!
  window=$(timeout 60 xdotool search --sync --onlyvisible --pid "$editor" | head -1)
  xdotool windowsize "$window" "$2" "$3"
  xdotool windowfocus "$window"
  sleep 1
}

# look FILE: a screenshot, once the screen's middle holds more than one colour.
look() {
  colors=0
  for _ in $(seq 60); do
    sleep 0.5
    import -window "$window" "$out/$1" 2>/dev/null || continue
    colors=$(convert "$out/$1" -gravity center -crop 400x300+0+0 +repage -format %k info:)
    [ "$colors" -gt 500 ] && break
  done
  kill -0 "$editor" || { echo "the editor ended by itself:"; cat "$out/window.log"; exit 1; }
  [ "$colors" -gt 500 ] || { echo "the viewport shows only $colors colours: see $out/$1"; exit 1; }
  echo "window shows $colors colours: $out/$1"
}

close() {
  kill "$editor"
  wait "$editor" 2>/dev/null || true
  editor=""
}

boxes() { "$program" info --json "$1" | grep -o '"boxes": *[0-9]*' | head -1; }

at() { xdotool mousemove --window "$window" "$1" "$2"; sleep 0.3; }

# The great cloud, chosen.
open assets/scenes/fair_weather.cloudscene 2560 1440
look window_2560x1440.png
at 1290 700; xdotool click 1; sleep 2
look window_2560x1440.png
close
open assets/scenes/fair_weather.cloudscene 1280 800
look window.png
at 620 400; xdotool click 1; sleep 2
look window.png
close

scene="$out/placed.cloudscene"
cp assets/scenes/single_cumulus.cloudscene "$scene"
before=$(boxes "$scene")
open "$scene" 1280 800
look placing_before.png
# Through the fourth camera, which looks down on the cloud.
for _ in 1 2 3 4; do xdotool key --window "$window" c; sleep 0.3; done
xdotool key --window "$window" b
sleep 1
# A footprint before the cloud, then its height.
at 420 600; xdotool mousedown 1; sleep 0.3
at 500 610; at 700 620; xdotool mouseup 1; sleep 0.3
at 700 580; at 700 540; sleep 0.5
import -window "$window" "$out/placing.png"
xdotool click 1
sleep 1.5
import -window "$window" "$out/placing_after.png"
xdotool key --window "$window" ctrl+s
for _ in $(seq 40); do sleep 0.25; [ "$(boxes "$scene")" != "$before" ] && break; done
after=$(boxes "$scene")
[ "$after" != "$before" ] || { echo "no box in the saved file ($before): see $out/placing_after.png"; exit 1; }
"$program" check "$scene" || { echo "the saved scene has problems"; exit 1; }
echo "a box was placed and saved: $before became $after"

# What is unsaved survives the end of the program: a second after the change, and told to end.
open "$scene" 1280 800
look keeping.png
xdotool key --window "$window" ctrl+a ctrl+d
sleep 1
close
kept=$(cat "$XDG_STATE_HOME"/cloudwright/recovery/*.rescue | grep -o '\\"model\\":' | wc -l)
saved=$(grep -o '"model":' "$scene" | wc -l)
[ "$kept" -gt "$saved" ] || { echo "a cloud more than the $saved saved was not kept, but $kept"; exit 1; }
echo "unsaved work was kept: $kept clouds, $saved saved"
