#!/usr/bin/env bash
# Two threads beside other programs: runs a command on one and on two threads in turns, while so many busy loops run, and prints
# the medians of the times, and of the ratio two threads over one (what a pair, run one right after the other, took). On an
# idle machine two threads should be faster; on a busy one they must not be much slower than one.
#
#   benchmarks/busy.sh [--loads "0 1 2 3 5 15"] [--pairs N] COMMAND...
#
#   --loads LIST  how many busy loops run beside the command, one after the other (default: 0 1 2 3 5 15)
#   --pairs N     pairs of runs at each of them (default: 7)
#   COMMAND       what is timed; ARENITE_THREADS in its environment says on how many threads, for example
#                 arenite-ffp drop --quiet --fields-every 0 --end 0.03 --out /tmp/drop
#
# Other programs of the machine count too: the load average at the begin is printed.
set -euo pipefail

script=benchmarks/busy.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/cmake/debian.sh"

loads="0 1 2 3 5 15"
pairs=7
while [ $# -gt 0 ]; do
  case $1 in
    --loads | --pairs)
      [ $# -ge 2 ] || fail "$1 needs a value"
      case $1 in --loads) loads=$2 ;; --pairs) pairs=$2 ;; esac
      shift 2
      ;;
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" && exit ;;
    -*) fail "unknown option $1 (known: --loads, --pairs)" ;;
    *) break ;;
  esac
done
[ $# -ge 1 ] || fail "a command is needed (see --help)"
[[ $pairs =~ ^[1-9][0-9]*$ ]] || fail "--pairs = $pairs: must be a whole number, at least 1"
[[ $loads =~ ^[0-9]+(\ +[0-9]+)*$ ]] || fail "--loads = $loads: must be whole numbers"

loops=()
end_loops() {
  if ((${#loops[@]})); then
    kill "${loops[@]}" 2> /dev/null || true
    wait "${loops[@]}" 2> /dev/null || true
  fi
  loops=()
}
trap end_loops EXIT

# seconds THREADS COMMAND...
seconds() {
  local threads=$1 begin end
  shift
  begin=$(date +%s%N)
  ARENITE_THREADS=$threads "$@" > /dev/null 2>&1 < /dev/null || fail "$* failed on $threads thread(s)"
  end=$(date +%s%N)
  awk -v ns=$((end - begin)) 'BEGIN { printf "%.3f\n", ns / 1e9 }'
}

# statistics NUMBERS...: median, smallest, largest
statistics() {
  printf '%s\n' "$@" | sort -n | awk '{ x[NR] = $1 } END {
    print (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2, x[1], x[NR] }'
}

read -r load _ < /proc/loadavg 2> /dev/null || load=unknown
echo "load average at the begin: $load; $pairs pairs each"
printf '%10s  %12s  %12s  %s\n' "busy loops" "1 thread, s" "2 threads, s" "2 threads over 1: median (smallest, largest)"
for busy in $loads; do
  for ((k = 0; k < busy; ++k)); do
    sh -c 'while :; do :; done' &
    loops+=($!)
  done
  one=() two=() ratios=()
  for ((pair = 0; pair < pairs; ++pair)); do
    # Who goes first alternates.
    if ((pair % 2)); then
      b=$(seconds 2 "$@")
      a=$(seconds 1 "$@")
    else
      a=$(seconds 1 "$@")
      b=$(seconds 2 "$@")
    fi
    one+=("$a") && two+=("$b") && ratios+=("$(awk -v a="$a" -v b="$b" 'BEGIN { printf "%.3f", b / a }')")
  done
  end_loops
  read -r median smallest largest < <(statistics "${ratios[@]}")
  printf '%10d  %12.2f  %12.2f  %.2f (%.2f, %.2f)\n' "$busy" "$(statistics "${one[@]}" | cut -d' ' -f1)" \
    "$(statistics "${two[@]}" | cut -d' ' -f1)" "$median" "$smallest" "$largest"
done
