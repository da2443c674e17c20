#!/usr/bin/env bash
# Adding the folder of an invented rule and nothing else: it is found, explained, tested and documented.
#   invented_rule.sh SOURCE_TREE BUILD_TREE FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
rule=AX2099-nameless-axis code=AX2099
fail() { echo "invented_rule.sh: $*" >&2; exit 1; }
quietly() { "$@" >"$folder/log" 2>&1 || { tail -n 50 "$folder/log" >&2; fail "$1 failed"; }; }
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

# The copy lies as deep as other trees do, so that ccache knows what it compiles; unchanged files keep their times, so that
# a second run of this test builds little.
tree="$folder/tree"
mkdir -p "$tree"
rm -rf "$tree/validator/rules"
(cd "$source" && tar cf - --exclude='./build' --exclude='./.git' --exclude='./bench' --exclude='./tests/data/images' .) | tar xf - -C "$tree"
# What another state of the source had, and this one has not, would still be compiled.
(cd "$tree" && find . -path ./build -prune -o -type f -print) | while IFS= read -r file; do
  [ -e "$source/$file" ] || rm -f "$tree/$file"
done
cp -rp "$source/tests/architecture/invented_rule/$rule" "$tree/validator/rules/"

quietly cmake -S "$tree" -B "$tree/build/release" -G Ninja -DCMAKE_BUILD_TYPE="$(cached CMAKE_BUILD_TYPE)" \
  -DCMAKE_C_COMPILER="$(cached CMAKE_C_COMPILER)" -DCMAKE_CXX_COMPILER="$(cached CMAKE_CXX_COMPILER)" \
  -DCMAKE_C_FLAGS_RELEASE="$(cached CMAKE_C_FLAGS_RELEASE)" -DCMAKE_CXX_FLAGS_RELEASE="$(cached CMAKE_CXX_FLAGS_RELEASE)" \
  -DAXISC_BATCHES="$(cached AXISC_BATCHES)" -DCMAKE_EXE_LINKER_FLAGS="$(cached CMAKE_EXE_LINKER_FLAGS)" -DAXISC_BUILD_TESTS=ON
quietly cmake --build "$tree/build/release" --target axisc test_rules
axisc="$tree/build/release/bin/axisc" test_rules="$tree/build/release/bin/test_rules"

samples="$tree/validator/rules/$rule"
"$axisc" lint "$samples/fail.lis" >"$folder/output" || true
grep -q "$code" "$folder/output" || fail "the failing sample has no finding"
"$axisc" lint "$samples/pass.lis" >"$folder/output" || true
! grep -q "$code" "$folder/output" || fail "the passing sample has a finding"

for language in en de; do
  "$axisc" --lang "$language" explain "$code" >"$folder/output"
  grep -qF "$(cat "$samples/$language.md")" "$folder/output" || fail "there is no page in the language $language"
done

quietly "$test_rules"
echo "1:1 $code" >"$samples/fail.expected"
! "$test_rules" "every rule reports its failing sample*" >"$folder/log" || fail "the failing sample is not tested"
grep -q "$rule" "$folder/log" || fail "the test of the samples fails elsewhere"
cp "$samples/fail.lis" "$samples/pass.lis"
! "$test_rules" "every rule passes its passing sample" >"$folder/log" || fail "the passing sample is not tested"

"$axisc" explain --all >"$folder/rules.md"
grep -qF "| [$code](#$code) | nameless-axis | warning |" "$folder/rules.md" || fail "docs/rules.md would have no row"
