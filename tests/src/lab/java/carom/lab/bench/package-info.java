/**
 * Measures the engine on the scenes of {@code carom.sim.scene}, next to other engines if they are
 * on the class path: {@code carom bench}, {@code ./gradlew bench}.
 *
 * <p>Imports {@code carom.lab.measure}, {@code carom.lab.broadphase}, {@code carom.physics}, {@code
 * carom.sim}, {@code carom.net.snapshot}, {@code carom.server.replication}, picocli, Jackson, the
 * JDK. Read first: {@link carom.lab.bench.BenchCommand}, {@link carom.lab.measure.Measurement},
 * {@link carom.lab.measure.BenchJob}, {@link carom.lab.bench.BenchEngine}.
 */
package carom.lab.bench;
