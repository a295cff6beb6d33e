#!/usr/bin/env bash
# A new user sits down at the editor's real window, on a screen without a screen: by clicks, keys and typed fields alone
# they follow README's walk, build a thunder cloud box by box, put a scene together out of two others and film a flight.
# Each part is judged by what comes out of it: files, pictures, a film. The numbered screenshots stay in OUT_FOLDER.
#
# What a person would need is added up: a click, a drag or a key 1.5 s, a field that is typed in 3 s.
# Needs Xvfb, xdotool, ImageMagick, jq and ffmpeg.
# usage: tests/sitting.sh PROGRAM OUT_FOLDER [PART…]     parts: readme cumulonimbus of_two film; all, if none is named
set -euo pipefail
program=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
shift 2
cd "$(dirname "$0")/.."

. tests/screen.sh
begin_screen 1600 1000

fail() { echo "$part: $*"; exit 1; }

# --- hands ---------------------------------------------------------------------------------------------------------

# Tenths of a second that a person would have needed by now.
pace=0
took() { pace=$((pace + $1)); }

# key KEYS…: together, as in ctrl+s.
key() { took 15; xdotool key --delay 40 "$@"; sleep 0.3; }

click() { took 15; at "$1" "$2"; xdotool click "${3:-1}"; sleep 0.4; }

# also X Y: a click that adds what is there to what is chosen.
also() { took 15; at "$1" "$2"; xdotool keydown "${3:-shift}" click 1 keyup "${3:-shift}"; sleep 0.4; }

# drag FROM_X FROM_Y TO_X TO_Y [BUTTON]
drag() {
  took 15
  at "$1" "$2"
  xdotool mousedown "${5:-1}"; sleep 0.2
  for step in 1 2 3 4; do
    xdotool mousemove --window "$window" $(($1 + ($3 - $1) * step / 4)) $(($2 + ($4 - $2) * step / 4)); sleep 0.12
  done
  xdotool mouseup "${5:-1}"; sleep 0.3
}

# wheel X Y TIMES: down, or up if TIMES is negative; one gesture of the finger.
wheel() {
  took 15
  at "$1" "$2"
  xdotool click --repeat "${3#-}" --delay 80 "$([ "$3" -lt 0 ] && echo 4 || echo 5)"; sleep 0.5
}

words() { xdotool type --delay 15 -- "$1"; sleep 0.2; }

# field X Y VALUE: a number that is clicked and typed.
field() { took 30; at "$1" "$2"; xdotool click 1; sleep 0.5; words "$3"; sleep 0.3; xdotool key Return; sleep 0.5; }

# palette NAME: a command by its name.
palette() { took 30; xdotool key ctrl+shift+p; sleep 0.5; words "$1"; xdotool key Return; sleep 0.5; }

# path FILE: into the window that asks for a path.
path() { took 30; sleep 0.6; xdotool key ctrl+a; words "$1"; xdotool key Return; sleep 0.8; }

# settle: until the window shows twice the same, or for a while.
settle() {
  local before="" now=""
  for _ in $(seq 25); do
    now=$(import -window "$window" rgb:- 2>/dev/null | cksum)
    [ "$now" = "$before" ] && return
    before=$now
    sleep 0.4
  done
}

# shot NAME: a numbered screenshot of a window that stands still.
shots=0
shot() {
  shots=$((shots + 1))
  settle
  import -window "$window" "$out/$(printf '%s_%02d_%s.png' "$part" "$shots" "$1")"
  kill -0 "$editor" 2>/dev/null || { cat "$out/window.log"; fail "the editor ended by itself"; }
}

# begin [SCENE]: the editor in a window of 1600 × 1000, with a picture in it.
begin() {
  open "$1" 1600 1000
  look "$part.png" >/dev/null
  settle
}

