package carom.server.checkpoint;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.TreeSet;

/** Writes slots to the server that follows a room. The threads of {@link SlotDisk}. */
final class RemoteSlots implements SlotStore {
  private static final byte[] NOTHING = {};

  private final SlotLink link;
  private final TreeSet<Integer> slots = new TreeSet<>();

  RemoteSlots(SlotLink link) {
    this.link = link;
  }

  @Override
  public String title() {
    return "follower " + link.title();
  }

  @Override
  public synchronized List<Integer> slots() {
    List<Integer> all = new ArrayList<>(slots);
    Collections.reverse(all);
    return all;
  }

  private void send(SlotLink.Step step, int slot, byte[] bytes) throws IOException {
    link.send(step, slot, bytes, 0, bytes.length);
  }

  @Override
  public WritableByteChannel newLog(int slot) throws IOException {
    synchronized (this) {
      slots.add(slot);
    }
    send(SlotLink.Step.LOG, slot, NOTHING);
    return new Log(slot);
  }

  /** The log of a slot there. */
  private final class Log implements WritableByteChannel {
    private final int slot;
    private boolean closed;

    Log(int slot) {
      this.slot = slot;
    }

    @Override
    public int write(ByteBuffer from) throws IOException {
      if (closed) {
        throw new ClosedChannelException();
      }
      byte[] bytes = new byte[from.remaining()];
      from.get(bytes);
      send(SlotLink.Step.LOG, slot, bytes);
      return bytes.length;
    }

    @Override
    public boolean isOpen() {
      return !closed;
    }

    @Override
    public void close() {
      closed = true;
    }
  }

  @Override
  public void writeSeats(int slot, byte[] bytes) throws IOException {
    send(SlotLink.Step.SEATS, slot, bytes);
  }

  @Override
  public void writeLatest(int slot, byte[] bytes) throws IOException {
    send(SlotLink.Step.LATEST, slot, bytes);
  }

  @Override
  public void force(int slot, WritableByteChannel log) throws IOException {
    link.await();
  }

  @Override
  public void delete(int slot) throws IOException {
    synchronized (this) {
      slots.remove(slot);
    }
    send(SlotLink.Step.DELETE, slot, NOTHING);
  }

  @Override
  public void writeClaim(long claim) {
    // Nothing: the follower knows it.
  }

  @Override
  public void addFailure() {
    // Nothing: a follower that goes on with a room counts its failures from then on.
  }

  @Override
  public void forgetFailures() {
    // Nothing, as above.
  }
}
