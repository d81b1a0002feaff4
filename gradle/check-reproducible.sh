#!/usr/bin/env bash
# Builds the last commit twice, from clones in two folders, one after the other, each with another umask, time zone, language and user
# folder, and compares all archives byte by byte. ./gradlew checkReproducible. Arguments: the repository, and archives that somebody else has
# built of that commit, to be compared, too. Takes some minutes. The last line counts.
set -u
repository=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0
export GRADLE_USER_HOME=${GRADLE_USER_HOME:-$HOME/.gradle} # what was downloaded is used again

# build FOLDER UMASK ZONE LANGUAGE: lists the sums of all archives in FOLDER.sums.
build() {
    echo "builds in $1"
    git clone -q "$repository" "$1" && mkdir -p "$1.home" || exit
    (
        cd "$1" || exit
        umask "$2"
        export TZ=$3 LC_ALL=C GRADLE_OPTS="-Duser.language=$4" HOME=$1.home
        ./gradlew --no-daemon -q "-Dmaven.repo.local=$1/build/maven" distZip deb image appImage publishToMavenLocal >"$1.log" 2>&1
    ) || { tail -40 "$1.log"; exit 1; }
    (cd "$1" && find build/distributions build/maven build/app -type f ! -name 'maven-metadata*' -exec sha256sum {} + | sort -k 2) >"$1.sums"
}

# same NAME SUM SUM
same() {
    if [ -n "$2" ] && [ "$2" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "failed: $1: ${2:-none} and ${3:-none}"
    fi
}
sum() { sed -n "s# .*[ /]$2\$##p" "$1" | sed 1q; }

build "$work/one" 022 UTC en
build "$work/another/place" 077 Asia/Tokyo de
while read -r sum name; do
    same "$name" "$sum" "$(sum "$work/another/place.sums" "$name")"
done <"$work/one.sums"
same "number of files" "$(wc -l <"$work/one.sums")" "$(wc -l <"$work/another/place.sums")"
for archive in "$@"; do
    same "$archive" "$(sha256sum <"$archive" | cut -d ' ' -f 1)" "$(sum "$work/one.sums" "${archive##*/}")"
done
grep build/distributions/ "$work/one.sums"
echo "reproducible: $passed passed, $failed failed"
[ "$failed" = 0 ]
