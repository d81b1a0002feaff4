package carom.net.snapshot;

import carom.net.codec.RangeEncoder;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.QuantizedPose;

/**
 * Writes the records section of a datagram: of what {@link Selection} gives, as much as fits. One
 * thread, no allocation.
 */
final class RecordsWriter {
  /**
   * Most bits that the end of the records takes: the surprise of three nodes, and rounding twice.
   */
  static final int END_BITS = 35;

  /**
   * Most records or runs that don't fit the rest of a datagram and are passed over for shorter
   * ones.
   */
  private static final int MAX_PASSED_OVER = 8;

  /**
   * Bits that a short run takes besides its deltas, to say that it is a run and of which slots;
   * mostly less.
   */
  private static final int RUN_BITS = 40;

  private final Deltas deltas;
  private final Selection selection;
  private final ClientKnowledge client;
  private final RangeEncoder range;
  private final RecordCodec records = new RecordCodec();
  private final QuantizedPose actual = new QuantizedPose();

  private FrameState frame;
  private int room;
  private int written;
  private int passedOver;

  /**
   * Creates a writer.
   *
   * @param range what it writes into
   */
  RecordsWriter(Deltas deltas, Selection selection, ClientKnowledge client, RangeEncoder range) {
    this.deltas = deltas;
    this.selection = selection;
    this.client = client;
    this.range = range;
  }

  /**
   * Writes records and their end.
   *
   * @param frame the newest one
   * @param room bits that the arithmetic code may take before the end
   */
  void write(FrameState frame, int room) {
    this.frame = frame;
    this.room = room;
    records.begin();
    written = 0;
    passedOver = 0;
    selection.rewind();
    writeSingles();
    writeRuns();
    selection.toSpare();
    writeSingles();
    writeRuns();
    records.kind(range, RecordCodec.END);
  }

  /** Writes what is no delta. */
  private void writeSingles() {
    for (int slot; mayTry(1) && (slot = selection.nextSingle(frame)) >= 0; ) {
      int before = mark();
      writeSingle(slot, client.baseline(frame, slot));
      int after = range.bits();
      if (fits(after)) {
        written++;
        selection.wroteSingle(slot, frame.tick(), after - before);
      } else {
        passOver();
      }
    }
  }

  private void writeSingle(int slot, BaselineReason baseline) {
    if (baseline == BaselineReason.OUT_OF_SIGHT || baseline == BaselineReason.GONE) {
      boolean gone = baseline == BaselineReason.GONE;
      records.kind(range, gone ? RecordCodec.GONE : RecordCodec.OUT_OF_SIGHT);
      records.slot(range, slot);
      return;
    }
    records.kind(range, RecordCodec.ABSOLUTE);
    records.slot(range, slot);
    records.generation(range, frame.generation(slot));
    records.archetype(range, frame.archetype(slot));
    records.owner(range, frame.ownership(slot));
    records.teleports(range, frame.teleports(slot));
    frame.pose(slot, actual);
    records.absolute(range, actual);
  }

  private void writeRuns() {
    selection.toRuns();
    for (int left;
        mayTry(Long.SIZE)
            && (left = room - range.bits() - RUN_BITS) > 0
            && selection.nextRun(frame); ) {
      int word = selection.runWord();
      int baseline = selection.baseline();
      long slots = selection.runSlots();
      if (!writeRun(word, slots, baseline)) {
        writeRun(word, deltas.fitting(frame, baseline, word, slots, left), baseline);
      }
    }
  }

  private boolean writeRun(int word, long slots, int baseline) {
    if (slots == 0) {
      return false;
    }
    int before = mark();
    deltas.writeRun(range, records, frame, baseline, word, slots);
    int after = range.bits();
    if (!fits(after)) {
      passOver();
      return false;
    }
    written += Long.bitCount(slots);
    selection.wroteRun(word, slots, frame.tick(), after - before);
    return true;
  }

  /** Returns whether so many more records are allowed, and few enough were passed over. */
  private boolean mayTry(int count) {
    return passedOver <= MAX_PASSED_OVER && written + count <= RecordCodec.MAX_RECORDS;
  }

  private int mark() {
    range.mark();
    records.mark();
    return range.bits();
  }

  private boolean fits(int bits) {
    return !range.overflow() && bits <= room;
  }

  private void passOver() {
    range.rewind();
    records.rewind();
    passedOver++;
  }
}
