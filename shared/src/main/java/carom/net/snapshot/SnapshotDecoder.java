package carom.net.snapshot;

import static carom.net.snapshot.DecodeStatus.DAMAGED;
import static carom.net.snapshot.DecodeStatus.OK;

import carom.net.codec.BitReader;
import carom.net.codec.RangeDecoder;
import carom.net.protocol.DatagramMark;
import carom.net.snapshot.exact.OwnInbox;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.RelayedInputs;
import carom.net.snapshot.frame.EventInbox;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.QuantizedPose;
import carom.net.snapshot.frame.ReceivedPoses;
import carom.net.snapshot.frame.SlotSet;
import carom.net.snapshot.table.TableInbox;
import java.util.Arrays;

/**
 * Reads the snapshots of one session: datagrams in, a history per entity out, and the acks to send
 * back.
 *
 * <p>Any bytes give a {@link DecodeStatus}, never an exception, and a datagram counts as a whole or
 * not at all. Memory is bounded: at most 2.4 KiB for each slot ever seen. One thread; allocates
 * only while a slot's history grows to that, or when a datagram has more records than any before.
 */
public final class SnapshotDecoder {

  private static final int MIN_RECORDS = 64;

  /** Age of a record whose baseline the history has at that very tick. */
  private static final int NOTHING_TO_HOLD = 0;

  /** Bytes of mark, sequence number, tick and five flags: no datagram is shorter. */
  private static final int MIN_BYTES = 6;

  private final int capacity;
  private final int mark;
  private final Predictor predictor;
  private final BitReader reader = new BitReader();
  private final RangeDecoder range = new RangeDecoder();
  private final RecordCodec records = new RecordCodec();
  private final DatagramHead head = new DatagramHead();
  private final DeltaCodec deltas;
  private EntityHistory[] histories = {};
  private final ReceivedPoses received = new ReceivedPoses();
  private int slotLimit;

  private final Receipts receipts = new Receipts();
  private int tick;
  private int newestTick;

  private final InputFeedback feedback = new InputFeedback();
  private boolean hasNews;
  private boolean hasOwn;
  private final OwnInbox own;
  private final EventInbox events = new EventInbox();
  private final TableInbox tables;

  // A datagram is read into these first and counts only when all of it was good.
  private final SlotSet named = new SlotSet(); // a slot comes once at most
  private int[] slots = {};
  private byte[] kinds = {};
  private int[] ages = {};
  private int[] indices = {};
  private int[] identities = {};
  private int[] owners = {};
  private QuantizedPose[] poses = {};
  private final QuantizedPose scratch = new QuantizedPose();
  private final Track track = new Track();
  private int count;
  private final int[] lastIndex = new int[Baseline.MOST_POSES];
  private int[] touchedSlots = {};
  private int touched;

  /** Creates a decoder that knows nothing, of a game without fields. */
  public SnapshotDecoder(int capacity, int epoch, int tick, int tickRate) {
    this(capacity, epoch, tick, tickRate, 0, new TableInbox());
  }

  /**
   * Creates a decoder that knows nothing.
   *
   * @param capacity entity slots, at least the server's; 1..65,535
   * @param epoch as in {@code Welcome}, 0..7
   * @param tick the server's tick in {@code Welcome}: datagrams carry 16 bits of theirs
   * @param tickRate ticks per second, as in {@code Welcome}
   * @param words number of words of the player's fields in an own section
   * @param tables takes the rows of the server's tables, whose layouts it has
   */
  public SnapshotDecoder(
      int capacity, int epoch, int tick, int tickRate, int words, TableInbox tables) {
    own = new OwnInbox(words);
    this.tables = tables;
    this.capacity = capacity;
    mark = DatagramMark.ofState(epoch);
    this.tick = tick;
    newestTick = tick;
    predictor = new Predictor(tickRate);
    deltas = new DeltaCodec();
    named.ensure(capacity);
    growRecords(MIN_RECORDS);
  }

