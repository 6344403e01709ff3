#!/bin/sh
# Installs the Debian packages that nodal needs and that are missing: `bench/packages.sh demo` for building and running,
# `tests` for the tests on top, `ci` for the extra builds, `slurm` for `ctest -L slurm` alone. Says what it installs; does
# nothing when all is there.
set -eu

demo="g++ cmake ninja-build git libsuitesparse-dev libopenblas0-serial libeigen3-dev libnlopt-dev libnlopt-cxx-dev
      libceres-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libfmt-dev libboost-dev libjs-vega libbenchmark-dev
      libcgal-dev"
tests="libgtest-dev chromium openmpi-bin"
slurm="slurmctld slurmd slurm-client munge"
ci="clang-14 clang-format-14 clang-tidy-14 libclang-rt-14-dev llvm-14 ccache"

case "${1:-demo}" in
  demo) wanted="$demo" ;;
  tests) wanted="$demo $tests" ;;
  ci) wanted="$demo $tests $ci" ;;
  slurm) wanted="$slurm" ;;
  *) echo "usage: $0 [demo|tests|ci|slurm]" >&2; exit 2 ;;
esac

missing=""
for package in $wanted; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" = 0 ]; then
  as_root=""
elif command -v sudo >/dev/null; then
  as_root="sudo"
else
  echo "nodal needs packages that only root can install, and there is no sudo:$missing" >&2
  exit 2
fi
echo "installing:$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export DEBIAN_FRONTEND=noninteractive
install() { $as_root apt-get install --yes --no-install-recommends $missing; }
# A fresh machine has no package lists; one with lists need not fetch them again.
if ! { install || { $as_root apt-get update && install; }; } >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "the packages could not be installed:$missing" >&2
  exit 2
fi