# save: by hand, and until the file has changed.
save() {
  local file=$1 before
  before=$(cksum <"$file" 2>/dev/null || true)
  key ctrl+s
  for _ in $(seq 40); do
    [ "$(cksum <"$file" 2>/dev/null || true)" != "$before" ] && return
    sleep 0.25
  done
}

# --- eyes ----------------------------------------------------------------------------------------------------------

# counted FILE PATH: what `info` says.
counted() { "$program" info --json "$1" | jq -r "$2"; }

# has FILE FILTER WORDS: the scene's file is so.
has() { jq -e "$2" "$1" >/dev/null || fail "$3 (in $1: not $2)"; }

# --- README's walk -------------------------------------------------------------------------------------------------

readme() {
  local scene="$out/sky.cloudscene"
  rm -f "$scene" "$out/sky.png"
  # 1: a scene with one small cumulus, opened.
  "$program" new "$scene"
  has "$scene" '.scene.clouds | length == 1' "step 1: one small cumulus"
  begin "$scene"
  shot opened
  # 2: an empty sky.
  key a; settle; click $middle_x $middle_y; key Delete
  shot empty
  save "$scene"
  has "$scene" '.scene.clouds | length == 0' "step 2: an empty sky"
  # 3: a wide flat box, and two rounder ones upon it.
  key b
  drag 520 600 920 600; at 920 590; at 920 630; click 920 630
  shot flat
  drag 560 560 760 560; at 760 500; click 760 480
  shot second
  drag 700 560 880 560; at 880 500; click 880 490
  shot heap
  save "$scene"
  has "$scene" '.scene.models[-1].boxes | length == 3' "step 3: three boxes"
  # 4: the flat one's sprites, and the dice.
  click 90 379
  field 1324 224 40
  field 1324 251 250; field 1411 251 350
  field 1324 278 120; field 1411 278 180
  field 1324 305 -5; field 1411 305 5
  click 1385 332; shot categories; click 1403 563
  shot sprites
  save "$scene"
  has "$scene" '.scene.models[-1].boxes[0] | [.sprite_count, .width, .height, .rotation_deg, .category] ==
    [40, [250, 350], [120, 180], [-5, 5], "flat_base"]' "step 4: the flat box's sprites"
  local before
  before=$(jq -c .scene "$scene")
  key k
  save "$scene"
  [ "$(jq -c .scene "$scene")" != "$before" ] || fail "step 4: K rolled nothing"
  # 5: moved, turned and stretched by hand, a face pulled; then by Blender's keys.
  click 90 406
  local second='.scene.models[-1].boxes[1]'
  has "$scene" "$second.center[1] < 200 and $second.orientation == null" "step 5: the second box as it was drawn"
  key w; shot move
  drag 660 531 660 471
  key e; shot turn
  drag 707 512 767 512
  key r; shot stretch
  drag 660 583 660 613
  shot stretched
  save "$scene"
  has "$scene" "$second.center[1] > 230" "step 5: W moves it up"
  has "$scene" "$second.orientation[1] | . != null and . != 0" "step 5: E turns it"
  has "$scene" "$second.size[1] > 380" "step 5: a face is pulled"
  key shift+s; shot snaps; key shift+s
  local high
  high=$(jq "$second.center[1]" "$scene")
  palette "Blender's keys"
  at $middle_x $middle_y
  key g; key y; words 100; xdotool key Return; sleep 0.5
  key g; at 900 300; shot grabbed; key Escape
  palette "Blender's keys"
  save "$scene"
  has "$scene" "$second.center[1] - $high | fabs - 100 | fabs < 0.01" "step 5: G Y 100 moves it by that, Esc by nothing"
  # 6: a level dragged, then a mood.
  drag 1228 716 1228 680
  shot level
  save "$scene"
  has "$scene" '.scene.models[-1].color_levels[2].height > 0.4' "step 6: the third level is higher"
  click 1217 562; shot moods; click 1231 183
  save "$scene"
  has "$scene" '.scene.models[-1].color_levels[0].color[0] == 0.1' "step 6: the mood “Storm”"
  # 7: the curve pulled; a group of two boxes, then groups by themselves.
  click 1290 531
  drag 1395 875 1395 851
  shot curve
  save "$scene"
  has "$scene" "$second.light.c_med > 0.45" "step 7: brighter across"
  also 90 433; key ctrl+g
  shot group
  save "$scene"
  has "$scene" '.scene.models[-1] | .groups | length == 1' "step 7: a group of two boxes"
  has "$scene" '.scene.models[-1] | [.boxes[1, 2].group] == [.groups[0, 0].id]' "step 7: both in it"
  click 1443 562
  key g; shot tints; key g
  save "$scene"
  has "$scene" '.scene.models[-1].groups | length >= 3' "step 7: groups by themselves"
  # 8: the hour dragged; then the day passes, until an hour is kept.
  click 1340 531
  drag 1363 562 1430 562
  shot hour
  save "$scene"
  has "$scene" '.scene.time_of_day_h > 13' "step 8: later in the day"
  local hour
  hour=$(jq .scene.time_of_day_h "$scene")
  key p; sleep 2; key p
  shot preview
  palette "Keep this hour"
  save "$scene"
  has "$scene" ".scene.time_of_day_h - $hour | fabs > 0.1" "step 8: another hour was kept"
  # 9: saved; a click in the history goes back, and on again.
  shot history
  click 90 921
  save "$scene"
  has "$scene" ".scene.time_of_day_h == $hour" "step 9: the history went a step back"
  key ctrl+shift+z
  save "$scene"
  has "$scene" ".scene.time_of_day_h != $hour" "step 9: and on again"
  shot done
  close
  # 10: drawn without a window.
  "$program" check "$scene" || fail "$scene has problems"
  "$program" render "$scene" -o "$out/sky.png"
  local drawn
  drawn=$(convert "$out/sky.png" -format '%wx%h %k' info:)
  [ "${drawn% *}" = 1280x720 ] && [ "${drawn#* }" -gt 2000 ] || fail "step 10: the picture is $drawn"
  echo "$part: all ten steps come out as README says"
}

