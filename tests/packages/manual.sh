#!/usr/bin/env bash
# Every command has a manual page in both languages, and what formats them has nothing to complain of: manual.sh SHARE AXISC
set -euo pipefail
share=$1 axisc=$2
pages=0
for page in "$share"/man/man1/*.1 "$share"/man/de/man1/*.1; do
  if command -v mandoc >/dev/null; then
    mandoc -T lint "$page"
  fi
  if command -v groff >/dev/null; then
    complaints=$(groff -man -ww -Tutf8 -z "$page" 2>&1)
    [ -z "$complaints" ] || { echo "$page: $complaints"; exit 1; }
  fi
  LC_ALL=C grep -P '[^\x00-\x7F]' "$page" && { echo "$page is not ASCII"; exit 1; }
  pages=$((pages + 1))
done
for command in $("$axisc" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  for folder in man/man1 man/de/man1; do
    [ -f "$share/$folder/axisc-$command.1" ] || { echo "axisc-$command.1 is missing in $folder"; exit 1; }
  done
  while read -r option; do
    grep -qF -- "${option//-/\\-}" "$share/man/man1/axisc-$command.1" || { echo "axisc-$command.1 lacks $option"; exit 1; }
  done < <("$axisc" "$command" --help | grep -oE '^  (-., )?--[a-z-]+' | grep -oE -- '--[a-z-]+')
done
[ "$pages" -gt 30 ]
command -v mandoc >/dev/null || command -v groff >/dev/null || { echo "neither mandoc nor groff is installed: not tried"; exit 77; }
