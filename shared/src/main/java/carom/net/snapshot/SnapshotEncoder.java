package carom.net.snapshot;

import carom.net.codec.BitWriter;
import carom.net.codec.RangeEncoder;
import carom.net.protocol.DatagramMark;
import carom.net.snapshot.exact.NearRowCodec;
import carom.net.snapshot.exact.OwnAcks;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.RulingDelivery;
import carom.net.snapshot.exact.UpdateDelivery;
import carom.net.snapshot.frame.EventOutbox;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.ledger.DatagramLedger;
import carom.net.snapshot.table.RowAudience;
import carom.net.snapshot.table.TableOutbox;
import carom.net.snapshot.table.Tables;
import java.util.function.LongConsumer;

/**
 * Writes the snapshots of one session. Each tick that sends calls, after {@link FrameRing#end}:
 *
 * <pre>{@code
 * encoder.receiveAck(ackSequence, ackBits);            // from each input datagram
 * encoder.begin(feedback, own, budgetBytes);
 * for (int n; (n = encoder.next(buffer)) > 0; ) link.sendDatagram(buffer, 0, n);
 * }</pre>
 *
 * <p>An entity whose quantised state hasn't changed since a tick that the client acked costs
 * nothing, neither bytes nor time. All others in sight are sent as far as the budget goes, the
 * highest collected priority first. A lost datagram is never sent again: the newest state is sent
 * until one of its records is acked.
 *
 * <p>One thread, no allocation in the steady state.
 */
public final class SnapshotEncoder {
  /** Size of the largest datagram, and of the array for {@link #next}, bytes. */
  public static final int MAX_DATAGRAM_BYTES = 1_200;

  /**
   * Least budget that another datagram is begun for, bytes. With less, the headers on the path
   * would cost more than the datagram holds. Any record fits.
   */
  private static final int MIN_FURTHER_BYTES = 64;

  /**
   * Part of the budget that events may take, and again that rows of tables may take, as a divisor.
   * Others wait for the next datagram.
   */
  private static final int SHARE = 4;

  private final FrameRing ring;
  private final int mark;
  private final RangeEncoder range = new RangeEncoder();
  private final NearRowCodec nearRows = new NearRowCodec();
  private final DatagramHead head = new DatagramHead();
  private final DatagramLedger ledger = new DatagramLedger();
  private final BitWriter writer = new BitWriter();

  private final ClientKnowledge client;
  private final Selection selection;
  private final RecordsWriter records;
  private final SnapshotReport report;
  private final OwnAcks own;
  private final UpdateDelivery updates = new UpdateDelivery(ledger);
  private final RulingDelivery rulings = new RulingDelivery(ledger);
  private final EventOutbox events;
  private final TableOutbox tables;

  private final InputFeedback feedback = new InputFeedback();

  private boolean sendOwn;
  private boolean news;

  private FrameState frame;
  private boolean first;
  private int budget;
  private int headerBytes;

  /**
   * Creates the encoder of a client that sees everything. No other encoder shares its deltas.
   *
   * @param ring the room's frames
   * @param epoch as in the other constructor
   * @param tickRate ticks per second, for prediction; the client's decoder must be given the same
   */
  public SnapshotEncoder(FrameRing ring, int epoch, int tickRate) {
    this(new Deltas(ring, tickRate), epoch, Interest.EVERYTHING, Tables.NONE, null);
  }

  /**
   * Creates the encoder of a client that knows nothing but the ring's {@link FrameRing#level}.
   *
   * @param deltas those of the room, shared by all sessions, like the frames they are of
   * @param epoch that of the client's last {@code Welcome}, 0..7
   * @param interest what the client is told about
   * @param tables those of the room, shared by all sessions
   * @param audience what the client may know of them; null without tables
   */
  public SnapshotEncoder(
      Deltas deltas, int epoch, Interest interest, Tables tables, RowAudience audience) {
    ring = deltas.ring();
    events = new EventOutbox(ring.events(), ledger);
    this.tables = new TableOutbox(tables, audience, ledger);
    RecordSizes sizes = new RecordSizes();
    client = new ClientKnowledge(ring, ledger, interest, sizes, deltas.bestStride());
    selection = new Selection(ring, interest, sizes, client);
    records = new RecordsWriter(deltas, selection, client, range);
    report = new SnapshotReport(ring, client, selection, events);
    own = new OwnAcks(ring, ledger);
    mark = DatagramMark.ofState(epoch);
  }

  /**
   * Tells the client of an event of {@link FrameRing#events}, reliably and in the order of the
   * calls.
   */
  public void offer(long eventNumber) {
    events.offer(eventNumber);
  }

  /**
   * Offers the events that the client of another encoder of the same frames lacks: those not sent
   * or not acked. All events of the oldest such tick are sent again.
   */
  public void takeOverEvents(SnapshotEncoder before) {
    events.takeOver(before.events);
  }

  /** Passes on the numbers of the events that the client may lack, whole ticks of them. */
  public void forEachUnacknowledged(LongConsumer reader) {
    events.forEachUnacknowledged(reader);
  }

  /** Returns what the client is told of the room's tables. */
  public TableOutbox tables() {
    return tables;
  }

  /** Returns what brings the client the exact update that {@link #begin} is given parts of. */
  public UpdateDelivery updates() {
    return updates;
  }

  /** Returns what brings the client the rulings that {@link #begin} is given. */
  public RulingDelivery rulings() {
    return rulings;
  }

  /** Returns those of 64 neighbouring slots, from 64 {@code word} on, that the client sees. */
  public long inSight(int word) {
    return client.inSight(word);
  }

