#!/usr/bin/env bash
# Builds and runs tests. On a fresh Debian it installs what is missing. Safe to repeat; works from any folder.
#
#   tests/run.sh [--change | --nightly | --all] [--gcc] [--asan] [--clang] [--python] [--trade] [--docs] [--format]
#
# How much (tests/scopes.cmake has the lists):
#   no option  g++ Release: the core of each room, one scene of a family, the driver
#   --change   what a change may break, beside that: the other tests of g++ but the long ones, examples, memory and files under the
#              sanitizers (clang++), the Python package, the documentation site, the format
#   --nightly  the rest: long tests, all under the sanitizers, clang++ Release, each header by itself, benchmarks, the driver's second width,
#              a tenth of the table of errors and costs (docs/trade.md)
#   --all      all three
# Stages (options add up; without one, all of what was asked for; without how much, whole stages):
#   --gcc      g++ Release              --asan     clang++ under the address and undefined-behaviour sanitizers
#   --clang    clang++ Release          --python   Python package: wheel, clean environment, pytest, mypy
#   --trade    errors of compositions on problems with a known answer, two sizes of cells, beside the table that docs/trade.md is from
#   --docs     documentation site, warnings are errors                --format   clang-format
#
# Environment: ARENITE_BUILD, where to build (default: build/tests in the checkout).
set -euo pipefail

script=tests/run.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/cmake/debian.sh"
build=${ARENITE_BUILD:-$root/build/tests}
jobs=$(processors)

stages=()
scope=
for option in "$@"; do
  case $option in
    --change | --nightly | --all) scope=${option#--} ;;
    --gcc | --asan | --clang | --python | --trade | --docs | --format) stages+=("${option#--}") ;;
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" && exit ;;
    *) fail "unknown option $option (known: --change, --nightly, --all, --gcc, --asan, --clang, --python, --trade, --docs, --format)" ;;
  esac
done
if [ ${#stages[@]} -gt 0 ]; then
  : "${scope:=all}"
else
  case ${scope:=quick} in
    quick) stages=(gcc) ;;
    change) stages=(gcc asan python docs format) ;;
    nightly) stages=(gcc asan clang trade) ;;
    all) stages=(gcc asan clang python trade docs format) ;;
  esac
fi
# What is built, and which of it runs: --change and --nightly leave out what those before them run.
case $scope in
  quick) build_scope=quick which=() ;;
  change) build_scope=change which=(-LE quick) ;;
  nightly) build_scope=nightly which=(-LE 'quick|change') ;;
  all) build_scope=nightly which=() ;;
esac
chosen() { [[ " ${stages[*]} " == *" $1 "* ]]; }

# --- what the machine must have
if chosen gcc || chosen clang || chosen asan; then
  need g++ "the compiler" g++
  need cmake "configures the build" cmake
  need ninja-build "builds" ninja
  need libeigen3-dev "the library's only dependency"
  need catch2 "the test framework"
  need libcli11-dev "options of the driver arenite-ffp"
  need nlohmann-json3-dev "the driver's summary.json"
  need libbenchmark-dev "the benchmarks must compile"
  need pkgconf "what arenite.pc says is tried" pkg-config
  need dpkg-dev "the driver's Debian package lists the libraries that it needs" dpkg-shlibdeps
  need qemu-user "a program runs on a processor without AVX" qemu-x86_64
  need libhdf5-dev "states and series in HDF5 files"
  need libopenmpi-dev "tiles on many ranks, and their tests" mpicxx
  need python3-matplotlib "the driver's pictures are drawn"
  need python3-venv "meshio and h5py, in a virtual environment, write and read the files that the readers and writers are tested on"
fi
if chosen python || chosen trade; then
  need g++ "the compiler of the package, and of compositions on first use" g++
  need python3-dev "headers of Python" python3-config
  need python3-venv "clean environments"
  need libcli11-dev "typed options of the driver, with which those of Python are compared"
  need doxygen "reads the headers that the recipes are written from" doxygen
  need libopenmpi-dev "scenes cut into tiles, on ranks" mpicxx
fi
if chosen clang || chosen asan; then
  need clang "the second compiler" clang++
fi
if chosen asan; then need libclang-rt-dev "the sanitizers' part of every program"; fi
if chosen docs; then
  need doxygen "reads the headers for the C++ reference" doxygen
  need python3-venv "Sphinx and its extensions, in a virtual environment"
fi
if chosen format; then need clang-format "the format check" clang-format; fi
install_missing

