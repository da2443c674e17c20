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
# Names of the files that are newer than the file "before".
newer() { find "$@" -name '*.axim' -newer before | sort | paste -sd' '; }
mark() {
  sleep 0.02
  touch before
  sleep 0.02
}
expect() { [ "$2" = "$3" ] || fail "$1: expected '$3', got '$2'"; }

for name in a b c; do write_list "$name" 20; done
example="$source/examples/ninja/build.ninja"
build_with "$example"
expect "first build" "$(find delivered -name '*.axim' | sort | paste -sd' ')" "delivered/a.axim delivered/b.axim delivered/c.axim"

build_with "$example"
grep -q "no work to do" out.log || fail "a second build did something: $(cat out.log)"

# A list that means something else: one image is written, one delivered.
mark
write_list b 30
build_with "$example"
expect "a value changed" "$(newer images delivered)" "delivered/b.axim images/b.axim"

# A list that is only touched: the batch runs, no image is written, nothing follows.
mark
touch c.lis
build_with "$example"
expect "touched" "$(newer images delivered)" ""
build_with "$example"
grep -q "no work to do" out.log || fail "after a touch there is work for ever"

# A comment is a part of the list, and an image holds the digest of its sources: it says which list it was made of. So the
# image is another one.
mark
write_list b 30 '( slower'
build_with "$example"
expect "a comment changed" "$(newer images delivered)" "delivered/b.axim images/b.axim"
# A stripped image holds that digest as well.
sed 's/^options = .*/& --strip/' "$example" >strip.ninja
build_with strip.ninja
mark
write_list b 30 '( slower than before'
build_with strip.ninja
expect "a comment changed, stripped" "$(newer images delivered)" "delivered/b.axim images/b.axim"

# Settings and schema files are not named by any list; the program names them in the rules.
echo '{"build": "V3.1.3080.00"}' >axisc.json
build_with strip.ninja
mark
touch a.lis
build_with strip.ninja
# Not in a pipe: where grep is done first, ninja fails.
grep -q axisc.json <<<"$(ninja -f strip.ninja -t deps images/a.axim)" || fail "the settings are no dependency"
mark
echo '{"build": "V3.1.3080.00", "disable": ["AX4007"]}' >axisc.json
build_with strip.ninja
grep -q "batch 1" out.log || fail "changed settings went unnoticed"
expect "settings that change no image" "$(newer images delivered)" ""

# An error stops the batch; the images of the other lists are there, and of this one the old image stays.
mark
printf 'filter[0].order 99\nEnde\n' >a.lis
write_list c 40
if ninja -f strip.ninja >out.log 2>&1; then fail "a list with errors was compiled"; fi
grep -q "AX3001" out.log || fail "the finding is not shown"
expect "with an error" "$(newer images)" "images/c.axim"

# The generator makes the same for a whole folder.
mkdir -p plant/line\ 1
mv a.lis b.lis c.lis plant
write_list plant/a 20
cp plant/a.lis "plant/line 1/x.lis"
(cd plant && BATCH=2 "$source/examples/ninja/generate.sh" >build.ninja && ninja >../out.log)
expect "generated" "$(cd plant/images && find . -name '*.axim' | sort | paste -sd'|')" "./a.axim|./b.axim|./c.axim|./line 1/x.axim"