  /**
   * Takes a client's acks. Anything is accepted: what was never sent, or is too old, changes
   * nothing.
   *
   * @param ackSequence newest snapshot datagram the client received, 16 bits
   * @param ackBits bit i = datagram {@code ackSequence - 1 - i} was received
   */
  public void receiveAck(int ackSequence, long ackBits) {
    ledger.receive(ackSequence, ackBits, ring.newest() == null ? 0 : ring.newest().tick());
  }

  /** Makes the slot's next record absolute, even if the client acknowledged an earlier one. */
  public void force(int slot) {
    if (slot < 0 || slot >= ring.capacity()) {
      throw new IndexOutOfBoundsException(
          "slot=" + slot + " is outside 0.." + (ring.capacity() - 1));
    }
    client.force(slot);
  }

  /**
   * Offers an entity that may have come into the client's view. If the {@link Interest} sees it,
   * its records are sent from the next {@link #begin} on. Only entities that the client doesn't
   * know need this, and only if not everything is of interest.
   */
  public void notice(int slot) {
    client.notice(slot);
  }

  /**
   * Returns whether the client has acked everything of the newest frame and this own state. If so,
   * the server may send less often.
   *
   * @param state as for {@link #begin}
   */
  public boolean nothingNew(OwnState state) {
    FrameState newest = ring.newest();
    if (newest == null) {
      return true;
    }
    if (events.isDue(newest.tick()) || tables.hasDue(newest.tick())) {
      return false;
    }
    if (state != null && !own.isKnown(state, newest)) {
      return false;
    }
    return client.update(newest) == 0;
  }

  /**
   * Starts the datagrams of the ring's newest frame. Entities that do not fit the budget wait and
   * collect priority.
   *
   * @param feedback about the client's inputs; copied
   * @param state the player's exact state at the newest frame's tick, or null to send none; copied
   * @param budgetBytes for all datagrams of this tick; the first one's header and own section are
   *     sent anyway
   * @throws IllegalStateException when the ring has no frame
   */
  public void begin(InputFeedback feedback, OwnState state, int budgetBytes) {
    frame = ring.newest();
    if (frame == null) {
      throw new IllegalStateException("begin() before the first frame was captured");
    }
    this.feedback.set(feedback);
    sendOwn = state != null;
    if (sendOwn) {
      own.begin(state, frame.tick());
    }
    int count = client.updated(frame);
    boolean knowsOwn = !sendOwn || own.isKnown(state, frame);
    int rows = tables.unacked(frame.tick());
    news = count > 0 || rows > 0 || events.hasUnacked() || !knowsOwn;
    selection.choose(frame, count, Math.max(0, budgetBytes - headerBytes));
    budget = budgetBytes;
    report.begin(frame.tick(), news, budgetBytes);
    first = true;
  }

  /**
   * Writes the next datagram of this tick. The first call after {@link #begin} always writes one.
   *
   * @param out at least {@link #MAX_DATAGRAM_BYTES}
   * @return its length, or 0 when there is nothing more to send this tick
   */
  public int next(byte[] out) {
    if (!first && (frame == null || budget < MIN_FURTHER_BYTES || !hasMore())) {
      frame = null;
      return 0;
    }
    boolean withOwn = first && sendOwn;
    BitWriter w = writer;
    w.reset(out, 0, MAX_DATAGRAM_BYTES);
    int nearBytes = writeHeader(w, ledger.begin(frame.tick(), news), withOwn);
    int header = w.bytes();
    int room = 8 * (Math.min(MAX_DATAGRAM_BYTES, Math.max(budget, 0)) - header);
    range.reset(out, header, MAX_DATAGRAM_BYTES - header);
    if (withOwn && own.now().near.updating) {
      nearRows.part(range, own.now());
    }
    int rowBytes = range.bits() / Byte.SIZE;
    report.wroteAhead(header + rowBytes, nearBytes + rowBytes);
    headerBytes = first ? header + rowBytes : headerBytes;
    records.write(frame, room - RecordsWriter.END_BITS);
    int length = header + range.finish();
    ledger.end(length);
    budget -= length;
    first = false;
    return length;
  }

  private boolean hasMore() {
    return selection.hasChosen() || tables.hasDue(frame.tick());
  }

  /** Writes all but rows and records; returns the bytes of the near section. */
  private int writeHeader(BitWriter w, int sequence, boolean withOwn) {
    head.mark = mark;
    head.sequence = sequence;
    head.tick = frame.tick();
    head.news = news;
    head.feedback.set(feedback);
    head.feedback.present &= first;
    head.hasOwn = withOwn;
    head.ownAge = withOwn ? own.age(frame.tick()) : 0;
    head.code(w, frame.tick());
    int nearBytes = 0;
    if (withOwn) {
      nearBytes = own.write(w, head.ownAge);
      updates.wrote(frame.tick());
      rulings.wrote();
    }
    int share = Math.min(budget, MAX_DATAGRAM_BYTES) * Byte.SIZE / SHARE;
    events.write(w, frame.tick(), share);
    tables.write(w, frame.tick(), share);
    return nearBytes;
  }

  /** Returns what became of the last snapshot, and what this encoder knows of its client. */
  public SnapshotReport report() {
    return report;
  }

  /** Returns the ledger of the datagrams written, with figures of the line. For reading only. */
  public DatagramLedger ledger() {
    return ledger;
  }

  /** Returns the sequence number of the last datagram written, 16 bits. */
  public int sequence() {
    return ledger.sequence();
  }
}
