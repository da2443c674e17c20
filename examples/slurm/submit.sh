#!/usr/bin/env bash
# Lints folders on a Slurm cluster, one array task each, and waits for the report:
#   examples/slurm/submit.sh FOLDER...
# Findings are in report.jsonl, in the order of the folders. Working folder, lists and axisc are on a file
# system that all nodes see. Exit status: the worst of the tasks, as of `axisc lint`. Variable: OPTIONS (of
# axisc lint).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
rm -rf found report.jsonl
mkdir found
printf '%s\n' "$@" >folders.txt
status=0
sbatch --wait --array="1-$#" "$here/lint.sbatch" || status=$?
for ((task = 1; task <= $#; ++task)); do
  [ -e "found/$task.jsonl" ] || { echo "${!task} was not checked; see found/$task.log" >&2; exit 2; }
  cat "found/$task.jsonl" >>report.jsonl
done
exit "$status"
