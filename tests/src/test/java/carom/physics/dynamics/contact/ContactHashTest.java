package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.StateHash;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ContactHashTest {
  /** Calls after which kernels are trusted with everything. */
  private static final int MANY = 2_000;

  private static final int[] COUNTED = {
    ContactTable.NORMAL0,
    ContactTable.TANGENT0,
    ContactTable.TOTAL0,
    ContactTable.NORMAL1,
    ContactTable.TANGENT1,
    ContactTable.TOTAL1
  };

  private final Random random = new Random(11);

  /** Some rows, by these keys; two in three touch, the others hold numbers nevertheless. */
  private ContactTable table(List<Long> keys) {
    ContactTable t = new ContactTable();
    for (long key : keys) {
      int row = t.append();
      Random numbers = new Random(key);
      t.key[row] = key;
      t.flags[row] = (byte) (key % 3 == 0 ? 0 : ContactTable.TOUCHING | ContactTable.WAS_TOUCHING);
      t.points[row] = (byte) (1 + key % 2);
      t.id[2 * row] = numbers.nextInt();
      t.id[2 * row + 1] = numbers.nextInt();
      for (int i = 0; i < ContactTable.CONTACT; i++) {
        t.contact[row * ContactTable.CONTACT + i] = numbers.nextFloat() - 0.5f;
      }
      t.roll[row] = key % 5 == 0 ? numbers.nextFloat() : 0;
    }
    return t;
  }

  private static List<Long> keys(int n) {
    List<Long> keys = new ArrayList<>();
    for (long i = 0; i < n; i++) {
      keys.add(i << 33 | (i * 7 + 1));
    }
    return keys;
  }

  private static long hash(ContactTable t) {
    return new ContactHash().mix(3, t, true);
  }

  /** Bits of one row, as words: the hash is their sum by place. */
  private static void add(ContactTable t, int row, long[] sums) {
    long factor = StateHash.finish(t.key[row]) | 1;
    int flags = t.flags[row] & 0x9f;
    long[] words = new long[7];
    words[0] = flags + 256L * t.points[row];
    words[1] = word(t.id[2 * row], t.id[2 * row + 1]);
    for (int i = 0; i < COUNTED.length; i += 3) {
      int at = row * ContactTable.CONTACT;
      int[] bits = new int[3];
      for (int k = 0; k < 3; k++) {
        bits[k] = Float.floatToRawIntBits(t.contact[at + COUNTED[i + k]]);
      }
      words[2 + i / 3 * 2] = word(bits[0], bits[1]);
      words[3 + i / 3 * 2] = word(bits[2], 0);
    }
    words[6] = Float.floatToRawIntBits(t.roll[row]);
    for (int i = 0; i < sums.length; i++) {
      sums[i] += words[i] * factor;
    }
  }

  private static long word(int low, int high) {
    long spread = (low & 0xffffffffL | (long) high << 32) * 0x9e3779b97f4a7c15L;
    return spread ^ spread >>> 32;
  }

  private static long expected(ContactTable t) {
    long[] sums = new long[7];
    for (int row = 0; row < t.count(); row++) {
      if ((t.flags[row] & ContactTable.TOUCHING) != 0) {
        add(t, row, sums);
      }
    }
    long h = 3;
    for (long sum : sums) {
      h = StateHash.mix(h, sum);
    }
    return h;
  }

  /** Goal: vectors show in no bit. Method: tables of all lengths, until vectors do all of them. */
  @Test
  void vectorsGiveTheSameBits() {
    for (int n : new int[] {0, 1, 7, 511, 512, 519, 1000, 1600, 3007}) {
      ContactTable t = table(keys(n));
      long expected = expected(t);
      for (int call = 0; call < (n == 3007 ? MANY : 3); call++) {
        assertEquals(expected, hash(t), "n=" + n + " call=" + call);
      }
    }
    for (int n = 500; n < 560; n++) {
      ContactTable t = table(keys(n));
      assertEquals(expected(t), hash(t), "n=" + n);
    }
  }

  @Test
  void theOrderOfRowsDoesNotMatterAndWhatDoesNotTouchNeither() {
    List<Long> all = keys(900);
    long before = hash(table(all));
    for (int i = 0; i < 10; i++) {
      Collections.shuffle(all, random);
      assertEquals(before, hash(table(all)));
    }
    all.removeIf(key -> key % 3 == 0);
    assertEquals(before, hash(table(all)));
    all.remove(100);
    assertNotEquals(before, hash(table(all)));
  }

  /** Every bit of every word of two rows, alone and with any other. */
  @Test
  void oneOrTwoFlippedBitsGiveAnotherHash() {
    ContactTable t = table(keys(20));
    int a = 0;
    while (t.flags[a] == 0) {
      a++;
    }
    int b = a + 1;
    while (t.flags[b] == 0) {
      b++;
    }
    List<Runnable> flips = new ArrayList<>();
    for (int row : new int[] {a, b}) {
      for (int bit = 0; bit < 64; bit++) {
        long mask = 1L << bit;
        flips.add(() -> t.key[row] ^= mask);
      }
      for (int bit = 0; bit < 32; bit++) {
        int mask = 1 << bit;
        flips.add(() -> t.id[2 * row] ^= mask);
        flips.add(() -> t.id[2 * row + 1] ^= mask);
        for (int i : COUNTED) {
          int at = row * ContactTable.CONTACT + i;
          flips.add(
              () ->
                  t.contact[at] =
                      Float.intBitsToFloat(Float.floatToRawIntBits(t.contact[at]) ^ mask));
        }
        flips.add(
            () -> t.roll[row] = Float.intBitsToFloat(Float.floatToRawIntBits(t.roll[row]) ^ mask));
      }
      for (int flag : new int[] {ContactTable.VETOED, ContactTable.SENSOR, ContactTable.IGNORED}) {
        flips.add(() -> t.flags[row] ^= (byte) flag);
      }
      flips.add(() -> t.points[row] ^= 3);
    }
    Set<Long> seen = new HashSet<>();
    seen.add(hash(t));
    int tried = 1;
    for (int i = 0; i < flips.size(); i++) {
      flips.get(i).run();
      seen.add(hash(t));
      tried++;
      for (int k = i + 1; k < flips.size(); k++) {
        flips.get(k).run();
        seen.add(hash(t));
        tried++;
        flips.get(k).run();
      }
      flips.get(i).run();
    }
    assertEquals(tried, seen.size());
  }

  @Test
  void impulsesThatChangeRowsOrPointsGiveAnotherHash() {
    ContactTable t = table(keys(30));
    Set<Long> seen = new HashSet<>();
    seen.add(hash(t));
    for (int row = 0; row < 30; row++) {
      for (int other = 0; other < row; other++) {
        if (t.flags[row] != 0 && t.flags[other] != 0) {
          for (int i : COUNTED) {
            swap(t.contact, row * ContactTable.CONTACT + i, other * ContactTable.CONTACT + i);
            assertTrue(seen.add(hash(t)), row + " " + other + " " + i);
            swap(t.contact, row * ContactTable.CONTACT + i, other * ContactTable.CONTACT + i);
          }
        }
      }
    }
    int at = ContactTable.CONTACT;
    swap(t.contact, at + ContactTable.NORMAL0, at + ContactTable.NORMAL1);
    assertTrue(seen.add(hash(t)));
  }

  @Test
  void whatFollowsFromTheStateBeforeDoesNotCount() {
    ContactTable t = table(keys(30));
    long before = hash(t);
    for (int i : new int[] {ContactTable.NX, ContactTable.GAP1, ContactTable.SLIDE0}) {
      t.contact[ContactTable.CONTACT + i] += 1;
    }
    t.contact[ContactTable.CONTACT + ContactTable.SLIDE1] += 1;
    t.flags[1] ^= ContactTable.FRESH | ContactTable.WAS_PUSHED;
    assertEquals(before, hash(t));
  }

  private static void swap(float[] a, int i, int k) {
    float kept = a[i];
    a[i] = a[k];
    a[k] = kept;
  }
}
