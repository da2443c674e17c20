#!/usr/bin/env bash
# Lints the lists below a folder on a Slurm cluster and waits for the report:
#   examples/slurm/submit.sh LISTS [SHARDS]
# Working folder, lists and axisc are on a file system that all nodes see. Exit status: that of `axisc lint`.
#
# Starting an array task costs about half a second, and a node checks thousands of lists per second: few large shards are
# better than many small ones. Variables: FORMAT (json or sarif), CACHE (a folder), OPTIONS (of lint).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
export LISTS=$1 FORMAT=${FORMAT:-json}
shards=${2:-4}
rm -rf shards "report.$FORMAT"
mkdir shards
array=$(sbatch --parsable --array="1-$shards" "$here/lint.sbatch")
# The merge step runs whatever the shards find: they end with 0 when they have a result.
sbatch --wait --dependency="afterany:$array" "$here/merge.sbatch"
