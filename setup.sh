#!/usr/bin/env bash
# Installs what is missing from Debian packages. Does nothing, and needs no rights, where everything is there.
#   ./setup.sh        what building and testing needs
#   ./setup.sh ci     and what the checks need: clang tools, cross compilers, emulators, emscripten, shells, editors, node, a browser
#   ./setup.sh long   and what .ci/long needs: libraries of another processor, tools for packages, LinuxCNC
set -euo pipefail

packages=(
  g++ cmake ninja-build pkg-config
  libboost1.81-dev libfmt-dev nlohmann-json3-dev libcli11-dev libsodium-dev libpugixml-dev zlib1g-dev
  libvalijson-dev
  catch2 librapidcheck-dev
)
if [ "${1:-}" = ci ] || [ "${1:-}" = long ]; then
  packages+=(
    ccache clang clang-format clang-tidy libclang-rt-14-dev
    g++-aarch64-linux-gnu g++-s390x-linux-gnu qemu-user
    clang-tools-14 lld llvm g++-mingw-w64-x86-64-posix wine64
    unzip mandoc groff-base zsh fish python3-jsonschema python3-yaml
    neovim emacs-nox elpa-eglot chromium
    python3-venv
    gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-dev qemu-system-arm
    emscripten lintian
  )
fi
if [ "${1:-}" = ci ] || [ "${1:-}" = long ]; then
  # Whoever has node need not have Debian's.
  command -v node >/dev/null || packages+=(nodejs)
  command -v npm >/dev/null || packages+=(npm)
fi
if [ "${1:-}" = long ]; then
  packages+=(libsodium-dev:arm64 libpugixml-dev:arm64 zlib1g-dev:arm64)
  packages+=(mono-mcs mono-runtime mmdebstrap buildah pre-commit mkdocs-material linuxcnc-uspace linuxcnc-uspace-dev python3-numpy)
fi

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: these packages are missing: ${missing[*]}" >&2
    echo "setup.sh: run 'apt-get install --no-install-recommends ${missing[*]}' as root" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup.sh: installing ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
other_processors() {
  [[ " ${missing[*]} " != *:arm64* ]] || "${as_root[@]}" dpkg --add-architecture arm64
}
if ! { other_processors && "${as_root[@]}" apt-get update &&
       "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
  tail -20 "$log" >&2
  echo "setup.sh: the packages could not be installed" >&2
  exit 1
fi