# --- a thunder cloud, box by box -----------------------------------------------------------------------------------

# The view from the top: so many centimetres a pixel, and where the cloud's middle is.
scale_cm=1
middle_x=720
middle_y=529

# box WEST EAST NORTH SOUTH HEIGHT: drawn in the view from the top, in metres from its middle.
box() {
  local x0=$((middle_x + $1 * 100 / scale_cm)) x1=$((middle_x + $2 * 100 / scale_cm))
  local y0=$((middle_y + $3 * 100 / scale_cm)) y1=$((middle_y + $4 * 100 / scale_cm))
  local wide=$(($2 - $1)) deep=$(($4 - $3))
  local begins=$(((wide < deep ? wide : deep) * 4 / 10))
  local up=$((($5 - begins) * 100 / scale_cm))
  drag "$x0" "$y0" "$x1" "$y1"
  at "$x1" $((y1 - up / 2)); at "$x1" $((y1 - up))
  click "$x1" $((y1 - up))
}

# base ALTITUDE: what the next boxes stand on.
base() { field 355 115 "$1"; }

# rows FROM TO: of the model's boxes in the outline, counted from 1.
rows() { click 90 $((217 + 27 * $1)); [ "$1" = "$2" ] || also 90 $((217 + 27 * $2)); }

# light TOWARDS ACROSS PULL: of what is selected, below the list in the groups' panel, which was pulled up.
light() { field 1341 638 "$1"; field 1341 665 "$2"; field 1341 883 "$3"; }

