#!/usr/bin/env bash
# Set-up, build, and the main job on the samples: lint, compile, inspect, run.
set -euo pipefail
cd "$(dirname "$0")"
./setup.sh
mkdir -p build
cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }
cmake --build --preset release --target axisc
axisc=build/release/bin/axisc

say() { printf '\n\033[1m$ %s\033[0m\n' "$*"; }

say axisc lint samples/mistakes
"$axisc" lint samples/mistakes --cycle-time 1ms && status=0 || status=$?
[ "$status" = 1 ] || { echo "run.sh: the lists with mistakes should give findings, not exit status $status" >&2; exit 1; }
say axisc lint samples/mill samples/manual
"$axisc" lint samples/mill samples/manual --cycle-time 1ms
say axisc compile samples/mill/machine.json -o build/mill.axim
"$axisc" compile samples/mill/machine.json -o build/mill.axim --quiet
ls -l build/mill.axim
say axisc inspect build/mill.axim
"$axisc" inspect build/mill.axim
say axisc run build/mill.axim --signal step --cycles 12
"$axisc" run build/mill.axim --signal step --cycles 12
say "axisc response build/mill.axim --axis X --frequencies 0,10,42,60"
"$axisc" response build/mill.axim --axis X --frequencies 0,10,42,60
