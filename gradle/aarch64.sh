#!/bin/sh
# Runs a Java program on an AArch64 JDK that QEMU emulates, on a Linux machine of another processor:
#
#   gradle/aarch64.sh FOLDER CPU JAVA_ARGUMENT...
#
# FOLDER keeps QEMU, a JRE and its libraries: the first call downloads 109 MB of Debian packages and unpacks them to 580 MB. Nothing is
# installed, and root isn't needed. CPU is QEMU's name of a processor: cortex-a72 has vectors of 128 bits, max,sve256=on of 256.
# `./gradlew aarch64` compares the golden hashes by it.
set -eu
[ $# -ge 3 ] || {
    sed -n 's/^# \{0,1\}//; 2,8p' "$0" >&2
    exit 2
}
command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null || {
    echo "aarch64: this needs apt-get and dpkg-deb, as Debian and Ubuntu have them" >&2
    exit 2
}
mkdir -p "$1"
folder=$(cd "$1" && pwd -P)
cpu=$2
shift 2
jre=openjdk-17-jre-headless
host=$(dpkg --print-architecture)

# Lists and packages live in the folder, so that the machine's own lists and architectures stay as they are.
get() {
    apt-get -qq -o Dir::State="$folder/state" -o Dir::State::status="$folder/status" -o Dir::Cache="$folder/cache" \
        -o APT::Architecture="$host" -o APT::Architectures::="$host" -o APT::Architectures::=arm64 -o APT::Sandbox::User= "$@"
}

if [ ! -f "$folder/ready" ]; then
    echo "aarch64: downloading QEMU and $jre for arm64 to $folder" >&2
    rm -rf "$folder/root" "$folder/packages"
    mkdir -p "$folder/state/lists/partial" "$folder/cache/archives/partial" "$folder/packages" "$folder/root"
    : >"$folder/status"
    get update
    (cd "$folder/packages" && get download "qemu-user-static:$host" "$jre:arm64" libc6:arm64 zlib1g:arm64 libgcc-s1:arm64 libstdc++6:arm64)
    for package in "$folder"/packages/*.deb; do
        dpkg-deb -x "$package" "$folder/root"
    done
    # Debian's JRE links to its settings in /etc, where another JRE's may be.
    find "$folder/root/usr/lib/jvm" -type l -lname '/etc/*' | while read -r link; do
        settings=$folder/root$(readlink "$link")
        rm "$link"
        [ ! -f "$settings" ] || cp "$settings" "$link"
    done
    rm -rf "$folder/state" "$folder/cache" "$folder/packages"
    : >"$folder/ready"
fi
for java in "$folder"/root/usr/lib/jvm/java-*-openjdk-arm64/bin/java; do
    [ ! -h "$(dirname "$(dirname "$java")")" ] || continue
    exec "$folder/root/usr/bin/qemu-aarch64-static" -L "$folder/root" -cpu "$cpu" "$java" "$@"
done
echo "aarch64: no Java in $folder/root; remove the folder and run it again" >&2
exit 1
