# shellcheck shell=sh
# Shell functions of the toolchain's scripts; the caller sets `root` to the checkout.
: "${root:?}"

say() {
  printf '\n== %s\n' "$*"
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    echo "Installing packages needs root or sudo, and there is neither. Please have this run: $*" >&2
    return 1
  fi
}

# Installs the missing packages of packages.txt and lists them.
install_packages() {
  packages="$(sed 's/#.*//' "$root/toolchain/packages.txt" | tr -s ' \n' ' ')"
  if ! command -v dpkg-query > /dev/null; then
    say "Not a Debian system: please see to the equivalents of these packages:$packages"
    return
  fi
  missing=""
  for package in $packages; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null)" != installed ]; then
      missing="$missing $package"
    fi
  done
  if ! command -v npm > /dev/null; then
    missing="$missing nodejs npm" # for the panel's page; not in the list, since npm may come with another Node.js
  fi
  if [ -z "$missing" ]; then
    say "All packages of toolchain/packages.txt are installed"
    return
  fi
  say "Installing what building and testing need and this system lacks:$missing"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
  # shellcheck disable=SC2086 # word splitting is intended
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
}

# build PRESET [TARGET]: configures and builds into build/PRESET.
build() {
  say "Configuring build/$1"
  (cd "$root" && cmake --preset "$1")
  # Deletes precompiled headers older than the last package change: installed headers keep their packages' older dates,
  # so ninja would not rebuild.
  if [ -f /var/lib/dpkg/status ]; then
    find "$root/build/$1" -name '*.pch' ! -newer /var/lib/dpkg/status -delete
  fi
  say "Building ${2:-everything} in build/$1"
  # One compiler per processor: ninja's two more cost more in memory and caches than they fill.
  (cd "$root" && cmake --build --preset "$1" -j"$(nproc)" ${2:+--target "$2"})
}
