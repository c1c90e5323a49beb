# SPDX-License-Identifier: MIT
# Shared by the commands in scripts/, bench/ and .ci/: what they install, how they build, and the two sets of EGL settings they run
# programs with. To be sourced by bash; sets `root` to the top of the checkout.

set -euo pipefail
shopt -s inherit_errexit
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\n== %s\n' "$*"; }
die() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; exit 1; }

# Prints the packages of scripts/packages.txt that are not installed.
missing_packages() {
  local package
  sed 's/#.*//' "$root/scripts/packages.txt" | while read -r package; do
    [ -n "$package" ] || continue
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^.i' || echo "$package"
  done
}

# Installs what is missing, as root or by sudo; does nothing, and needs no rights, when nothing is.
install_missing() {
  command -v dpkg-query >/dev/null || die "this is not Debian: install what scripts/packages.txt names"
  local -a missing as_root=()
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${missing[*]}"
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || die "these packages are missing, and there is no sudo to install them: ${missing[*]}"
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# The build folder of a preset.
build_folder() {
  case $1 in
    release | ci) echo "$root/build" ;;
    *) echo "$root/build-$1" ;;
  esac
}

# Configures and builds a preset: build PRESET [target...]
build() {
  local preset=$1 target
  local -a targets=()
  shift
  for target in "$@"; do targets+=(--target "$target"); done
  say "building the preset '$preset'"
  local log
  log=$(mktemp)
  # The configuration's output matters only when it fails.
  if ! (cd "$root" && cmake --preset "$preset") >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    die "the configuration of the preset '$preset' failed"
  fi
  rm -f "$log"
  cmake --build "$(build_folder "$preset")" "${targets[@]}"
}

clearpipe_manifest=${CLEARPIPE_MANIFEST:-$root/build/icd/clearpipe_icd.json}
mesa_manifest=${MESA_MANIFEST:-/usr/share/glvnd/egl_vendor.d/50_mesa.json}

# Runs a program on one implementation, through libglvnd: on clearpipe|llvmpipe|softpipe command...
on() {
  local which=$1
  shift
  case $which in
    clearpipe)
      [ -e "$clearpipe_manifest" ] || die "there is no $clearpipe_manifest: build first"
      __EGL_VENDOR_LIBRARY_FILENAMES=$clearpipe_manifest "$@"
      ;;
    llvmpipe | softpipe)
      __EGL_VENDOR_LIBRARY_FILENAMES=$mesa_manifest EGL_PLATFORM=surfaceless LIBGL_ALWAYS_SOFTWARE=1 \
        GALLIUM_DRIVER=$which "$@"
      ;;
    *) die "no such implementation: $which" ;;
  esac
}
