package carom.server.replication;

import carom.net.protocol.ProtocolLimits;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.EventRing;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.ledger.DatagramLedger;
import carom.net.transport.Link;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import java.util.function.LongConsumer;
import java.util.function.Supplier;

/**
 * Sends one session's snapshots over one link, and decides when and how much.
 *
 * <p>When: at the snapshot rate, or at the slower keep-alive rate while the client has everything.
 * How much: what a token bucket of bytes and the client's line allow. Headers and the own body come
 * first. The exact state of the predicted set and the records share the rest, so that neither
 * starves the other.
 *
 * <p>The room's thread; no allocation after construction.
 */
final class SnapshotSender {
  /** Depth of the token bucket: the full datagrams that may leave at once after a quiet time. */
  private static final int BURST_DATAGRAMS = 4;

  /**
   * Silence of a client, in keep-alive intervals, after which it is sent more keep-alives. Where
   * losses come in bursts, a rare keep-alive would leave the client cut off for long.
   */
  private static final double SILENT_PAUSES = 1.5;

  /** Least rate of snapshots while there is news, or the client is silent. */
  private static final int LEAST_WITH_NEWS_HZ = 12;

  /** Least rate while the client's inputs come too late, because its clock learns from each. */
  private static final int LEAST_WHEN_LATE_HZ = 20;

  /**
   * Most bytes by which exact state may get ahead of the records that wait, or fall behind them.
   */
  private static final int NEAR_CREDIT_BYTES = 2 * SnapshotEncoder.MAX_DATAGRAM_BYTES;

  /** A slow line lowers that to what it carries in one part of a second of so many. */
  private static final int NEAR_CREDIT_PER_SECOND = 8;

  /** Weight of the newest round trip in the smoothed one. */
  private static final float ROUND_TRIP_WEIGHT = 0.1f;

  private static final float MS_PER_S = 1_000;

  private final Supplier<ServerConfig> settings;
  private ServerConfig config;
  private final FrameRing frames;
  private final SessionView view;
  private final FieldAudience audience;
  private final SnapshotEncoder encoder;
  private final DatagramLedger ledger;
  private final Counters counters;
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final int tickRateHz;
  private int snapshotRateHz;
  private final int keepAliveTicks;
  private final int newsTicks;
  private final int lateTicks;
  private int bytesPerSecond;
  private final long bucketDepth; // in byte-ticks: bytes times tickRateHz, so that no rest is lost
  private final LinkPace pace;
  private long bucket;
  private int nearCredit = NEAR_CREDIT_BYTES;
  private long nextEvent;
  private long lostSeen;
  private int rateAccumulator;
  private int ticksSinceSent;
  private int ticksSinceHeard;

  /** Ticks for which a client that was silent is still sent more keep-alives. */
  private int answerTicks;

  private boolean due;
  private long bytesSent;

  /** Smoothed ticks from sending a snapshot to its acknowledgement; negative before the first. */
  private float roundTripTicks = -1;

  /**
   * Creates the sender for a client that knows nothing but the level.
   *
   * @param capture the room's frames
   * @param player the player that the client belongs to
   * @param epoch that of the session's Welcome
   * @param settings returns the present settings of the server
   */
  public SnapshotSender(
      FrameCapture capture,
      HostPlayer player,
      int epoch,
      Supplier<ServerConfig> settings,
      Counters counters) {
    this.settings = settings;
    config = settings.get();
    this.frames = capture.frames();
    this.view =
        new SessionView(
            capture.index(),
            player,
            config.get(ServerConfig.VIEW),
            config.get(ServerConfig.TICK_RATE));
    this.audience = new FieldAudience(capture, new JointAudience(capture, view), player);
    this.encoder = new SnapshotEncoder(capture.deltas(), epoch, view, capture.tables(), audience);
    audience.of(encoder);
    this.ledger = encoder.ledger();
    this.counters = counters;
    this.tickRateHz = config.get(ServerConfig.TICK_RATE);
    this.snapshotRateHz = Math.min(config.snapshotRateHz(), tickRateHz);
    this.keepAliveTicks = Math.max(1, tickRateHz / config.get(ServerConfig.KEEP_ALIVE_RATE));
    this.newsTicks = Math.min(keepAliveTicks, Math.max(1, tickRateHz / LEAST_WITH_NEWS_HZ));
    this.lateTicks = Math.min(newsTicks, Math.max(1, tickRateHz / LEAST_WHEN_LATE_HZ));
    this.bytesPerSecond = config.bytesPerSecond();
    this.bucketDepth = (long) BURST_DATAGRAMS * SnapshotEncoder.MAX_DATAGRAM_BYTES * tickRateHz;
    this.bucket = bucketDepth;
    // Headers come on top of the budget; small datagrams double it.
    this.pace = new LinkPace(tickRateHz, 2 * bytesPerSecond);
    this.rateAccumulator = tickRateHz; // the first tick sends
    this.ticksSinceSent = keepAliveTicks;
    this.nextEvent = frames.events().limit();
  }

