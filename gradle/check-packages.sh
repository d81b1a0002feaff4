#!/usr/bin/env bash
# Opens the zips, the Debian package and the image that were built, checks what is in them, and starts the zip's server where no JDK is on
# the PATH. ./gradlew checkPackages. Arguments: the folder of the files, the version. Needs unzip, tar, dpkg-deb. The last line counts.
set -u
cd "$1" || exit
version=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# check WHAT COMMAND...: the command succeeds; what it says shows only if it doesn't.
check() {
    local what=$1
    shift
    if "$@" >"$work/said" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "failed: $what"
        head -20 "$work/said"
    fi
}
has() { grep -Eq -- "$2" "$1"; }
lacks() { ! grep -P -- "$2" "$1"; }

plain=carom-$version.zip
runtime=$(ls carom-"$version"-*.zip)
for zip in "$plain" "$runtime"; do
    unzip -Z "$zip" >"$work/list"
    for file in bin/carom bin/carom-bots bin/carom-client bin/carom-prepare bin/carom-server; do
        check "$zip has an executable $file" has "$work/list" "^-rwx.* carom-$version/$file\$"
    done
    for file in LICENSE carom.cdx.json bin/carom-server.bat docs/server/OPERATIONS.md "lib/server-$version.jar" "lib/launcher-$version.jar"; do
        check "$zip has $file" has "$work/list" " carom-$version/$file\$"
    done
    unzip -Z1 "$zip" >"$work/names"
    check "$zip has one folder" lacks "$work/names" "^(?!carom-$version/)"
    check "$zip has no prepared classes, which are of one place" lacks "$work/list" '\.jsa$'
done
check "$runtime has a runtime" has "$work/list" "^-rwx.* carom-$version/runtime/bin/java\$"
unzip -Z "$plain" >"$work/list"
check "$plain has no runtime" lacks "$work/list" ' [^ ]*/runtime/'

# What cmd needs of the scripts for Windows: both characters at each line's end, a label for each jump, quotes in pairs.
unzip -q "$plain" -d "$work/windows"
for bat in "$work/windows/carom-$version"/bin/*.bat; do
    name=${bat##*/}
    check "$name ends its lines with CR and LF" lacks "$bat" '[^\r]$'
    tr -d '\r' <"$bat" | sed 's/%[A-Z_]*:"=%//g' >"$work/bat" # which takes quotes out of a variable
    for label in $(grep -oiP '\bgoto :?\K\w+' "$work/bat" | sort -u); do
        check "$name has the label $label" has "$work/bat" "^:$label\$"
    done
    check "$name has quotes in pairs" lacks "$work/bat" '^(?!@?rem\b|echo\b)[^"]*"([^"]*"[^"]*")*[^"]*$'
    check "$name starts a class that a library holds" sh -c "
        class=\$(grep -oP -- '-classpath \"%CLASSPATH%\" \K[\w.]+' '$work/bat' | tr . /)
        [ -n \"\$class\" ] && for jar in '$work/windows/carom-$version'/lib/*.jar; do unzip -l \"\$jar\"; done | grep -q \" \$class.class\""
done

# A PATH with everything of this system but Java.
mkdir "$work/path"
for tool in /usr/bin/* /bin/*; do
    case ${tool##*/} in java* | jar | jlink | jshell | keytool) ;; *) ln -sf "$tool" "$work/path/" ;; esac
done
unzip -q "$runtime" -d "$work"
check 'no java on the PATH of this check' env -i PATH="$work/path" sh -c '! command -v java'
start() {
    printf 'rooms\nstop\n' | env -i PATH="$work/path" HOME="$work" timeout 60 "$work/carom-$version/bin/carom-server" --data "$work/data" \
        --bind 127.0.0.1 --tcp-port 47555 --udp-port 47777 --web-port 48090 --no-query >"$work/server" 2>&1
}
check "$runtime starts without a JDK, answers and stops" start
check 'its answer is the list of rooms' has "$work/server" '@1 +0/64 +arena'
check 'no warning of incubator modules' lacks "$work/server" 'incubator'

deb=$(ls carom_"$version"_*.deb)
dpkg-deb --field "$deb" >"$work/control"
for field in 'Package: carom' "Version: $version" 'Architecture: [a-z0-9]+' 'Depends: .*libc6'; do
    check "$deb says $field" has "$work/control" "^$field"
done
dpkg-deb --contents "$deb" >"$work/list"
check "$deb has the server" has "$work/list" '^-rwx.* \./opt/carom/bin/carom-server$'
check "$deb has a runtime" has "$work/list" '^-rwx.* \./opt/carom/runtime/bin/java$'
check "$deb has the unit" has "$work/list" '^-rw-r--r-- root/root .* \./usr/lib/systemd/system/carom.service$'
check "$deb links the programs" has "$work/list" '\./usr/bin/carom-server -> ../../opt/carom/bin/carom-server$'
check "$deb belongs to root alone, and nobody else may write" lacks "$work/list" '^.{10} (?!root/root)|^-.......w'
check "$deb has no setuid" lacks "$work/list" '^-..[sS]|^-.....[sS]'
dpkg-deb --extract "$deb" "$work/deb"
dpkg-deb --control "$deb" "$work/DEBIAN"
for script in postinst prerm postrm; do
    check "$deb has a $script that a shell reads" sh -n "$work/DEBIAN/$script"
done
if command -v systemd-analyze >/dev/null; then
    unit=$work/carom.service
    sed "s#/opt/carom#$work/deb/opt/carom#g" "$work/deb/usr/lib/systemd/system/carom.service" >"$unit"
    check "$deb's unit is one" systemd-analyze verify --man=no "$unit"
fi

image=carom-$version-image.tar
if [ -f "$image" ]; then
    mkdir "$work/image"
    tar -xf "$image" -C "$work/image"
    config=$work/image/$(sed 's/.*"Config":"\([^"]*\)".*/\1/' "$work/image/manifest.json")
    check "$image is called carom:$version" has "$work/image/manifest.json" "\"carom:$version\""
    check "$image's user is a number" has "$config" '"User":"10001:10001"'
    check "$image has a health check" has "$config" '"Healthcheck":.*carom.server.CaromMain","health"'
    check "$image runs the server" has "$config" '"Entrypoint":.*carom.server.ServerMain"'
    check "$image keeps its data outside" has "$config" '"Volumes":\{"/data":'
    check "$image says its ports" has "$config" '54555/tcp'
    grep -o '"[^"]*\.tar[^"]*"' "$work/image/manifest.json" | tr -d '"' | grep -v "^carom:" >"$work/layers"
    while read -r layer; do
        check "$image has the layer $layer" test -f "$work/image/$layer"
        tar --warning=no-unknown-keyword -tvf "$work/image/$layer"
    done <"$work/layers" >"$work/list"
    check "$image has a runtime" has "$work/list" '^-rwx.* opt/carom/runtime/bin/java$'
    check "$image has the server" has "$work/list" " opt/carom/lib/server-$version.jar\$"
    check "$image has a data folder of that user" has "$work/list" '^drwxr-x--- 10001.* data/$'
    check "$image has no shell" lacks "$work/list" ' (usr/)?bin/'
    check "$image has no client" lacks "$work/list" ' opt/carom/lib/(client|gdx)[^/]*\.jar$'
fi

echo "packages: $passed passed, $failed failed"
[ "$failed" = 0 ]
