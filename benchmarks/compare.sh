#!/usr/bin/env bash
# Regression check: runs the same benchmark of two builds in turns and prints how much slower the second is. Exit code 1 if
# any benchmark is slower than the factor allows, else 0; 2 if the runs cannot be compared. Works from any folder.
#
#   benchmarks/compare.sh BUILD_A BUILD_B [FILTER] [--factor F] [--rounds N] [--benchmark NAME] [--short]
#
#   BUILD_A, BUILD_B  build folders (as made by benchmarks/run.sh): before, after
#   FILTER            regular expression of benchmark names (default: /arenite)
#   --factor F        how much slower is a failure (default: 1.10)
#   --rounds N        runs of each (default: 7)
#   --benchmark NAME  which executable (default: whole_step; with laws give a FILTER, e.g. law/mohr)
#   --short           its small scenes
set -euo pipefail

script=benchmarks/compare.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/cmake/debian.sh"

factor=1.10
rounds=7
name=whole_step
short=()
positional=()
while [ $# -gt 0 ]; do
  case $1 in
    --factor | --rounds | --benchmark)
      [ $# -ge 2 ] || fail "$1 needs a value"
      case $1 in --factor) factor=$2 ;; --rounds) rounds=$2 ;; --benchmark) name=$2 ;; esac
      shift
      ;;
    --short) short=(--short) ;;
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" && exit ;;
    -*) fail "unknown option $1 (known: --factor, --rounds, --benchmark, --short)" ;;
    *) positional+=("$1") ;;
  esac
  shift
done
((${#positional[@]} == 2 || ${#positional[@]} == 3)) ||
  fail "two build folders are needed, and at most one filter (see --help)"
[[ $rounds =~ ^[1-9][0-9]*$ ]] || fail "--rounds = $rounds: must be a whole number, at least 1"
[[ $factor =~ ^[0-9]*\.?[0-9]+$ ]] || fail "--factor = $factor: must be a number"
filter=${positional[2]:-/arenite}
for folder in "${positional[0]}" "${positional[1]}"; do
  [ -x "$folder/benchmarks/benchmark.$name" ] || fail "$folder/benchmarks/benchmark.$name is missing: build it first"
done

raw=$(mktemp -d)
trap 'rm -rf "$raw"' EXIT

# once WHICH FOLDER ROUND
once() {
  "$2/benchmarks/benchmark.$name" ${short[@]+"${short[@]}"} --benchmark_filter="$filter" \
    --benchmark_out="$raw/$1.$3.json" --benchmark_out_format=json > "$raw/log" 2>&1 < /dev/null ||
    { tail -n 5 "$raw/log" >&2 && fail "$2/benchmarks/benchmark.$name failed"; }
  [ -s "$raw/$1.$3.json" ] || fail "$2/benchmarks/benchmark.$name has no benchmark that matches $filter"
}

for ((round = 0; round < rounds; ++round)); do
  printf '\rround %d of %d' $((round + 1)) "$rounds" >&2
  # Who goes first alternates, too.
  if ((round % 2 == 0)); then
    once a "${positional[0]}" "$round"
    once b "${positional[1]}" "$round"
  else
    once b "${positional[1]}" "$round"
    once a "${positional[0]}" "$round"
  fi
done
printf '\r' >&2
/usr/bin/python3 -B "$root/benchmarks/compare.py" "$raw" "$factor"
