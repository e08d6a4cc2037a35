#!/usr/bin/env bash
# What a user pays before the first number: CPU seconds and memory of the compiler for common units, beside another revision of the same
# repository, in turns; prints a table with medians, and the median of the ratios. Works from any folder.
#
#   benchmarks/compile.sh [REVISION] [--rounds N] [--only REGEX] [--compiler COMMAND]
#
#   REVISION            what to compare with (default: none, this state alone)
#   --rounds N          of each (default: 5)
#   --only REGEX        rows whose name matches
#   --compiler COMMAND  default: g++
exec python3 "$(dirname "${BASH_SOURCE[0]}")/compile.py" "$@"
