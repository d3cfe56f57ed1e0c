# Sourced by the scripts of this folder and of verification/: goes to the root of the project, installs the packages that are missing
# (nothing missing: nothing is asked of the network) and gives them what follows.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." > /dev/null

say() { printf '== %s\n' "$*"; }

is_installed() { dpkg-query --show --showformat='${db:Status-Status}\n' "$1" 2> /dev/null | grep -qx installed; }

# install_missing_packages PACKAGE...
install_missing_packages() {
  local package missing=() as_root=()
  for package; do
    is_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0

  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo > /dev/null; then
      say "these packages are missing; install them as root, or install sudo: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  say "installing ${#missing[@]} missing packages: ${missing[*]}"
  "${as_root[@]}" apt-get update --quiet || say "the package lists could not be renewed; going on with the old ones" >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --quiet --yes --no-install-recommends "${missing[@]}"
}

# build TARGET: configures the release preset, with warnings as errors (this is Debian 12 with its gcc 12), and builds one of its targets.
build() {
  say "configuring and building the release preset in build/release (target $1)"
  cmake --preset release -D CMAKE_COMPILE_WARNING_AS_ERROR=ON
  cmake --build --preset release --parallel "$(nproc)" --target "$1"
}

# run_tests PRESET [ctest options]
run_tests() { ctest --test-dir "build/$1" --output-on-failure --no-tests=error -j"$(nproc)" "${@:2}"; }

mapfile -t packages < <(grep -v '^#' tools/packages.txt | grep .)
install_missing_packages "${packages[@]}"
