#!/usr/bin/env bash
# Runs N random scenes, shared out over all processors, and prints the share of each ending by composition, what stopped
# the runs, and each fault with its seed. Exit 1 if there is a fault.
#
#   tests/extremes/run.sh [N [FIRST]]     default: 20000 scenes, from seed 0 on
#
# Environment: ARENITE_BUILD, where to build (default: build/extremes in the checkout).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${ARENITE_BUILD:-$root/build/extremes}
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

cat "$lines"/*.tsv | awk -F '\t' '
  BEGIN { count = split("sound damped left stopped refused fault", column, " ") }
  {
    ending = $3 ~ /^[a-z]/ ? $3 : "fault"
    ++of[$2]; ++n[$2, ending]; ++all; ++n["all", ending]
    if (ending == "fault") fault[++faults] = sprintf("%s, %s, seed %s: %s\n    %s", $2, $3, $4, $5, $6)
    if (ending == "stopped") {
      cause = $5
      sub(/.* \| t = [^:]*: /, "", cause)
      sub(/[0-9=].*/, "", cause)
      ++by[$2, cause]; ++causes[cause]; ++by["all", cause]
    }
  }
  function share(part, whole) { return part == 0 ? "        " : sprintf("%7.2f ", 100 * part / whole) }
  function row(name, whole,   k, cause) {
    printf "%-66.66s %6d ", name, whole
    for (k = 1; k <= count; ++k) printf "%s", share(n[name, column[k]], whole)
    for (cause in causes) if (by[name, cause] > 0) printf " %s%.2f;", cause, 100 * by[name, cause] / whole
    printf "\n"
  }
  END {
    printf "%-66s %6s ", "composition, % of its scenes", "scenes"
    for (k = 1; k <= count; ++k) printf "%7s ", column[k]
    printf " stopped by\n"
    for (name in of) row(name, of[name])
    row("all", all)
    for (k = 1; k <= faults; ++k) printf "\n%s\n", fault[k]
    exit faults > 0
  }'
