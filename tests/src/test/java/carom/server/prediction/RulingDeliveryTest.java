package carom.server.prediction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.physics.rows.BodyRow;
import carom.sim.ruling.Ruling;
import org.junit.jupiter.api.Test;

/**
 * Goal: a ruling is sent until it has arrived, and no more often than that. Method: a snapshot in
 * each tick; the test acknowledges some.
 */
class RulingDeliveryTest {
  private static final int KEY = 5;
  private static final int MUCH = 10_000;

  private final FrameRing ring = new FrameRing(16);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, 1, 60);
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final RulingDelivery delivery = new RulingDelivery();
  private final KeyList members = new KeyList();
  private final NearState near = new OwnState().near();
  private int tick;

  RulingDeliveryTest() {
    members.add(KEY);
  }

  private Ruling push(int key) {
    Ruling ruling = new Ruling();
    ruling.tick = tick + 1;
    ruling.key = key;
    ruling.mask = 1 << BodyRow.FORCE_X - BodyRow.MOTION;
    ruling.row[BodyRow.FORCE_X] = Float.floatToRawIntBits(3.5f);
    return ruling;
  }

  /** Sends the snapshot of the next tick; returns how many rulings it has. */
  private int sendTick(int room) {
    ring.begin(++tick);
    ring.end();
    near.begin(0);
    near.add(KEY);
    delivery.write(tick, members, room, near);
    encoder.begin(new InputFeedback(), new OwnState(), 10_000);
    encoder.next(buffer);
    delivery.sent(tick);
    return near.rulings();
  }

  private void acknowledgeNewest() {
    encoder.receiveAck(encoder.sequence(), 0);
    delivery.acknowledge(encoder);
  }

  @Test
  void aRulingIsSentOnceWithItsTickAndItsNumbers() {
    delivery.add(push(KEY), 1);
    assertEquals(0, sendTick(20), "there is no room");
    assertEquals(1, sendTick(MUCH));
    assertEquals(1, near.rulingAge(0));
    assertEquals(3.5f, Float.intBitsToFloat(near.rulingWord(0, BodyRow.FORCE_X - BodyRow.MOTION)));
    assertEquals(0, sendTick(MUCH));
    acknowledgeNewest();
    assertEquals(0, sendTick(MUCH));
  }

  @Test
  void aLostOneIsSentAgain() {
    delivery.add(push(KEY), 1);
    assertEquals(1, sendTick(MUCH));
    for (int i = 0; i < 3; i++) {
      assertEquals(0, sendTick(MUCH));
    }
    acknowledgeNewest();
    assertTrue(delivery.isBehind());
    assertEquals(1, sendTick(MUCH));
    acknowledgeNewest();
    assertFalse(delivery.isBehind());
  }

  @Test
  void ofTwoCopiesOneIsEnough() {
    delivery.add(push(KEY), 2);
    assertEquals(1, sendTick(MUCH));
    assertEquals(1, sendTick(MUCH));
    acknowledgeNewest();
    for (int i = 0; i < 9; i++) {
      assertEquals(0, sendTick(MUCH));
      acknowledgeNewest();
    }
  }

  @Test
  void whatIsNotListedOrTooOldIsNotSent() {
    delivery.add(push(KEY + 1), 1);
    assertEquals(0, sendTick(MUCH));
    delivery.add(push(KEY), 1);
    tick += 70;
    assertEquals(0, sendTick(MUCH));
  }

  @Test
  void thereIsAnEndToTheirNumber() {
    for (int i = 0; i < RulingDelivery.MOST; i++) {
      assertTrue(delivery.add(push(KEY), 1));
    }
    assertFalse(delivery.add(push(KEY), 1));
    assertEquals(NearState.MAX_RULINGS, sendTick(MUCH));
  }
}
