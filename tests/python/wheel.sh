#!/usr/bin/env bash
# The wheel, installed by pip into an environment of its own, passes the tests of the package, and pip removes it again.
#   wheel.sh SOURCE_TREE FOLDER_OF_WHEEL FOLDER PYTHON AXISC
set -euo pipefail
source=$1 folder=$3 python=$4
export AXISC=$5
wheel=$(echo "$2"/axisc-*.whl)
rm -rf "$folder"
mkdir -p "$folder"
# Nothing but the environment's own package can be found.
unset PYTHONPATH AXISC_LIBRARIES
export PYTHONDONTWRITEBYTECODE=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INDEX=1
if ! "$python" -m venv "$folder/environment" >"$folder/log" 2>&1; then
  cat "$folder/log"
  echo "this Python makes no environments with pip (python3-venv): not tried"
  exit 77
fi
pip() { "$folder/environment/bin/python" -m pip --quiet "$@"; }
pip install --no-compile "$wheel"
pip check >/dev/null
installed=$("$folder/environment/bin/python" -c 'import axisc; print(axisc.__path__[0])')
[[ "$installed" == "$folder"/environment/* ]] || { echo "another package was imported: $installed" >&2; exit 1; }
(cd "$source" && "$folder/environment/bin/python" -m unittest discover -s tests/python)
pip uninstall --yes axisc
! ls -d "$installed" "$(dirname "$installed")"/axisc-* 2>/dev/null || { echo "pip left files of the wheel" >&2; exit 1; }
