#!/bin/sh
# Starts ${applicationName}. Options for the JVM go in JAVA_OPTS; JAVA_HOME, if set, says which JVM.
self=\$0
while [ -h "\$self" ]; do
    link=\$(readlink "\$self")
    case \$link in /*) self=\$link ;; *) self=\$(dirname "\$self")/\$link ;; esac
done
APP_HOME=\$(cd "\$(dirname "\$self")/.." && pwd -P) || exit
exec "\${JAVA_HOME:+\$JAVA_HOME/bin/}java" <% print defaultJvmOpts.replace("'", '') %> \$JAVA_OPTS \\
    -cp "$classpath" $mainClassName "\$@"
