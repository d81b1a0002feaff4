package carom.physics.dynamics.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactKey;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class KeySorterTest {
  @Test
  void sortsAsTheLibraryDoes() {
    KeySorter sorter = new KeySorter();
    long seed = 42;
    SplittableRandom r = new SplittableRandom(seed);
    long[] keys = new long[3000];
    for (int n : new int[] {0, 1, 2, 31, 32, 33, 500, 3000, 40}) {
      for (int i = 0; i < n; i++) {
        keys[i] = ContactKey.of(r.nextInt(5000), r.nextInt(3), 5000 + r.nextInt(900), r.nextInt(9));
      }
      long[] expected = Arrays.copyOf(keys, n);
      Arrays.sort(expected);
      keys = sorter.sort(keys, n);
      assertArrayEquals(expected, Arrays.copyOf(keys, n), "seed=" + seed + " n=" + n);
    }
  }

  @Test
  void sortsRowsByTheirKeys() {
    KeySorter sorter = new KeySorter();
    long seed = 43;
    SplittableRandom r = new SplittableRandom(seed);
    for (int n : new int[] {0, 1, 2, 31, 32, 33, 500, 3000, 40}) {
      long[] keys = new long[n + 50];
      Arrays.setAll(keys, i -> ContactKey.of(r.nextInt(5000), r.nextInt(3), 5000 + i, i % 9));
      int[] rows = r.ints(0, keys.length).distinct().limit(n).toArray();
      long[] expected = Arrays.stream(rows).mapToLong(row -> keys[row]).sorted().toArray();
      sorter.sort(rows, n, keys);
      long[] sorted = Arrays.stream(rows).mapToLong(row -> keys[row]).toArray();
      assertArrayEquals(expected, sorted, "seed=" + seed + " n=" + n);
    }
  }

  @Test
  void keysCarryFourNumbers() {
    int body = BodyStore.MAX_BODIES - 1;
    int part = BodyStore.MAX_PARTS - 1;
    long key = ContactKey.of(body - 1, part, body, part - 1);
    assertEquals(body - 1, ContactKey.bodyA(key));
    assertEquals(body, ContactKey.bodyB(key));
    assertEquals(part, ContactKey.partA(key));
    assertEquals(part - 1, ContactKey.partB(key));
  }
}
