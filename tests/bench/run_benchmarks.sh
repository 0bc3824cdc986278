#!/usr/bin/env bash
# Builds the benchmarks, times gapcheck and check-c as processes and the solver, and rewrites the tables of docs/benchmarks.md.
# usage: tests/bench/run_benchmarks.sh [options of measure.py]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DGAPCHECK_BENCH=ON -DGAPCHECK_TESTS=OFF \
  $(command -v ninja >/dev/null && echo -G Ninja) >/dev/null
cmake --build "$build" --target gapcheck check-c gapcheck_make_plates gapcheck_make_messag gapcheck_bench \
  gapcheck_solver_speed >&2

python3 "$root/tests/bench/measure.py" "$build" "$build/decks" "$root/docs/benchmarks.md" "$@"
