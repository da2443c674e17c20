#!/usr/bin/env bash
# Emacs with Eglot, the mode of editor/clients/emacs and the program on PATH: it shows what lint says.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$root/samples" "$folder/samples"
# A project of its own: Eglot starts a server for each.
printf '#!/bin/sh\nexec axisc lsp\n' >"$folder/server"
chmod +x "$folder/server"
AXISC_SAMPLES=$folder/samples AXISC_SERVER=$folder/server HOME=$folder timeout 120 emacs -q --batch \
  -L "$root/editor/clients/emacs" -l "$root/tests/editors/emacs.el"
echo "emacs: shows what lint says"
