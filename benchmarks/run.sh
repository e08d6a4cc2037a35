#!/usr/bin/env bash
# Builds the benchmarks for this machine, runs all of them and writes one report: report.md, report.json. On a fresh Debian it
# installs what is missing. Safe to repeat; works from any folder. On an idle machine it takes about ten minutes.
#
#   benchmarks/run.sh [--quick] [--huge]
#
#   --quick  small scenes, short runs: whether it works, not how fast it is
#   --huge   a scene of 10,000,000 points too
#
# Environment: ARENITE_BUILD, where to build (default: build/bench in the checkout; the report goes there too);
# ARENITE_JOBS, compilers at once (default: all processors).
set -euo pipefail

script=benchmarks/run.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/cmake/debian.sh"
build=${ARENITE_BUILD:-$root/build/bench}

quick=false
short=()
kind=()
scaling=()
for option in "$@"; do
  case $option in
    --quick) quick=true && short=(--short) && kind=(--quick) ;;
    --huge) scaling=(--huge) ;;
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" && exit ;;
    *) fail "unknown option $option (known: --quick, --huge)" ;;
  esac
done

need g++ "the compiler" g++
need cmake "configures the build" cmake
need ninja-build "builds" ninja
need libeigen3-dev "the library's only dependency"
need libbenchmark-dev "times"
need nlohmann-json3-dev "the driver's scene"
need python3 "writes the report" python3
install_missing

mkdir -p "$build"
echo "building the benchmarks in $build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DARENITE_NATIVE=ON -DARENITE_TESTS=OFF \
  -DARENITE_EXAMPLES=OFF -DARENITE_BENCHMARKS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON > "$build/configure.log" 2>&1 < /dev/null ||
  { tail -n 30 "$build/configure.log" >&2 && fail "configuring failed (log: $build/configure.log)"; }
cmake --build "$build" -j "${ARENITE_JOBS:-$(processors)}" -- --quiet < /dev/null || fail "building the benchmarks failed"

raw=$build/raw
rm -rf "$raw"
mkdir -p "$raw"
cat /proc/loadavg > "$raw/load_before" 2> /dev/null || true

# --- compile time of the smallest scene: the README's, as a user would compile it
awk '/^```cpp/ { inside = 1; next } /^```/ { if (inside) exit } inside' "$root/README.md" > "$raw/minimal_scene.cpp"
[ -s "$raw/minimal_scene.cpp" ] || fail "README.md holds no example in a \`\`\`cpp block"
eigen=$(grep -o -m1 -e '-isystem [^ "]*' "$build/compile_commands.json" | head -n 1 || true)
echo "compiling the smallest scene"
for _ in 1 2 3; do
  begin=$(date +%s%N)
  # shellcheck disable=SC2086  # an option and its value
  CCACHE_DISABLE=1 g++ -std=c++20 -O2 -I "$root/include" $eigen -c -o /dev/null "$raw/minimal_scene.cpp" < /dev/null ||
    fail "the README's scene does not compile"
  end=$(date +%s%N)
  awk -v ns=$((end - begin)) 'BEGIN { printf "%.3f\n", ns / 1e9 }' >> "$raw/compile_seconds"
done

# measure NAME OUTPUT OPTIONS...: five repetitions, in random order, so that a disturbance hits all alike.
measure() {
  local name=$1 output=$2
  shift 2
  printf '%-12s' "$name"
  local start=$SECONDS
  "$build/benchmarks/benchmark.$name" --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true "$@" \
    --benchmark_out="$raw/$output.json" --benchmark_out_format=json > "$raw/$output.log" 2>&1 < /dev/null ||
    { tail -n 5 "$raw/$output.log" >&2 && fail "benchmark.$name failed (log: $raw/$output.log)"; }
  echo "$((SECONDS - start)) s"
}

law_time=0.05
$quick && law_time=0.005
measure machine machine_before
measure whole_step whole_step ${short[@]+"${short[@]}"}
measure drop drop ${short[@]+"${short[@]}"}
measure scaling scaling ${short[@]+"${short[@]}"} ${scaling[@]+"${scaling[@]}"}
measure laws laws --benchmark_min_time=$law_time
if ! $quick; then
  for kernels in simplex bspline contact; do measure stages_$kernels stages_$kernels; done
  measure saved_state saved_state
fi
measure machine machine_after
cat /proc/loadavg > "$raw/load_after" 2> /dev/null || true

/usr/bin/python3 -B "$root/benchmarks/report.py" "$raw" "$build" ${kind[@]+"${kind[@]}"} || fail "writing the report failed"
printf '\nthe report: %s\n            %s\n' "$build/report.md" "$build/report.json"
