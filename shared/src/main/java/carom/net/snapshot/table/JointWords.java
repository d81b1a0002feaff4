package carom.net.snapshot.table;

import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import java.util.Arrays;

/**
 * The words of a row of the table of joints. A row is what a joint was made with; its key is the
 * joint's index in the server's world, its identity the generation. All words are plain 32 bits.
 *
 * <p>An end is the key of an entity, the inverted slot ({@code ~slot}) of a static body of the
 * level, or {@link JointRow#GROUND}.
 */
public final class JointWords {
  /** Place of the table in the list of tables. */
  public static final int TABLE = 0;

  /** Body A. */
  public static final int END_A = 0;

  /** Body B. */
  public static final int END_B = END_A + 1;

  /** Id of the root of the assembly that the joint belongs to; negative for none. */
  public static final int ROOT = END_B + 1;

  /** Which joint of its assembly, or of the level, it is. */
  public static final int NUMBER = ROOT + 1;

  /** First of the ints of {@link JointDefRow}. */
  public static final int DEFINITION = NUMBER + 1;

  /** Number of words. */
  public static final int WORDS = DEFINITION + JointDefRow.INTS;

  /** Class of audience of a client that may know a joint. */
  public static final int KNOWS = 1;

  /** Bits of a generation. */
  private static final int IDENTITY_BITS = 8;

  /** The shape of the table. */
  public static final TableLayout LAYOUT =
      new TableLayout(
          TableLayout.MAX_KEYS,
          IDENTITY_BITS,
          true,
          all(Integer.SIZE),
          all(0),
          all(0),
          all(1 << KNOWS),
          false);

  private JointWords() {}

  /**
   * Fills in a row.
   *
   * @param words receives {@link #WORDS} words
   * @param definition holds a {@link JointDefRow}
   * @param at where that begins
   */
  public static void put(
      int[] words, int endA, int endB, int root, int number, int[] definition, int at) {
    words[END_A] = endA;
    words[END_B] = endB;
    words[ROOT] = root;
    words[NUMBER] = number;
    System.arraycopy(definition, at, words, DEFINITION, JointDefRow.INTS);
  }

  private static int[] all(int value) {
    int[] words = new int[WORDS];
    Arrays.fill(words, value);
    return words;
  }
}
