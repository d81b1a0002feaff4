/**
 * Other engines in the benchmark, built from the same scenes; no program and no test has them on
 * its class path. May use {@code carom.server.bench}, {@code carom.physics} and the engines. Read
 * first: {@code carom.server.bench.PeerEngine}.
 */
package carom.bench;
