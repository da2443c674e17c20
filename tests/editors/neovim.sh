#!/usr/bin/env bash
# Neovim with the plug-in of editor/clients/neovim and the program on PATH: it shows what lint says, and the server ends with it.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$root/samples" "$folder/samples"
# How the server ended, in a file.
cat >"$folder/server" <<SERVER
#!/bin/sh
axisc lsp
echo \$? >"$folder/status"
SERVER
chmod +x "$folder/server"
AXISC_SAMPLES=$folder/samples HOME=$folder XDG_STATE_HOME=$folder timeout 120 nvim --headless --clean -n \
  --cmd "set runtimepath^=$root/editor/clients/neovim" --cmd "let g:axisc_command = ['$folder/server']" \
  -c "luafile $root/tests/editors/neovim.lua"
for _ in $(seq 100); do
  [ -s "$folder/status" ] && break
  sleep 0.1
done
if [ "$(cat "$folder/status" 2>/dev/null)" != 0 ]; then
  echo "neovim: the server did not end with the editor" >&2
  exit 1
fi
echo "neovim: shows what lint says"
