package carom.net.snapshot.table;

import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import java.util.Arrays;

/**
 * The words of a row of the table of joints. A row is what a joint was made with, and what the game
 * has changed about it since; its key is the joint's index in the server's world, its identity the
 * generation.
 *
 * <p>An end is the key of an entity, the inverted slot ({@code ~slot}) of a static body of the
 * level, or {@link JointRow#GROUND}.
 *
 * <p>What a joint was made with has plain 32 bits a word, because clients compute with it. What the
 * game changed is for the picture: exact rows tell it of joints that are predicted. It is stored as
 * the difference to what the joint was made with, bit by bit (exclusive or), without the lowest
 * bits of floats: 0 unless it changed by more than a picture shows.
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

  /** Number of the joint in its assembly, or in the level. */
  public static final int NUMBER = ROOT + 1;

  /** First of the ints of {@link JointDefRow}. */
  public static final int DEFINITION = NUMBER + 1;

  /** First of the words for {@link JointRow#SETTINGS}, in their order. */
  public static final int SETTINGS = DEFINITION + JointDefRow.INTS;

  /** Number of words. */
  public static final int WORDS = SETTINGS + JointRow.SETTING_INTS;

  /** Class of audience of a client that may know a joint. */
  public static final int KNOWS = 1;

  /** Bits of a generation. */
  private static final int IDENTITY_BITS = 8;

  /** Bits of the flags, which are an integer. */
  private static final int FLAG_BITS = 5;

  /** Bits of a length, a place or an angle, to 1 part in 65,536. */
  private static final int LENGTH_BITS = 24;

  /** Bits of a speed, a force, a spring or a direction, to 1 part in 256. */
  private static final int COARSE_BITS = 16;

  /** The shape of the table. */
  public static final TableLayout LAYOUT =
      new TableLayout(
          TableLayout.MAX_KEYS,
          IDENTITY_BITS,
          true,
          bits(),
          all(0),
          all(0),
          all(1 << KNOWS),
          false);

  private JointWords() {}

  /**
   * Fills in the row of a joint that is as it was made.
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
    Arrays.fill(words, SETTINGS, WORDS, 0);
  }

  /**
   * Fills in what has changed about the joint of a row.
   *
   * @param words a row that has been put
   * @param present holds a {@link JointDefRow} with the settings of now
   */
  public static void putSettings(int[] words, int[] present) {
    for (int i = 0; i < JointRow.SETTING_INTS; i++) {
      int field = JointRow.definedBy(i);
      int difference = present[field] ^ words[DEFINITION + field];
      words[SETTINGS + i] = difference >>> dropped(field);
    }
  }

  /**
   * Returns a setting of now.
   *
   * @param field of {@link JointRow}, from {@link JointRow#SETTINGS} on
   * @param made the same setting as the joint was made with
   * @param word the row's word for it: that of number {@code SETTINGS + field - JointRow.SETTINGS}
   */
  public static int setting(int field, int made, int word) {
    return made ^ word << dropped(JointRow.definedBy(field - JointRow.SETTINGS));
  }

  private static int dropped(int field) {
    return field == JointDefRow.FLAGS ? 0 : Integer.SIZE - settingBits(field);
  }

  private static int settingBits(int field) {
    return switch (field) {
      case JointDefRow.FLAGS -> FLAG_BITS;
      case JointDefRow.LOWER,
          JointDefRow.UPPER,
          JointDefRow.REST,
          JointDefRow.ANCHOR_AX,
          JointDefRow.ANCHOR_AY ->
          LENGTH_BITS;
      default -> COARSE_BITS;
    };
  }

  private static int[] bits() {
    int[] bits = all(Integer.SIZE);
    for (int i = 0; i < JointRow.SETTING_INTS; i++) {
      bits[SETTINGS + i] = settingBits(JointRow.definedBy(i));
    }
    return bits;
  }

  private static int[] all(int value) {
    int[] words = new int[WORDS];
    Arrays.fill(words, value);
    return words;
  }
}
