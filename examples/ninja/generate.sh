#!/usr/bin/env bash
# Writes a Ninja file with one image per machine below the working folder, and one per list that no machine
# names:
#   examples/ninja/generate.sh [OPTION of axisc compile]... >build.ninja && ninja
# What is a machine, and which files belong to it, says axisc itself: the images are made once here, and the
# rules of its dependency file become edges. Run it again when a machine is added or removed. Findings go to
# standard error; an input with errors has an edge, too, which fails until they are mended.
set -euo pipefail
folder=images
rules=$(dirname "$0")/build.ninja
found=$(mktemp)
trap 'rm -f "$found"' EXIT
axisc compile . --output-folder "$folder" --depfile "$found" --quiet "$@" >&2 || [ $? -eq 1 ]

sed -n '1,/^# Edges/{/^#/!p}' "$rules"
# Each rule is "image: \", and below it the input, then what it is made of. Ninja escapes blanks and colons
# with `$`.
awk -v options="$*" '
  function ninja(name) { gsub(/\\/, "", name); gsub(/[$: ]/, "$&", name); return name }
  / *\\$/ { sub(/ *\\$/, "") }
  /:$/ { sub(/:$/, ""); image = $0; next }
  image != "" {
    sub(/^ */, "")
    printf "build %s: image %s\n", ninja(image), ninja($0)
    if (options != "") printf "  options = --quiet %s\n", options
    image = ""
  }' "$found"
