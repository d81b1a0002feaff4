package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.codec.SectionCheck;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The own section: written, measured and read alike. */
class OwnCodecTest {
  private final Random random = new Random(73);

  private OwnState own() {
    OwnState own = new OwnState(20);
    if (random.nextInt(4) > 0) {
      own.slot = random.nextInt(1 << 16);
      own.generation = random.nextInt(256);
    }
    for (int i = 0; i < own.values.length; i++) {
      own.values[i] = random.nextInt(3) == 0 ? 0 : random.nextInt() >> random.nextInt(32);
    }
    for (int n = random.nextInt(OwnState.MAX_RELAYED + 1); n > 0; n--) {
      own.relayed.add(random.nextInt(1_024));
    }
    int origin = SpawnList.FIRST_ORIGIN + random.nextInt(SpawnList.FIRST_ORIGIN);
    for (int n = random.nextInt(SpawnList.MOST + 1); n > 0 && origin > 0; n--) {
      own.spawned().add(origin, random.nextInt(1 << 24));
      origin += 1 + random.nextInt(500);
    }
    return own;
  }

  /** A state that has some of another one's values. */
  private OwnState like(OwnState other) {
    OwnState own = own();
    if (random.nextBoolean()) {
      own.slot = other.slot;
      own.generation = other.generation;
    }
    for (int i = 0; i < own.values.length; i++) {
      own.values[i] = random.nextBoolean() ? own.values[i] : other.values[i];
    }
    if (random.nextBoolean()) {
      own.relayed.set(other.relayed);
    }
    if (random.nextBoolean()) {
      own.spawned().set(other.spawned());
      if (random.nextBoolean() && other.spawned().count() > 1) {
        own.spawned().clear();
        for (int i = random.nextInt(2); i < other.spawned().count(); i += 1 + random.nextInt(2)) {
          own.spawned().add(other.spawned().origin(i), other.spawned().key(i));
        }
        int newest = other.spawned().origin(other.spawned().count() - 1);
        own.spawned().add(newest | 63, random.nextInt(1 << 24));
      }
    }
    return own;
  }

  private static String text(OwnState own) {
    StringBuilder out = new StringBuilder(own.slot + "/" + own.generation);
    out.append(Arrays.toString(own.values));
    for (int p = own.relayed.next(0); p >= 0; p = own.relayed.next(p + 1)) {
      out.append(' ').append(p);
    }
    for (int i = 0; i < own.spawned().count(); i++) {
      out.append(' ').append(own.spawned().origin(i)).append('=').append(own.spawned().key(i));
    }
    return out.toString();
  }

  @Test
  void whatIsWrittenIsMeasuredAndRead() {
    for (int i = 0; i < 200; i++) {
      OwnState baseline = i % 4 == 0 ? new OwnState(20) : own();
      SectionCheck<OwnState> check =
          new SectionCheck<>(
              (c, own) -> OwnCodec.code(c, baseline, own), this::own, OwnCodecTest::text);
      check.check(like(baseline));
      assertEquals(1, check.check(baseline), "nothing has changed");
      check.hostile(random, 20);
    }
  }
}
