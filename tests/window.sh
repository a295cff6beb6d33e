#!/usr/bin/env bash
# Opens the editor in a real window on a screen without a screen: looks at it, places a box with the pointer, saves with
# the keyboard, and finds the box in the saved file. The screenshots stay in OUT_FOLDER.
# usage: tests/window.sh PROGRAM OUT_FOLDER
set -euo pipefail
program=$1
out=$2
mkdir -p "$out"

. "$(dirname "$0")/screen.sh"
begin_screen 2560 1440

boxes() { "$program" info --json "$1" | grep -o '"boxes": *[0-9]*' | head -1; }

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