  /**
   * Takes over the entities of the level file, before the first datagram. Each has its place in the
   * level as its state of tick 0 until the server says otherwise.
   *
   * @param state the same as the server's {@code FrameRing.level}
   */
  public void level(FrameState state) {
    for (int slot = 0; slot < state.slotLimit(); slot++) {
      if (state.alive(slot)) {
        state.pose(slot, scratch);
        int kind = EntityHistory.kindOf(state.generation(slot), state.archetype(slot), 0);
        historyFor(slot).add(0, kind, state.ownership(slot), scratch);
      }
    }
  }

  /**
   * Sets gravity, m/s^2, before the first datagram; it is zero until then.
   *
   * @param x the same as the server's {@code FrameRing.gravity}
   */
  public void gravity(float x, float y) {
    predictor.gravity(x, y);
  }

  /**
   * Decodes a datagram. After {@code OK} the other methods return what it held; after any other
   * status nothing has changed.
   */
  public DecodeStatus decode(byte[] bytes, int offset, int length) {
    if (length < MIN_BYTES || length > SnapshotEncoder.MAX_DATAGRAM_BYTES) {
      return DAMAGED;
    }
    reader.reset(bytes, offset, length);
    head.code(reader, newestTick);
    if (head.mark != mark) {
      return DecodeStatus.STALE;
    }
    DecodeStatus seen = receipts.status(head.sequence);
    if (seen != OK) {
      return seen;
    }
    DecodeStatus status = read(bytes, offset + length);
    if (status == OK) {
      receipts.add(head.sequence);
      keep();
    }
    return status;
  }

  /** Reads what follows the head. */
  private DecodeStatus read(byte[] bytes, int end) {
    BitReader r = reader;
    if (head.tick < 0) {
      return DAMAGED;
    }
    if (head.hasOwn) {
      if (!own.hasBaseline(head.tick, head.ownAge)) {
        return DecodeStatus.NO_BASELINE;
      }
      if (!own.read(r, head.tick, head.ownAge)) {
        return DAMAGED;
      }
    }
    events.read(r, head.tick);
    tables.read(r);
    int at = r.align();
    if (r.failed()) {
      return DAMAGED;
    }
    range.reset(bytes, at, end - at);
    if (head.hasOwn) {
      own.readRows(range);
    }
    return readRecords(head.tick);
  }

  private DecodeStatus readRecords(int datagramTick) {
    RangeDecoder r = range;
    count = 0;
    named.clear();
    records.begin();
    for (int kind; (kind = records.kind(r, RecordCodec.END)) != RecordCodec.END; ) {
      DecodeStatus status =
          kind == RecordCodec.RUN ? readRun(datagramTick) : readSingle(kind) ? OK : DAMAGED;
      if (status != OK) {
        return status;
      }
      if (r.exhausted()) {
        return DAMAGED;
      }
    }
    return r.finished() ? OK : DAMAGED;
  }

  private boolean readSingle(int kind) {
    int slot = records.slot(range, 0);
    if (!open(kind, slot)) {
      return false;
    }
    if (kind == RecordCodec.ABSOLUTE) {
      int generation = records.generation(range, 0);
      int archetype = records.archetype(range, 0);
      owners[count] = records.owner(range, 0);
      identities[count] = EntityHistory.kindOf(generation, archetype, records.teleports(range, 0));
      records.absolute(range, poses[count]);
      if (!poses[count].inRange()) {
        return false;
      }
    }
    count++;
    return true;
  }

