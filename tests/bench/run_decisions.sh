#!/usr/bin/env bash
# Builds what times the decisions and rewrites the table of docs/decision-speed.md.
# usage: tests/bench/run_decisions.sh [--rounds N] [--count PAIRS_PER_FAMILY] [deck...]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DGAPCHECK_BENCH=ON -DGAPCHECK_TESTS=OFF \
  $(command -v ninja >/dev/null && echo -G Ninja) >/dev/null
cmake --build "$build" --target gapcheck_make_plates gapcheck_decide_bench >&2

python3 "$root/tests/bench/decisions.py" "$build" "$build/decks" "$root/docs/decision-speed.md" "$@"
