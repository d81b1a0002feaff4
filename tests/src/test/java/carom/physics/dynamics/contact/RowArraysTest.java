package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RowArraysTest {
  private static RowArrays make() {
    return new RowArrays(4, new int[] {1, 2}, new long[0], new float[0]);
  }

  private static void write(RowArrays to, int row, int value) {
    ((long[]) to.array(0))[row] = value;
    ((float[]) to.array(1))[2 * row + 1] = value;
  }

  private static int read(RowArrays from, int row) {
    float second = ((float[]) from.array(1))[2 * row + 1];
    assertEquals(((long[]) from.array(0))[row], (long) second);
    return (int) second;
  }

  @Test
  void whoWritesFirstTakesArraysOfItsOwn() {
    RowArrays live = make();
    write(live, 3, 7);
    assertSame(live, live.own(4, 4), "nobody else has them");
    RowArrays copy = live.share();
    assertTrue(live.shared());
    RowArrays own = live.own(4, 9);
    assertNotSame(copy, own);
    assertEquals(9, own.capacity());
    assertFalse(copy.shared() || own.shared());
    write(own, 3, 8);
    assertEquals(7, read(copy, 3));
    assertEquals(8, read(own, 3));
  }

  @Test
  void arraysThatNobodyNeedsAreUsedAgain() {
    RowArrays live = make();
    RowArrays copy = live.share();
    RowArrays first = live;
    for (int i = 0; i < 10; i++) {
      RowArrays before = live;
      live = live.own(4, 4);
      copy.release();
      copy = live.share();
      assertNotSame(before, live);
      if (i % 2 == 1) {
        assertSame(first, live, "there are two in all");
      }
    }
  }

  /** One that is stepped, and copies of it that are taken and gone back to, beside plain lists. */
  @Test
  void copiesStayAsTheyWere() {
    for (long seed = 1; seed <= 200; seed++) {
      SplittableRandom r = new SplittableRandom(seed);
      RowShifts shifts = new RowShifts();
      RowArrays live = make();
      List<Integer> expected = new ArrayList<>();
      RowArrays[] saved = new RowArrays[4];
      List<List<Integer>> then = new ArrayList<>();
      for (int i = 0; i < saved.length; i++) {
        saved[i] = live.share();
        then.add(List.of());
      }
      for (int step = 1; step < 60; step++) {
        int which = r.nextInt(saved.length);
        switch (r.nextInt(4)) {
          case 0 -> {
            saved[which].release();
            saved[which] = live.share();
            then.set(which, List.copyOf(expected));
          }
          case 1 -> {
            RowArrays from = saved[which].share();
            live.release();
            live = from;
            expected = new ArrayList<>(then.get(which));
          }
          case 2 -> {
            live = live.own(expected.size(), live.room(expected.size()));
            for (int row = 0; row < expected.size(); row++) {
              write(live, row, step * 100 + row);
              expected.set(row, step * 100 + row);
            }
          }
          default -> {
            List<Integer> now = new ArrayList<>();
            int fresh = 0;
            shifts.clear(live.shared());
            for (int row = 0; row < expected.size(); row++) {
              if (r.nextInt(5) > 0) {
                shifts.keep(row, now.size());
                now.add(expected.get(row));
              }
              if (r.nextInt(4) == 0) {
                shifts.insert(fresh++, now.size());
                now.add(-step);
              }
            }
            shifts.insert(fresh++, now.size());
            now.add(-step);
            live = live.moved(shifts, live.room(now.size()));
            shifts.carryOut(null);
            for (int i = 0; i < fresh; i++) {
              write(live, shifts.inserted[i], -step);
            }
            expected = now;
          }
        }
        compare(expected, live, "live, seed=" + seed);
        for (int i = 0; i < saved.length; i++) {
          compare(then.get(i), saved[i], "copy " + i + ", seed=" + seed);
        }
      }
    }
  }

  private static void compare(List<Integer> expected, RowArrays actual, String what) {
    for (int row = 0; row < expected.size(); row++) {
      assertEquals(expected.get(row), read(actual, row), what);
    }
  }
}
