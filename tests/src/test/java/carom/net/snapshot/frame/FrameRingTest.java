package carom.net.snapshot.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.Quantizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class FrameRingTest {
  private static final int SLOTS = 150;

  /** What a slot holds; null for nothing. */
  private record Held(int owner, int audience, List<Integer> motion) {}

  private static List<Integer> motion(Random random) {
    return List.of(
        within(random, Quantizer.MAX_POSITION),
        within(random, Quantizer.MAX_POSITION),
        random.nextInt(Quantizer.ANGLE_STEPS),
        random.nextInt(2));
  }

  /** Often one of the ends. */
  private static int within(Random random, int max) {
    return switch (random.nextInt(4)) {
      case 0 -> max;
      case 1 -> -max;
      default -> random.nextInt(2 * max + 1) - max;
    };
  }

  private static void put(FrameState frame, int slot, Held h) {
    List<Integer> m = h.motion;
    frame.putQuantized(slot, 1, 2, h.owner, m.get(0), m.get(1), m.get(2), m.get(3) != 0);
    frame.setAudience(slot, h.audience);
  }

  private static Held read(FrameState frame, int slot) {
    if (!frame.alive(slot)) {
      return null;
    }
    List<Integer> motion =
        List.of(frame.x(slot), frame.y(slot), frame.angle(slot), frame.still(slot) ? 1 : 0);
    return new Held(frame.owner(slot), frame.audience(slot), motion);
  }

  /** Against a record of everything that was ever put. */
  @Test
  void everyFrameKeepsWhatWasPutAndSinceWhenIsKnown() {
    Random random = new Random(7);
    FrameRing ring = new FrameRing(SLOTS);
    List<Held[]> history = new ArrayList<>();
    List<Integer> ticks = new ArrayList<>();
    List<int[]> since = new ArrayList<>();
    Held[] now = new Held[SLOTS];
    int tick = 0;
    for (int n = 0; n < 300; n++) {
      tick += 1 + random.nextInt(2);
      int[] changed = n == 0 ? new int[SLOTS] : since.get(n - 1).clone();
      now = now.clone();
      boolean many = n % 50 < 10;
      for (int slot = 0; slot < SLOTS; slot++) {
        Held before = now[slot];
        if (n == 0 || random.nextInt(many ? 2 : 60) == 0) {
          now[slot] = changedAtRandom(before, random);
        }
        boolean same = before == null ? now[slot] == null : before.equals(now[slot]);
        changed[slot] = n == 0 || !same ? tick : changed[slot];
      }
      now[SLOTS - 1] = n == 0 ? new Held(-1, 0, motion(random)) : now[SLOTS - 1];
      FrameState frame = ring.begin(tick);
      for (int slot = 0; slot < SLOTS; slot++) {
        if (now[slot] != null) {
          put(frame, slot, now[slot]);
        }
      }
      ring.end();
      history.add(now);
      ticks.add(tick);
      since.add(changed);
      int slot = random.nextInt(SLOTS);
      for (int back = 0; back < Math.min(n + 1, FrameRing.SIZE); back++) {
        assertEquals(history.get(n - back)[slot], read(ring.back(back), slot));
      }
      for (int each = 0; each < SLOTS; each++) {
        assertEquals(changed[each], ring.changedTick(each));
        assertEquals(changed[each] == tick, frame.changed().has(each));
      }
      requireLastLike(ring, ticks, since, slot);
    }
  }

  private static Held changedAtRandom(Held before, Random random) {
    if (before == null || random.nextInt(3) == 0) {
      return new Held(random.nextInt(3) - 1, random.nextInt(2) * 9, motion(random));
    }
    return switch (random.nextInt(4)) {
      case 0 -> null;
      case 1 -> new Held(before.owner + 1, before.audience, before.motion);
      case 2 -> new Held(before.owner, before.audience + 1, before.motion);
      default -> new Held(before.owner, before.audience, motion(random));
    };
  }

  private static void requireLastLike(
      FrameRing ring, List<Integer> ticks, List<int[]> since, int slot) {
    int newest = ticks.size() - 1;
    int oldest = Math.max(0, newest - FrameRing.SIZE + 1);
    for (int i = 0; i <= newest; i++) {
      if (since.get(newest)[slot] <= ticks.get(i)) {
        continue; // asked only of what has changed
      }
      int last = i;
      while (since.get(last + 1)[slot] <= ticks.get(i)) {
        last++;
      }
      FrameState expected = last < oldest ? null : ring.at(ticks.get(last));
      assertSame(expected, ring.lastLike(slot, ticks.get(i)), "slot=" + slot + " frame=" + i);
    }
  }

  @Test
  void whoIsThereIsSharedUntilSomebodyElseIs() {
    FrameRing ring = new FrameRing(SLOTS);
    put(ring.begin(0), 70, new Held(4, 0, motion(new Random(1))));
    ring.end();
    FrameState first = ring.newest();
    FrameState frame = ring.begin(1);
    frame.identifyAs(first);
    assertThrows(IllegalStateException.class, () -> frame.identify(3, 1, 1, -1));
    assertThrows(IllegalStateException.class, () -> frame.setTeleports(70, 1));
    assertThrows(IllegalStateException.class, () -> frame.identifyAs(first));
    frame.putPoses(2, new int[] {-1, 70}, 0, new int[][] {{0, 1}, {0, -2}, {0, 3}, {0, 1}});
    ring.end();
    assertEquals(new Held(4, 0, List.of(1, -2, 3, 1)), read(frame, 70));
    assertTrue(frame.renamed().nextWord(0) < 0);
    assertTrue(frame.changed().has(70));
    put(ring.begin(2), 70, new Held(5, 0, List.of(1, -2, 3, 1)));
    ring.end();
    assertTrue(ring.newest().renamed().has(70));
    assertEquals(4, first.owner(70));
    assertEquals(4, frame.owner(70));
    for (int tick = 3; tick < 3 + FrameRing.SIZE; tick++) {
      ring.begin(tick).identifyAs(ring.newest());
      ring.end();
      assertEquals(5, ring.newest().owner(70));
      assertFalse(ring.newest().renamed().has(70));
    }
  }
}
