package carom.net.snapshot;

import carom.net.codec.BitWriter;
import carom.net.codec.Crc16;
import java.util.Arrays;

/**
 * One session's snapshots. Each send tick, after {@link FrameRing#end}:
 *
 * <pre>{@code
 * encoder.receiveAck(ackSequence, ackBits);            // from each input datagram
 * encoder.begin(feedback, own, budgetBytes);
 * for (int n; (n = encoder.next(buffer)) > 0; ) link.sendDatagram(buffer, 0, n);
 * }</pre>
 *
 * <p>An entity whose quantised state hasn't changed since a tick that the client acked costs
 * nothing, neither bytes nor time. All others are sent, who waited longest first, as far as the
 * budget goes. Loss is never repaired by sending again what was lost: the newest state is sent
 * until one of its records is acked.
 *
 * <p>One thread, no allocation in the steady state.
 */
public final class SnapshotEncoder {

  /** Largest datagram; the size of the array for {@link #next}. */
  public static final int MAX_DATAGRAM_BYTES = 1_200;

  private static final int MIN_LENGTH = 64;

  /**
   * A further datagram is not begun for less: headers on the path would cost more than it holds.
   * Any record fits.
   */
  private static final int MIN_FURTHER_BYTES = 64;

  /** No record is longer: an absolute one with all forms at their widest. */
  private static final int MAX_RECORD_BYTES = 32;

  private static final int MAX_WAIT = 255;

  private final FrameRing ring;
  private final int key;
  private final Predictor predictor;
  private final SentLog sent = new SentLog();
  private final BitWriter writer = new BitWriter();
  private final BitWriter measure = new BitWriter();
  private final byte[] measured = new byte[MAX_RECORD_BYTES + Long.BYTES];
  private final Motion old = new Motion();
  private final Motion residual = new Motion();
  private final Motion actual = new Motion();

  private int[] acked = {};
  private int[] lastSent = {};
  private long[] candidates = {};
  private long[] forced = {};
  private long[] chosen = {};
  private int[] order = {};
  private final int[] waitCount = new int[MAX_WAIT + 1];
  private int seenTick = -1;

  private final InputFeedback feedback = new InputFeedback();
  private final OwnState[] ownSent = new OwnState[FrameRing.SIZE];
  private final OwnState ownAcked = new OwnState();
  private final OwnState nothing = new OwnState();
  private int ownAckedTick = -1;
  private boolean sendOwn;

  private FrameState frame;
  private boolean first;
  private int budget;
  private int cursor;
  private int startSlot;
  private int resumeSlot;
  private boolean wrapped;
  private int waiting;
  private int previousAge;

  // The answer of chooseBaseline, besides its reason.
  private FrameState baselineFrame;

  /**
   * Creates the encoder of a client that knows nothing.
   *
   * @param ring the room's frames, shared by all sessions
   * @param key the session's datagram key; seeds the check that each datagram carries
   * @param tickRate ticks per second, for prediction; the client's decoder must be given the same
   */
  public SnapshotEncoder(FrameRing ring, int key, int tickRate) {
    this.ring = ring;
    this.key = key;
    predictor = new LinearPredictor(tickRate);
    for (int i = 0; i < ownSent.length; i++) {
      ownSent[i] = new OwnState();
    }
  }

  /**
   * Forgets all acks: the client knows nothing (it loads anew, or came back). Sequence numbers go
   * on.
   */
  public void reset() {
    Arrays.fill(acked, -1);
    Arrays.fill(lastSent, -1);
    Arrays.fill(candidates, 0);
    Arrays.fill(forced, 0);
    Arrays.fill(chosen, 0);
    seenTick = -1;
    ownAckedTick = -1;
    sent.forget();
  }

  /**
   * Takes a client's acks. Anything is accepted: what was never sent, or is too old, changes
   * nothing.
   *
   * @param ackSequence newest snapshot datagram the client received, 16 bits
   * @param ackBits bit i = datagram {@code ackSequence - 1 - i} was received
   */
  public void receiveAck(int ackSequence, long ackBits) {
    take(ackSequence, 0);
    for (long bits = ackBits; bits != 0; bits &= bits - 1) {
      take(ackSequence, Long.numberOfTrailingZeros(bits) + 1);
    }
  }

  private void take(int sequence, int before) {
    int at = sent.take(sequence, before);
    if (at < 0) {
      return;
    }
    int tick = sent.tickAt(at);
    for (int i = 0; i < sent.countAt(at); i++) {
      int slot = sent.slotAt(at, i);
      acked[slot] = Math.max(acked[slot], tick);
    }
    if (sent.ownAt(at) && tick > ownAckedTick && ring.newest().tick() - tick < FrameRing.SIZE) {
      ownAcked.set(ownSent[tick & (FrameRing.SIZE - 1)]);
      ownAckedTick = tick;
    }
  }

