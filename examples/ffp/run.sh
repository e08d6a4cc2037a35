#!/usr/bin/env bash
# Drops the free-fall penetrometer into sand: installs what is missing, builds the driver for this machine, runs it, draws
# the pictures and prints the summary. Safe to repeat; works from any folder.
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
echo "building arenite-ffp in $build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DARENITE_NATIVE=ON -DARENITE_TESTS=OFF \
  -DARENITE_BENCHMARKS=OFF > "$build/configure.log" 2>&1 < /dev/null ||
  { tail -n 30 "$build/configure.log" >&2 && fail "configuring failed (log: $build/configure.log)"; }
cmake --build "$build" -j "$(processors)" --target arenite-ffp -- --quiet < /dev/null || fail "building arenite-ffp failed"
driver=$build/examples/ffp/arenite-ffp

# Where the driver will write: the last --out among the options, or our default.
out=
previous=
for option in "$@"; do
  case $option in --out=*) out=${option#--out=} ;; -h | --help) exec "$driver" drop --help ;; esac
  [ "$previous" = --out ] && out=$option
  previous=$option
done
options=("$@")
if [ -z "$out" ]; then
  out=$root/out/ffp
  options+=(--out "$out")
fi

status=0
"$driver" drop "${options[@]}" || status=$?
[ $status -eq 0 ] || { echo "$script: arenite-ffp stopped with exit code $status" >&2 && exit $status; }

# Debian's own Python by its path: another, without matplotlib, may come first.
/usr/bin/python3 "$root/examples/ffp/plot.py" "$out" || fail "drawing the pictures failed"

printf '\n'
/usr/bin/python3 - "$out/summary.json" << 'END' || fail "$out/summary.json cannot be read"
import json
import sys


def show(values, indent=""):
    for name, value in values.items():
        if isinstance(value, dict):
            print(f"{indent}{name}")
            show(value, indent + "  ")
        else:
            text = f"{value:.6g}" if isinstance(value, float) else value
            print(f"{indent}{name:<{32 - len(indent)}} {text}")


show(json.load(open(sys.argv[1])))
END

printf '\nfields for ParaView, history and summary: %s\npictures:\n' "$out"
find "$out" -maxdepth 2 \( -name '*.png' -o -name '*.svg' -o -name '*.pdf' \) | sort | sed 's/^/  /'
