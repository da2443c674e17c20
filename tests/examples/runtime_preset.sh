#!/usr/bin/env bash
# What a controller engineer does first: the runtime alone from the sources, installed, and a program of his own. Nothing
# of the tool is built; the image comes from the tree that is tested. What that tree has compiled, ccache knows here.
#   runtime_preset.sh SOURCE_TREE BUILD_TREE FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
cd "$source"
cmake --preset runtime >"$folder/configure.txt"
cmake --build --preset runtime >"$folder/build.txt" || { cat "$folder/build.txt" >&2; exit 1; }
cmake --install build/runtime --component axisrt --prefix "$folder/axisrt" >/dev/null

export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$folder/axisrt" -name axisrt.pc)")
# Options are words on purpose.
# shellcheck disable=SC2046
cc $(pkg-config --cflags axisrt) "$source/examples/record.c" "$source/examples/image_file.c" $(pkg-config --libs axisrt) \
  -o "$folder/record"
"$build/bin/axisc" compile --quiet "$source/samples/mill/machine.json" --strip -o "$folder/mill.axim" 2>/dev/null
"$folder/record" "$folder/mill.axim" "$folder/jump.axrd" | grep -qx 'cycle 500: AXISRT_IMPLAUSIBLE'
