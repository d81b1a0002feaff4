package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.physics.rows.BodyRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** The one place that decides a baseline, reason by reason. */
class BaselineTest {

  private final FrameRing ring = new FrameRing(16);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, 1, 60);
  private final InputFeedback feedback = new InputFeedback();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private int tick;

  /** The next frame holds the slot 3 like this; a generation of -1 = free. */
  private void frame(int generation, int owner, int x) {
    FrameState frame = ring.begin(++tick);
    if (generation >= 0) {
      frame.putQuantized(3, generation, 7, owner, x, 0, 0, true);
    }
    ring.end();
  }

  private int send() {
    encoder.begin(feedback, null, 10_000);
    int length = encoder.next(buffer);
    assertEquals(0, encoder.next(buffer));
    return length;
  }

  private void ackNewest() {
    encoder.receiveAck(encoder.sequence(), 0);
  }

  @Test
  void firstSeenIsNewUntilAcked() {
    frame(1, -1, 0);
    assertEquals(BaselineReason.NEW, encoder.report().baseline(3));
    send();
    assertEquals(BaselineReason.NEW, encoder.report().baseline(3), "sent is not received");
    ackNewest();
    assertEquals(BaselineReason.QUIESCENT, encoder.report().baseline(3));
    assertEquals(tick, encoder.report().ackedTick(3));
    frame(1, -1, 5);
    assertEquals(BaselineReason.ACKED, encoder.report().baseline(3));
  }

  @Test
  void aNeverUsedSlotAndOneNeverSentCostNothing() {
    frame(-1, -1, 0);
    assertEquals(BaselineReason.QUIESCENT, encoder.report().baseline(3));
    frame(1, -1, 0);
    frame(-1, -1, 0);
    assertEquals(
        BaselineReason.QUIESCENT, encoder.report().baseline(3), "born and dead between two sends");
    int empty = send();
    assertEquals(empty, send());
  }

  @Test
  void deathIsToldUntilAcked() {
    frame(1, -1, 0);
    send();
    frame(-1, -1, 0);
    assertEquals(
        BaselineReason.GONE, encoder.report().baseline(3), "the client may have it, acked or not");
    send();
    assertEquals(BaselineReason.GONE, encoder.report().baseline(3));
    ackNewest();
    assertEquals(BaselineReason.QUIESCENT, encoder.report().baseline(3));
  }

  @Test
  void anotherEntityOrOwnerIsAbsolute() {
    frame(1, -1, 0);
    send();
    ackNewest();
    frame(1, 9, 0);
    assertEquals(BaselineReason.IDENTITY, encoder.report().baseline(3));
    send();
    ackNewest();
    frame(2, 9, 0);
    assertEquals(BaselineReason.IDENTITY, encoder.report().baseline(3), "the slot was used again");
  }

  @Test
  void aRestOfAnyLengthIsNoReason() {
    frame(1, -1, 0);
    send();
    ackNewest();
    for (int i = 0; i < 500; i++) {
      frame(1, -1, 0);
    }
    assertEquals(BaselineReason.QUIESCENT, encoder.report().baseline(3));
    frame(1, -1, 1);
    assertEquals(
        BaselineReason.ACKED, encoder.report().baseline(3), "coded against the end of its rest");
    for (int i = 0; i < FrameRing.SIZE - 2; i++) {
      frame(1, -1, 2 + i);
      assertEquals(
          BaselineReason.ACKED, encoder.report().baseline(3), "moving since ticks=" + (i + 2));
    }
    frame(1, -1, 1_000);
    assertEquals(BaselineReason.TOO_OLD, encoder.report().baseline(3));
  }

  @Test
  void gapsBetweenFramesAreNoReason() {
    frame(1, -1, 0);
    send();
    ackNewest();
    tick += 20;
    frame(1, -1, 4);
    assertEquals(BaselineReason.ACKED, encoder.report().baseline(3));
    tick += FrameRing.SIZE;
    frame(1, -1, 5);
    assertEquals(BaselineReason.TOO_OLD, encoder.report().baseline(3));
  }

  @Test
  void forcedIsAbsoluteOnce() {
    frame(1, -1, 0);
    send();
    ackNewest();
    int quiet = send();
    encoder.force(3);
    assertEquals(BaselineReason.FORCED, encoder.report().baseline(3));
    assertEquals(true, send() > quiet);
    assertEquals(BaselineReason.QUIESCENT, encoder.report().baseline(3));
    encoder.force(15);
    assertEquals(BaselineReason.QUIESCENT, encoder.report().baseline(15), "nobody there");
    assertThrows(IndexOutOfBoundsException.class, () -> encoder.force(16));
  }

  @Test
  void nothingIsWrittenBeforeTheFirstFrame() {
    assertThrows(
        IllegalStateException.class,
        () -> new SnapshotEncoder(new FrameRing(1), 1, 60).begin(feedback, null, 100));
  }

  @Test
  void ownStateCountsAsNews() {
    frame(-1, -1, 0);
    OwnState own = new OwnState(4);
    own.setWord(2, 5);
    assertEquals(false, encoder.nothingNew(own));
    encoder.begin(feedback, own, 0);
    encoder.next(buffer);
    ackNewest();
    assertEquals(true, encoder.nothingNew(own));
    own.setWord(2, 6);
    assertEquals(false, encoder.nothingNew(own));
    assertThrows(IndexOutOfBoundsException.class, () -> own.setWord(4, 0));
  }

  @Test
  void exactStateOfWhatIsNearComesOutOfTheSameBudgetAndTheVerdictTellsIt() {
    int bodies = 400;
    FrameRing many = new FrameRing(bodies);
    SnapshotEncoder alone = new SnapshotEncoder(many, 1, 60);
    SnapshotEncoder both = new SnapshotEncoder(many, 1, 60);
    FrameState frame = many.begin(1);
    for (int slot = 0; slot < bodies; slot++) {
      frame.putQuantized(slot, 1, 7, -1, 1_000 * slot, -slot, slot, false);
    }
    many.end();
    OwnState own = new OwnState(4);
    int[] row = new int[BodyRow.INTS];
    Arrays.fill(row, 0x3f9d_70a4);
    row[BodyRow.ARCHETYPE] = 7;
    own.near().begin(1);
    for (int i = 0; i < 12; i++) {
      own.near().add(i | 1 << 16);
    }
    own.near().beginPart(0, contacts(12), 0);
    for (int i = 0; i < 12; i++) {
      own.near().tell(i);
    }
    for (int i = 0; i < 12; i++) {
      own.near().addRow(row, 0);
    }
    int budget = 2_000;
    int sentAlone = all(alone, null, budget);
    int sentBoth = all(both, own, budget);
    assertTrue(sentAlone <= budget && sentBoth <= budget, sentAlone + " " + sentBoth);
    assertTrue(sentAlone > 0.9 * budget && sentBoth > 0.9 * budget, sentAlone + " " + sentBoth);
    Explanation verdict = both.report().explain(bodies - 1);
    assertEquals(Explanation.Reason.OVER_BUDGET, verdict.reason());
    assertEquals(budget, verdict.budgetBytes());
    assertTrue(verdict.aheadBytes() > 550, verdict.toString());
    assertTrue(alone.report().explain(bodies - 1).aheadBytes() < 40, "headers only");
    assertTrue(
        both.report().waiting() > alone.report().waiting() + 30,
        both.report().waiting() + " " + alone.report().waiting());
  }

  private int all(SnapshotEncoder to, OwnState own, int budget) {
    to.begin(feedback, own, budget);
    int sum = 0;
    for (int n; (n = to.next(buffer)) > 0; ) {
      sum += n;
    }
    return sum;
  }

  private static RowCounts contacts(int count) {
    RowCounts counts = new RowCounts();
    counts.set(RowKind.CONTACT, count);
    return counts;
  }
}