  private DecodeStatus readRun(int datagramTick) {
    RangeDecoder r = range;
    records.run(r, 0, 0, 0, 0, 0);
    int baseline = records.baseline();
    r.cut();
    long which = SlotCodec.code(r, records.density(), 0);
    r.cut();
    if (!Baseline.isValid(baseline) || which == 0) {
      return DAMAGED;
    }
    long quick = received(which, datagramTick, baseline);
    for (long rest = which; rest != 0; rest &= rest - 1) {
      int slot = (records.word() << 6) + Long.numberOfTrailingZeros(rest);
      if (!open(RecordCodec.RUN, slot) || r.exhausted()) {
        return DAMAGED;
      }
      boolean isQuick = (quick >>> slot & 1) != 0;
      if (isQuick) {
        receivedBaseline(slot, datagramTick, baseline);
      } else if (!baseline(slot, datagramTick, baseline)) {
        return DecodeStatus.NO_BASELINE;
      }
      int profile = (slot & 32) == 0 ? records.lowProfile() : records.highProfile();
      predictor.study(track, baseline);
      predictor.predict(track, profile, poses[count]);
      deltas.profile(profile);
      int rested = deltas.code(r, track, scratch, 0);
      r.cut();
      ages[count] = Baseline.age(baseline) - rested;
      if (ages[count] <= 0) {
        return DAMAGED;
      }
      ages[count] = isQuick && rested == 0 ? NOTHING_TO_HOLD : ages[count];
      poses[count].addResidual(scratch);
      if (!poses[count].inRange()) {
        return DAMAGED;
      }
      count++;
    }
    return OK;
  }

  /** Begins the next record; returns false for a slot out of range, named twice, or too many. */
  private boolean open(int kind, int slot) {
    if (slot < 0 || slot >= capacity || named.has(slot) || count == RecordCodec.MAX_RECORDS) {
      return false;
    }
    named.add(slot);
    if (count == slots.length) {
      growRecords(2 * count);
    }
    slots[count] = slot;
    kinds[count] = (byte) kind;
    ages[count] = NOTHING_TO_HOLD;
    return true;
  }

  /** Returns those of a run's slots whose poses of a baseline are all among those received. */
  private long received(long which, int datagramTick, int baseline) {
    long result = which;
    for (int i = 0; i < Baseline.poses(baseline); i++) {
      int back = Baseline.age(baseline) + i * Baseline.stride(baseline);
      result &= received.held(records.word(), datagramTick - back);
    }
    return result;
  }

  /** Loads what {@link #baseline} does, of a slot whose poses are among those received. */
  private void receivedBaseline(int slot, int datagramTick, int baseline) {
    for (int i = 0; i < Baseline.poses(baseline); i++) {
      int back = Baseline.age(baseline) + i * Baseline.stride(baseline);
      received.read(slot, datagramTick - back, track.pose(i));
    }
    indices[count] = 0;
    identities[count] = received.kind(slot);
    owners[count] = received.owner(slot);
  }

  /**
   * Loads the poses of a baseline into the track, and who it is into the next record; returns false
   * when one isn't known, or is another entity's.
   */
  private boolean baseline(int slot, int datagramTick, int baseline) {
    EntityHistory history = history(slot);
    int tick = datagramTick - Baseline.age(baseline);
    for (int i = 0; i < Baseline.poses(baseline); i++) {
      int index = history == null ? -1 : history.indexAt(tick, lastIndex[i]);
      if (index < 0 || !history.alive(index)) {
        return false;
      }
      lastIndex[i] = index; // mostly that of its neighbours, too
      history.pose(index, track.pose(i));
      if (i == 0) {
        indices[count] = index;
        identities[count] = history.kind(index);
        owners[count] = history.ownership(index);
      } else if (history.generation(index) != history.generation(indices[count])) {
        return false;
      }
      tick -= Baseline.stride(baseline);
    }
    return true;
  }

  private void growRecords(int length) {
    int old = slots.length;
    slots = Arrays.copyOf(slots, length);
    kinds = Arrays.copyOf(kinds, length);
    ages = Arrays.copyOf(ages, length);
    indices = Arrays.copyOf(indices, length);
    identities = Arrays.copyOf(identities, length);
    owners = Arrays.copyOf(owners, length);
    touchedSlots = Arrays.copyOf(touchedSlots, length);
    poses = Arrays.copyOf(poses, length);
    for (int i = old; i < length; i++) {
      poses[i] = new QuantizedPose();
    }
  }