  /** The slot's next record is absolute, whatever was acked. */
  public void force(int slot) {
    if (slot < 0 || slot >= ring.capacity()) {
      throw new IndexOutOfBoundsException(
          "slot=" + slot + " is outside 0.." + (ring.capacity() - 1));
    }
    ensure(slot + 1);
    forced[slot >> 6] |= 1L << slot;
    candidates[slot >> 6] |= 1L << slot;
  }

  /**
   * Whether the client has, as far as the server knows, everything of the newest frame and this own
   * state: then the replication may send less often.
   *
   * @param own as for {@link #begin}
   */
  public boolean nothingNew(OwnState own) {
    FrameState newest = ring.newest();
    if (newest == null) {
      return true;
    }
    if (own != null && !isKnown(own, newest)) {
      return false;
    }
    see(newest);
    return collect(newest) == 0;
  }

  /** Whether the client has acked all of the own section, with the inputs that belong to it. */
  private boolean isKnown(OwnState own, FrameState newest) {
    if (ownAckedTick < 0 || !own.sameSection(ownAcked)) {
      return false;
    }
    int window = newest.tick() - ownAckedTick;
    PlayerSet relayed = own.relayed;
    if (window > RelayCodec.MAX_WINDOW && relayed.next(0) >= 0) {
      return false;
    }
    for (int p = relayed.next(0); p >= 0; p = relayed.next(p + 1)) {
      if (!RelayCodec.isUnchanged(ring, newest, window, p)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Starts the datagrams of the ring's newest frame. Entities that did not fit the budget wait; who
   * waited longest goes first.
   *
   * @param feedback about the client's inputs; copied
   * @param own the player's exact state at the newest frame's tick, or null to send none; copied
   * @param budgetBytes for all datagrams of this tick; the first one's header and own section are
   *     sent anyway
   * @throws IllegalStateException when the ring has no frame
   */
  public void begin(InputFeedback feedback, OwnState own, int budgetBytes) {
    frame = ring.newest();
    if (frame == null) {
      throw new IllegalStateException("begin() before the first frame was captured");
    }
    this.feedback.set(feedback);
    sendOwn = own != null;
    if (own != null) {
      ownSent[frame.tick() & (FrameRing.SIZE - 1)].set(own);
    }
    see(frame);
    waiting = collect(frame);
    sent.reserve(waiting);
    if ((long) waiting * MAX_RECORD_BYTES <= budgetBytes) {
      System.arraycopy(candidates, 0, chosen, 0, chosen.length);
    } else {
      chooseLongestWaiting(budgetBytes);
    }
    budget = budgetBytes;
    startSlot = resumeSlot;
    cursor = startSlot;
    wrapped = false;
    first = true;
  }

  /** Makes everything a candidate that changed in frames since the last one seen. */
  private void see(FrameState newest) {
    ensure(newest.slotLimit());
    if (seenTick == newest.tick()) {
      return;
    }
    int back = 0;
    FrameState old = newest;
    while (old != null && old.tick() > seenTick) {
      old.addChanged(candidates);
      old = ring.back(++back);
    }
    if (old == null) {
      // The last frame seen has left the ring, or there was none: anything may have changed.
      for (int slot = 0; slot < newest.slotLimit(); slot++) {
        candidates[slot >> 6] |= 1L << slot;
      }
    }
    seenTick = newest.tick();
  }

  private void ensure(int length) {
    if (length <= acked.length) {
      return;
    }
    int old = acked.length;
    int grown = Math.max(MIN_LENGTH, Math.max(length, 2 * old));
    acked = Arrays.copyOf(acked, grown);
    Arrays.fill(acked, old, grown, -1);
    lastSent = Arrays.copyOf(lastSent, grown);
    Arrays.fill(lastSent, old, grown, -1);
    int words = (grown + 63) >> 6;
    candidates = Arrays.copyOf(candidates, words);
    forced = Arrays.copyOf(forced, words);
    chosen = Arrays.copyOf(chosen, words);
    order = new int[grown];
  }

  /** Drops candidates that have nothing to send any more and counts the rest. */
  private int collect(FrameState now) {
    int count = 0;
    for (int word = 0; word < candidates.length; word++) {
      for (long bits = candidates[word]; bits != 0; bits &= bits - 1) {
        int slot = (word << 6) + Long.numberOfTrailingZeros(bits);
        if (chooseBaseline(now, slot) == Baseline.QUIESCENT) {
          candidates[word] &= ~(1L << slot);
        } else {
          count++;
        }
      }
    }
    return count;
  }

  /**
   * Fills {@code chosen} with those candidates that fit the budget, by waiting time. Linear: a
   * counting sort.
   */
  private void chooseLongestWaiting(int budgetBytes) {
    Arrays.fill(chosen, 0);
    Arrays.fill(waitCount, 0);
    for (int slot = nextBit(candidates, 0); slot >= 0; slot = nextBit(candidates, slot + 1)) {
      waitCount[MAX_WAIT - waited(slot)]++;
    }
    int at = 0;
    for (int i = 0; i <= MAX_WAIT; i++) {
      int count = waitCount[i];
      waitCount[i] = at;
      at += count;
    }
    for (int slot = nextBit(candidates, 0); slot >= 0; slot = nextBit(candidates, slot + 1)) {
      order[waitCount[MAX_WAIT - waited(slot)]++] = slot;
    }
    long bitsLeft = 8L * budgetBytes;
    for (int i = 0; i < at && bitsLeft > 0; i++) {
      bitsLeft -= measure(order[i]);
      chosen[order[i] >> 6] |= 1L << order[i];
    }
  }

  /** Ticks since the slot was sent, 0..{@link #MAX_WAIT}; never sent counts as longest. */
  private int waited(int slot) {
    return lastSent[slot] < 0 ? MAX_WAIT : Math.min(MAX_WAIT, frame.tick() - lastSent[slot]);
  }

  /**
   * Size of the slot's record in bits, next to its neighbour: written to be measured, so that the
   * two can't differ.
   */
  private int measure(int slot) {
    measure.reset(measured, 0, measured.length);
    writeRecord(measure, slot - 1, slot);
    return measure.bits();
  }

  /**
   * Writes the next datagram of this tick. The first call after {@link #begin} always writes one.
   *
   * @param out at least {@link #MAX_DATAGRAM_BYTES}
   * @return its length, or 0 when there is nothing more to send this tick
   */
  public int next(byte[] out) {
    int slot = frame == null ? -1 : nextChosen(cursor);
    if (!first && (slot < 0 || budget < MIN_FURTHER_BYTES)) {
      frame = null;
      return 0;
    }
    boolean withOwn = first && sendOwn;
    BitWriter w = writer;
    w.reset(out, 0, MAX_DATAGRAM_BYTES);
    writeHeader(w, sent.begin(frame.tick(), withOwn), withOwn);
    int limitBits = 8 * Math.min(MAX_DATAGRAM_BYTES, Math.max(budget, 0)) - RecordCodec.END_BITS;
    int previous = -1;
    previousAge = 0;
    while (slot >= 0) {
      int mark = w.bits();
      int age = previousAge;
      writeRecord(w, previous, slot);
      if (w.overflow() || w.bits() > limitBits) {
        w.rewind(mark);
        previousAge = age;
        break;
      }
      sent.add(slot);
      lastSent[slot] = frame.tick();
      forced[slot >> 6] &= ~(1L << slot);
      waiting--;
      previous = slot;
      slot = nextChosen(slot + 1);
    }
    RecordCodec.writeEnd(w);
    int length = w.bytes();
    int check = Crc16.of(key, out, 2, length - 2);
    out[0] = (byte) check;
    out[1] = (byte) (check >>> 8);
    cursor = slot < 0 ? Integer.MAX_VALUE : slot;
    resumeSlot = Math.max(slot, 0);
    budget -= length;
    first = false;
    return length;
  }

  /**
   * The next chosen slot from a place on. A tick begins with the slot at which the budget cut the
   * one before: if the order were always the same, it would always be the same slots that are cut.
   */
  private int nextChosen(int from) {
    int begin = from;
    if (!wrapped) {
      int slot = nextBit(chosen, begin);
      if (slot >= 0) {
        return slot;
      }
      wrapped = true;
      begin = 0;
    }
    int slot = nextBit(chosen, begin);
    return slot < startSlot ? slot : -1;
  }

  private void writeHeader(BitWriter w, int sequence, boolean withOwn) {
    w.write(0, 16);
    w.write(sequence, 16);
    w.write(frame.tick(), 16);
    if (first) {
      HeaderCodec.writeFeedback(w, feedback, frame.tick());
    } else {
      w.write(false);
    }
    w.write(withOwn);
    if (withOwn) {
      int age = frame.tick() - ownAckedTick;
      boolean known = ownAckedTick >= 0 && age > 0 && age < FrameRing.SIZE;
      w.write(known ? age : 0, RecordCodec.AGE_BITS);
      OwnState baseline = known ? ownAcked : nothing;
      OwnState own = ownSent[frame.tick() & (FrameRing.SIZE - 1)];
      HeaderCodec.writeOwn(w, baseline, own);
      int window = known ? RelayCodec.window(age) : 0;
      RelayCodec.write(w, ring, window, baseline.relayed, own.relayed);
    }
  }

  private void writeRecord(BitWriter w, int previous, int slot) {
    Baseline baseline = chooseBaseline(frame, slot);
    RecordCodec.writeSlot(w, previous, slot);
    if (baseline == Baseline.GONE) {
      RecordCodec.writeKind(w, RecordCodec.GONE);
      return;
    }
    frame.motion(slot, actual);
    if (baseline == Baseline.ACKED) {
      int age = frame.tick() - baselineFrame.tick();
      baselineFrame.motion(slot, old);
      residual.setResidual(predictor, old, actual, age);
      RecordCodec.writeKind(w, RecordCodec.DELTA);
      RecordCodec.writeAge(w, previousAge, age);
      RecordCodec.writeResidual(w, residual);
      previousAge = age;
    } else {
      RecordCodec.writeKind(w, RecordCodec.ABSOLUTE);
      RecordCodec.writeIdentity(
          w, frame.generation(slot), frame.archetype(slot), frame.owner(slot));
      RecordCodec.writeAbsolute(w, actual);
    }
  }

  /**
   * The one place that decides what a slot's record is coded against. For {@link Baseline#ACKED}
   * the frame is left in {@code baselineFrame}: the newest one in which the slot still is as it was
   * in the acked tick. So a body that begins to move after a long rest is coded against the end of
   * its rest, and the client learns when it began.
   */
  private Baseline chooseBaseline(FrameState now, int slot) {
    int ackedTick = acked[slot];
    boolean force = (forced[slot >> 6] & 1L << slot) != 0;
    boolean alive = now.alive(slot);
    if (ackedTick >= now.changedTick(slot) && !(force && alive)) {
      return Baseline.QUIESCENT;
    }
    if (!alive) {
      return lastSent[slot] < 0 ? Baseline.QUIESCENT : Baseline.GONE;
    }
    if (force) {
      return Baseline.FORCED;
    }
    if (ackedTick < 0) {
      return Baseline.NEW;
    }
    FrameState held = lastHolding(now, slot, ackedTick);
    if (held == null) {
      return Baseline.TOO_OLD;
    }
    if (!held.sameIdentity(now, slot)) {
      return Baseline.IDENTITY;
    }
    baselineFrame = held;
    return Baseline.ACKED;
  }

  /**
   * The newest frame in which the slot is as in the acked tick, or null when none in the ring is
   * young enough.
   */
  private FrameState lastHolding(FrameState now, int slot, int ackedTick) {
    FrameState following = ring.at(ackedTick + 1);
    if (following != null && following.changedTick(slot) > ackedTick) {
      FrameState exact = ring.at(ackedTick);
      return exact != null && now.tick() - ackedTick < FrameRing.SIZE ? exact : null;
    }
    // changedTick only grows from frame to frame: search the border between "still as acked" and
    // "changed".
    int holds = ring.count();
    int differs = 0;
    while (holds - differs > 1) {
      int middle = (holds + differs) >>> 1;
      FrameState candidate = ring.back(middle);
      if (candidate.tick() >= ackedTick && candidate.changedTick(slot) > ackedTick) {
        differs = middle;
      } else {
        holds = middle;
      }
    }
    FrameState held = ring.back(holds);
    boolean young = held != null && now.tick() - held.tick() < FrameRing.SIZE;
    return young && held.tick() >= ackedTick ? held : null;
  }

  private static int nextBit(long[] bits, int from) {
    int word = from >> 6;
    if (word >= bits.length) {
      return -1;
    }
    long rest = bits[word] & -1L << from;
    while (rest == 0) {
      if (++word == bits.length) {
        return -1;
      }
      rest = bits[word];
    }
    return (word << 6) + Long.numberOfTrailingZeros(rest);
  }

  /**
   * What the slot's record would be coded against now, and why: the one place where that is
   * decided.
   *
   * @param slot 0..capacity - 1
   */
  public Baseline baseline(int slot) {
    FrameState newest = ring.newest();
    if (newest == null || slot >= newest.slotLimit()) {
      return Baseline.QUIESCENT;
    }
    ensure(newest.slotLimit());
    return chooseBaseline(newest, slot);
  }

  /** Newest tick of the slot that the client has acked, or -1. */
  public int ackedTick(int slot) {
    return slot < acked.length ? acked[slot] : -1;
  }

  /** Last tick at which a record of the slot was sent, or -1. */
  public int sentTick(int slot) {
    return slot < lastSent.length ? lastSent[slot] : -1;
  }

  /**
   * Entities that have changed and are not sent yet in this tick; after the last {@link #next},
   * those that must wait.
   */
  public int waiting() {
    return waiting;
  }

  /** Sequence number of the last datagram written. */
  public int sequence() {
    return sent.sequence();
  }
}
