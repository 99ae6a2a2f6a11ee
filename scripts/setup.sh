#!/bin/sh
# Installs the Debian packages of packages.txt that are missing, and the npm packages of apps/rhino, apps/report
# and tests/dxf. Needs root or sudo only if a package is missing.
set -eu
cd "$(dirname "$0")"

# The packages that the package.json of a folder names.
install_npm() {
    (
        cd "../$1"
        stamp=node_modules/.ripstop-setup
        [ "$stamp" -nt package-lock.json ] && exit
        if ! npm ci --no-audit --no-fund --loglevel=error; then
            echo "setup: npm could not install what $1 needs; is there a connection to the registry?" >&2
            exit 1
        fi
        touch "$stamp"
    )
}

install_all_npm() {
    install_npm apps/rhino
    install_npm apps/report
    install_npm tests/dxf
}

missing=""
for package in $(sed 's/#.*//' packages.txt); do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $package"
done
# Some distributions of Node.js include npm; Debian's does not.
command -v npm > /dev/null || missing="$missing npm"
if [ -z "$missing" ]; then
    install_all_npm
    exit 0
fi
as_root=""
[ "$(id -u)" = 0 ] || as_root=sudo
echo "Installing:$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=500 install -y -q --no-install-recommends $missing
install_all_npm
