#!/usr/bin/env bash
# The extension as a .vsix: ./package.sh FILE. The same sources give the same bytes: SOURCE_DATE_EPOCH is the time of the
# last commit that changed them, unless the caller names another.
set -euo pipefail
target=$(realpath -m "${1:-axisc.vsix}")
cd "$(dirname "$0")"
first_time_of_zip=315532800
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct -- . 2>/dev/null)}
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$first_time_of_zip}
node build.mjs
node_modules/.bin/vsce package --no-dependencies --allow-missing-repository --out "$target" >/dev/null
