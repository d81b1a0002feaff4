package carom.net.snapshot.frame;

import carom.net.codec.BitReader;
import carom.net.codec.Sequence;

/**
 * Receives the server's events, each once and in order, although datagrams may be lost, repeated or
 * reordered. Take them with {@link #poll} after each datagram decoded.
 *
 * <p>Any bits are read without harm. One thread; allocates nothing after construction.
 */
public final class EventInbox {
  private static final int WINDOW = EventCodec.WINDOW;

  /** Twice the window: those that wait for one before them, and those that wait to be taken. */
  private static final int SIZE = 2 * WINDOW;

  private static final int MASK = SIZE - 1;

  private final EventRecord[] events = new EventRecord[SIZE];
  private final boolean[] here = new boolean[SIZE];
  private long taken;
  private long expected; // all before have been received, or given up
  private int completeTick = -1;
  private long missed;

  // A datagram is read into these first and counts only when all of it was good.
  private final EventCodec codec = new EventCodec();
  private final EventRecord[] read = new EventRecord[WINDOW];
  private final int[] readPlace = new int[WINDOW];
  private int readCount;

  /** Creates an inbox that has heard nothing. */
  public EventInbox() {
    for (int i = 0; i < SIZE; i++) {
      events[i] = new EventRecord();
    }
    for (int i = 0; i < WINDOW; i++) {
      read[i] = new EventRecord();
    }
  }

  /** Reads the event section of a datagram; the reader fails when it makes no sense. */
  public void read(BitReader r, int tick) {
    readCount = 0;
    codec.begin(r, tick, 0, 0);
    if (codec.outstanding() == 0) {
      return;
    }
    while (codec.next(r, false, 0, read[Math.min(readCount, WINDOW - 1)])) {
      readPlace[readCount++] = codec.place();
    }
  }

  /** Accepts what was read last: the whole datagram was good. */
  public void keep(int tick) {
    if (codec.outstanding() == 0) {
      completeTick = Math.max(completeTick, tick);
      return;
    }
    long base = expected + Sequence.difference(codec.sequence(), (int) expected & 0xffff);
    while (expected < base) { // the server has given up what we never got
      if (here[(int) expected & MASK]) {
        here[(int) expected & MASK] = false;
        expected++;
        makeRoom();
      } else {
        skip();
      }
    }
    for (int i = 0; i < readCount; i++) {
      long sequence = base + readPlace[i];
      int at = (int) sequence & MASK;
      if (sequence >= expected && sequence < expected + WINDOW && !here[at]) {
        events[at].set(read[i]);
        here[at] = true;
      }
    }
    while (here[(int) expected & MASK]) {
      here[(int) expected & MASK] = false;
      expected++;
      makeRoom();
    }
    if (expected >= base + codec.outstanding()) {
      completeTick = Math.max(completeTick, tick);
    }
  }

  /** Passes over an event that never comes: its place stays empty for {@link #poll}. */
  private void skip() {
    missed++;
    events[(int) expected & MASK].tick = -1;
    expected++;
    makeRoom();
  }

  /** Drops the oldest events if a client doesn't take them. */
  private void makeRoom() {
    while (expected - taken > SIZE - WINDOW) {
      missed += events[(int) taken & MASK].tick >= 0 ? 1 : 0;
      taken++;
    }
  }

  /**
   * Takes the next event.
   *
   * @return null when there is none; else valid until the next datagram is decoded
   */
  public EventRecord poll() {
    while (taken < expected) {
      EventRecord e = events[(int) taken++ & MASK];
      if (e.tick >= 0) {
        return e;
      }
    }
    return null;
  }

  /** Returns the tick up to which all events have been received; -1 before any is known. */
  public int completeTick() {
    return completeTick;
  }

  /** Returns the number of events that were lost because too many waited. */
  public long missed() {
    return missed;
  }
}
