#!/usr/bin/env bash
# Set-up, build, all tests.
set -euo pipefail
cd "$(dirname "$0")"
./setup.sh
mkdir -p build
cmake --preset release -DAXISC_BUILD_TESTS=ON >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
