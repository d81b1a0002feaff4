package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.RepeatedEventFilter;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.EventRing;
import carom.net.snapshot.frame.FrameRing;
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
  private static final int EPOCH = 7;
  private static final int RATE = 60;

  private final FrameRing ring = new FrameRing(4);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, EPOCH, RATE);
  private final SnapshotDecoder decoder = new SnapshotDecoder(4, EPOCH, 0, RATE);
  private final InputFeedback feedback = new InputFeedback();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final List<EventRecord> sent = new ArrayList<>();
  private int tick;

  private void tick(int events, Random random) {
    ring.begin(++tick);
    ring.end();
    happen(events, random);
  }

  private void happen(int events, Random random) {
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
    assertEquals(0, encoder.report().eventsLost());
    assertEquals(0, encoder.report().eventsWaiting());
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
    assertEquals(512, encoder.report().eventsWaiting());
    assertEquals(1_200 - 512, encoder.report().eventsLost());
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

  /** A client that heard of two of a tick's five events comes back over a new link. */
  private final class Returning {
    final Random random = new Random(6);
    final RepeatedEventFilter repeats = new RepeatedEventFilter();
    final List<String> heard = new ArrayList<>();
    final SnapshotEncoder again = new SnapshotEncoder(ring, EPOCH, RATE);
    final SnapshotDecoder anew = new SnapshotDecoder(4, EPOCH, 0, RATE);

    Returning() {
      repeats.beginLink("1", 1, 1, 0);
      tick(2, random);
      byte[] d = next();
      assertEquals(DecodeStatus.OK, decoder.decode(d, 0, d.length));
      encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());
      hear(decoder);
      assertEquals(2, heard.size());
      happen(3, random);
    }

    private void hear(SnapshotDecoder from) {
      for (EventRecord e; (e = from.events().poll()) != null; ) {
        if (repeats.accept(e.tick, from.events().missed())) {
          heard.add(describe(e));
        }
      }
    }

    void comeBack(int meanwhile) {
      again.takeOverEvents(encoder);
      for (int i = 0; i < meanwhile; i++) {
        tick(1, random);
        again.offer(ring.events().limit() - 1);
      }
      repeats.beginLink("1", 1, 1, tick);
      for (int t = 0; t < 300; t++) {
        tick(0, random);
        again.begin(feedback, null, 2_000);
        byte[] d = Arrays.copyOf(buffer, again.next(buffer));
        assertEquals(DecodeStatus.OK, anew.decode(d, 0, d.length));
        again.receiveAck(anew.ackSequence(), anew.ackBits());
        hear(anew);
      }
      assertEquals(0, again.report().eventsWaiting());
    }

    /** All but what is left out, numbers of {@link #sent}. */
    void heardAllBut(int from, int to) {
      List<String> all = new ArrayList<>(sent.stream().map(e -> describe(e)).toList());
      all.subList(from, to).clear();
      assertEquals(all, heard);
    }
  }

  @Test
  void whoComesBackHearsTheRestOfATick() {
    Returning client = new Returning();
    for (int i = 0; i < 507; i++) {
      tick(1, client.random);
    }
    client.comeBack(0);
    client.heardAllBut(0, 0);
    assertEquals(0, client.again.report().eventsLost());
  }

  @Test
  void ofATickWhoseBeginDoesNotFitNothingIsRepeated() {
    Returning client = new Returning();
    for (int i = 0; i < 509; i++) { // with the two that were heard, two too many
      tick(1, client.random);
    }
    assertEquals(512, encoder.report().eventsWaiting());
    client.comeBack(0);
    client.heardAllBut(2, 5);
    assertEquals(3, client.again.report().eventsLost(), "what was heard isn't lost");
  }

  @Test
  void ofATickWhoseBeginIsForgottenNothingIsRepeated() {
    Returning client = new Returning();
    tick(1, client.random);
    for (int i = 0; i < EventRing.SIZE - 3; i++) { // of others: three of the first tick go
      ring.events().add(sent.get(5), 0);
    }
    client.comeBack(0);
    client.heardAllBut(2, 5);
    assertEquals(3, client.again.report().eventsLost());
  }

  @Test
  void whatIsLostBeforeTheRepeatIsThroughEndsItsTick() {
    Returning client = new Returning();
    for (int i = 0; i < 507; i++) {
      tick(1, client.random);
    }
    client.comeBack(1); // is one too many
    assertEquals(1, client.anew.events().missed());
    client.heardAllBut(2, 5);
  }

  @Test
  void damagedBytesDoNoHarm() {
    // The head stays whole, so that the section's own reader sees the damage.
    Random random = new Random(4);
    int refused = 0;
    for (int t = 0; t < 3_000; t++) {
      tick(random.nextInt(4), random);
      byte[] good = next();
      byte[] bad = good.clone();
      for (int i = random.nextInt(6); i >= 0; i--) {
        bad[5 + random.nextInt(bad.length - 5)] ^= (byte) (1 << random.nextInt(8));
      }
      SnapshotDecoder other = new SnapshotDecoder(4, EPOCH, tick - 1, RATE);
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
