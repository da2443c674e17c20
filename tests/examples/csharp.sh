#!/usr/bin/env bash
# The example in C#, compiled and run by Mono, gives what the program gives. Where Mono is missing, the test says so.
#   csharp.sh SOURCE_TREE BUILD_TREE FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
command -v mcs >/dev/null && command -v mono >/dev/null || { echo "mono-mcs and mono-runtime are not installed: not tried"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
fail() { echo "$1" >&2; exit 1; }
mcs -warn:4 -warnaserror "$source/examples/CheckAndCompile.cs" -out:"$folder/CheckAndCompile.exe"
run() { LC_ALL=C.UTF-8 LD_LIBRARY_PATH="$build/lib" mono "$folder/CheckAndCompile.exe" "$@"; }
cd "$source"

cp -r samples/mill "$folder/Fräse"
for input in samples/mill/machine.json "$folder/Fräse/machine.json"; do
  "$build/bin/axisc" compile "$input" -o "$folder/wanted.axim" --quiet 2>/dev/null
  "$build/bin/axisc" lint "$input" --format json >"$folder/wanted.json" 2>/dev/null
  run "$input" "$folder/out.axim" >"$folder/out.json"
  diff "$folder/wanted.json" "$folder/out.json" >&2 || fail "the example finds what lint does not find"
  cmp "$folder/wanted.axim" "$folder/out.axim" || fail "the example compiles another image"
done
run samples/mistakes/typing.lis "$folder/none.axim" >"$folder/out.json" && fail "the example overlooks errors"
"$build/bin/axisc" lint samples/mistakes/typing.lis --cycle-time 1ms --format json >"$folder/wanted.json" 2>/dev/null || true
diff "$folder/wanted.json" "$folder/out.json" >&2 || fail "the example finds what lint does not find"
[ ! -e "$folder/none.axim" ] || fail "the example wrote an image of a list with errors"
status=0
run samples/none "$folder/none.axim" >/dev/null 2>"$folder/error.txt" || status=$?
[ "$status" = 2 ] && grep -q 'samples/none' "$folder/error.txt" || fail "the example does not say what is missing"
