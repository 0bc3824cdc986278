#!/usr/bin/env bash
# Builds the benchmarks, times `gapcheck audit` as a process and rewrites the table of docs/benchmarks.md.
# usage: tests/bench/run_benchmarks.sh [options of measure.py]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DGAPCHECK_BENCH=ON -DGAPCHECK_TESTS=OFF \
  $(command -v ninja >/dev/null && echo -G Ninja) >/dev/null
cmake --build "$build" --target gapcheck gapcheck_make_plates gapcheck_bench >&2

gapcheck=$(find "$build/apps" -type f -name gapcheck -perm -u+x | head -n 1)
python3 "$root/tests/bench/measure.py" "$gapcheck" "$build/tests/bench/gapcheck_make_plates" "$build/decks" \
  "$root/docs/benchmarks.md" "$@"
