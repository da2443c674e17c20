#!/usr/bin/env bash
# find_package(axisc) and axisc_add_image() from an installed tree.
#   cmake_images.sh SOURCE_TREE BUILD_TREE FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
fail() { echo "cmake_images.sh: $*" >&2; exit 1; }
cmake --install "$build" --component axisc --prefix "$folder/installed" >/dev/null
mv "$folder/installed" "$folder/moved"  # an install tree may lie anywhere
cp -r "$source/samples" "$folder/lists"

for generator in Ninja "Unix Makefiles"; do
  [ "$generator" = Ninja ] || command -v make >/dev/null || continue
  tree="$folder/${generator// /_}"
  cmake -S "$source/examples/cmake" -B "$tree" -G "$generator" -DCMAKE_PREFIX_PATH="$folder/moved" \
    -DAXISC_EXAMPLE_LISTS="$folder/lists" >/dev/null
  run() { cmake --build "$tree" >"$tree.log" 2>&1 || { cat "$tree.log" >&2; fail "$generator: the build failed"; }; }
  run
  for image in mill.axim images/time-delay.axim package/mill.axim; do
    "$folder/moved/bin/axisc" inspect "$tree/$image" >/dev/null || fail "$generator: $image is no image"
  done
  run
  ! grep -q "Compiling the image" "$tree.log" || fail "$generator: a second build compiled something"
  sleep 1.1  # some make programs look at whole seconds
  # A list that the machine file names, which CMake knows only from the dependency file.
  sed -i 's/^Ende/# changed\nEnde/' "$folder/lists/mill/y.lis"
  cp "$tree/package/mill.axim" "$folder/old.axim"
  run
  grep -q "Compiling the image mill" "$tree.log" || fail "$generator: a changed list went unnoticed"
  ! grep -q "Compiling the image time_delay" "$tree.log" || fail "$generator: an image too many was compiled"
  [ "$tree/mill.axim" -nt "$folder/lists/mill/y.lis" ] || fail "$generator: the image is older than its list"
  ! cmp -s "$folder/old.axim" "$tree/package/mill.axim" || fail "$generator: the package holds the old image"
  run
  ! grep -q "Compiling the image" "$tree.log" || fail "$generator: the build does not come to rest"
done
