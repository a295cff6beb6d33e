# A screen without a screen, and the editor's real window on it; to be sourced by what looks at that window.
#
# Wants `program` and `out`, a folder that is there. What the editor remembers between starts is not this user's.

editor=""
cleanup() { kill $editor "$screen" 2>/dev/null || true; rm -rf "$home"; }

# begin_screen WIDTH HEIGHT: a display that nobody has.
begin_screen() {
  number=77
  while [ -e "/tmp/.X11-unix/X$number" ]; do number=$((number + 1)); done
  export DISPLAY=":$number"
  home=$(mktemp -d)
  export XDG_CONFIG_HOME="$home/config" XDG_STATE_HOME="$home/state" XDG_DATA_HOME="$home/data" XDG_CACHE_HOME="$home/cache"
  Xvfb "$DISPLAY" -screen 0 "$1x$2x24" -nolisten tcp >/dev/null 2>&1 &
  screen=$!
  trap cleanup EXIT
  for _ in $(seq 50); do xdpyinfo >/dev/null 2>&1 && break; sleep 0.2; done
}

# open SCENE WIDTH HEIGHT: the editor's window, with a picture in it.
open() {
  "$program" ${1:+"$1"} >"$out/window.log" 2>&1 &
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

at() { xdotool mousemove --window "$window" "$1" "$2"; sleep 0.3; }
