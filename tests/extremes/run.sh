#!/usr/bin/env bash
# Runs N random scenes, shared out over all processors, and prints the share of each ending by composition, what stopped
# the runs, and each fault with its seed. Exit 1 if there is a fault.
#
#   tests/extremes/run.sh [--page] [N [FIRST]]     default: 20000 scenes, from seed 0 on
#
#   --page   writes docs/envelope.md and what `arenite.check` asks (with matplotlib)
#
# Environment: ARENITE_BUILD, where to build (default: build/extremes in the checkout).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${ARENITE_BUILD:-$root/build/extremes}
page=()
if [ "${1:-}" = --page ]; then page=(--page) && shift; fi
scenes=${1:-20000}
first=${2:-0}
units=$(cd "$root/tests/extremes" && ls ./*.cpp | sed 's|^\./||; s|\.cpp$||')
chunk=250

mkdir -p "$build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DARENITE_EXAMPLES=OFF -DARENITE_BENCHMARKS=OFF \
  -DARENITE_TEST_HEADERS=OFF -DARENITE_TEST_EXTREMES_ALL=ON > "$build.log"
# shellcheck disable=SC2046,SC2086  # the names of the targets are words
cmake --build "$build" --target $(printf 'test.extremes.%s ' $units) >> "$build.log"

lines=$build/scenes
rm -rf "$lines"
mkdir -p "$lines"
run_chunk() {  # unit, first seed, number
  local status=0
  ARENITE_THREADS=1 ARENITE_EXTREMES="$2 $3" timeout 900 "$build/tests/test.extremes.$1" > "$lines/$1.$2.out" 2>&1 || status=$?
  grep '^scene	' "$lines/$1.$2.out" > "$lines/$1.$2.tsv" || true
  local done
  done=$(wc -l < "$lines/$1.$2.tsv")
  if [ "$done" -lt "$3" ]; then
    printf 'scene\t%s\tCRASHED\t%s\t\tended with status %s\n' "$1" "$(($2 + done))" "$status" >> "$lines/$1.$2.tsv"
  fi
}
export -f run_chunk
export build lines

of_unit=$((scenes / $(wc -w <<< "$units")))
for unit in $units; do
  for ((seed = first; seed < first + of_unit; seed += chunk)); do
    left=$((first + of_unit - seed))
    echo "$unit $seed $((left < chunk ? left : chunk))"
  done
done | xargs -P "$(nproc)" -L 1 bash -c 'run_chunk "$@"' run_chunk

python3 "$root/tests/extremes/report.py" "$lines" "${page[@]}"