  /**
   * Notes which events the player may hear of while it has no link; call once per tick. The view
   * moves only when there is something to hear.
   */
  public void listen() {
    if (nextEvent < frames.events().limit()) {
      view.follow(frames.newest());
      offerEvents();
    }
  }

  /**
   * Takes over the events that the player hasn't acknowledged yet.
   *
   * @param before the sender of the link that was lost, which went on to {@link #listen}
   */
  public void takeOver(SnapshotSender before) {
    nextEvent = before.nextEvent;
    encoder.takeOverEvents(before.encoder);
  }

  /** Passes on the numbers of the events that the player may not have heard of. */
  public void forEachUnacknowledged(LongConsumer reader) {
    encoder.forEachUnacknowledged(reader);
  }

  /** Offers an event of the ring that the player may not have heard of. */
  public void offer(long number) {
    encoder.offer(number);
  }

  /** Takes a client's acks as they are; see {@link SnapshotEncoder#receiveAck}. */
  public void receiveAck(int ackSequence, long ackBits) {
    if (isSilent()) {
      answerTicks = keepAliveTicks; // it waits to learn which of its inputs were used
    }
    ticksSinceHeard = 0;
    encoder.receiveAck(ackSequence, ackBits);
    int delay = ledger.ackDelayTicks();
    if (delay >= 0) {
      pace.acked(delay);
      float smooth = roundTripTicks + ROUND_TRIP_WEIGHT * (delay - roundTripTicks);
      roundTripTicks = roundTripTicks < 0 ? delay : smooth;
    }
  }

  /** Takes over what the client says it shows; see {@link SessionView#look}. */
  public void look(float x, float y, float halfWidth, float halfHeight, int follows) {
    view.look(x, y, halfWidth, halfHeight, follows);
  }

  /** Returns whether the game lets the player know of an entity; of the own body it always does. */
  public boolean mayKnow(HostEntity e) {
    return view.mayKnow(frames.newest(), e);
  }

  /** Returns whether the player looks at the place of an entity and may know it. */
  boolean sees(int entityId) {
    FrameState frame = frames.newest();
    return entityId < frame.slotLimit()
        && frame.alive(entityId)
        && view.sees(frame, entityId, true);
  }

  /** Earns budget for a tick; call once per tick, before anything else. */
  public void tick() {
    if (!settings.get().equals(config)) {
      config = settings.get();
      snapshotRateHz = Math.min(config.snapshotRateHz(), tickRateHz);
      bytesPerSecond = config.bytesPerSecond();
      pace.limit(2 * bytesPerSecond);
    }
    bucket = Math.min(bucketDepth, bucket + bytesPerSecond);
    pace.tick(
        ledger.ackedBytes() + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES * ledger.ackedDatagrams());
  }

  /**
   * Prepares a snapshot of the newest frame, and decides whether it {@linkplain #isDue is due};
   * call once per tick, between {@link #tick} and {@link #send}.
   *
   * @param own the player's exact state
   * @param late whether the client's inputs come too late
   */
  public void prepare(OwnState own, boolean late) {
    // The bound forgets the time in which nothing was due, but not the rest of a rate that doesn't
    // divide the tick rate.
    rateAccumulator = Math.min(tickRateHz + snapshotRateHz - 1, rateAccumulator + snapshotRateHz);
    ticksSinceSent++;
    ticksSinceHeard++;
    answerTicks = Math.max(0, answerTicks - 1);
    due = rateAccumulator >= tickRateHz;
    if (due) {
      view.update(frames.newest(), encoder);
      audience.update(frames.newest().tick());
      offerEvents();
      boolean news = !encoder.nothingNew(own);
      // Over budget, or over what the line takes: fewer snapshots, never none, each of the newest
      // tick.
      due =
          ticksSinceSent >= mostTicksWithout(news, late)
              || (news && bucket > 0 && budgetBytes() >= leastBytes());
    }
  }

