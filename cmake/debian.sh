# shellcheck shell=bash
# Sourced by tests/run.sh and examples/ffp/run.sh: installs with apt what is missing, and says what and why.

# fail SENTENCE: the one clear sentence, and the end.
fail() {
  echo "${script:-$0}: $1" >&2
  exit 1
}

missing=()

# need PACKAGE REASON [COMMAND]: notes PACKAGE as missing unless it is installed, or unless COMMAND is at hand anyhow.
need() {
  if [ -n "${3:-}" ] && command -v "$3" > /dev/null; then return; fi
  if dpkg-query -W -f='${Status}' "$1" 2> /dev/null | grep -q '^install ok installed'; then return; fi
  missing+=("$1")
  echo "missing: $1 ($2)"
}

# install_missing: installs what `need` noted, as root or with sudo.
install_missing() {
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=(env)
  command -v apt-get > /dev/null || fail "this system has no apt; please install by other means: ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null || fail "to install ${missing[*]} it must run as root, or sudo must be present"
    as_root=(sudo env)
  fi
  echo "installing with apt: ${missing[*]}"
  local log
  log=$(mktemp)
  # The lists may be absent or stale: refreshed once, and only when something is to be installed.
  if ! { "${as_root[@]}" apt-get update && "${as_root[@]}" DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends "${missing[@]}"; } > "$log" 2>&1 < /dev/null; then
    tail -n 15 "$log" >&2
    fail "apt could not install ${missing[*]} (its output: $log)"
  fi
  rm -f "$log"
  missing=()
}

# processors: how many jobs to run at once.
processors() { nproc 2> /dev/null || echo 2; }
