package carom.physics.rows;

/**
 * The fields of a row of words: offsets of ints from the row's beginning. It holds eight words that
 * the using program keeps with a body. The physics neither reads nor writes it.
 *
 * <p>Words are stored as differences from what they are at the start, so that zero means nothing
 * special, and eight zeros need no row.
 */
public final class FieldRow {
  /** Place of the body among the rows of bodies. */
  public static final int PLACE = 0;

  /** Number of the group of eight among the body's words; 0..{@link #MAX_CHUNKS} - 1. */
  public static final int CHUNK = PLACE + 1;

  /** First of {@link #WORD_INTS} ints: the words. */
  public static final int WORDS = CHUNK + 1;

  /** Number of words. */
  public static final int WORD_INTS = 8;

  /** Number of ints of a row. */
  public static final int INTS = WORDS + WORD_INTS;

  /** Largest number of rows of one body. */
  public static final int MAX_CHUNKS = 64;

  private FieldRow() {}
}