# --- Python packages, pinned, in the build folder. Debian's own Python by its path: another may come first.
venv=$build/venv
mkdir -p "$build"
# environment STAGE FOLDER REQUIREMENTS: a virtual environment with these packages, made anew when they change.
environment() {
  local stage=$1 folder=$2 requirements=$root/$3
  cmp -s "$requirements" "$folder/requirements.txt" && return
  rm -rf "$folder"
  /usr/bin/python3 -m venv "$folder" || fail "stage $stage: /usr/bin/python3 -m venv $folder failed"
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check -r "$requirements" < /dev/null ||
    fail "stage $stage: pip could not install $3"
  cp "$requirements" "$folder/requirements.txt"
}
prepare_python() { environment Python "$venv" tests/requirements.txt; }

summary=()

# run_stage NAME FOLDER CMAKE-OPTIONS...
run_stage() {
  local name=$1 folder=$build/$2
  shift 2
  local start=$SECONDS runs=("${which[@]}")
  [ "$name" != "clang++ Release" ] || runs=()  # whole at night
  printf '\n=== %s\n' "$name"
  cmake -S "$root" -B "$folder" -G Ninja -DARENITE_TEST_PYTHON="$venv/bin/python" -DARENITE_REQUIRE_ALL=ON \
    -DARENITE_TEST_TOGETHER=8 -DARENITE_TEST_SCOPE=$build_scope "$@" > "$folder.log" 2>&1 < /dev/null ||
    { tail -n 30 "$folder.log" >&2 && fail "stage $name: configuring failed (log: $folder.log)"; }
  # Errors and warnings of the compiler, not the list of commands that it ran.
  # Compilers take 3 to 5 % less time with memory in large pages, where the system has them.
  GLIBC_TUNABLES=glibc.malloc.hugetlb=1 cmake --build "$folder" -j "$jobs" -- --quiet -k 0 < /dev/null || fail "stage $name: building failed"
  local built=$SECONDS
  if ! ctest --test-dir "$folder" -j "$jobs" --output-on-failure --no-tests=error "${runs[@]}" < /dev/null |
    tee "$folder.ctest.log"; then
    fail "stage $name: tests failed (log: $folder.ctest.log)"
  fi
  summary+=("$name: $(grep 'tests passed' "$folder.ctest.log") (build $((built - start)) s, tests $((SECONDS - built)) s)")
}

# Precompiled headers need these two for ccache to keep them.
export CCACHE_SLOPPINESS=pch_defines,time_macros

if chosen gcc; then
  prepare_python
  # At night examples and driver are compiled as their users do.
  options=(-DARENITE_EXAMPLES_FFP_ONLY=OFF -DARENITE_FFP_DROPS=all -DARENITE_BENCHMARKS=OFF -DARENITE_FFP_WIDTHS=16 -DARENITE_EXAMPLES_FAST_BUILD=ON)
  case $build_scope in
    quick) options+=(-DARENITE_EXAMPLES_FFP_ONLY=ON -DARENITE_FFP_DROPS=default) ;;
    nightly) options+=(-DARENITE_BENCHMARKS=ON "-DARENITE_FFP_WIDTHS=16;64" -DARENITE_EXAMPLES_FAST_BUILD=OFF) ;;
  esac
  run_stage "g++ Release" gcc -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release -DARENITE_WERROR=ON \
    -DARENITE_BENCHMARKS_FAST_BUILD=ON "${options[@]}"
fi
if chosen asan; then
  prepare_python
  # clang++, which takes a tenth of g++ 12's time for the kernels under the sanitizers; -O0, a third of what it takes for -O1 (but
  # for the tests that run long, tests/CMakeLists.txt). Left out is what says nothing more under them: how the library is
  # built, which the stages before check with the same compilers, and the driver, which is what the tests of the library test, put
  # together.
  sanitize="-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
  # A quarter of the random scenes.
  ARENITE_EXTREMES="1 25" run_stage "clang++ sanitizers" asan -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS="$sanitize -D_GLIBCXX_ASSERTIONS" -DCMAKE_CXX_FLAGS_DEBUG="-O0" -DARENITE_WERROR=ON \
    -DARENITE_BENCHMARKS=OFF -DARENITE_EXAMPLES=OFF -DARENITE_FUZZ=ON -DARENITE_TEST_HEADERS=OFF -DARENITE_TEST_HEAVY=OFF \
    -DARENITE_TEST_BUILDS=OFF
