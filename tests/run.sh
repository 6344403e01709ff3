#!/bin/sh
# On a fresh Debian 12 machine: packages, a Release build, every test. The last lines are CTest's summary. Arguments go to
# CMake.
set -eu
cd "$(dirname "$0")/.."

bench/packages.sh tests
cmake --preset release -DNODAL_TESTS=ON "$@"
cmake --build --preset release
ctest --preset release
