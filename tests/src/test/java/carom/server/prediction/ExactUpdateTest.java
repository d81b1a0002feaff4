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
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: the server knows what the client lacks of updates that were replaced or given up. Method:
 * updates of one to four players' bodies, one snapshot in each tick; the test says which arrive.
 */
class ExactUpdateTest {
  private static final int PLAYERS = 4;
  private static final int ROW_BITS = 5_000;

  /** Snapshots after which a hole in the acks counts as a loss. */
  private static final int WARM_UP = 140;

  /** Snapshots after a lost one by whose acks the server knows that it is lost. */
  private static final int SEEN = 4;

  private final FrameRing ring = new FrameRing(16);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, 1, 60);
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private SimulationHost simulation;
  private ExactUpdate update;

  /** Which of the 64 snapshots before the newest one have arrived, the newest of them lowest. */
  private long arrivedBefore = -1;

  private boolean hasNewestArrived = true;

  @BeforeEach
  void settleALine() throws Exception {
    Level level = Level.builtIn(Games.create("arena").defaultLevel());
    simulation = new SimulationHost(Games.create("arena"), level, 1, 60, Role.AUTHORITY);
    for (int i = 0; i < PLAYERS; i++) {
      simulation.join("player" + i);
    }
    update = new ExactUpdate(simulation, 0, encoder);
    for (int i = 0; i < WARM_UP; i++) {
      send(1);
      acknowledge();
    }
    begin(1, true, true);
    acknowledge();
    assertFalse(update.isHelping(), "all of it has arrived");
    assertFalse(encoder.ledger().isLossy(simulation.tick()));
  }

  /**
   * Begins an update, whose list has the bodies of the first players, and sends its one part.
   *
   * @return the number of bodies that it tells
   */
  private int begin(int players, boolean all, boolean arrives) {
    simulation.step();
    EntityList near = new EntityList();
    for (int i = 0; i < players; i++) {
      near.add(simulation.player(i).entity());
    }
    update.begin(near, all);
    return sendTick(arrives);
  }

  /** Sends the snapshots of the next ticks, which arrive. */
  private void send(int ticks) {
    for (int i = 0; i < ticks; i++) {
      simulation.step();
      sendTick(true);
    }
  }

  /**
   * Sends a snapshot, with a part of the update if one is due; returns how many bodies it tells.
   */
  private int sendTick(boolean arrives) {
    ring.begin(simulation.tick());
    ring.end();
    OwnState own = new OwnState();
    for (int i = 0; i < update.members().count(); i++) {
      own.near().add(update.members().get(i));
    }
    update.write(ROW_BITS, own);
    encoder.begin(new InputFeedback(), new OwnState(), 10_000);
    encoder.next(buffer);
    update.sent();
    arrivedBefore = arrivedBefore << 1 | (hasNewestArrived ? 1 : 0);
    hasNewestArrived = arrives;
    return own.near().toldCount();
  }

  /** Tells the server which snapshots have arrived. The newest one has. */
  private void acknowledge() {
    assertTrue(hasNewestArrived);
    encoder.receiveAck(encoder.sequence(), arrivedBefore);
    update.endIfArrived();
  }

  @Test
  void anUpdateHelpsAfterOneThatReplacedAnotherHasArrived() {
    // An update that replaces another on its way makes nothing doubtful for ever. Else the loss of
    // a later update counts as a state that the client has computed otherwise.
    begin(2, false, true);
    assertEquals(1, begin(3, false, true), "nothing is lost on this line");
    acknowledge();
    assertFalse(update.isHelping(), "none is under way");
    begin(4, false, false);
    assertTrue(update.isHelping());
  }

  @Test
  void anUpdateThatTellsAgainWhatTheOneBeforeToldHelps() {
    simulation.step();
    sendTick(false);
    send(SEEN);
    acknowledge();
    assertTrue(encoder.ledger().isLossy(simulation.tick()));
    begin(2, false, false);
    assertEquals(2, begin(3, false, false), "the newcomers of both updates");
    assertTrue(update.isHelping());
    simulation.step();
    sendTick(false); // the second copy, on a line with losses
    send(SEEN);
    acknowledge();
    assertTrue(update.isHelping(), "both copies are lost, too, and it is sent again");
    send(1);
    acknowledge();
    assertFalse(update.isHelping(), "all of it has arrived");
  }

  @Test
  void anUpdateDoesNotHelpWhenOneThatItReplacedIsLost() {
    begin(2, false, false);
    begin(3, false, false);
    assertTrue(update.isHelping(), "nobody knows of a loss yet");
    send(SEEN);
    acknowledge();
    assertFalse(update.isHelping(), "no update tells the newcomer of the first one");
    assertEquals(3, begin(3, true, false));
    assertTrue(update.isHelping(), "all is told");
  }

  @Test
  void aDifferenceBetweenTwoUpdatesIsBeyondHelpWhenTheThirdBegins() {
    begin(2, false, true);
    final int sent = update.sentTick();
    send(3);
    acknowledge();
    final int base = simulation.tick() + 1;
    begin(3, false, true);
    assertFalse(update.isBeyondHelp(sent + 1), "the second one may tell of it");
    send(3);
    begin(4, false, true);
    assertFalse(update.isBeyondHelp(sent), "of that tick the first one tells");
    assertTrue(update.isBeyondHelp(sent + 1));
    assertTrue(update.isBeyondHelp(base - 1));
    assertFalse(update.isBeyondHelp(base), "of that tick the second one tells");
    begin(4, true, true);
    assertFalse(update.isBeyondHelp(base - 1), "all is told");
  }

  @Test
  void whatAnUpdateRepeatsMayPutRightWhatItTellsOf() {
    simulation.step();
    sendTick(false);
    send(SEEN);
    acknowledge();
    begin(2, false, false);
    send(1); // the second copy, on a line with losses
    final int sent = update.sentTick();
    send(1);
    begin(3, false, true);
    assertFalse(update.isBeyondHelp(sent + 1), "the first one is told again");
    send(1);
    begin(4, false, true);
    assertTrue(update.isBeyondHelp(sent + 1), "two have been sent, and neither helped");
  }

  @Test
  void missingPartsAreSentAgainWithoutWaitingForMoreAcks() {
    begin(2, false, false);
    send(1);
    acknowledge();
    assertEquals(0, update.waitingRows(), "one datagram may overtake another");
    final int sentTick = update.sentTick();
    update.sendMissingAgain();
    assertTrue(update.waitingRows() > 0);
    assertFalse(update.isSending(), "the list may change");
    update.sendMissingAgain();
    send(1);
    assertEquals(0, update.waitingRows());
    assertEquals(sentTick + 2, update.sentTick());
    acknowledge();
    assertFalse(update.isHelping(), "all of it has arrived");
  }

  @Test
  void theNextUpdateTellsAgainWhatIsKnownToBeLost() {
    begin(2, false, false);
    send(SEEN);
    acknowledge();
    assertEquals(2, begin(3, false, true));
  }

  @Test
  void theNextUpdateTellsAgainWhatOneThatWasGivenUpTold() {
    begin(2, false, false);
    update.cancel();
    assertFalse(update.isHelping());
    assertEquals(2, begin(3, false, true));
    assertTrue(update.isHelping());
    acknowledge();
    assertEquals(1, begin(4, false, true), "all before has arrived");
  }
}