fi
if chosen clang; then
  prepare_python
  run_stage "clang++ Release" clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DARENITE_WERROR=ON \
    -DARENITE_BENCHMARKS=OFF -DARENITE_TEST_HEADERS=OFF -DARENITE_TEST_EXTREMES=OFF
fi
# package STAGE: the Python package, built as a wheel and installed into a clean environment.
clean=$build/python
package() {
  [ -z "${wheel:-}" ] || return 0
  rm -rf "$clean/env" "$clean/wheel" "$clean/cache"
  mkdir -p "$clean"
  /usr/bin/python3 -m venv "$clean/env"
  pip() { "$clean/env/bin/python" -m pip --quiet --disable-pip-version-check "$@" < /dev/null; }
  pip install -r "$root/python/tests/requirements.txt" &  # from the network, while the compiler works
  local requirements=$!
  GLIBC_TUNABLES=glibc.malloc.hugetlb=1 pip wheel --no-deps -w "$clean/wheel" --config-settings build-dir="$clean/build" "$root" || fail "stage $1: the wheel was not built"
  wheel=$(ls "$clean"/wheel/arenite-*.whl)
  [ "$(stat -c %s "$wheel")" -le 25000000 ] || fail "stage $1: $wheel is larger than 25 MB"
  wait $requirements || fail "stage $1: pip could not install python/tests/requirements.txt"
  pip install "$wheel" || fail "stage $1: the wheel was not installed"
}
if chosen python; then
  printf '\n=== Python\n'
  start=$SECONDS
  package Python
  # From another folder, so that the installed package is tested.
  (cd "$clean" && ARENITE_CACHE="$clean/cache" "$clean/env/bin/python" -m pytest -q -n "$jobs" --dist loadfile "$root/python/tests" < /dev/null) ||
    fail "stage Python: tests failed"
  (cd "$root" && "$clean/env/bin/python" -m mypy < /dev/null) || fail "stage Python: types do not fit"
  summary+=("Python: wheel of $(($(stat -c %s "$wheel") / 1000000)) MB, built, installed, tested ($((SECONDS - start)) s)")
fi
if chosen trade; then
  printf '\n=== trade\n'
  start=$SECONDS
  package trade
  rm -rf "$build/trade"
  trade() {
    ARENITE_CACHE="$clean/cache" "$clean/env/bin/python" "$root/benchmarks/trade/trade.py" --only "$1" --out "$build/trade/$1" "${@:2}" < /dev/null
  }
  for problem in "$root"/benchmarks/trade/problems/*.py; do
    while [ "$(jobs -r | wc -l)" -ge "$jobs" ]; do wait -n || fail "stage trade: a problem was not solved"; done
    trade "$(basename "$problem" .py)" --quick > /dev/null 2>&1 &
  done
  wait
  for problem in "$root"/benchmarks/trade/problems/*.py; do
    trade "$(basename "$problem" .py)" --compare || fail "stage trade: errors are not those of benchmarks/trade/rows.csv"
  done
  summary+=("trade: errors as in benchmarks/trade/rows.csv ($((SECONDS - start)) s)")
fi
if chosen docs; then
  printf '\n=== documentation\n'
  start=$SECONDS
  site=$build/docs
  mkdir -p "$site"
  environment documentation "$site/env" docs/requirements.txt
  # -E: all pages anew, so that no warning is missed.
  "$site/env/bin/python" -m sphinx -q -W --keep-going -E -j "$jobs" -d "$site/doctrees" "$root/docs" "$site/html" < /dev/null ||
    fail "stage documentation: the site was not built without warnings"
  summary+=("documentation: $site/html/index.html ($((SECONDS - start)) s)")
fi
if chosen format; then
  printf '\n=== format\n'
  cd "$root"
  # Not --dry-run: version 14 objects to the comment that it writes itself behind `namespace a::inline B`.
  unformatted=$(find include tests examples benchmarks python \( -name '*.hpp' -o -name '*.cpp' \) -print0 |
    xargs -0 -n 8 -P "$jobs" sh -c 'for file; do clang-format "$file" | cmp -s - "$file" || echo "$file"; done' sh | sort)
  if [ -n "$unformatted" ]; then
    echo "$unformatted"
    fail "stage format: run clang-format -i on the files above"
  fi
  summary+=("format: clean")
fi

printf '\n=== all stages passed in %d s\n' "$SECONDS"
printf '%s\n' "${summary[@]}"
