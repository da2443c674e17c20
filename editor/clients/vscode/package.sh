#!/usr/bin/env bash
# The extension as a .vsix: ./package.sh FILE. With AXISC_WASM, the folder of axisc.js and axisc.wasm, also for editors in
# browsers; AXISC_HOMEPAGE is the address of the sources, where they have one. The same sources give the same bytes: SOURCE_DATE_EPOCH is the time of the
# last commit that changed them, unless the caller names another.
set -euo pipefail
target=$(realpath -m "${1:-axisc.vsix}")
cd "$(dirname "$0")"
first_time_of_zip=315532800
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct -- . 2>/dev/null)}
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$first_time_of_zip}
node build.mjs
packed=$(mktemp -d)
trap 'rm -rf "$packed"' EXIT
cp -r .vscodeignore package.json package.nls*.json l10n dist syntaxes language-configuration.json icon.png ./*.md LICENSE "$packed"
node - "$packed/package.json" <<'MANIFEST'
const fs = require('fs');
const file = process.argv[2];
const { browser, ...manifest } = JSON.parse(fs.readFileSync(file));
if (process.env.AXISC_WASM) manifest.browser = browser;
else manifest.capabilities.virtualWorkspaces.supported = false;
if (process.env.AXISC_HOMEPAGE) manifest.repository = { type: 'git', url: process.env.AXISC_HOMEPAGE };
fs.writeFileSync(file, JSON.stringify(manifest, null, 2) + '\n');
MANIFEST
vsce=$PWD/node_modules/.bin/vsce
cd "$packed"
"$vsce" package --no-dependencies --allow-missing-repository --out "$target" >/dev/null
