/**
 * Recordings: files from which any machine computes a game again, bit for bit. {@code
 * docs/protocol/RECORDING.md} describes the format.
 *
 * <p>A {@link carom.replay.Recorder} is a {@link carom.sim.Journal}. It turns the inputs of a
 * simulation and fingerprints of the results into blocks. A {@link carom.replay.BlockWriter} writes
 * blocks to a file, and a {@link carom.replay.RecordingReader} reads them and trusts nothing. A
 * {@link carom.replay.Replay} simulates the game again and finds the first tick and body that
 * differ.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics}, its archive, {@code carom.game},
 * the JDK. No threads, no clocks.
 */
package carom.replay;
