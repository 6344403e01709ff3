#!/bin/sh
# The paper's figures, made again: runs the studies of bench/scenes/paper/, and writes the tables of docs/reproduction.md and the
# pictures beside it. Takes some minutes; what is stored already is not run again (results/NAME).
#
#     bench/reproduce.sh            all of it, with the program in build/release
#     bench/reproduce.sh --short    two repeats, less of each, and nothing is kept: whether all of it runs
#
# NODAL, PAGE_TABLE and FIGURE12 name other programs, OUT another folder for results.
set -eu
cd "$(dirname "$0")/.."
nodal="${NODAL:-build/release/bench/nodal}"
page_table="${PAGE_TABLE:-build/release/tests/docs/page_table}"
figure12="${FIGURE12:-build/release/tests/bench/paper/figure12}"
out="${OUT:-results}"
scenes=bench/scenes/paper
page=docs/reproduction.md
pictures=docs/pictures
less=""
if [ "${1:-}" = "--short" ]; then
  out="$(mktemp -d)"
  cp "$page" "$out/reproduction.md"
  page="$out/reproduction.md"
  pictures="$out"
  less="--repeats 2 --evaluations 2000"
fi

compare() {  # STUDY: its table
  # shellcheck disable=SC2086  # several words
  "$nodal" compare "$scenes/$1.toml" --out "$out/$1" $less >"$out/$1.txt" 2>>"$out/reproduce.log"
  "$page_table" "$page" "$out/$1"
}
evaluate() {  # STUDY PROBLEM PICTURE
  "$nodal" evaluate "$scenes/$1.toml" --problem "$2" --picture "$pictures/$3.svg" >/dev/null 2>>"$out/reproduce.log"
}
fit() {  # STUDY PROBLEM METHOD PICTURE
  # shellcheck disable=SC2086
  "$nodal" fit "$scenes/$1.toml" --problem "$2" --with "$3" --picture "$pictures/$4.svg" ${less#--repeats 2} >/dev/null \
    2>>"$out/reproduce.log"
}

mkdir -p "$out"
finish() {  # STATUS
  [ "$1" = 0 ] || tail -n 20 "$out/reproduce.log" >&2
  [ -z "$less" ] || rm -rf "$out"
}
trap 'finish $?' EXIT
: >"$out/reproduce.log"
echo "pictures"
evaluate fig01 "random points" fig01-0
evaluate fig01 "1 iteration" fig01-1
evaluate fig01 "15 iterations" fig01-15
for topology in crossed single alternating; do evaluate fig03 $topology fig03-$topology; done
evaluate fig04 "edges held" fig04
evaluate fig04 "rigid motions held" fig05
evaluate fig07 cube fig07
for study in fig08 fig09 fig10 fig11; do
  evaluate $study "start as printed" $study-before
  fit $study "start as printed" annealing $study-after
done
echo "tables"
for study in fig02 fig07 fig08 fig09 fig10 fig11 schedule gradients; do compare $study; done
[ -n "$less" ] || "$figure12" "$page"
echo "written: $page, $pictures"
