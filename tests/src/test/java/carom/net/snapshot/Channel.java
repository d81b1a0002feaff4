package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.RelayedInputs;
import carom.net.snapshot.frame.PlayerSet;
import carom.net.snapshot.frame.WaitingInputs;
import carom.net.snapshot.table.TableInbox;
import carom.net.snapshot.table.Tables;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * An encoder and a decoder with a bad network between them, tick by tick. Every decoded datagram is
 * held against the scene: what the client has for a slot and tick must be exactly what the server
 * had.
 */
final class Channel {

  static final int EPOCH = 3;

  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Delayed(int atTick, byte[] bytes, int ackSequence, long ackBits) {}

  final Scene scene;
  final SnapshotEncoder encoder;
  SnapshotDecoder decoder;
  final Dice dice;
  final String name;
  double lossPercent;
  double duplicatePercent;
  double reorderPercent;
  int sendEvery = 1;
  int latencyTicks = 3;
  int jitterTicks;
  int budget = Integer.MAX_VALUE;
  boolean withOwn = true;

  /** What the client holds of earlier ticks is the level's word, which may be wrong. */
  int firstTold = Integer.MIN_VALUE;

  final Map<DecodeStatus, Integer> statuses = new EnumMap<>(DecodeStatus.class);
  long datagrams;
  long bytes;
  long records;
  final Set<Integer> touched = new TreeSet<>();
  int maxBytesPerTick;
  int maxWaiting;
  long inputsKnown;
  long inputsWaiting;

  private final List<Delayed> down = new ArrayList<>();
  private final List<Delayed> up = new ArrayList<>();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final InputFeedback feedback = new InputFeedback();
  private final OwnState own = new OwnState(4);
  private final OwnState expectedOwn = new OwnState(4);

  Channel(Scene scene, long seed) {
    this(scene, seed, Scene.TICK_RATE);
  }

  Channel(Scene scene, long seed, int tickRate) {
    this(scene, seed, tickRate, Interest.EVERYTHING);
  }

  Channel(Scene scene, long seed, int tickRate, Interest interest) {
    this.scene = scene;
    dice = new Dice(seed);
    name = "seed=" + seed;
    encoder =
        new SnapshotEncoder(new Deltas(scene.ring, tickRate), EPOCH, interest, Tables.NONE, null);
    decoder =
        new SnapshotDecoder(scene.slots, EPOCH, scene.firstTick, tickRate, 4, new TableInbox());
  }

  void tick() {
    if (scene.tick % sendEvery == 0) {
      send();
    }
    deliver();
    acknowledge();
  }

  private void send() {
    feedback.present = scene.tick % 7 != 0;
    feedback.sequence = scene.tick & 0xffff;
    feedback.holdMs = scene.tick % 256;
    feedback.margin = scene.tick % 64 - 32;
    Scene.own(scene.tick, own);
    encoder.begin(feedback, withOwn ? own : null, budget);
    int sum = 0;
    for (int n; (n = encoder.next(buffer)) > 0; ) {
      sum += n;
      assertTrue(n <= SnapshotEncoder.MAX_DATAGRAM_BYTES, name);
      datagrams++;
      byte[] copy = Arrays.copyOf(buffer, n);
      if (dice.percent(lossPercent)) {
        continue;
      }
      down.add(new Delayed(due(), copy, 0, 0));
      if (dice.percent(duplicatePercent)) {
        down.add(new Delayed(due(), copy.clone(), 0, 0));
      }
    }
    bytes += sum;
    maxBytesPerTick = Math.max(maxBytesPerTick, sum);
    maxWaiting = Math.max(maxWaiting, encoder.report().waiting());
  }

  private int due() {
    int late = dice.percent(reorderPercent) ? dice.below(6) : 0;
    int jitter = jitterTicks == 0 ? 0 : dice.below(jitterTicks + 1);
    return scene.tick + latencyTicks + jitter + late;
  }

  private void deliver() {
    for (int i = 0; i < down.size(); i++) {
      if (down.get(i).atTick <= scene.tick) {
        byte[] datagram = down.remove(i--).bytes;
        DecodeStatus status = decoder.decode(datagram, 0, datagram.length);
        statuses.merge(status, 1, Integer::sum);
        if (status == DecodeStatus.OK) {
          check();
        }
      }
    }
  }

