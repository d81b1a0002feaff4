package carom.server.checkpoint;

import java.io.IOException;
import java.nio.channels.WritableByteChannel;
import java.util.List;

/** A place to which the slots of a room's journal are written: a folder, or another server. */
interface SlotStore {
  /** Returns the name of the place, for logs. */
  String title();

  /** Returns the numbers of the slots, the newest first. */
  List<Integer> slots() throws IOException;

  /** Creates the log of a slot. */
  WritableByteChannel newLog(int slot) throws IOException;

  /** Writes who plays at the checkpoint of a slot. */
  void writeSeats(int slot, byte[] bytes) throws IOException;

  /** Writes who plays in a slot now, in the place of who did before. */
  void writeLatest(int slot, byte[] bytes) throws IOException;

  /**
   * Waits until a slot is certain to stay.
   *
   * @param log that of the slot, or null if it is closed
   */
  void force(int slot, WritableByteChannel log) throws IOException;

  /** Deletes a slot. */
  void delete(int slot) throws IOException;

  /** Notes the claim under which the slots are written. */
  void writeClaim(long claim) throws IOException;

  /** Notes that the room has failed. */
  void addFailure() throws IOException;

  /** Forgets failures, because the room has played for long enough. */
  void forgetFailures() throws IOException;
}
