#!/usr/bin/env bash
# Builds what it takes, measures the pages of --html and rewrites the table of docs/html.md. Needs Chromium.
# usage: tests/bench/run_html_page.sh [options of html_page.py]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DGAPCHECK_BENCH=ON -DGAPCHECK_TESTS=OFF \
  $(command -v ninja >/dev/null && echo -G Ninja) >/dev/null
cmake --build "$build" --target gapcheck gapcheck_make_plates >&2

python3 -B "$root/tests/bench/html_page.py" "$build/apps/gapcheck/gapcheck" "$build/tests/bench/gapcheck_make_plates" \
  "$build/decks" "$root/docs/html.md" "$@"
