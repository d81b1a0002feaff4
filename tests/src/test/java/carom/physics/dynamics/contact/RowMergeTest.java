package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.WorldDef;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.threads.Workers;
import java.util.Arrays;
import java.util.SortedSet;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rows that leave and pairs that come, against sets of keys; by one worker and in pieces. */
final class RowMergeTest {
  private static final int BODIES = 150;

  private final ContactTable table = new ContactTable();
  private final ShapeTable shapes = new ShapeTable(new WorldDef());

  /** Does tasks backwards, as if each was another thread's. */
  private static final class Backwards implements Workers {
    private int runs;

    @Override
    public int count() {
      return 3;
    }

    @Override
    public void run(int tasks, Task task) {
      runs++;
      for (int i = tasks - 1; i >= 0; i--) {
        task.run(i, i % 3);
      }
    }
  }

  private static long randomKey(SplittableRandom r) {
    int a = r.nextInt(BODIES - 1);
    return ContactKey.of(a, 0, a + 1 + r.nextInt(BODIES - 1 - a), 0);
  }

  /** Parts in a line of boxes of random width, some of which moved. */
  private void placeParts(SplittableRandom r) {
    shapes.moved = new boolean[BODIES];
    shapes.fat.ensureCapacity(BODIES);
    for (int part = 0; part < BODIES; part++) {
      float x = r.nextInt(100);
      shapes.fat.set(part, x, 0, x + r.nextInt(60), 1);
      shapes.moved[part] = r.nextInt(3) == 0;
    }
  }

  private void fill(SplittableRandom r, SortedSet<Long> keys) {
    table.clear();
    for (long key : keys) {
      int row = table.append();
      table.key[row] = key;
      table.part[2 * row] = ContactKey.bodyA(key);
      table.part[2 * row + 1] = ContactKey.bodyB(key);
      int kind = r.nextInt(10);
      table.flags[row] =
          kind == 0 ? ContactTable.IGNORED : kind < 4 ? ContactTable.TOUCHING : (byte) 0;
    }
  }

  private boolean stays(int row, boolean all) {
    if (table.flags[row] != 0) {
      return table.flags[row] == ContactTable.TOUCHING;
    }
    int a = table.part[2 * row];
    int b = table.part[2 * row + 1];
    return !(all || shapes.moved[a] || shapes.moved[b]) || shapes.fat.overlaps(a, b);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void rowsLeaveAndComeAsSetsSay(long seed) {
    SplittableRandom r = new SplittableRandom(seed);
    Backwards workers = new Backwards();
    ParallelFor shared = new ParallelFor();
    shared.use(workers);
    shared.stepBegins(BODIES * 100);
    for (int round = 0; round < 40; round++) {
      placeParts(r);
      TreeSet<Long> keys = new TreeSet<>();
      int rows = round % 4 == 0 ? r.nextInt(3) : 3_500 + r.nextInt(3_000);
      while (keys.size() < rows) {
        keys.add(randomKey(r));
      }
      fill(r, keys);
      long[] found = new long[r.nextInt(3) == 0 ? 0 : r.nextInt(3_000)];
      for (int i = 0; i < found.length; i++) {
        found[i] = i > 0 && r.nextInt(20) == 0 ? found[i - 1] : randomKey(r);
      }
      Arrays.sort(found);
      boolean all = r.nextBoolean();
      TreeSet<Long> expected = new TreeSet<>();
      for (int row = 0; row < rows; row++) {
        if (stays(row, all)) {
          expected.add(table.key[row]);
        }
      }
      TreeSet<Long> fresh = new TreeSet<>();
      for (long key : found) {
        if (!keys.contains(key)) {
          fresh.add(key);
        }
      }
      expected.addAll(fresh);
      String when = "seed=" + seed + " round=" + round;
      check(new ParallelFor(), found.clone(), all, expected, fresh, when + " alone");
      check(shared, found.clone(), all, expected, fresh, when + " shared");
    }
    assertTrue(workers.runs > 0, "rows must be enough to be shared");
  }

  private void check(
      ParallelFor parallel,
      long[] found,
      boolean all,
      SortedSet<Long> expected,
      SortedSet<Long> fresh,
      String when) {
    RowShifts shifts = new RowShifts();
    shifts.clear(false);
    RowMerge merge = new RowMerge(table);
    int come = merge.find(found, found.length, shapes, all, parallel, shifts);
    assertArrayEquals(toArray(fresh), Arrays.copyOf(found, come), when);
    assertEquals(expected.size(), merge.rowCount(), when);
    long[] keys = Arrays.copyOf(table.key, Math.max(table.count(), merge.rowCount()));
    shifts.plan(keys, keys, 1);
    shifts.carryOut(null);
    for (int i = 0; i < come; i++) {
      keys[shifts.inserted[i]] = found[i];
    }
    assertArrayEquals(toArray(expected), Arrays.copyOf(keys, merge.rowCount()), when);
  }

  private static long[] toArray(SortedSet<Long> keys) {
    return keys.stream().mapToLong(Long::longValue).toArray();
  }
}
