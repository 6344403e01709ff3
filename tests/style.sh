#!/bin/sh
# How the code is written: clang-format and the sections of comments over every source, clang-tidy over the toolkit and
# the headers of all components. `tests/style.sh` says what differs and ends with 1; `tests/style.sh --fix` lays the
# sources out. clang-tidy needs a configured build, in which compile_commands.json is:
# `tests/style.sh --tidy build/release` (on two cores 5 minutes).
set -eu
cd "$(dirname "$0")/.."

sources() { git ls-files '*.cpp' '*.h' '*.inl'; }

# Laying out fills the lines of a comment, and so may take a section (Cost, Errors) into the prose before it.
sections_begin_lines() {
  section='(Shapes|Units|Cost|Memory|Errors|Threads|Needs|Source)(  +|: )[^ ]'
  if sources | xargs grep -nE "//+<? .*[^ \"] +$section" >&2; then
    echo "tests/style.sh: a section begins a line; put /// alone before it" >&2
    return 1
  fi
}

public_headers() { git ls-files 'lib/include/*.h' 'problems/*/include/*.h' 'bench/include/*.h'; }

# Includes every public header, those of optimizers, which have no others, and the sources of the toolkit: most of the time
# goes to the headers of others, so to judge one takes as long as to judge all.
write_everything() {
  public_headers | sed 's|.*/include/\(.*\)|#include <\1>|'
  git ls-files 'optimizers/*.h' 'lib/src/*.cpp' | sed "s|.*|#include \"$PWD/&\"|"
}

tidy() {
  build=$1
  cmake --build "$build" --target nodal_revision >&2 || return  # writes a header that lib includes
  write_everything >"$build/everything.cpp"
  folders=$(public_headers | sed 's|/include/.*|/include|' | sort -u | sed 's|^|-I|')
  # Eigen is where Debian has it; Ceres' headers include it.
  clang-tidy-14 --quiet --checks='-clang-analyzer-*,-bugprone-suspicious-include' "$build/everything.cpp" -- \
    -std=c++20 $folders -Ilib/src -Ilib -I"$build/lib/generated" -I/usr/include/eigen3 || return
  # The analyzer follows the paths of one source. Its deep mode takes five times as long. Of the flags of GCC some mean
  # nothing to Clang.
  clang="--extra-arg=-Xclang --extra-arg"
  git ls-files 'lib/src/*.cpp' | xargs -n 1 -P "$(nproc)" clang-tidy-14 --quiet --checks='-*,clang-analyzer-*' \
    $clang=-analyzer-config $clang=mode=shallow --extra-arg=-Wno-unknown-warning-option -p "$build"
}

case "${1:-}" in
  "") sources | xargs clang-format-14 --dry-run -Werror && sections_begin_lines ;;
  --fix) sources | xargs clang-format-14 -i && sections_begin_lines ;;
  --tidy)
    # Beside findings clang-tidy counts warnings that it doesn't show.
    tidy "$2" 2>"$2/style.log" || { grep -v 'warnings generated' "$2/style.log" >&2; exit 1; }
    ;;
  *) echo "usage: $0 [--fix | --tidy <build>]" >&2; exit 2 ;;
esac
