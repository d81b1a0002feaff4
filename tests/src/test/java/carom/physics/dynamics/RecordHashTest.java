package carom.physics.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class RecordHashTest {
  private static final int RECORDS = 40;

  private final float[][] columns = new float[7][RECORDS];

  private long hash(int[] order) {
    RecordHash hash = new RecordHash();
    System.arraycopy(order, 0, hash.list(order.length), 0, order.length);
    hash.begin(order.length);
    for (int i = 0; i < hash.count(); i++) {
      hash.add(i, 0, hash.record(i));
    }
    hash.add(1, columns[0], columns[1], columns[2], columns[3]);
    hash.add(5, columns[4], columns[5]);
    hash.add(7, columns[6]);
    return hash.finish();
  }

  private static int[] all() {
    int[] order = new int[RECORDS];
    for (int i = 0; i < RECORDS; i++) {
      order[i] = i;
    }
    return order;
  }

  @Test
  void theOrderOfRecordsDoesNotMatterAndWhatIsNotListedNeither() {
    Random random = new Random(3);
    for (float[] column : columns) {
      for (int i = 0; i < RECORDS; i++) {
        column[i] = random.nextFloat();
      }
    }
    int[] some = {5, 7, 30, 2};
    long before = hash(some);
    columns[3][6] = 100;
    assertEquals(before, hash(new int[] {2, 30, 7, 5}));
  }

  /** Every bit of every word, alone and with the sign or the top bit of any other word. */
  @Test
  void oneOrTwoFlippedBitsGiveAnotherHash() {
    Set<Long> seen = new HashSet<>();
    seen.add(hash(all()));
    int tried = 1;
    for (int f = 0; f < columns.length; f++) {
      for (int bit = 0; bit < 32; bit++) {
        flip(f, 11, bit);
        seen.add(hash(all()));
        tried++;
        for (int g = 0; g < columns.length; g++) {
          for (int other = 0; other < 32; other++) {
            if (g > f || (g == f && other > bit)) {
              flip(g, 11, other);
              seen.add(hash(all()));
              tried++;
              flip(g, 11, other);
            }
          }
        }
        flip(f, 11, bit);
      }
    }
    assertEquals(tried, seen.size());
  }

  @Test
  void recordsThatChangePlacesGiveAnotherHash() {
    Set<Long> seen = new HashSet<>();
    columns[2][4] = 1;
    for (int i = 0; i < RECORDS; i++) {
      columns[2][4] = 0;
      columns[2][i] = 1;
      assertTrue(seen.add(hash(all())), "i=" + i);
      columns[2][i] = 0;
    }
  }

  private void flip(int column, int record, int bit) {
    int bits = Float.floatToRawIntBits(columns[column][record]) ^ 1 << bit;
    columns[column][record] = Float.intBitsToFloat(bits);
  }
}
