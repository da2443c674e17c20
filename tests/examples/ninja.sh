#!/usr/bin/env bash
# The Ninja example builds what changed and nothing else.
#   ninja.sh SOURCE_TREE BUILD_TREE FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export PATH="$build/bin:$PATH"

fail() { echo "ninja.sh: $*" >&2; exit 1; }
write_list() {  # NAME FREQUENCY [COMMENT]
  printf 'kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].prototype CRIT_DAMPING\nfilter[0].fg_f0 %s %s\nEnde\n' \
    "$2" "${3:-}" >"$1.lis"
}
build_with() { ninja -f "$1" >out.log || { cat out.log >&2; fail "the build failed"; }; }
is_at_rest() { ninja "$@" >rest.log && grep -q "no work to do" rest.log || fail "there is work for ever: $(cat rest.log)"; }
# Names of the files that are newer than the file "before".
newer() { find "$@" -name '*.axim' -newer before | sort | paste -sd' '; }
mark() {
  sleep 0.02
  touch before
  sleep 0.02
}
expect() { [ "$2" = "$3" ] || fail "$1: expected '$3', got '$2'"; }

mkdir -p mill lathe/listen
for name in mill/x mill/y lathe/listen/z; do write_list $name 20; done
printf '{"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]}' >mill/machine.json
printf 'zahl_mds 1\nachs_mds[0] ./listen/z.lis\n' >lathe/listen/hochlauf.lis
echo '{"cycle_time_us": 1000}' >axisc.json
example="$source/examples/ninja/build.ninja"
build_with "$example"
expect "first build" "$(find delivered -name '*.axim' | sort | paste -sd' ')" "delivered/lathe.axim delivered/mill.axim"
is_at_rest -f "$example"

# A list that means something else: the image of its machine is written and delivered.
mark
write_list mill/x 30
build_with "$example"
expect "a value changed" "$(newer images delivered)" "delivered/mill.axim images/mill.axim"
mark
write_list lathe/listen/z 30
build_with "$example"
expect "a value of a controller changed" "$(newer images delivered)" "delivered/lathe.axim images/lathe.axim"

# A list that is only touched: no image is written, nothing follows.
mark
touch mill/x.lis lathe/listen/z.lis
build_with "$example"
expect "touched" "$(newer images delivered)" ""
is_at_rest -f "$example"

# A comment is a part of the list, and an image holds the digest of its sources: it says which list it was made of. So the
# image is another one.
mark
write_list mill/x 30 '( slower'
build_with "$example"
expect "a comment changed" "$(newer images delivered)" "delivered/mill.axim images/mill.axim"
# A stripped image holds that digest as well.
sed 's/^options = .*/& --strip/' "$example" >strip.ninja
build_with strip.ninja
mark
write_list mill/x 30 '( slower than before'
build_with strip.ninja
expect "a comment changed, stripped" "$(newer images delivered)" "delivered/mill.axim images/mill.axim"

# Settings are not named by any list; the program names them in the rules. Not in a pipe: where grep is done first, ninja fails.
grep -q axisc.json <<<"$(ninja -f strip.ninja -t deps images/mill.axim)" || fail "the settings are no dependency"
mark
echo '{"cycle_time_us": 1000, "disable": ["AX4007"]}' >axisc.json
build_with strip.ninja
grep -q "image images/mill.axim" out.log || fail "changed settings went unnoticed"
expect "settings that change no image" "$(newer images delivered)" ""

# An error stops its machine; the other image is made, and the old one of this machine stays.
mark
printf 'filter[0].order 99\nEnde\n' >mill/x.lis
write_list lathe/listen/z 40
if ninja -k 0 -f strip.ninja >out.log 2>&1; then fail "a list with errors was compiled"; fi
grep -q "AX3001" out.log || fail "the finding is not shown"
expect "with an error" "$(newer images)" "images/lathe.axim"

# The generator makes one image per machine, and one for a list that no machine names.
plant="$folder/plant: 1 # \$a"
mkdir -p "$plant/line 1"
cp -r "$source/samples/controller" "$source/samples/mill" "$plant"
cp -r "$source/samples/controller" "$plant/line 1/lathe"
cp axisc.json "$plant"
write_list "$plant/alone" 20
cd "$plant"
"$source/examples/ninja/generate.sh" --strip >build.ninja 2>generate.log || { cat generate.log >&2; fail "nothing was generated"; }
ninja >out.log || { cat out.log >&2; fail "what was generated cannot be built"; }
is_at_rest
find images -name "*.axim" | sort >images.log
expect "generated" "$(wc -l <images.log)" "$(grep -c "^build " build.ninja)"
grep -qx "images/controller/listen/hochlauf.axim" images.log || fail "the controller has no image"
grep -qx "images/line 1/lathe/listen/hochlauf.axim" images.log || fail "the controller in a folder with a blank has no image"
grep -qx "images/mill/machine.axim" images.log || fail "the machine file has no image"
grep -qx "images/alone.axim" images.log || fail "the list of no machine has no image"
! grep -q "achsmds" images.log || fail "a list of a machine has an image of its own"
touch controller/listen/achsmds1.lis
ninja >out.log
is_at_rest
rm -r images
ninja >out.log
find images -name '*.axim' | sort | cmp - images.log || fail "the edges make other images the second time"
is_at_rest

# A machine with errors has an edge as well, which fails until they are mended.
printf 'filter[0].order 99\n' >alone.lis
"$source/examples/ninja/generate.sh" >build.ninja 2>/dev/null
grep -q "^build images/alone.axim: image alone.lis" build.ninja || fail "a list with errors has no edge"
if ninja >out.log; then fail "a list with errors was compiled"; fi
