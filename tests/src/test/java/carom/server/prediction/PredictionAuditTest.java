package carom.server.prediction;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.protocol.ClientMessage.Diverged;
import carom.net.snapshot.exact.OwnState;
import carom.physics.rows.BodyRow;
import carom.physics.rows.RowKind;
import carom.server.prediction.PredictionAudit.Finding;
import carom.sim.near.Neighbourhood;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

final class PredictionAuditTest {
  private final PredictionAudit audit = new PredictionAudit(4);

  @Test
  void namesTheFirstBodyThatDiffersWithBothStates() {
    for (int tick = 100; tick <= 104; tick++) {
      keep(tick, false);
      audit.keepSet(tick, false, false);
      audit.keepSetState(tick, near(tick, 3));
    }
    Diverged right = report(104, 101, near(104, 3));
    assertEquals(Finding.EQUAL, audit.judge(right));
    List<Integer> bits = new ArrayList<>(right.bodies());
    bits.set(Diverged.BODY_INTS + 5, Float.floatToRawIntBits(-2.5f)); // vx of the second
    Diverged wrong = new Diverged(104, 101, true, bits, List.of());
    assertEquals(Finding.UNEXPLAINED, audit.judge(wrong));
    assertEquals(
        " entity=11 generation=7 x server=104.0 client=104.0 y server=104.0 client=104.0"
            + " cos server=104.0 client=104.0 sin server=104.0 client=104.0"
            + " vx server=104.0 client=-2.5 vy server=104.0 client=104.0"
            + " omega server=104.0 client=104.0",
        audit.describe(wrong));
    audit.keepSet(103, false, true);
    assertEquals(Finding.FIELD_HIDDEN, audit.judge(wrong));
    audit.keepSet(103, true, true);
    assertEquals(Finding.INTERFERED, audit.judge(wrong));
    assertEquals(Finding.UNEXPLAINED, audit.judge(new Diverged(104, 103, true, bits, List.of())));
    audit.clear();
    assertEquals(Finding.UNKNOWN, audit.judge(wrong));
  }

  @Test
  void aMissingInputExplainsAReportOfThePredictedSet() {
    for (int tick = 100; tick <= 104; tick++) {
      keep(tick, tick == 102);
      audit.keepSet(tick, false, false);
      audit.keepSetState(tick, near(tick, 3));
    }
    Diverged wrong = report(104, 101, near(5, 3));
    assertEquals(Finding.INPUT_MISSING, audit.judge(wrong));
    audit.confirmInput(102);
    assertEquals(Finding.UNEXPLAINED, audit.judge(wrong));
  }

  @Test
  void theOwnBodyIsJudgedByTouchesInterferenceAndInputs() {
    for (int tick = 100; tick <= 104; tick++) {
      keep(tick, false);
    }
    assertEquals(Finding.EQUAL, audit.judge(ownReport(104, 101, 104, 8)));
    Diverged wrong = ownReport(104, 101, -1, 9);
    assertEquals(Finding.UNEXPLAINED, audit.judge(wrong));
    assertEquals(
        " x server=104.0 client=-1.0 y server=104.0 client=104.0 cos server=104.0 client=104.0"
            + " sin server=104.0 client=104.0 vx server=104.0 client=104.0"
            + " vy server=104.0 client=104.0 omega server=104.0 client=104.0"
            + " word3 server=8 client=9",
        audit.describe(wrong));
    audit.keep(103, own(103), true, false, false);
    assertEquals(Finding.INPUT_MISSING, audit.judge(wrong));
    audit.keep(102, own(102), false, false, true);
    assertEquals(Finding.INTERFERED, audit.judge(wrong));
    audit.keep(104, own(104), false, true, false);
    assertEquals(Finding.TOUCHED, audit.judge(wrong));
    audit.keep(102, new OwnState(4), false, false, false); // no body in between
    assertEquals(Finding.UNKNOWN, audit.judge(wrong));
  }

  @Test
  void anyNumbersAreJudgedWithoutHarm() {
    long seed = 11;
    Random random = new Random(seed);
    for (int tick = 0; tick < 500; tick++) {
      keep(tick, random.nextInt(20) == 0);
      audit.keepSet(tick, random.nextInt(20) == 0, random.nextInt(20) == 0);
      if (random.nextBoolean()) {
        audit.keepSetState(tick, near(tick, random.nextInt(60)));
      }
      for (int i = 0; i < 50; i++) {
        int at = random.nextInt(4) == 0 ? random.nextInt() : tick - random.nextInt(80);
        int equal = random.nextInt(4) == 0 ? random.nextInt() : at - 1 - random.nextInt(9);
        if (equal < 0 || equal >= at) {
          continue; // the codec refuses it
        }
        Diverged wild =
            random.nextInt(3) == 0
                ? ownReport(at, equal, tick, random.nextInt(3))
                : report(at, equal, near(tick, 1 + random.nextInt(31)));
        if (audit.judge(wild) == Finding.UNEXPLAINED) {
          audit.describe(wild);
        }
      }
    }
  }

  private void keep(int tick, boolean inputMissing) {
    audit.keep(tick, own(tick), inputMissing, false, false);
  }

  /** Entity 10 of generation 7, all of whose numbers are the tick's; words 5 to 8. */
  private static OwnState own(int tick) {
    OwnState own = new OwnState(4);
    own.setBody(10, 7, tick, tick, tick, tick, tick, tick, tick);
    for (int i = 0; i < 4; i++) {
      own.setWord(i, 5 + i);
    }
    return own;
  }

  /** Of the body of {@link #own}, but for x and the last word. */
  private static Diverged ownReport(int tick, int equalTick, float x, int lastWord) {
    List<Integer> body = new ArrayList<>();
    body.add(Neighbourhood.key(10, 7));
    body.add(Float.floatToRawIntBits(x));
    for (int i = 2; i < Diverged.BODY_INTS; i++) {
      body.add(Float.floatToRawIntBits(tick));
    }
    return new Diverged(tick, equalTick, false, body, List.of(5, 6, 7, lastWord));
  }

  /** Entities 10, 11, ... of generation 7, all of whose numbers are the tick's. */
  private static Neighbourhood near(int tick, int count) {
    Neighbourhood near = new Neighbourhood();
    int[] row = new int[BodyRow.INTS];
    Arrays.fill(row, Float.floatToRawIntBits(tick));
    for (int i = 0; i < count; i++) {
      row[BodyRow.KEY] = Neighbourhood.key(10 + i, 7);
      near.rows().add(RowKind.BODY, row, 0);
    }
    return near;
  }

  private static Diverged report(int tick, int equalTick, Neighbourhood near) {
    List<Integer> bits = new ArrayList<>();
    for (int i = 0; i < Math.min(near.count(), Diverged.MAX_BODIES); i++) {
      for (int j = 0; j < Diverged.BODY_INTS; j++) {
        bits.add(near.rows().bodies().get(i, j));
      }
    }
    return new Diverged(tick, equalTick, true, bits, List.of());
  }
}