cumulonimbus() {
  local scene="$out/cumulonimbus.cloudscene"
  rm -f "$scene"
  begin ""
  xdotool key Escape; sleep 1
  pace=0
  key ctrl+n; click 555 433; key ctrl+a; key Delete; palette "Remove unused"
  # From the top, far enough away, and the box tool.
  key 7; key 5
  wheel $middle_x $middle_y 6
  key b
  shot empty
  scale_cm=2348
  # The base, rain beneath it, a ring of heaps around it.
  box -3000 3000 -1700 2500 300
  base 540
  box -1800 2200 -1000 1200 400
  base 1380
  box -3500 -1900 -700 900 1500
  box -2300 -300 0 1700 1900
  box -600 1700 100 1900 1800
  box 1300 3300 -700 1100 1500
  box -1200 1400 -1700 0 2200
  # A tower that leans on itself.
  base 2700
  box -2000 100 -800 1000 2200
  box 0 2200 -900 1100 2200
  box -900 900 200 1500 1700
  base 4500
  box -1500 500 -900 900 2200
  box 100 1900 -800 1000 2200
  base 6000
  box -1200 600 -900 800 1900
  box 100 1900 -900 900 1700
  # The anvil.
  base 7500
  box -3400 1000 -1500 1500 500
  box -500 5000 -2000 2000 500
  box 4000 8800 -1600 1600 250
  shot boxes
  key q
  # Heaps, anvil, rain and base: each like its kind.
  rows 3 14
  field 1324 217 1.8
  rows 15 17
  field 1324 190 0.7
  field 1324 217 2.6
  field 1324 298 700; field 1411 298 1100
  field 1324 325 -5; field 1411 325 5
  click 1385 352; click 1207 583
  rows 1 1
  field 1324 170 1.5
  field 1324 197 1.3
  field 1324 305 -5; field 1411 305 5
  click 1385 332; click 1403 563
  rows 2 2
  click 1385 332; click 1207 641
  click 90 217
  click 1348 162; shot categories; click 1230 370
  field 1325 216 0.222
  shot filled
  # How they take the sun: the higher, the brighter.
  click 1290 531
  drag 1380 517 1380 300
  rows 3 7
  light 0.62 0.14 0.3
  rows 8 10
  light 0.9 0.22 0.3
  rows 11 14
  light 1.05 0.28 0.3
  rows 15 17
  light 0.85 0.25 1
  rows 1 2
  light 0.2 0.05 0
  shot light
  # A mood, and the hour.
  click 1210 314; click 1217 345; shot moods; click 1230 455
  click 1340 314; field 1558 345 18:48
  key ctrl+s; path "$scene"
  shot saved
  echo "$part: a person would need $((pace / 10)) s for it"
  [ "$pace" -le 3000 ] || fail "that is more than five minutes"
  close
  has "$scene" '.scene.models | length == 1' "one model, built by hand"
  has "$scene" '.scene.models[0].boxes | length == 17' "all boxes that were drawn"
  has "$scene" '.scene.models[0] | [.category, .boxes[0].category] == ["cumulonimbus", "flat_base"]' "categories"
  has "$scene" '.scene.models[0].boxes[14:] | all(.height == [700, 1100] and .rotation_deg == [-5, 5])' "a flat anvil"
  has "$scene" '[.scene.models[0].boxes[].light.c_max] | unique | length > 3' "light by groups"
  has "$scene" '.scene.models[0].color_levels[0].color[0] == 0.1' "the mood “Storm”"
  has "$scene" '.scene.time_of_day_h == 18.8' "the hour"
  "$program" check "$scene" || fail "$scene has problems"
  against_preset "$scene"
}

# seen SCENE FILE: the scene's clouds (of the preset itself if it is that) before the preset's camera, in its air.
preset=assets/presets/cumulonimbus.cloudscene
seen() {
  jq --slurpfile other "$1" '.scene.models = $other[0].scene.models | .scene.clouds = $other[0].scene.clouds
    | .scene.next_id = 1000000 | .scene.cameras[0].id = 999999
    | .scene.clouds |= map(.position = [0, 1000, 0])' "$preset" >"$2.cloudscene"
  "$program" render "$2.cloudscene" -o "$2.png" --size 960x540 --renderer cpu
}

