#!/bin/sh
# On a fresh Debian 12 machine: packages, a Release build, the default comparison, its table and report.
set -eu
cd "$(dirname "$0")/.."

bench/packages.sh demo
echo "building (the first time takes some minutes)"
mkdir -p build
# Ten sources are compiled at a time: nobody changes them here.
if ! { cmake --preset release -DNODAL_TESTS=OFF -DNODAL_MICRO=OFF -DCMAKE_UNITY_BUILD=ON \
         -DCMAKE_UNITY_BUILD_BATCH_SIZE=10 -B build/demo && cmake --build build/demo; } >build/demo.log 2>&1; then
  tail -n 30 build/demo.log >&2
  echo "the build failed; all of its output is in build/demo.log" >&2
  exit 1
fi
exec build/demo/bench/nodal compare bench/scenes/plate.toml "$@"
