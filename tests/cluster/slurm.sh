#!/bin/sh
# One process against the array script of docs/clusters.md, run by a Slurm of its own: one node, loopback, a socket and a key
# for munge, everything in a temporary folder. slurm.sh NODAL SAME_TRIALS; installs what is missing.
set -eu
nodal=$1 same_trials=$2
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
"$root/bench/packages.sh" slurm

folder=$(mktemp -d)
daemons=""
finish() {
  code=$?
  for daemon in $daemons; do kill "$daemon" 2>/dev/null || true; done
  wait 2>/dev/null || true
  if [ "$code" != 0 ]; then tail -n 20 "$folder"/*.log "$folder"/*.out 2>/dev/null || true; fi
  rm -rf "$folder"
}
trap finish EXIT
trap 'exit 1' INT TERM
PATH="$PATH:/usr/sbin"
node=$(hostname -s)
user=$(id -un)
# Ports of its own: another Slurm may run here.
port=$((20000 + $$ % 20000))

mkdir "$folder/state" "$folder/spool" "$folder/munge"
dd if=/dev/urandom of="$folder/munge/key" bs=1024 count=1 2>/dev/null
chmod 400 "$folder/munge/key"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
  --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" \
  >"$folder/munged.log" 2>&1 &
daemons="$!"

cat >"$folder/slurm.conf" <<END
ClusterName=nodal
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MailProg=/bin/true
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$node Default=YES State=UP
END
export SLURM_CONF="$folder/slurm.conf"
for attempt in $(seq 100); do
  [ -S "$folder/munge/socket" ] && break
  sleep 0.1
done
slurmctld -D >"$folder/slurmctld.log" 2>&1 &
daemons="$daemons $!"
slurmd -D >"$folder/slurmd.log" 2>&1 &
daemons="$daemons $!"
state=""
for attempt in $(seq 60); do
  state=$(sinfo --noheader --format=%T 2>/dev/null || true)
  [ "$state" = idle ] && break
  sleep 1
done
[ "$state" = idle ] || { echo "the node is '$state', not idle"; exit 1; }

"$nodal" compare "$here/study.toml" --out "$folder/whole" >/dev/null
cd "$folder"
cp "$here/study.toml" study.toml
# The page's script as it stands, but for the number of its tasks and where the program is.
sed -n '/^## A Slurm array/,/^```$/p' "$root/docs/clusters.md" | sed '1,/^```sh/d; /^```$/d' |
  sed "s|--array=0-199|--array=0-3|; s|exec nodal|exec $nodal|" >array.sh
grep -q -- '--array=0-3' array.sh
grep -q -- "$nodal compare study.toml --out results --shard auto" array.sh
sbatch --wait --output="$folder/task-%a.out" array.sh
files=$(find results/trials -name '*.jsonl' | wc -l)
[ "$files" = 4 ] || { echo "$files tasks have written, not 4"; exit 1; }
"$same_trials" whole results

# A step of several tasks, as the page has it, too.
srun --ntasks=2 --overcommit "$nodal" compare study.toml --out steps --shard auto
"$same_trials" whole steps
