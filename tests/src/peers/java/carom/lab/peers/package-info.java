/**
 * Other engines in the benchmark, built from the same scenes; no program and no test has them on
 * its class path. May use {@code carom.lab.bench}, {@code carom.physics} and the engines. Read
 * first: {@code carom.lab.bench.PeerEngine}.
 */
package carom.lab.peers;
