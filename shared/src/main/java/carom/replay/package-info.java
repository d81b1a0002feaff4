/**
 * Recordings: a game as a file that computes itself again, bit for bit, on any machine. The format
 * is described in {@code docs/REPLAY.md}.
 *
 * <p>A {@link carom.replay.Recorder} is a {@link carom.sim.Journal}: it turns what enters a
 * simulation, and fingerprints of what comes of it, into blocks. A {@link carom.replay.BlockWriter}
 * puts blocks into a file, a {@link carom.replay.RecordingReader} gets them out again and trusts
 * nothing it reads, a {@link carom.replay.Replay} simulates the game once more and finds the first
 * tick and body at which it goes another way.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics}, its archive, {@code carom.game},
 * the JDK. No threads, no clocks.
 */
package carom.replay;
