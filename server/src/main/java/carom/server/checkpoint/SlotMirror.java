package carom.server.checkpoint;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The journal of a room that another server owns, in a folder of this one: what its {@link
 * SlotLink} sends. The room can go on from the folder as from its own checkpoints. Nothing waits
 * for the disk, as the owner's death is what the mirror is for, not this machine's.
 *
 * <p>One thread, but for {@link #knows}, {@link #match} and {@link #isUsable}.
 */
public final class SlotMirror implements AutoCloseable {
  private final SlotFolder folder;
  private final Map<Integer, FileChannel> logs = new HashMap<>();
  private final Set<Integer> slots = ConcurrentHashMap.newKeySet();
  private final Set<Long> secrets = ConcurrentHashMap.newKeySet();
  private volatile int match;

  /**
   * Creates a mirror that has nothing, whatever the folder had before.
   *
   * @param path folder of this room's mirror alone
   * @param claim the owner's
   * @throws IOException if the folder can't be used
   */
  public SlotMirror(Path path, long claim) throws IOException {
    folder = new SlotFolder(path);
    folder.create();
    for (int slot : folder.slots()) {
      folder.delete(slot);
    }
    folder.forgetFailures();
    folder.writeClaim(claim);
  }

  /** Returns the folder. */
  public Path path() {
    return folder.path();
  }

  /**
   * Does one step of the owner's.
   *
   * @param slot 1..999,999,999
   * @throws IOException if it can't be done; the mirror is of no use then
   */
  public void apply(SlotLink.Step step, int slot, byte[] bytes) throws IOException {
    if (slot < 1 || slot > 999_999_999) {
      throw new SlotException("slot=" + slot + " of a journal is outside 1..999999999");
    }
    switch (step) {
      case LOG -> append(slot, bytes);
      case SEATS -> {
        folder.writeSeats(slot, bytes);
        note(bytes);
      }
      case LATEST -> {
        folder.writeLatest(slot, bytes);
        note(bytes);
      }
      case DELETE -> {
        slots.remove(slot);
        FileChannel log = logs.remove(slot);
        if (log != null) {
          log.close();
        }
        folder.delete(slot);
      }
    }
  }

  private void append(int slot, byte[] bytes) throws IOException {
    FileChannel log = logs.get(slot);
    if (log == null) {
      log = folder.newLog(slot);
      logs.put(slot, log);
      slots.add(slot);
    }
    for (ByteBuffer rest = ByteBuffer.wrap(bytes); rest.hasRemaining(); ) {
      log.write(rest);
    }
  }

  private void note(byte[] seats) throws IOException {
    SavedRoom saved = SavedRoom.parse(seats);
    match = saved.match();
    List<SavedSeat> all = saved.seats();
    Set<Long> present = new HashSet<>();
    all.forEach(seat -> present.add(seat.secret()));
    secrets.addAll(present);
    secrets.retainAll(present);
  }

  /** Returns whether a session with this secret plays in the room. Any thread. */
  public boolean knows(long secret) {
    return secrets.contains(secret);
  }

  /** Returns the number of the match that the room plays, 0 before it is known. Any thread. */
  public int match() {
    return match;
  }

  /** Returns whether the room could go on from here, with players or without. Any thread. */
  public boolean isUsable() {
    return !slots.isEmpty();
  }

  /** Closes and deletes the files, which have the secrets of sessions. */
  public void delete() throws IOException {
    close();
    slots.clear();
    for (int slot : folder.slots()) {
      folder.delete(slot);
    }
  }

  /** Closes the files; the room can go on from the folder. */
  @Override
  public void close() throws IOException {
    for (FileChannel log : logs.values()) {
      log.close();
    }
    logs.clear();
  }
}
