#!/usr/bin/env bash
# Installs the runtime into a tree of its own, then builds and runs the examples as another project would: through
# find_package (C alone, and with C++) and through pkg-config.
#   embedding.sh SOURCE_TREE BUILD_TREE FOLDER CC CXX
set -euo pipefail
source=$1 build=$2 folder=$3
export CC=$4 CXX=$5
rm -rf "$folder"
mkdir -p "$folder"
cmake --install "$build" --component axisrt --prefix "$folder/installed" >/dev/null
mv "$folder/installed" "$folder/moved"  # an install tree may lie anywhere
"$build/bin/axisc" compile --quiet "$source/samples/mill/machine.json" -o "$folder/mill.axim" 2>/dev/null

build_examples() {
  cmake -S "$source/examples" -B "$folder/$1" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$folder/moved" \
    -DCMAKE_C_FLAGS="-Wall -Wextra -Wpedantic -Werror" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" "${@:2}" >/dev/null
  cmake --build "$folder/$1" >"$folder/$1.log" || { cat "$folder/$1.log" >&2; exit 1; }
}
build_examples with_cxx
build_examples c_alone -DAXISRT_EXAMPLES_CXX=OFF -DCMAKE_CXX_COMPILER=/nowhere

export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$folder/moved" -name axisrt.pc)")
# Options are words on purpose.
# shellcheck disable=SC2046
"$CC" -std=c11 $(pkg-config --cflags axisrt) "$source/examples/filter_in_c.c" "$source/examples/image_file.c" \
  $(pkg-config --libs axisrt) -o "$folder/filter_by_pkg_config"

"$build/bin/axisc" run "$folder/mill.axim" --level auto --signal step --amplitude 1000 --cycles 30 |
  awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) if ($i !~ /\./ && $i != "cycle") use[i] = 1}
           NR > 1 {line = NR - 2; for (i = 1; i <= NF; ++i) if (i in use) line = line " " sprintf("%.17g", $i); print line}' \
  >"$folder/expected.txt"
for program in with_cxx/filter_in_c with_cxx/filter_in_cxx c_alone/filter_in_c filter_by_pkg_config; do
  "$folder/$program" "$folder/mill.axim" 30 >"$folder/out.txt"
  diff "$folder/expected.txt" "$folder/out.txt" >&2 || { echo "$program differs from axisc run" >&2; exit 1; }
done

"$folder/with_cxx/cyclic_task" "$folder/mill.axim" 300 2>/dev/null

# The recording ends with the jump, and is executed again bit for bit.
"$folder/with_cxx/record" "$folder/mill.axim" "$folder/jump.axrd" | grep -qx 'cycle 500: AXISRT_IMPLAUSIBLE'
"$build/bin/axisc" replay "$folder/mill.axim" "$folder/jump.axrd" --lang en >"$folder/replay.txt"
grep -q 'every output is the same, bit for bit' "$folder/replay.txt"

# Two images of one axis that may change over in motion; those of the mill may not.
for frequency in 25 40; do
  printf '%s\n' 'kopf.achs_nr 1' 'kopf.log_achs_name X' 'kenngr.achs_typ 1' 'getriebe[0].dynamik.vb_max 200000' \
    'getriebe[0].dynamik.a_max 2000' 'filter[0].enable 1' 'filter[0].order 2' 'filter[0].prototype CRIT_DAMPING' \
    'filter[0].type LOWPASS' "filter[0].fg_f0 $frequency" >"$folder/x$frequency.lis"
  "$build/bin/axisc" compile --quiet "$folder/x$frequency.lis" --cycle-time 1ms -o "$folder/x$frequency.axim" 2>/dev/null
done
"$folder/with_cxx/change_image" "$folder/x25.axim" "$folder/x40.axim" >"$folder/change.txt"
# 20 units a cycle, and no output moves faster than by the quarter more that a change may add.
awk '/done/ {done = 1} /largest move/ {largest = $NF} END {exit !(done && largest >= 20 && largest <= 25)}' "$folder/change.txt"
if "$folder/with_cxx/change_image" "$folder/mill.axim" "$folder/mill.axim" >"$folder/change.txt"; then
  echo "the mill changed over in motion" >&2
  exit 1
fi
grep -q AXISRT_NEEDS_STANDSTILL "$folder/change.txt"

# Signed, unsigned, changed, signed with another key, and older than the controller has seen.
if [ -x "$folder/c_alone/signed_image" ]; then
  "$build/bin/axisc" compile --quiet --image-version 7 "$source/samples/mill/machine.json" -o "$folder/signed.axim" 2>/dev/null
  cp "$folder/signed.axim" "$folder/unsigned.axim"
  "$build/bin/axisc" keygen "$folder/plant.key" >/dev/null 2>&1
  "$build/bin/axisc" keygen "$folder/other.key" >/dev/null 2>&1
  "$build/bin/axisc" sign "$folder/signed.axim" --key "$folder/plant.key" >/dev/null 2>&1
  says() { { "$folder/c_alone/signed_image" "${@:2}" || true; } | grep -q "^$1:" || { echo "signed_image ${*:2} does not say $1" >&2; exit 1; }; }
  says AXISRT_OK "$folder/signed.axim" "$folder/plant.key.pub" 7
  says AXISRT_UNSIGNED "$folder/unsigned.axim" "$folder/plant.key.pub" 7
  says AXISRT_WRONG_SIGNATURE "$folder/signed.axim" "$folder/other.key.pub" 7
  says AXISRT_OLDER_IMAGE "$folder/signed.axim" "$folder/plant.key.pub" 8
fi

# What `axisc export` writes links the installed runtime in C99, too.
"$build/bin/axisc" export "$folder/mill.axim" --to c -o "$folder/exported" 2>/dev/null
"$CC" -std=c99 -I"$(dirname "$(find "$folder/moved" -name axisrt_c.h)")" "$folder/exported/example.c" "$folder/exported/machine.c" \
  "$(find "$folder/moved" -name libaxisrt_c.a)" -o "$folder/example"
[ "$("$folder/example" | wc -l)" = 100 ]
if "$folder/c_alone/filter_in_c" "$source/README.md" 2>"$folder/refused.txt"; then
  echo "a text was taken for an image" >&2
  exit 1
fi
grep -q AXISRT_WRONG_MAGIC "$folder/refused.txt"
