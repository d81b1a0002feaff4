package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.ledger.DatagramLedger;
import carom.physics.rows.BodyRow;
import org.junit.jupiter.api.Test;

/**
 * Goal: a ruling is sent until it has arrived, and no more often than that. Method: a snapshot in
 * each tick; the test acknowledges some.
 */
class RulingDeliveryTest {
  private static final int KEY = 5;
  private static final int MUCH = 10_000;
  private static final int BEFORE_STEP = 0;
  private static final int INPUT = 1;

  private final DatagramLedger ledger = new DatagramLedger();
  private final RulingDelivery delivery = new RulingDelivery(ledger);
  private final NearState near = new OwnState().near();
  private int tick;

  private boolean push(int key, int moment) {
    int[] row = new int[BodyRow.INTS];
    row[BodyRow.FORCE_X] = Float.floatToRawIntBits(3.5f);
    int mask = 1 << BodyRow.FORCE_X - BodyRow.MOTION;
    return delivery.add(tick, tick + 1, moment, key, -1, mask, row);
  }

  /** Sends the snapshot of the next tick; returns how many rulings it has. */
  private int sendTick(int room) {
    tick++;
    near.begin(0);
    near.add(KEY);
    delivery.write(tick, room, near);
    ledger.begin(tick, true);
    delivery.wrote();
    return near.rulings();
  }

  private void acknowledgeNewest() {
    ledger.receive(ledger.sequence(), 0, tick);
  }

  /** Sends and acknowledges until losses count, and loses one datagram. */
  private void loseOnTheLine() {
    for (int i = 0; i < 150; i++) {
      sendTick(MUCH);
      acknowledgeNewest();
    }
    for (int i = 0; i <= DatagramLedger.LOST_TICKS; i++) {
      sendTick(MUCH);
    }
    acknowledgeNewest();
    assertTrue(ledger.isLossy(tick));
  }

  @Test
  void aRulingIsSentOnceWithItsTickAndItsNumbers() {
    push(KEY, BEFORE_STEP);
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
    push(KEY, BEFORE_STEP);
    assertTrue(delivery.isBehind());
    assertEquals(1, sendTick(MUCH));
    assertFalse(delivery.isBehind());
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
  void oneOfAnInputGoesOutTwiceAndOneCopyIsEnough() {
    push(KEY, INPUT);
    assertEquals(1, sendTick(MUCH));
    assertEquals(1, sendTick(MUCH));
    acknowledgeNewest();
    for (int i = 0; i < 9; i++) {
      assertEquals(0, sendTick(MUCH));
      acknowledgeNewest();
    }
  }

  @Test
  void onALineWithLossesThereIsACopyMoreAndItIsSentAgainWhenAllAreLost() {
    loseOnTheLine();
    push(KEY, BEFORE_STEP);
    assertEquals(1, sendTick(MUCH));
    assertEquals(1, sendTick(MUCH));
    for (int i = 0; i < 2; i++) {
      assertEquals(0, sendTick(MUCH));
    }
    acknowledgeNewest();
    assertEquals(0, sendTick(MUCH), "the first copy is lost, the second may come");
    acknowledgeNewest();
    assertEquals(1, sendTick(MUCH));
  }

  @Test
  void whatIsNotListedOrTooOldIsNotSent() {
    push(KEY + 1, BEFORE_STEP);
    assertEquals(0, sendTick(MUCH));
    push(KEY, BEFORE_STEP);
    tick += 70;
    assertEquals(0, sendTick(MUCH));
  }

  @Test
  void thereIsAnEndToTheirNumber() {
    for (int i = 0; i < RulingDelivery.MOST; i++) {
      assertTrue(push(KEY, BEFORE_STEP));
    }
    assertFalse(push(KEY, BEFORE_STEP));
    assertEquals(NearState.MAX_RULINGS, sendTick(MUCH));
  }
}