  private void check() {
    int tick = decoder.tick();
    records += decoder.touchedCount();
    for (int i = 0; i < decoder.touchedCount(); i++) {
      int slot = decoder.touchedSlot(i);
      touched.add(slot);
      EntityHistory history = decoder.history(slot);
      int index = history.indexAt(tick);
      assertEquals(tick, history.tick(index), name);
      checkEntry(slot, history, index);
      if (index + 1 < history.size()) {
        checkEntry(slot, history, index + 1);
      }
    }
    if (decoder.feedback().present) {
      assertEquals(tick & 0xffff, decoder.feedback().sequence, name);
      assertEquals(tick % 256, decoder.feedback().holdMs, name);
      assertEquals(tick % 64 - 32, decoder.feedback().margin, name);
    }
    if (decoder.hasOwn()) {
      Scene.own(tick, expectedOwn);
      assertTrue(decoder.own().sameSection(expectedOwn), name + " own state of tick " + tick);
      checkInputs(tick, decoder.own().relayed());
    }
  }

  private void checkInputs(int tick, PlayerSet relayed) {
    RelayedInputs inputs = decoder.inputs();
    for (int p = relayed.next(0); p >= 0; p = relayed.next(p + 1)) {
      assertTrue(inputs.knows(p, tick), name + " input of player=" + p + " tick=" + tick);
      for (int ahead = 1; ahead <= WaitingInputs.MOST; ahead++) {
        if (inputs.knows(p, tick + ahead)) {
          inputsWaiting++;
          long truth = Scene.input(p, tick + ahead);
          assertEquals(truth, inputs.at(p, tick + ahead), name + " player=" + p + " +" + ahead);
        }
      }
      for (int back = 0; back < RelayedInputs.TICKS && back <= tick; back++) {
        if (inputs.knows(p, tick - back)) {
          inputsKnown++;
          long truth = Scene.input(p, tick - back);
          assertEquals(truth, inputs.at(p, tick - back), name + " player=" + p + " back=" + back);
        }
      }
    }
  }

  void checkEntry(int slot, EntityHistory history, int index) {
    if (history.outOfSight(index)) {
      return; // says nothing about the entity
    }
    int tick = history.tick(index);
    if (tick < firstTold) {
      return;
    }
    int[] truth = scene.truth(slot, tick);
    String where = name + " slot=" + slot + " tick=" + tick;
    assertEquals(truth != null, history.alive(index), where);
    if (truth != null) {
      assertEquals(truth[0], history.generation(index), where);
      assertEquals(truth[1], history.archetype(index), where);
      assertEquals(truth[2], history.ownership(index), where);
      assertEquals(truth[3], history.x(index), where);
      assertEquals(truth[4], history.y(index), where);
      assertEquals(truth[5], history.angle(index), where);
      assertEquals((truth[6] | truth[7] | truth[8]) == 0, history.still(index), where);
    }
  }

  private void acknowledge() {
    if (decoder.hasAck() && !dice.percent(lossPercent)) {
      up.add(new Delayed(due(), null, decoder.ackSequence(), decoder.ackBits()));
    }
    for (int i = 0; i < up.size(); i++) {
      if (up.get(i).atTick <= scene.tick) {
        Delayed ack = up.remove(i--);
        encoder.receiveAck(ack.ackSequence, ack.ackBits);
      }
    }
  }

  /** Everything in every history is true. */
  void checkHistories() {
    for (int slot = 0; slot < decoder.slotLimit(); slot++) {
      EntityHistory history = decoder.history(slot);
      for (int i = 0; history != null && i < history.size(); i++) {
        checkEntry(slot, history, i);
        if (i > 0) {
          assertTrue(history.tick(i) < history.tick(i - 1), name);
        }
      }
    }
  }

  /** The client shows exactly the world that the server has now. */
  void checkConverged() {
    for (int slot = 0; slot < scene.slots; slot++) {
      EntityHistory history = decoder.history(slot);
      int[] truth = scene.bodies[slot];
      if (truth == null) {
        assertFalse(history != null && history.alive(), name + " ghost in slot " + slot);
      } else {
        assertTrue(history != null && history.alive(), name + " nothing in slot " + slot);
        assertEquals(truth[3], history.x(0), name + " slot=" + slot);
        assertEquals(truth[4], history.y(0), name + " slot=" + slot);
        assertEquals(truth[5], history.angle(0), name + " slot=" + slot);
        assertEquals(truth[0], history.generation(0), name + " slot=" + slot);
      }
    }
  }

  int count(DecodeStatus status) {
    return statuses.getOrDefault(status, 0);
  }
}
