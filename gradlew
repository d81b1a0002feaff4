#!/bin/sh
# Runs the Gradle release that gradle/wrapper/gradle-wrapper.properties names; the first run downloads and checks it.
# Where it can't be downloaded, runs the gradle on the PATH, which on Debian this installs if need be.
set -eu

# What is given and typed is UTF-8, whatever locale cron or ssh set.
[ "$(locale charmap 2>/dev/null)" = UTF-8 ] || export LC_ALL=C.UTF-8

properties=$(cd "$(dirname "$0")" && pwd)/gradle/wrapper/gradle-wrapper.properties
property() { sed -n "s/^$1=//p" "$properties" | tr -d '\\\r'; }
url=$(property distributionUrl)
archive=${url##*/}
dists=${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/${archive%.zip}
gradle=$dists/checked/${archive%-*.zip}/bin/gradle
OTHER_CHECKSUM=3

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
    pinned=$(property distributionSha256Sum)
    [ "$sum" = "$pinned" ] && return
    echo "gradlew: wrong checksum: what $url gave has the SHA-256 sum" >&2
    echo "gradlew: $sum, and gradle-wrapper.properties asks for" >&2
    echo "gradlew: $pinned. It was thrown away. A proxy may have answered instead; try again." >&2
    exit "$OTHER_CHECKSUM"
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

# Says what to do by hand when nothing could be set up.
give_up() {
    echo "gradlew: $1" >&2
    echo "gradlew: install a JDK 17 or later and Gradle (Debian: apt-get install gradle default-jdk-headless; elsewhere any" >&2
    echo "gradlew: Gradle 4.4 to 9 on the PATH), or let this machine reach $url, and run the same command again." >&2
    exit 1
}

debian() {
    has apt-get || give_up "cannot find $1, and this machine has no apt-get to install it with"
    [ "$(id -u)" = 0 ] && root= || root='sudo -n'
    echo "gradlew: cannot find $1; installing Debian's package" >&2
    export DEBIAN_FRONTEND=noninteractive
    { $root apt-get -qq update && $root apt-get -qq install --no-install-recommends "$2"; } >&2 ||
        give_up "apt-get could not install $2"
}

has javac || [ -x "${JAVA_HOME:-/none}/bin/javac" ] || debian 'a Java compiler (javac)' default-jdk-headless

# Gradle's process ends before the JVM's second compiler has earned what it costs.
export GRADLE_OPTS="${GRADLE_OPTS--XX:TieredStopAtLevel=1 -XX:+UseSerialGC}"

# The server greets a newcomer on a terminal; behind Gradle it can't see one itself.
[ -t 1 ] && set -- -Pterminal "$@"

status=0
[ -x "$gradle" ] || fetch || status=$?
[ "$status" != "$OTHER_CHECKSUM" ] || exit 1
[ "$status" = 0 ] && exec "$gradle" "$@"

has gradle || debian 'Gradle' gradle
echo "gradlew: can't download ${archive%-*.zip}, so this runs the gradle on the PATH; its first run takes a minute or two" >&2
# A daemon of an old Gradle gives programs the environment in which the daemon was started: no DISPLAY. Where it only starts a
# program, its warnings about class files that are younger than itself would hide what the program says.
case " $* " in *' run '* | *' play '* | *' bots '* | *' replay '* | *' render '* | *' bench '* | *' figures '*) set -- -q "$@" ;; esac
set -- --no-daemon "$@"
# Debian's script prints the version of Java on each start, so this does what the script does afterwards.
launcher=/usr/share/gradle/lib/gradle-launcher-4.4.1.jar
if [ "$(readlink -f "$(command -v gradle)")" = /usr/share/gradle/bin/gradle ] && [ -e "$launcher" ]; then
    exec "${JAVA_HOME:+$JAVA_HOME/bin/}java" --add-opens java.base/java.lang=ALL-UNNAMED ${JAVA_OPTS:-} ${GRADLE_OPTS:-} \
        -Dorg.gradle.appname=gradle -classpath "$launcher" org.gradle.launcher.GradleMain "$@"
fi
exec gradle "$@"
