#!/usr/bin/env bash
# Throws RUNS changed files (1,000,000) at every reader, or at those named: tests/fuzz.sh [TARGET…]. Needs `cargo install
# cargo-fuzz`; a compiler that is not nightly is told to act as one. It begins with files that are sound; what it finds lies
# in target/fuzz/artifacts. Half an hour or so on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."
export RUSTC_BOOTSTRAP=1
runs=${RUNS:-1000000}
work=$PWD/target/fuzz
program=${PROGRAM:-target/release/cloudwright}
targets=${*:-cld cryengine flightgear glb model report scene wpr}

seed() { mkdir -p "$work/corpus/$1"; }
for target in $targets; do seed "$target"; done
small=assets/presets
for preset in "$small"/*.cloudscene; do
  name=$(basename "$preset" .cloudscene)
  [ -d "$work/corpus/scene" ] && cp "$preset" "$work/corpus/scene/$name"
  for format in cld cryengine:xml flightgear:xml glb; do
    target=${format%:*}
    [ -d "$work/corpus/$target" ] || continue
    "$program" export "$preset" -o "$work/corpus/$target/$name.${format#*:}" --format "$target" 2>/dev/null || true
  done
done
[ -d "$work/corpus/wpr" ] && cp tests/wpr/*.WPR "$work/corpus/wpr/"
[ -d "$work/corpus/model" ] && cp assets/models/aircraft.glb "$work/corpus/model/"
[ -d "$work/corpus/report" ] && split -l 1 -a 4 tests/reports/metars.txt "$work/corpus/report/"

for target in $targets; do
  mkdir -p "$work/artifacts/$target"
  log=$work/$target.log
  if ! cargo fuzz run --fuzz-dir tests/fuzz --target-dir "$work/build" "$target" "$work/corpus/$target" -- \
    -runs="$runs" -max_len=65536 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="$work/artifacts/$target/" >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    echo "$target: what it found lies in $work/artifacts/$target, what it said in $log" >&2
    exit 1
  fi
  grep "^stat::" "$log"
  echo "$target: $runs inputs, no fault"
done
