#!/usr/bin/env bash
# Drops the free-fall penetrometer into sand: installs what is missing, builds the driver for this machine, runs it, draws
# the pictures and prints what it came to; also of a run that failed or was interrupted (Ctrl-C), whose exit code it hands on.
# Safe to repeat; works from any folder.
#
#   examples/ffp/run.sh [drop options]     the options are those of `arenite-ffp drop --help`
#
# Output goes to out/ffp in the checkout unless --out says otherwise.
# Environment: ARENITE_BUILD, where to build (default: build/ffp in the checkout).
set -euo pipefail

script=examples/ffp/run.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$root/cmake/debian.sh"
build=${ARENITE_BUILD:-$root/build/ffp}

need g++ "the compiler" g++
need cmake "configures the build" cmake
need ninja-build "builds" ninja
need libeigen3-dev "the library's only dependency"
need libcli11-dev "options of the driver"
need nlohmann-json3-dev "the driver's summary.json"
need python3-matplotlib "draws the pictures"
need python3-numpy "reads the history for them"
install_missing

mkdir -p "$build"
driver=$build/examples/ffp/arenite-ffp
# build DROPS TOLD: the driver with the drops of ARENITE_FFP_DROPS, "slice;axisymmetric-law".
build() {
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DARENITE_NATIVE=ON -DARENITE_TESTS=OFF \
    -DARENITE_BENCHMARKS=OFF -DARENITE_FFP_DROPS="$1" > "$build/configure.log" 2>&1 < /dev/null ||
    { tail -n 30 "$build/configure.log" >&2 && fail "configuring failed (log: $build/configure.log)"; }
  echo "building $2"
  NINJA_STATUS='  [%f/%t, %e s] ' cmake --build "$build" -j "$(processors)" --target arenite-ffp < /dev/null || fail "building arenite-ffp failed"
}
# What the default drop runs; another drop once it is asked for.
drops=$(sed -n 's/^ARENITE_FFP_DROPS:STRING=//p' "$build/CMakeCache.txt" 2> /dev/null || true)
build "${drops:=default}" "arenite-ffp in $build: about a minute on two processors the first time, seconds later"

# Where the driver will write: the last --out among the options, or our default.
out=
previous=
for option in "$@"; do
  case $option in --out=*) out=${option#--out=} ;; -h | --help | --version) exec "$driver" drop "$option" ;; esac
  [ "$previous" = --out ] && out=$option
  previous=$option
done
options=("$@")
if [ -z "$out" ]; then
  out=$root/out/ffp
  options+=(--out "$out")
fi

echo "dropping: seconds for the default drop, minutes for a slice; arenite-ffp tells how long once it has begun"
trap : INT # Ctrl-C ends the drop, not this script
status=0
"$driver" drop "${options[@]}" || status=$?
if [ $status -eq 3 ]; then # it has run nothing, and names the drop that it was built without: asked once more, for the name
  asked=$("$driver" drop "${options[@]}" 2>&1 | sed -n 's/.*: drops = \([a-z, -]*\): .*/\1/p' || true)
  build "$drops;${asked//, /;}" "what these options need: less than a minute, once"
  status=0
  "$driver" drop "${options[@]}" || status=$?
fi
trap - INT
# With 2 nothing was run.
if [ $status -eq 2 ] || [ ! -e "$out/summary.json" ]; then
  echo "$script: arenite-ffp stopped with exit code $status" >&2
  exit $status
fi

echo "drawing the pictures: about 10 seconds"
# Debian's own Python by its path: another, without matplotlib, may come first.
/usr/bin/python3 "$root/examples/ffp/scripts/plot.py" "$out" > /dev/null || fail "drawing the pictures failed"
printf '\n'
/usr/bin/python3 "$root/examples/ffp/scripts/report.py" "$out"
if [ -e "$out/reduced.csv" ]; then
  printf '\nAs practitioners read it (arenite-ffp reduce %s):\n' "$out"
  "$driver" reduce "$out" || fail "the reduction failed"
fi
exit $status