  private void keep() {
    int datagramTick = head.tick;
    tick = datagramTick;
    hasNews = head.news;
    hasOwn = head.hasOwn;
    newestTick = Math.max(newestTick, datagramTick);
    feedback.set(head.feedback);
    events.keep(datagramTick);
    tables.keep(datagramTick);
    if (hasOwn) {
      own.keep(datagramTick);
    }
    for (int i = 0; i < count; i++) {
      EntityHistory history = historyFor(slots[i]);
      if (kinds[i] == RecordCodec.GONE) {
        history.addFree(datagramTick);
        continue;
      }
      if (kinds[i] == RecordCodec.OUT_OF_SIGHT) {
        history.addOutOfSight(datagramTick);
        continue;
      }
      if (ages[i] != NOTHING_TO_HOLD) {
        int held = datagramTick - ages[i];
        history.hold(history.indexAt(held, indices[i]), held, scratch);
      }
      history.add(datagramTick, identities[i], owners[i], poses[i]);
      received.add(slots[i], datagramTick, identities[i], owners[i], poses[i]);
    }
    System.arraycopy(slots, 0, touchedSlots, 0, count);
    touched = count;
  }

  private EntityHistory historyFor(int slot) {
    if (slot >= histories.length) {
      int grown = Math.min(capacity, Math.max(64, Math.max(slot + 1, 2 * histories.length)));
      histories = Arrays.copyOf(histories, grown);
    }
    if (histories[slot] == null) {
      histories[slot] = new EntityHistory();
      slotLimit = Math.max(slotLimit, slot + 1);
    }
    return histories[slot];
  }

  /** Returns the tick of the last decoded datagram, which holds the state after this tick. */
  public int tick() {
    return tick;
  }

  /** Returns the newest tick of all datagrams; before the first, that of {@code Welcome}. */
  public int newestTick() {
    return newestTick;
  }

  /** Returns the feedback of the last decoded datagram; not {@code present} if it had none. */
  public InputFeedback feedback() {
    return feedback;
  }

  /**
   * Returns whether the last decoded datagram held anything that the server didn't know the client
   * to have. If so, the server waits for the ack.
   */
  public boolean hasNews() {
    return hasNews;
  }

  /** Returns whether the last decoded datagram had an own section. */
  public boolean hasOwn() {
    return hasOwn;
  }

  /**
   * Returns the own section of the last decoded datagram: the exact state after {@link #tick}.
   * Valid if {@link #hasOwn}, until the next {@link #decode}.
   */
  public OwnState own() {
    return own.own();
  }

  /** Returns the inputs of other players that were received; always the same object. */
  public RelayedInputs inputs() {
    return own.inputs();
  }

  /** Returns the events that were received; always the same object. */
  public EventInbox events() {
    return events;
  }

  /** Returns the rows of the server's tables that were received; always the same object. */
  public TableInbox tables() {
    return tables;
  }

  /** Returns the number of records in the last decoded datagram. */
  public int touchedCount() {
    return touched;
  }

  /** Returns the slot of a record of the last decoded datagram; index 0..touchedCount - 1. */
  public int touchedSlot(int index) {
    if (index < 0 || index >= touched) {
      throw new IndexOutOfBoundsException("index=" + index + " is outside 0.." + (touched - 1));
    }
    return touchedSlots[index];
  }

  /** Returns one more than the highest slot ever seen: iterate {@link #history} below it. */
  public int slotLimit() {
    return slotLimit;
  }

  /**
   * Returns what is known of a slot, or null when nothing ever was. Always the same object, which
   * {@link #decode} changes.
   */
  public EntityHistory history(int slot) {
    return slot < histories.length ? histories[slot] : null;
  }

  /** Returns whether any datagram was decoded: before that, there is nothing to ack. */
  public boolean hasAck() {
    return receipts.any();
  }

  /** Returns the sequence number of the newest datagram decoded. */
  public int ackSequence() {
    return receipts.newest();
  }

  /** Returns the ack bits: bit i = datagram {@code ackSequence() - 1 - i} was decoded. */
  public long ackBits() {
    return receipts.older();
  }
}
