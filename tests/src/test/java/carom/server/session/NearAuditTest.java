package carom.server.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.protocol.ClientMessage.DivergedNear;
import carom.server.session.PredictionAudit.Verdict;
import carom.sim.Neighbourhood;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

final class NearAuditTest {
  private final NearAudit audit = new NearAudit();

  @Test
  void namesTheFirstBodyThatDiffersWithBothStates() {
    for (int tick = 100; tick <= 104; tick++) {
      audit.keep(tick, false);
      audit.keepState(tick, near(tick, 3));
    }
    DivergedNear right = report(104, 101, near(104, 3));
    assertEquals(Verdict.EQUAL, audit.judge(right));
    List<Integer> bits = new ArrayList<>(right.bodies());
    bits.set(DivergedNear.BODY_INTS + 5, Float.floatToRawIntBits(-2.5f)); // vx of the second
    DivergedNear wrong = new DivergedNear(104, 101, bits);
    assertEquals(Verdict.UNEXPLAINED, audit.judge(wrong));
    assertEquals(
        " entity=11 generation=7 x server=104.0 client=104.0 y server=104.0 client=104.0"
            + " cos server=104.0 client=104.0 sin server=104.0 client=104.0"
            + " vx server=104.0 client=-2.5 vy server=104.0 client=104.0"
            + " omega server=104.0 client=104.0",
        audit.describe(wrong));
    audit.keep(103, true);
    assertEquals(Verdict.RULED, audit.judge(wrong));
    assertEquals(Verdict.UNEXPLAINED, audit.judge(new DivergedNear(104, 103, bits)));
    audit.clear();
    assertEquals(Verdict.UNKNOWN, audit.judge(wrong));
  }

  @Test
  void anyNumbersAreJudgedWithoutHarm() {
    long seed = 11;
    Random random = new Random(seed);
    for (int tick = 0; tick < 500; tick++) {
      audit.keep(tick, random.nextInt(20) == 0);
      if (random.nextBoolean()) {
        audit.keepState(tick, near(tick, random.nextInt(60)));
      }
      for (int i = 0; i < 50; i++) {
        int at = random.nextInt(4) == 0 ? random.nextInt() : tick - random.nextInt(80);
        int equal = random.nextInt(4) == 0 ? random.nextInt() : at - 1 - random.nextInt(9);
        if (equal < 0 || equal >= at) {
          continue; // the codec refuses it
        }
        DivergedNear wild = report(at, equal, near(tick, 1 + random.nextInt(31)));
        if (audit.judge(wild) == Verdict.UNEXPLAINED) {
          audit.describe(wild);
        }
      }
    }
  }

  /** Entities 10, 11, ... of generation 7, all of whose numbers are the tick's. */
  private static Neighbourhood near(int tick, int count) {
    Neighbourhood near = new Neighbourhood();
    int[] row = new int[Neighbourhood.ENTITY_INTS];
    Arrays.fill(row, Float.floatToRawIntBits(tick));
    for (int i = 0; i < count; i++) {
      row[0] = Neighbourhood.key(10 + i, 7);
      near.add(row, 0);
    }
    return near;
  }

  private static DivergedNear report(int tick, int equalTick, Neighbourhood near) {
    List<Integer> bits = new ArrayList<>();
    for (int i = 0; i < Math.min(near.count(), DivergedNear.MAX_BODIES); i++) {
      for (int j = 0; j < DivergedNear.BODY_INTS; j++) {
        bits.add(near.entities()[i * Neighbourhood.ENTITY_INTS + j]);
      }
    }
    return new DivergedNear(tick, equalTick, bits);
  }
}