# shape PICTURE EMPTY: of what is in the picture and not in the empty one: rows of cloud; the widest in the upper third, the
# narrowest in the middle and the widest in the lower third, in thousandths of the picture's width; how many rows of the
# upper half are wider than two thirds of the anvil, in thousandths of the cloud's height.
shape() {
  convert "$1" "$2" -compose difference -composite -colorspace gray -threshold 5% -scale 1x540\! -depth 8 gray:- |
    od -An -v -tu1 -w1 | awk '
      { row[NR] = $1 / 255 * 1000; if (row[NR] > 20) { if (!top) top = NR; foot = NR } }
      END {
        high = foot - top + 1; waist = 1000
        for (i = top; i <= foot; i++) {
          at = (i - top) / high
          if (at < 0.33 && row[i] > anvil) anvil = row[i]
          if (at >= 0.33 && at < 0.67 && row[i] < waist) waist = row[i]
          if (at >= 0.67 && row[i] > skirt) skirt = row[i]
        }
        for (i = top; i < top + high / 2; i++) thick += row[i] > anvil * 0.67
        printf "%d %d %d %d %d\n", high, anvil, waist, skirt, thick / high * 1000
      }'
}

# light_in PICTURE EMPTY FROM TO: the mean brightness of cloud between those rows, in thousandths.
light_in() {
  local rows="960x$(($4 - $3))+0+$3"
  paste <(convert "$1" "$2" -compose difference -composite -colorspace gray -threshold 5% \
      -crop "$rows" -depth 8 gray:- | od -An -v -tu1 -w1) \
    <(convert "$1" -colorspace gray -crop "$rows" -depth 8 gray:- | od -An -v -tu1 -w1) |
    awk '$1 { sum += $2; count++ } END { printf "%d\n", count ? sum / count / 255 * 1000 : 0 }'
}

# detail PICTURE: how much goes on from pixel to pixel in the tower, in thousandths.
detail() {
  convert "$1" -colorspace gray -crop 160x160+340+160 +repage -morphology Convolve Laplacian:0 -evaluate abs 0 \
    -format '%[fx:standard_deviation*1000]' info: | cut -d. -f1
}

# against_preset SCENE: it is as good as the shipped one.
against_preset() {
  local by_hand="$out/seen_by_hand" shipped="$out/seen_preset" empty="$out/seen_empty"
  seen "$1" "$by_hand"
  seen "$preset" "$shipped"
  jq '.scene.clouds = [] | .scene.models = []' "$preset" >"$empty.cloudscene"
  "$program" render "$empty.cloudscene" -o "$empty.png" --size 960x540 --renderer cpu
  convert "$shipped.png" "$by_hand.png" +append "$out/cumulonimbus_preset_and_by_hand.png"
  read -r high anvil waist skirt thick < <(shape "$by_hand.png" "$empty.png")
  read -r its_high its_anvil _ < <(shape "$shipped.png" "$empty.png")
  local below above fine its_fine
  below=$(light_in "$by_hand.png" "$empty.png" 380 440)
  above=$(light_in "$by_hand.png" "$empty.png" 120 250)
  fine=$(detail "$by_hand.png"); its_fine=$(detail "$shipped.png")
  echo "$part: $high rows high (the preset $its_high), anvil $anvil ($its_anvil), waist $waist, foot $skirt, thick $thick;" \
    "light $below below, $above above; detail $fine ($its_fine)"
  [ $((high * 100)) -gt $((its_high * 85)) ] || fail "it does not tower"
  [ $((anvil * 100)) -gt $((its_anvil * 75)) ] && [ "$anvil" -gt $((waist * 2)) ] || fail "it has no anvil"
  [ "$thick" -lt 300 ] || fail "its anvil is not thin"
  [ $((skirt * 2)) -gt $((waist * 3)) ] || fail "it has no foot"
  [ $((below * 100)) -lt $((above * 85)) ] || fail "its base is not dark"
  [ $((fine * 100)) -gt $((its_fine * 75)) ] || fail "its outline and heads are too soft"
  echo "$part: as good as the preset by these; look at $out/cumulonimbus_preset_and_by_hand.png"
}

