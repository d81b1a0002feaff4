package carom.net.snapshot.table;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitPass;
import carom.net.codec.SectionCheck;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Goal: the table section is the same whether it is measured, written or read. */
class TableCodecTest {
  private static final int MOST_ROWS = 6;

  private final long seed = Long.getLong("carom.seed", System.nanoTime());
  private final Random random = new Random(seed);

  /** Rows as {@link TableCodec} tells them, each with its words. */
  private static final class Section {
    int count;
    final int[] table = new int[1 << 16];
    final int[] key = new int[1 << 16];
    final boolean[] whole = new boolean[1 << 16];
    final boolean[] present = new boolean[1 << 16];
    final int[] identity = new int[1 << 16];
    final long[] mask = new long[1 << 16];
    final int[] age = new int[1 << 16];
    final int[][] words = new int[1 << 16][];

    @Override
    public String toString() {
      StringBuilder text = new StringBuilder();
      for (int i = 0; i < count; i++) {
        text.append(table[i]).append(' ').append(key[i]).append(' ').append(whole[i]);
        text.append(' ').append(present[i]).append(' ').append(identity[i]);
        text.append(' ').append(mask[i]).append(' ').append(age[i]);
        text.append(' ').append(Arrays.toString(words[i])).append('\n');
      }
      return text.toString();
    }
  }

  /** Returns layouts of one word, of a few, and of more than a row holds. */
  private TableLayout[] layouts() {
    TableLayout[] all = new TableLayout[1 + random.nextInt(TableCodec.MAX_TABLES)];
    for (int i = 0; i < all.length; i++) {
      int words = new int[] {1, 5, 9, 64, 100}[random.nextInt(5)];
      int[] bits = new int[words];
      int[] least = new int[words];
      int[] audiences = new int[words];
      for (int w = 0; w < words; w++) {
        bits[w] = 1 + random.nextInt(Integer.SIZE);
        least[w] = random.nextInt(1 << 20) - (1 << 19);
        audiences[w] = 2;
      }
      int targets = 1 + random.nextInt(random.nextBoolean() ? 20 : 30_000);
      all[i] =
          new TableLayout(
              targets,
              random.nextInt(17),
              random.nextBoolean(),
              bits,
              least,
              new int[words],
              audiences,
              random.nextBoolean());
    }
    return all;
  }

  private Section section(TableLayout[] layouts) {
    Section s = new Section();
    s.count = random.nextInt(MOST_ROWS + 1);
    for (int i = 0; i < s.count; i++) {
      s.table[i] = i > 0 && random.nextBoolean() ? s.table[i - 1] : random.nextInt(layouts.length);
      TableLayout layout = layouts[s.table[i]];
      int near = i == 0 ? 0 : s.key[i - 1] + random.nextInt(20);
      s.key[i] = random.nextBoolean() ? near % layout.keys() : random.nextInt(layout.keys());
      s.whole[i] = random.nextBoolean();
      s.present[i] = !s.whole[i] || !layout.startsEmpty() || random.nextBoolean();
      s.identity[i] = s.whole[i] && s.present[i] ? random.nextInt(1 << layout.identityBits()) : 0;
      long all = layout.width() == Long.SIZE ? -1 : (1L << layout.width()) - 1;
      long half = random.nextLong() & all;
      s.mask[i] = s.present[i] ? half & random.nextLong() : 0; // a quarter of the bits
      s.age[i] = layout.isUrgent() ? random.nextInt(64) : 0;
      s.words[i] = new int[Long.bitCount(s.mask[i])];
      int at = 0;
      for (long rest = s.mask[i]; rest != 0; rest &= rest - 1) {
        int word = Long.numberOfTrailingZeros(rest);
        int above = random.nextInt() >>> Integer.SIZE - layout.bits(s.key[i], word);
        s.words[i][at++] = layout.least(s.key[i], word) + above;
      }
    }
    return s;
  }

  private static void code(TableCodec codec, BitPass c, Section s) {
    int written = c.isReading() ? 0 : s.count;
    s.count = 0;
    codec.begin();
    while (true) {
      int i = s.count;
      boolean more = i < written;
      if (more) {
        codec.key = s.key[i];
        codec.whole = s.whole[i];
        codec.present = s.present[i];
        codec.identity = s.identity[i];
        codec.mask = s.mask[i];
        codec.age = s.age[i];
      }
      if (!codec.next(c, more, more ? s.table[i] : 0)) {
        return;
      }
      s.table[i] = codec.table;
      s.key[i] = codec.key;
      s.whole[i] = codec.whole;
      s.present[i] = codec.present;
      s.identity[i] = codec.identity;
      s.mask[i] = codec.mask;
      s.age[i] = codec.age;
      int[] words = more ? s.words[i] : new int[Long.bitCount(codec.mask)];
      int at = 0;
      for (long rest = codec.mask; rest != 0; rest &= rest - 1) {
        words[at] = codec.word(c, Long.numberOfTrailingZeros(rest), words[at]);
        at++;
      }
      s.words[i] = words;
      s.count++;
    }
  }

  @Test
  void measuredWrittenAndReadAlike() {
    System.out.println("table codec: -Dcarom.seed=" + seed);
    int bits = 0;
    for (int round = 0; round < 40; round++) {
      TableLayout[] layouts = layouts();
      TableCodec codec = new TableCodec(layouts);
      SectionCheck<Section> check =
          new SectionCheck<>((c, s) -> code(codec, c, s), Section::new, Section::toString);
      Section s = section(layouts);
      bits += check.check(s);
      check.hostile(random, 5);
    }
    assertTrue(bits > 40 * 50, "bits=" + bits);
  }
}
