#!/bin/sh
# Runs the Gradle release that gradle/wrapper/gradle-wrapper.properties names; the first run downloads and checks it.
# Where it can't be downloaded, runs the gradle on the PATH, which on Debian this installs if need be.
set -eu

properties=$(cd "$(dirname "$0")" && pwd)/gradle/wrapper/gradle-wrapper.properties
property() { sed -n "s/^$1=//p" "$properties" | tr -d '\\\r'; }
url=$(property distributionUrl)
archive=${url##*/}
dists=${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/${archive%.zip}
gradle=$dists/checked/${archive%-*.zip}/bin/gradle

has() { command -v "$1" >/dev/null; }

download() {
    if has curl; then
        curl -fsSL --connect-timeout 5 -o "$archive" "$url"
    else
        wget -q --timeout=5 --tries=1 -O "$archive" "$url"
    fi 2>/dev/null
}

verify() {
    sum=$(if has sha256sum; then sha256sum "$archive"; else shasum -a 256 "$archive"; fi | cut -d ' ' -f 1)
    [ "$sum" = "$(property distributionSha256Sum)" ] || { echo "gradlew: not the pinned checksum: $url" >&2; false; }
}

unpack() {
    if has unzip; then unzip -q "$archive"; else jar xf "$archive"; fi && rm "$archive" && chmod +x gradle-*/bin/gradle
}

# In a folder of its own, so that an interrupted run leaves nothing half done.
fetch() (
    mkdir -p "$dists" && new=$(mktemp -d "$dists/new.XXXXXX") || exit
    trap 'rm -rf "$new"' EXIT
    cd "$new" && download && verify && unpack && { [ -e ../checked ] || mv "$new" ../checked; }
)

debian() {
    has apt-get || { echo 'gradlew: found no Gradle, and could download none' >&2; exit 1; }
    [ "$(id -u)" = 0 ] && root= || root='sudo -n'
    $root apt-get -qq update >&2
    $root apt-get -qq install --no-install-recommends gradle $(has javac || echo default-jdk-headless) >&2
}

[ -x "$gradle" ] || fetch || gradle=gradle
has "$gradle" || debian
exec "$gradle" "$@"
