#!/bin/sh
# One process against four that mpirun starts: the same set of trials. mpi.sh NODAL SAME_TRIALS; 77 without mpirun.
set -eu
nodal=$1 same_trials=$2
here=$(cd "$(dirname "$0")" && pwd)
if ! command -v mpirun >/dev/null; then
  echo "skipped: there is no mpirun; bench/packages.sh tests installs one"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
root=""
[ "$(id -u)" = 0 ] && root="--allow-run-as-root"

"$nodal" compare "$here/study.toml" --out "$folder/whole" >/dev/null
# No network but the loopback, no binding: it may be one core of a container.
mpirun -n 4 --oversubscribe --bind-to none $root --mca btl self,tcp --mca oob_tcp_if_include lo \
  "$nodal" compare "$here/study.toml" --out "$folder/shared" --shard auto
files=$(find "$folder/shared/trials" -name '*.jsonl' | wc -l)
[ "$files" = 4 ] || { echo "$files processes have written, not 4"; exit 1; }
"$same_trials" "$folder/whole" "$folder/shared"
"$nodal" report "$folder/shared" >/dev/null
