package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: events come through any loss, once and in order, and the bytes that carry them do no harm.
 * Method: an encoder and a decoder of an empty world with dice between them.
 */
class EventOverSnapshotsTest {
  private static final int KEY = 77;
  private static final int RATE = 60;

  private final FrameRing ring = new FrameRing(4);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, KEY, RATE);
  private final SnapshotDecoder decoder = new SnapshotDecoder(4, KEY, 0, RATE);
  private final InputFeedback feedback = new InputFeedback();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final List<EventRecord> sent = new ArrayList<>();
  private int tick;

  private void tick(int events, Random random) {
    ring.begin(++tick);
    ring.end();
    for (int i = 0; i < events; i++) {
      EventRecord e = new EventRecord();
      e.kind = random.nextInt(256);
      e.tick = tick;
      e.player = random.nextInt(257) - 1;
      e.first = random.nextBoolean() ? -1 : random.nextInt(65_535) | random.nextInt(256) << 16;
      e.second = random.nextBoolean() ? -1 : random.nextInt(65_535) | random.nextInt(256) << 16;
      e.place(random.nextFloat() * 100 - 50, random.nextFloat() * 1e6f);
      e.strength(random.nextFloat() * 1e9f);
      e.data = random.nextInt() >> random.nextInt(32);
      ring.events().add(e, 0);
      encoder.offer(ring.events().limit() - 1);
      sent.add(e);
    }
  }

  private byte[] next() {
    encoder.begin(feedback, null, 2_000);
    int n = encoder.next(buffer);
    return Arrays.copyOf(buffer, n);
  }

  private int take(int from) {
    int at = from;
    for (EventRecord e; (e = decoder.events().poll()) != null; at++) {
      EventRecord s = sent.get(at);
      assertEquals(describe(s), describe(e), "event " + at);
    }
    return at;
  }

  private static String describe(EventRecord e) {
    return e.kind
        + " "
        + e.tick
        + " "
        + e.player
        + " "
        + e.first
        + " "
        + e.second
        + " "
        + e.x
        + " "
        + e.y
        + " "
        + e.strength
        + " "
        + e.data;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 2, 10, 30, 60})
  void allComeOnceAndInOrder(int lossPercent) {
    Random random = new Random(lossPercent);
    ArrayDeque<byte[]> down = new ArrayDeque<>();
    ArrayDeque<long[]> up = new ArrayDeque<>();
    int taken = 0;
    for (int t = 0; t < 2_400; t++) {
      tick(t < 1_200 && random.nextInt(6) == 0 ? 1 + random.nextInt(3) : 0, random);
      if (t % 2 == 0 && !encoder.nothingNew(null) || t % 30 == 0) {
        byte[] datagram = next();
        if (random.nextInt(100) >= lossPercent) {
          down.add(datagram);
          if (random.nextInt(5) == 0) {
            down.add(datagram);
          }
        }
      }
      if (t % 7 > 3) { // they come in heaps, the later first
        for (byte[] d; (d = down.pollLast()) != null; ) {
          decoder.decode(d, 0, d.length);
          taken = take(taken);
        }
      }
      if (decoder.hasAck()) {
        up.add(new long[] {decoder.ackSequence(), decoder.ackBits()});
      }
      if (up.size() > 8) {
        long[] ack = up.poll();
        if (random.nextInt(100) >= lossPercent) {
          encoder.receiveAck((int) ack[0], ack[1]);
        }
      }
    }
    assertEquals(sent.size(), taken, "loss=" + lossPercent);
    assertEquals(0, encoder.eventsLost());
    assertEquals(0, encoder.eventsWaiting());
    assertTrue(decoder.events().completeTick() > tick - 60);
    assertTrue(sent.size() > 200);
  }

  @Test
  void whatWaitsIsBoundedAndTheClientLearnsWhatItMisses() {
    Random random = new Random(1);
    for (int t = 0; t < 600; t++) { // nothing arrives
      tick(2, random);
      next();
    }
    assertEquals(512, encoder.eventsWaiting());
    assertEquals(1_200 - 512, encoder.eventsLost());
    int heard = 0;
    for (int t = 0; t < 300; t++) {
      tick(0, random);
      byte[] d = next();
      assertEquals(DecodeStatus.OK, decoder.decode(d, 0, d.length));
      for (EventRecord e; (e = decoder.events().poll()) != null; heard++) {
        assertEquals(describe(sent.get(1_200 - 512 + heard)), describe(e));
      }
      encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());
    }
    assertEquals(512, heard);
    assertEquals(1_200 - 512, decoder.events().missed());
    assertEquals(tick, decoder.events().completeTick());
  }

  @Test
  void damagedBytesDoNoHarm() {
    // The check at the front is set right, so that the section's own reader sees the damage.
    Random random = new Random(4);
    int refused = 0;
    for (int t = 0; t < 3_000; t++) {
      tick(random.nextInt(4), random);
      byte[] good = next();
      byte[] bad = good.clone();
      for (int i = random.nextInt(6); i >= 0; i--) {
        bad[6 + random.nextInt(bad.length - 6)] ^= (byte) (1 << random.nextInt(8));
      }
      int check = carom.net.codec.Crc16.of(KEY, bad, 2, bad.length - 2);
      bad[0] = (byte) check;
      bad[1] = (byte) (check >>> 8);
      SnapshotDecoder other = new SnapshotDecoder(4, KEY, tick - 1, RATE);
      DecodeStatus status = other.decode(bad, 0, bad.length);
      assertNotNull(status);
      refused += status == DecodeStatus.OK ? 0 : 1;
      int lastTick = 0;
      for (EventRecord e; (e = other.events().poll()) != null; ) {
        assertTrue(e.tick >= lastTick && e.tick <= tick + 40_000, describe(e));
        lastTick = e.tick;
      }
      if (random.nextInt(3) == 0) {
        decoder.decode(good, 0, good.length);
        encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());
      }
    }
    assertTrue(refused > 300, "refused=" + refused);
  }

  @Test
  void whoDoesNotTakeThemLosesTheOldest() {
    Random random = new Random(5);
    for (int t = 0; t < 300; t++) {
      tick(1, random);
      byte[] d = next();
      decoder.decode(d, 0, d.length);
      encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());
    }
    int heard = 0;
    while (decoder.events().poll() != null) {
      heard++;
    }
    assertEquals(300, heard + decoder.events().missed());
    assertNull(decoder.events().poll());
  }
}