# --- a scene of two others -----------------------------------------------------------------------------------------

of_two() {
  local one=assets/scenes/forming.cloudscene other=assets/scenes/single_cumulus.cloudscene
  local scene="$out/of_two.cloudscene"
  rm -f "$scene"
  begin "$one"
  # All clouds of the one, into a new scene that has none.
  key ctrl+a; key ctrl+c
  shot copied
  key ctrl+n; key Return; settle
  key ctrl+v
  shot pasted
  # And what the other has.
  palette "Append"; path "$PWD/$other"
  shot chosen
  click 640 561
  shot appended
  key a
  key ctrl+s; path "$scene"
  shot saved
  [ -s "$scene" ] || fail "nothing was saved as $scene"
  local have want
  have=$(counted "$scene" '[.clouds[] | {name, sprites}] | sort_by(.name) | tostring')
  want=$({ counted "$one" .; counted "$other" .; } | jq -rs '[.[].clouds[] | {name, sprites}] | sort_by(.name) | tostring')
  [ "$have" = "$want" ] || fail "its clouds are $have, but those of both $want"
  "$program" check "$scene" || fail "$scene has problems"
  "$program" render "$scene" -o "$out/of_two.png" --size 960x540 --renderer cpu
  local colors
  colors=$(convert "$out/of_two.png" -format %k info:)
  [ "$colors" -gt 5000 ] || fail "its picture has only $colors colours"
  echo "$part: $(counted "$scene" .total.clouds) clouds of two scenes, $(counted "$scene" .total.sprites) sprites, as there"
}

# --- a film --------------------------------------------------------------------------------------------------------

film() {
  local scene="$out/film.cloudscene" video="$out/film.mp4"
  rm -rf "$video" "$out/film_frames"
  cp assets/scenes/fair_weather.cloudscene "$scene"
  begin "$scene"
  key ctrl+F12
  field 769 392 320; field 769 419 180; field 769 446 10
  shot asked
  click 644 670
  shot where
  path "$video"
  sleep 1
  import -window "$window" "$out/film_underway.png"
  for _ in $(seq 240); do [ -s "$video" ] && break; sleep 0.5; done
  shot finished
  [ -s "$video" ] || fail "no $video"
  local seen want
  seen=$(ffprobe -v error -count_frames -select_streams v:0 \
    -show_entries stream=width,height,avg_frame_rate,nb_read_frames -of csv=p=0 "$video")
  want="320,180,10/1,$(counted "$scene" '.paths[0].duration_s * 10 + 1.000001 | floor')"
  [ "$seen" = "$want" ] || fail "ffprobe sees $seen, asked for was $want"
  # It moves: the first and the last frame are not alike.
  ffmpeg -v error -y -i "$video" -vf "select=eq(n\\,0)" -frames:v 1 "$out/film_first.png"
  ffmpeg -v error -y -sseof -0.15 -i "$video" -frames:v 1 "$out/film_last.png"
  local apart
  apart=$(compare -metric RMSE "$out/film_first.png" "$out/film_last.png" null: 2>&1 | sed 's/.*(\(.*\)).*/\1/' || true)
  awk "BEGIN { exit !($apart > 0.02) }" || fail "its first and last frame are alike: $apart"
  rm -rf "$out/film_frames"
  echo "$part: $seen, as asked for"
}

[ $# -gt 0 ] || set -- readme cumulonimbus of_two film
for part in "$@"; do
  case "$part" in
    readme | cumulonimbus | of_two | film) ;;
    *) echo "no part is called $part: readme, cumulonimbus, of_two, film"; exit 2 ;;
  esac
done
for part in "$@"; do
  shots=0
  "$part"
  [ -z "$editor" ] || close
done
