#!/usr/bin/env bash
# Writes a Ninja file for all axis lists below the working folder, in batches of 100, each with an image beside those of
# its batch:  examples/ninja/generate.sh > build.ninja && ninja
set -euo pipefail
size=${BATCH:-100}
rules=$(dirname "$0")/build.ninja
sed -n '/^ninja_required_version/,/^out_folder/p' "$rules"

escaped() { sed 's/[$: ]/$&/g' <<<"$1"; }

batch=0
inputs=() outputs=()
write_batch() {
  [ ${#inputs[@]} -gt 0 ] || return 0
  batch=$((batch + 1))
  printf 'build %s: images %s\n  batch = %s\n' "${outputs[*]}" "${inputs[*]}" "$batch"
  inputs=() outputs=()
}
while IFS= read -r -d '' list; do
  list=${list#./}
  inputs+=("$(escaped "$list")")
  outputs+=("images/$(escaped "${list%.*}.axim")")
  [ ${#inputs[@]} -lt "$size" ] || write_batch
done < <(find . -path ./images -prune -o -name '*.lis' -print0 | sort -z)
write_batch
