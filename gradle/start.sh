#!/bin/sh
# Starts ${applicationName} on the Java runtime that came along, else on that of JAVA_HOME, else on the one on the PATH. Options for the JVM
# go in JAVA_OPTS.
# A daemon's caller may have closed these; then the JVM's first file would get their number, and its bytes would be taken for commands.
(true 9<&0) 2>/dev/null || exec </dev/null
(true 9>&1) 2>/dev/null || exec >/dev/null
(true 9>&2) || exec 2>/dev/null
self=\$0
while [ -h "\$self" ]; do
    link=\$(readlink "\$self")
    case \$link in /*) self=\$link ;; *) self=\$(dirname "\$self")/\$link ;; esac
done
APP_HOME=\$(cd "\$(dirname "\$self")/.." && pwd -P) || exit
home=\${JAVA_HOME:-}
[ ! -x "\$APP_HOME/runtime/bin/java" ] || home=\$APP_HOME/runtime
java=\${home:+\$home/bin/}java
if ! command -v "\$java" >/dev/null; then
    echo "${applicationName}: there is no Java: install a JRE from 17 on, or take the zip that brings a runtime" >&2
    exit 127
fi
# File names, arguments and what is typed are UTF-8, also where cron, ssh or systemd set no locale or one that isn't installed.
[ "\$(locale charmap 2>/dev/null)" = UTF-8 ] || export LC_ALL=C.UTF-8
jdk=\${home:-\$(dirname "\$(readlink -f "\$(command -v java)")")/..}
# Classes that carom-prepare has kept, for the JVM that made them alone: others crashed on them.
classes=
if [ -f "\$APP_HOME/lib/${applicationName}.jsa" ]; then
    cmp -s "\$jdk/release" "\$APP_HOME/lib/${applicationName}.release" && classes=\$APP_HOME/lib/${applicationName}.jsa
fi
priorities=
<% if (applicationName in ['carom-server', 'carom-bots']) { %># Linux: Java's priorities count, as nice values, and the JIT compiler's threads leave the processors to those that play. Without root
# a process can't be preferred, only step back, and the JVM would say so at each start. Measured: docs/lab/crowd.md.
# Only on the JVMs that CI has tried: a later one may refuse flags that only tune.
# In a server of a fleet no thread steps back: when it is killed, its sockets close with its last thread, and on a busy machine one of
# nice 10 gets a processor after seconds (8 busy processes on 2 cores: 2.8 s; nice 4: 0.9, nice 0: 0.4), while players wait.
version=\$(sed -n 's/^JAVA_VERSION="\\([0-9]*\\).*/\\1/p' "\$jdk/release" 2>/dev/null)
if [ "\$(uname)" = Linux ] && [ "\${version:-99}" -le 25 ]; then
    compilers=10
    case " \$* \${CAROM_FLEET:+--fleet}" in *" --fleet"*) compilers=0 ;; esac
    priorities="-XX:ThreadPriorityPolicy=1 -XX:CompilerThreadPriority=\$compilers"
    [ "\$(id -u)" = 0 ] || priorities="\$priorities -XX:-PrintWarnings"
fi
<% } %>exec "\$java" <% print defaultJvmOpts.replace("'", '') %> \\
    \${classes:+"-Xlog:cds*=off" "-XX:SharedArchiveFile=\$classes"} \$priorities \$JAVA_OPTS \\
    -cp "$classpath:\$APP_HOME/games/*" $mainClassName "\$@"
