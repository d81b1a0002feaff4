package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.ledger.DatagramLedger;
import carom.physics.rows.BodyRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: the rows of an exact update are due until they have arrived, whatever the line loses.
 * Method: updates of rows of bodies, one snapshot in each tick; the test acknowledges some ticks.
 */
class UpdateDeliveryTest {
  private static final int ROWS = 3;
  private static final int ROW_BITS = 5_000;

  /** Bodies at rest. */
  private static final class Bodies implements UpdateDelivery.Content {
    final RowCounts counts = new RowCounts();
    final int[] row = new int[BodyRow.INTS];

    Bodies(int rows) {
      counts.set(RowKind.BODY, rows);
    }

    @Override
    public RowCounts counts() {
      return counts;
    }

    @Override
    public int toldCount() {
      return counts.total();
    }

    @Override
    public int told(int index) {
      return index;
    }

    @Override
    public int[] source(int row) {
      return this.row;
    }

    @Override
    public int at(int row) {
      return 0;
    }
  }

  private final DatagramLedger ledger = new DatagramLedger();
  private final UpdateDelivery delivery = new UpdateDelivery(ledger);
  private final OwnState prepared = new OwnState();
  private Bodies bodies;
  private int tick;

  @BeforeEach
  void beginAnUpdate() {
    begin(ROWS);
  }

  private void begin(int rows) {
    bodies = new Bodies(rows);
    prepared.near().begin(0);
    for (int i = 0; i < rows; i++) {
      prepared.near().add(i);
    }
    delivery.begin(rows);
  }

  /** Sends the snapshot of the next tick; returns whether the last due row left with it. */
  private boolean sendTick() {
    return sendTick(ROW_BITS);
  }

  private boolean sendTick(int rowBits) {
    tick++;
    prepared.near().endUpdate();
    if (delivery.isDue()) {
      delivery.write(bodies, 1, rowBits, prepared);
    } else {
      delivery.skip();
    }
    ledger.begin(tick, true);
    delivery.wrote(tick);
    return delivery.sentTick() == tick;
  }

  /** Acknowledges the newest snapshot alone; returns whether the whole update has arrived. */
  private boolean acknowledgeNewest() {
    ledger.receive(ledger.sequence(), 0, tick);
    return delivery.hasArrived();
  }

  /** Sends and acknowledges until losses count, and loses one datagram. */
  private void loseOnTheLine() {
    for (int i = 0; i < 150; i++) {
      sendTick();
      acknowledgeNewest();
    }
    for (int i = 0; i <= DatagramLedger.LOST_TICKS; i++) {
      sendTick();
    }
    acknowledgeNewest();
    assertTrue(ledger.isLossy(tick));
  }

  @Test
  void anUpdateWhosePartArrivesIsOver() {
    assertTrue(sendTick());
    assertEquals(0, delivery.dueRows());
    assertTrue(acknowledgeNewest());
  }

  @Test
  void rowsOfALostPartAreDueAgain() {
    sendTick();
    for (int i = 0; i < 3; i++) {
      assertFalse(sendTick());
    }
    assertFalse(acknowledgeNewest());
    assertEquals(ROWS, delivery.dueRows());
    assertTrue(sendTick());
    assertTrue(acknowledgeNewest());
  }

  @Test
  void rowsWhoseTwoCopiesAreBothLostAreDueOnce() {
    loseOnTheLine();
    begin(ROWS);
    assertTrue(sendTick());
    assertTrue(sendTick(), "a lossy line gets a second copy");
    for (int i = 0; i < 3; i++) {
      sendTick();
    }
    assertFalse(acknowledgeNewest());
    assertEquals(ROWS, delivery.dueRows());
    assertTrue(sendTick());
    assertTrue(acknowledgeNewest());
  }

  @Test
  void whatHasArrivedIsNotSentAgainWhenAnotherCopyIsLost() {
    loseOnTheLine();
    begin(ROWS);
    sendTick();
    sendTick();
    assertTrue(acknowledgeNewest(), "the second copy");
    sendTick();
    sendTick();
    acknowledgeNewest();
    assertTrue(delivery.hasArrived());
    assertFalse(delivery.isDue());
  }

  @Test
  void anUpdateWithoutRowsIsAnnouncedUntilThatArrives() {
    begin(0);
    assertTrue(delivery.isDue());
    assertEquals(0, delivery.dueRows());
    sendTick(0);
    assertTrue(prepared.near().updating());
    assertFalse(delivery.isDue());
    for (int i = 0; i < 3; i++) {
      sendTick();
    }
    assertFalse(acknowledgeNewest());
    assertTrue(delivery.isDue());
    sendTick();
    assertTrue(acknowledgeNewest());
  }

  @Test
  void everyRowArrivesWhateverIsLost() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int round = 0; round < 50; round++) {
      int rows = random.nextInt(200);
      begin(rows);
      boolean[] has = new boolean[rows];
      int[] sequences = new int[8];
      long[] arrived = new long[8];
      long bits = 0;
      for (int i = 0; !delivery.hasArrived(); i++) {
        assertTrue(i < 5_000, "seed=" + seed);
        sendTick(50 + random.nextInt(800));
        boolean comes = random.nextInt(3) > 0;
        for (int n = 0; comes && n < prepared.near().partRows(); n++) {
          has[prepared.near().firstRow() + n] = true;
        }
        bits = bits << 1 | (comes ? 1 : 0);
        sequences[i & 7] = ledger.sequence();
        arrived[i & 7] = bits;
        int old = i - random.nextInt(7);
        if (old >= 0 && random.nextInt(4) == 0 && (arrived[old & 7] & 1) != 0) {
          ledger.receive(sequences[old & 7], arrived[old & 7] >>> 1, tick);
        }
        if (random.nextInt(40) == 0) {
          delivery.sendMissingAgain();
        }
      }
      for (int row = 0; row < rows; row++) {
        assertTrue(has[row], "seed=" + seed + " row=" + row);
      }
    }
  }
}