  /**
   * Returns the least budget that a snapshot is worth. While records wait, it holds as much of them
   * as of what goes ahead of them: on a slow line, snapshots that are sent as soon as their headers
   * fit would never tell of a body.
   */
  private int leastBytes() {
    return encoder.report().waiting() == 0
        ? 1
        : Math.min(2 * overheadBytes(), pace.mostAllowance());
  }

  /** Returns the most ticks between two snapshots. */
  private int mostTicksWithout(boolean news, boolean late) {
    if (late) {
      return lateTicks;
    }
    return news || isSilent() || answerTicks > 0 ? newsTicks : keepAliveTicks;
  }

  private boolean isSilent() {
    return ticksSinceHeard > SILENT_PAUSES * keepAliveTicks;
  }

  /** Returns whether the snapshot prepared last may be sent. */
  public boolean isDue() {
    return due;
  }

  /**
   * Returns how much the exact state of the predicted set may take in the next snapshot, bits; not
   * positive if it must wait.
   */
  public int nearBits() {
    return nearCredit <= 0 ? 0 : Byte.SIZE * (budgetBytes() - overheadBytes());
  }

  private int budgetBytes() {
    return (int) Math.max(0, Math.min(bucket / tickRateHz, pace.allowance()));
  }

  /** Returns the bytes of the last snapshot before exact state and records. */
  private int overheadBytes() {
    return encoder.report().aheadBytes() - encoder.report().nearBytes();
  }

  private void offerEvents() {
    EventRing events = frames.events();
    for (; nextEvent < events.limit(); nextEvent++) {
      if (events.holds(nextEvent)
          && view.hears(frames, events.at(nextEvent), events.audience(nextEvent))) {
        encoder.offer(nextEvent);
        counters.add(Counter.EVENTS_OFFERED, 1);
      }
    }
    if (encoder.report().eventsLost() != lostSeen) {
      counters.add(Counter.EVENTS_LOST, encoder.report().eventsLost() - lostSeen);
      lostSeen = encoder.report().eventsLost();
    }
  }

  /**
   * Sends the newest frame, in as many datagrams as the budget allows, at least one.
   *
   * @param feedback about the client's inputs
   * @param own the player's exact state
   * @return datagrams sent
   */
  public int send(Link link, InputFeedback feedback, OwnState own) {
    rateAccumulator -= tickRateHz;
    ticksSinceSent = 0;
    encoder.begin(feedback, own, budgetBytes());
    int datagrams = 0;
    int bytes = 0;
    for (int length; (length = encoder.next(buffer)) > 0; ) {
      if (!link.sendDatagram(buffer, 0, length)) {
        counters.add(Counter.DATAGRAMS_UNSENT, 1);
      }
      pace.sent(length, encoder.report().hasNews());
      bucket = Math.max(-bucketDepth, bucket - (long) length * tickRateHz);
      counters.add(Counter.DATAGRAMS_OUT, 1);
      counters.add(Counter.SNAPSHOT_BYTES, length);
      datagrams++;
      bytes += length;
      bytesSent += length;
    }
    shareOut(bytes - encoder.report().aheadBytes());
    return datagrams;
  }

  /** Keeps exact state from taking more than the records in the long run, while records wait. */
  private void shareOut(int recordBytes) {
    int credit = nearCredit + recordBytes - encoder.report().nearBytes();
    // On a slow line fewer bytes: records must not wait for long.
    int most = Math.min(NEAR_CREDIT_BYTES, pace.bytesPerSecond() / NEAR_CREDIT_PER_SECOND);
    nearCredit = encoder.report().waiting() == 0 ? most : Math.max(-most, Math.min(most, credit));
  }

  /** Returns the round trip to the client and back, ms, or 0 before the first acknowledgement. */
  public int roundTripMs() {
    return roundTripTicks < 0 ? 0 : Math.max(1, Math.round(roundTripTicks * MS_PER_S / tickRateHz));
  }

  /** Returns the payload bytes sent over the link. */
  public long bytesSent() {
    return bytesSent;
  }

  /** Returns the estimated capacity of the client's line, bytes per second, headers included. */
  public int paceBytesPerSecond() {
    return pace.bytesPerSecond();
  }

  /** Returns the encoder, for inspection. */
  public SnapshotEncoder encoder() {
    return encoder;
  }
}
