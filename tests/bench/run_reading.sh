#!/usr/bin/env bash
# Builds the benchmark of reading rows, runs it and rewrites its table of docs/benchmarks.md.
# usage: tests/bench/run_reading.sh [options of measure_reading.py]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DGAPCHECK_BENCH=ON -DGAPCHECK_TESTS=OFF \
  $(command -v ninja >/dev/null && echo -G Ninja) >/dev/null
cmake --build "$build" --target gapcheck_reading_bench >&2

python3 "$root/tests/bench/measure_reading.py" "$build" "$root/docs/benchmarks.md" "$@"
