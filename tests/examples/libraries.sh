#!/usr/bin/env bash
# The shared libraries show what their headers declare and nothing else, need what they may need, and an example in C
# that links them (by CMake shared and static, by pkg-config) gives what the program gives.
#   libraries.sh SOURCE_TREE BUILD_TREE FOLDER CC
set -euo pipefail
source=$1 build=$2 folder=$3
export CC=$4
rm -rf "$folder"
mkdir -p "$folder"
for component in libaxisc libaxisc_dev axisrt axisrt_shared axisrt_shared_dev; do
  cmake --install "$build" --component "$component" --prefix "$folder/installed" >/dev/null
done
mv "$folder/installed" "$folder/moved"  # an install tree may lie anywhere
fail() { echo "$1" >&2; exit 1; }

# Every name that the header declares, with the version of the script, and every name that the package's list of
# symbols promises: who changes or removes one sees it here.
shows() {
  local library=$1 version=$2 header=$3 prefix=$4 symbols=$source/cmake/debian/$5.symbols.in
  nm --dynamic --defined-only --format=posix "$library" | awk '$2 != "A" {print $1}' | LC_ALL=C sort >"$folder/shown.txt"
  grep -oE "^[a-z_0-9 *]+ \**${prefix}_[a-z_]+\(" "$header" | grep -oE "${prefix}_[a-z_]+\(" | sed "s/($/@@$version/" |
    LC_ALL=C sort -u >"$folder/declared.txt"
  [ "$(wc -l <"$folder/declared.txt")" -gt 10 ] || fail "$header declares hardly anything"
  diff "$folder/declared.txt" "$folder/shown.txt" >&2 || fail "$library does not show what $header declares"
  sed -n "s/^ \(${prefix}_[a-z_]*\)@$version [0-9.]*$/\1@@$version/p" "$symbols" | LC_ALL=C sort >"$folder/promised.txt"
  diff "$folder/promised.txt" "$folder/shown.txt" >&2 || fail "$library does not show what $symbols promises"
}
axisc=$(find "$folder/moved" -name 'libaxisc.so.?') axisrt=$(find "$folder/moved" -name 'libaxisrt.so.?')
shows "$axisc" AXISC_0 "$folder/moved/include/axisc.h" axisc libaxisc0
shows "$axisrt" AXISRT_5 "$folder/moved/include/axisrt.h" axisrt libaxisrt5
readelf --dynamic "$axisrt" | grep -F '(NEEDED)' | grep -vF 'libc.so' >&2 && fail "libaxisrt.so needs more than the C library"

# Structures and numbers: programs that were compiled before rely on them.
cat >"$folder/layout.c" <<'C'
#include <axisc.h>
#include <axisrt.h>
#define SAME(number, value) _Static_assert((number) == (value), #number)
SAME(AXISC_FINDINGS, 1); SAME(AXISC_BAD_ARGUMENT, -1); SAME(AXISC_NOT_FOUND, -2); SAME(AXISC_UNUSABLE, -3);
SAME(AXISC_CANCELLED, -4); SAME(AXISC_BUSY, -5); SAME(AXISC_NO_MEMORY, -6); SAME(AXISC_INTERNAL, -7);
SAME(AXISC_ENDED, 2); SAME(AXISC_BROKEN_OFF, 3); SAME(AXISC_FIX_ALL, 1);
#if defined(__LP64__)
SAME(sizeof(axisc_bytes), 16); SAME(sizeof(axisc_files), 32); SAME(offsetof(axisc_files, read), 16);
SAME(sizeof(axisrt_config), 64); SAME(offsetof(axisrt_config, verify_signature), 48);
SAME(sizeof(axisrt_filter_command), 40); SAME(sizeof(axisrt_velocities), 32); SAME(sizeof(axisrt_axis_state), 72);
#endif
int layout;
C
"$CC" -std=c11 -c -I"$folder/moved/include" "$folder/layout.c" -o "$folder/layout.o"

cmake -S "$source/examples" -B "$folder/by_cmake" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$folder/moved" \
  -DAXISRT_EXAMPLES_CXX=OFF -DCMAKE_C_FLAGS="-Wall -Wextra -Wpedantic -Werror" >/dev/null
cmake --build "$folder/by_cmake" --target check_and_compile check_and_compile_static >"$folder/by_cmake.log" ||
  { cat "$folder/by_cmake.log" >&2; exit 1; }
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$folder/moved" -name axisc.pc)")
# Options are words on purpose.
# shellcheck disable=SC2046
"$CC" -std=c11 -Wall -Wextra -Wpedantic -Werror $(pkg-config --cflags axisc) "$source/examples/check_and_compile.c" \
  $(pkg-config --libs axisc) -o "$folder/by_pkg_config"

cd "$source"
"$build/bin/axisc" compile samples/mill -o "$folder/mill.axim" --quiet 2>/dev/null
"$build/bin/axisc" lint samples/mill/machine.json --format json >"$folder/mill.json" 2>/dev/null
"$build/bin/axisc" lint samples/mistakes/typing.lis --cycle-time 1ms --format json >"$folder/typing.json" 2>/dev/null || true
for program in by_cmake/check_and_compile by_cmake/check_and_compile_static by_pkg_config; do
  run() { LD_LIBRARY_PATH=$(dirname "$axisc") "$folder/$program" "$@"; }
  run samples/mill/machine.json "$folder/out.axim" >"$folder/out.json"
  diff "$folder/mill.json" "$folder/out.json" >&2 || fail "$program finds what lint does not find"
  cmp "$folder/mill.axim" "$folder/out.axim" || fail "$program compiles another image"
  run samples/mistakes/typing.lis "$folder/none.axim" >"$folder/out.json" && fail "$program overlooks errors"
  diff "$folder/typing.json" "$folder/out.json" >&2 || fail "$program finds what lint does not find"
  [ ! -e "$folder/none.axim" ] || fail "$program wrote an image of a list with errors"
  status=0
  run samples/none "$folder/none.axim" >/dev/null 2>"$folder/error.txt" || status=$?
  [ "$status" = 2 ] && grep -q 'samples/none' "$folder/error.txt" || fail "$program does not say what is missing"
done
