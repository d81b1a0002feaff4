package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitWriter;
import carom.net.codec.RangeEncoder;
import carom.net.protocol.DatagramMark;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.QuantizedPose;
import carom.net.snapshot.table.TableInbox;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

/**
 * Goal: a decoder stands any bytes. Method: cuts, damage, and damage under a right check; then good
 * datagrams must still count.
 */
class SnapshotWireTest {

  private static final int EPOCH = 6;

  private final Scene scene = new Scene(60, 0, 7);
  private SnapshotEncoder encoder = new SnapshotEncoder(scene.ring, EPOCH, Scene.TICK_RATE);
  private SnapshotDecoder decoder = newDecoder();
  private final InputFeedback feedback = new InputFeedback();
  private final OwnState own = new OwnState(4);
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];

  private static SnapshotDecoder newDecoder() {
    return new SnapshotDecoder(60, EPOCH, 0, Scene.TICK_RATE, 4, new TableInbox());
  }

  private byte[] datagram() {
    feedback.present = true;
    Scene.own(scene.tick, own);
    encoder.begin(feedback, own, Integer.MAX_VALUE);
    return Arrays.copyOf(buffer, encoder.next(buffer));
  }

  private byte[] nextDatagram() {
    scene.step();
    return datagram();
  }

  private void decodeAndAck(byte[] bytes) {
    assertEquals(DecodeStatus.OK, decoder.decode(bytes, 0, bytes.length));
    encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());
  }

  /** They would poison the client's prediction. */
  @Test
  void anOwnBodyOfNumbersThatAreNoneIsDamage() {
    scene.step();
    float[][] bodies = {{Float.NaN, 1, 0}, {Float.POSITIVE_INFINITY, 1, 0}, {0, 1, 1}, {0, 1, 0}};
    for (float[] b : bodies) {
      own.setBody(1, 1, b[0], 0, b[1], b[2], 0, 0, 0);
      encoder.begin(feedback, own, Integer.MAX_VALUE);
      byte[] bytes = Arrays.copyOf(buffer, encoder.next(buffer));
      boolean good = b[0] == 0 && b[2] == 0;
      assertEquals(
          good ? DecodeStatus.OK : DecodeStatus.DAMAGED, decoder.decode(bytes, 0, bytes.length));
    }
  }

  @Test
  void mostCutsAreDamage() {
    int accepted = 0;
    int cuts = 0;
    for (int round = 0; round < 40; round++) {
      byte[] bytes = nextDatagram();
      for (int length = 0; length < bytes.length; length++) {
        byte[] cut = Arrays.copyOf(bytes, length);
        // The head of an arithmetic code may be a shorter message.
        cuts++;
        SnapshotDecoder other = newDecoder();
        accepted += other.decode(cut, 0, length) == DecodeStatus.OK ? 1 : 0;
      }
      byte[] longer = Arrays.copyOf(bytes, bytes.length + 1);
      assertEquals(DecodeStatus.DAMAGED, decoder.decode(longer, 0, longer.length));
      decodeAndAck(bytes);
    }
    assertTrue(accepted < cuts / 10, "accepted=" + accepted + " of " + cuts);
    assertEquals(DecodeStatus.DAMAGED, decoder.decode(new byte[1_300], 0, 1_300));
  }

  /** Gives bytes the right mark and the next sequence number. */
  private static void next(SnapshotDecoder decoder, byte[] bytes) {
    int sequence = decoder.ackSequence() + 1;
    bytes[0] = (byte) (sequence << DatagramMark.BITS | DatagramMark.ofState(EPOCH));
    bytes[1] = (byte) (sequence >> Byte.SIZE - DatagramMark.BITS);
    bytes[2] = (byte) (bytes[2] & 0xf0 | sequence >> 2 * Byte.SIZE - DatagramMark.BITS & 0x0f);
  }

  @Test
  void hostileContentNeverThrows() {
    Dice dice = new Dice(5);
    Set<DecodeStatus> seen = EnumSet.noneOf(DecodeStatus.class);
    SnapshotDecoder victim = decoder;
    for (int round = 0; round < 300; round++) {
      if (round % 20 == 0) {
        encoder = new SnapshotEncoder(scene.ring, EPOCH, Scene.TICK_RATE);
        decoder = newDecoder();
        victim = newDecoder();
      }
      byte[] good = nextDatagram();
      if (round % 3 == 0) {
        decodeAndAck(good);
      }
      for (int i = 0; i < 200; i++) {
        byte[] bad = dice.percent(50) ? good.clone() : new byte[6 + dice.below(200)];
        int damages = bad.length == good.length ? 1 + dice.below(4) : bad.length;
        for (int d = 0; d < damages; d++) {
          bad[dice.below(bad.length)] = (byte) dice.next();
        }
        if (dice.percent(60)) {
          next(victim, bad);
        }
        seen.add(victim.decode(bad, 0, bad.length));
      }
      seen.add(victim.decode(good, 0, good.length));
      assertTrue(victim.slotLimit() <= 60, "no history beyond the capacity");
    }
    assertEquals(EnumSet.allOf(DecodeStatus.class), seen);
  }

  @Test
  void aRefusedDatagramChangesNothing() {
    decodeAndAck(nextDatagram());
    byte[] good = nextDatagram();
    int sequence = decoder.ackSequence();
    int tick = decoder.newestTick();
    int touched = decoder.touchedCount();
    byte[] bad = Arrays.copyOf(good, good.length + 1);
    assertEquals(DecodeStatus.DAMAGED, decoder.decode(bad, 0, bad.length));
    assertEquals(sequence, decoder.ackSequence());
    assertEquals(tick, decoder.newestTick());
    assertEquals(touched, decoder.touchedCount());
    decodeAndAck(good);
    assertEquals(scene.tick, decoder.newestTick());
  }

  @Test
  void duplicatesAndStaleDatagramsAreNamed() {
    byte[] first = nextDatagram();
    byte[] second = nextDatagram();
    assertEquals(DecodeStatus.OK, decoder.decode(second, 0, second.length));
    assertEquals(DecodeStatus.OK, decoder.decode(first, 0, first.length), "late, not stale");
    assertEquals(DecodeStatus.DUPLICATE, decoder.decode(first, 0, first.length));
    assertEquals(DecodeStatus.DUPLICATE, decoder.decode(second, 0, second.length));
    assertEquals(1, decoder.ackSequence());
    assertEquals(1, decoder.ackBits());
    byte[] skipped = nextDatagram();
    for (int i = 0; i < 64; i++) {
      decodeAndAck(nextDatagram());
    }
    assertEquals(-1L, decoder.ackBits() | 1L << 63);
    byte[] last = nextDatagram();
    decodeAndAck(last);
    assertEquals(DecodeStatus.STALE, decoder.decode(skipped, 0, skipped.length));
  }

  @Test
  void aDatagramOfAnotherEpochIsStale() {
    byte[] bytes = nextDatagram();
    SnapshotDecoder other =
        new SnapshotDecoder(60, EPOCH - 1, 0, Scene.TICK_RATE, 4, new TableInbox());
    assertEquals(DecodeStatus.STALE, other.decode(bytes, 0, bytes.length));
    assertFalse(other.hasAck());
  }

  @Test
  void aDeltaWithoutItsBaselineCountsAsLost() {
    decodeAndAck(nextDatagram());
    decodeAndAck(nextDatagram());
    byte[] delta = nextDatagram();
    SnapshotDecoder empty = newDecoder();
    assertEquals(DecodeStatus.NO_BASELINE, empty.decode(delta, 0, delta.length));
    assertFalse(empty.hasAck());
    assertNull(empty.history(0));
  }

  @Test
  void slotsBeyondTheCapacityAreDamage() {
    byte[] bytes = nextDatagram();
    SnapshotDecoder small = new SnapshotDecoder(1, EPOCH, 0, Scene.TICK_RATE, 4, new TableInbox());
    assertEquals(DecodeStatus.DAMAGED, small.decode(bytes, 0, bytes.length));
  }

  /** A datagram of records alone, all of them of slot 3: absolute at rest, gone, or such runs. */
  private static byte[] recordsOfOneSlot(int sequence, int tick, int age, int... kinds) {
    byte[] bytes = new byte[100];
    BitWriter w = new BitWriter();
    w.reset(bytes, 0, bytes.length);
    w.write(DatagramMark.ofState(EPOCH), DatagramMark.BITS);
    w.write(sequence, 16);
    w.write(tick, 16);
    w.write(0, 5); // no news, feedback, own section, events
    int header = w.bytes();
    RangeEncoder range = new RangeEncoder();
    range.reset(bytes, header, bytes.length - header);
    RecordCodec records = new RecordCodec();
    DeltaCodec deltas = new DeltaCodec();
    deltas.profile(0);
    records.begin();
    for (int kind : kinds) {
      records.kind(range, kind);
      if (kind == RecordCodec.RUN) {
        int baseline = Baseline.of(age, 1, 0);
        records.run(range, 0, baseline, 0, 0, 0);
        range.cut();
        SlotCodec.code(range, 0, 1 << 3);
        range.cut();
        Track track = new Track();
        new Predictor(Scene.TICK_RATE).study(track, baseline);
        deltas.code(range, track, new QuantizedPose(), 0);
        range.cut();
      } else {
        records.slot(range, 3);
      }
      if (kind == RecordCodec.ABSOLUTE) {
        records.generation(range, 1);
        records.archetype(range, 1);
        records.owner(range, -1);
        records.teleports(range, 0);
        records.absolute(range, new QuantizedPose());
      }
    }
    records.kind(range, RecordCodec.END);
    return Arrays.copyOf(bytes, header + range.finish());
  }

  /** The first of two could push the other's baseline out of a full history. */
  @Test
  void aSlotThatComesTwiceIsDamage() {
    int sequence = 0;
    for (int tick = 2; tick <= 2 * EntityHistory.SIZE; tick += 2) {
      byte[] bytes = recordsOfOneSlot(sequence++, tick, 0, RecordCodec.ABSOLUTE);
      assertEquals(DecodeStatus.OK, decoder.decode(bytes, 0, bytes.length));
    }
    EntityHistory history = decoder.history(3);
    assertEquals(EntityHistory.SIZE, history.size());
    for (int first = RecordCodec.RUN; first <= RecordCodec.OUT_OF_SIGHT; first++) {
      for (int second = RecordCodec.RUN; second <= RecordCodec.OUT_OF_SIGHT; second++) {
        byte[] twice = recordsOfOneSlot(sequence, 65, 63, first, second);
        String kinds = first + " then " + second;
        assertEquals(DecodeStatus.DAMAGED, decoder.decode(twice, 0, twice.length), kinds);
        assertEquals(sequence - 1, decoder.ackSequence(), kinds);
        assertEquals(2, history.tick(EntityHistory.SIZE - 1), kinds);
      }
    }
    byte[] once = recordsOfOneSlot(sequence, 65, 63, RecordCodec.RUN);
    assertEquals(DecodeStatus.OK, decoder.decode(once, 0, once.length));
    assertEquals(65, history.tick(history.indexAt(65)));
  }

  @Test
  void acksOfAnythingAreHarmless() {
    Dice dice = new Dice(8);
    encoder.receiveAck(0, -1);
    for (int i = 0; i < 500; i++) {
      nextDatagram();
      for (int j = 0; j < 5; j++) {
        encoder.receiveAck(dice.below(65_536), dice.next());
      }
      encoder.receiveAck(encoder.sequence() + 1, -1);
    }
    for (int slot = 0; slot < 60; slot++) {
      assertTrue(encoder.report().ackedTick(slot) <= scene.tick);
    }
  }

  @Test
  void theRingRefusesWrongOrder() {
    FrameRing ring = new FrameRing(4);
    assertThrows(IllegalStateException.class, ring::end);
    assertNull(ring.newest());
    FrameState frame = ring.begin(5);
    frame.put(0, 1, 2, -1, 1, 2, 3, 4, 5, 6);
    assertThrows(
        IllegalStateException.class, () -> frame.put(0, 1, 2, -1, 1, 2, 3, 4, 5, 6), "twice");
    assertThrows(
        IllegalArgumentException.class, () -> frame.put(4, 1, 2, -1, 1, 2, 3, 4, 5, 6), "slot");
    assertThrows(
        IllegalArgumentException.class,
        () -> frame.putQuantized(1, 1, 2, -1, 0, 0, 1024, true),
        "angle");
    assertThrows(
        IllegalArgumentException.class, () -> frame.put(1, 256, 2, -1, 1, 2, 3, 4, 5, 6), "gen");
    ring.end();
    assertThrows(IllegalStateException.class, () -> frame.put(1, 1, 2, -1, 1, 2, 3, 4, 5, 6));
    assertThrows(IllegalArgumentException.class, () -> ring.begin(5));
    assertThrows(IllegalArgumentException.class, () -> new FrameRing(0));
  }

  @Test
  void theRingFindsTicksAcrossGaps() {
    FrameRing ring = new FrameRing(2);
    int tick = 0;
    Dice dice = new Dice(3);
    for (int i = 0; i < 300; i++) {
      tick += 1 + (dice.percent(20) ? dice.below(70) : 0);
      ring.begin(tick).putQuantized(0, 1, 1, -1, i, 0, 0, true);
      ring.end();
      assertEquals(i, ring.newest().x(0));
      int found = 0;
      for (int t = tick - 5_000; t <= tick + 1; t++) {
        FrameState frame = ring.at(t);
        if (frame != null) {
          assertEquals(t, frame.tick());
          found++;
        }
      }
      assertEquals(Math.min(i + 1, FrameRing.SIZE), found);
    }
  }

  @Test
  void hashesFollowTheStateAlone() {
    FrameRing ring = new FrameRing(8);
    ring.begin(1).putQuantized(3, 1, 1, -1, 5, 6, 7, false);
    ring.end();
    long first = ring.newest().hash();
    ring.begin(2).putQuantized(3, 1, 1, -1, 5, 6, 7, false);
    ring.end();
    assertEquals(first, ring.newest().hash());
    assertEquals(1, ring.changedTick(3));
    ring.begin(3).putQuantized(3, 1, 1, 0, 5, 6, 7, false);
    ring.end();
    assertTrue(first != ring.newest().hash(), "the owner counts");
    assertEquals(3, ring.changedTick(3));
    ring.begin(4);
    ring.end();
    assertEquals(4, ring.changedTick(3), "so does death");
    assertEquals(-1, ring.changedTick(7));
    assertEquals(0, ring.newest().count());
  }
}
