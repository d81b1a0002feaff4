#!/bin/sh
# Makes later starts faster: keeps the classes that server and bots load, parsed and verified, in lib/PROGRAM.jsa (class data sharing).
# Such a file fits one JVM and one place. So this runs where the programs are unpacked, and again when they were moved or Java was updated.
# Without it, or if it fails, everything works as well, but starts slower.
APP_HOME=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd -P) || exit
cd "$APP_HOME" || exit
java=${JAVA_HOME:-$(dirname "$(readlink -f "$(command -v java)")")/..}
if [ -x runtime/bin/java ]; then
    java=$APP_HOME/runtime
    [ -f runtime/lib/server/classes.jsa ] || runtime/bin/java -Xshare:dump >/dev/null || exit
fi
rm -f lib/carom-*.jsa lib/carom-*.release
work=$(mktemp -d) || exit
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null; rm -rf "$work" lib/carom-*.jsa.new' EXIT

# Runs a program that writes its classes when it ends.
collect() {
    program=$1
    shift
    JAVA_OPTS="-Xlog:cds*=off -XX:ArchiveClassesAtExit=$APP_HOME/lib/$program.jsa.new" exec "bin/$program" "$@" </dev/null
}

# Takes what a program has written; a file that was cut off would crash the JVM.
keep() {
    mv "lib/$1.jsa.new" "lib/$1.jsa" && cp "$java/release" "lib/$1.release"
}

: >"$work/out" # it may be read before the program begins
collect carom-server --tcp-port=0 --udp-port=0 --web-port=0 --log-level=off --data="$work" >"$work/out" 2>&1 &
server=$!
tries=0
until grep -q '^ready ' "$work/out"; do
    tries=$((tries + 1))
    if [ "$tries" -gt 600 ] || ! kill -0 "$server" 2>/dev/null; then
        cat "$work/out" >&2
        exit 1
    fi
    sleep 0.1
done
sleep 1 # the page's classes load after `ready`
port=$(sed -n 's/^ready tcp=\([0-9]*\) .*/\1/p' "$work/out")
(collect carom-bots --host="localhost:$port" --count=2 --seconds=1) >/dev/null 2>&1 && keep carom-bots
kill "$server" && wait "$server"
server=
keep carom-server
