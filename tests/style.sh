#!/bin/sh
# How the code is written: clang-format over every source, clang-tidy over the toolkit and the public headers.
# `tests/style.sh` says what differs and ends with 1; `tests/style.sh --fix` lays the sources out. clang-tidy needs a
# configured build, in which compile_commands.json is: `tests/style.sh --tidy build/release`.
set -eu
cd "$(dirname "$0")/.."

sources() { git ls-files '*.cpp' '*.h' '*.inl'; }

case "${1:-}" in
  "") sources | xargs clang-format-14 --dry-run -Werror ;;
  --fix) sources | xargs clang-format-14 -i ;;
  --tidy)
    # Headers are judged where they are included: HeaderFilterRegex in .clang-tidy.
    git ls-files 'lib/src/*.cpp' | xargs -n 1 -P "$(nproc)" clang-tidy-14 --quiet --warnings-as-errors='*' -p "$2"
    ;;
  *) echo "usage: $0 [--fix | --tidy <build>]" >&2; exit 2 ;;
esac
