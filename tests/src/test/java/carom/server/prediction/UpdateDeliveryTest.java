package carom.server.prediction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.level.Level;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: the rows of an exact update are due until they have arrived, whatever the line loses.
 * Method: one part that holds all rows is sent in each tick; the test acknowledges some ticks.
 */
class UpdateDeliveryTest {
  private static final int ROWS = 3;
  private static final int ROW_BITS = 5_000;

  private final FrameRing ring = new FrameRing(16);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, 1, 60);
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final UpdateRows rows = new UpdateRows(-1);
  private final UpdateDelivery delivery = new UpdateDelivery();
  private final OwnState prepared = new OwnState();
  private int tick;

  @BeforeEach
  void beginAnUpdate() throws Exception {
    Level level = Level.builtIn(Games.create("arena").defaultLevel());
    Simulation simulation = new Simulation(Games.create("arena"), level, 1, 60, Role.AUTHORITY);
    EntityList entities = new EntityList();
    for (int i = 0; i < ROWS; i++) {
      simulation.join("player" + i);
      entities.add(simulation.player(i).body());
    }
    rows.begin(entities, simulation);
    for (int i = 0; i < ROWS; i++) {
      rows.tell(i);
      prepared.near().add(entities.key(i));
    }
    rows.end();
    assertEquals(ROWS, rows.count());
    delivery.begin(ROWS);
  }

  /** Sends the snapshot of the next tick; returns whether the last due row left with it. */
  private boolean sendTick(boolean lossy) {
    ring.begin(++tick);
    ring.end();
    if (delivery.isDue()) {
      delivery.write(rows, tick, ROW_BITS, prepared);
    } else {
      delivery.skip();
    }
    encoder.begin(new InputFeedback(), new OwnState(), 10_000);
    encoder.next(buffer);
    return delivery.sent(tick, lossy);
  }

  /** Acknowledges the newest snapshot alone; returns whether the whole update has arrived. */
  private boolean acknowledgeNewest() {
    encoder.receiveAck(encoder.sequence(), 0);
    return delivery.acknowledge(encoder);
  }

  @Test
  void anUpdateWhosePartArrivesIsOver() {
    assertTrue(sendTick(false));
    assertEquals(0, delivery.dueRows());
    assertTrue(acknowledgeNewest());
  }

  @Test
  void rowsOfALostPartAreDueAgain() {
    sendTick(false);
    for (int i = 0; i < 3; i++) {
      assertFalse(sendTick(false));
    }
    assertFalse(acknowledgeNewest());
    assertEquals(ROWS, delivery.dueRows());
    assertTrue(sendTick(false));
    assertTrue(acknowledgeNewest());
  }

  @Test
  void rowsWhoseTwoCopiesAreBothLostAreDueOnce() {
    assertTrue(sendTick(true));
    assertTrue(sendTick(true), "a lossy line gets a second copy");
    for (int i = 0; i < 3; i++) {
      sendTick(true);
    }
    assertFalse(acknowledgeNewest());
    assertEquals(ROWS, delivery.dueRows());
    assertTrue(sendTick(true));
    assertTrue(acknowledgeNewest());
  }
}
