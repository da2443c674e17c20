#!/usr/bin/env bash
# Writes a Ninja file with one image per machine below the working folder, and one per list of no machine:
#   examples/ninja/generate.sh [OPTION of axisc compile]... >build.ninja && ninja
# axisc itself says what a machine is: here it makes the images once, elsewhere, and the rules of its dependency
# file become edges. Run it again when a machine is added or removed. Findings go to standard error; an input with
# errors has an edge, too, which fails until they are mended.
set -euo pipefail
folder=$(env -u TMPDIR mktemp -d)    # a name that no rule escapes
trap 'rm -rf "$folder"' EXIT
axisc compile . --output-folder "$folder" --depfile "$folder/rules" --quiet "$@" >&2 || [ $? -eq 1 ]

sed -n '1,/^# Edges/{/^#/!p}' "$(dirname "$0")/build.ninja"
# A rule is "FOLDER/IMAGE: \", the input, and below it what else the image is made of. Ninja escapes with `$`.
awk -v options="$*" -v skipped=$((${#folder} + 1)) '
  function ninja(name) {
    gsub(/\\/, "", name)
    gsub(/\$\$/, "$", name)
    gsub(/[$: ]/, "$&", name)
    return name
  }
  { sub(/ \\$/, "") }
  /^[^ ].*:$/ { image = substr($0, skipped + 1, length($0) - skipped - 1); next }
  image != "" {
    printf "build images/%s: image %s\n", ninja(image), ninja(substr($0, 3))
    if (options != "") printf "  options = --quiet %s\n", options
    image = ""
  }' "$folder/rules"
