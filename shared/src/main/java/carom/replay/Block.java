package carom.replay;

/**
 * The kinds of blocks in a recording. A file stores a kind by its position in this list, so new
 * kinds go to the end.
 */
public enum Block {
  /** The first block, with the {@link RecordingHeader}. */
  HEADER,
  /** The events of up to a second of ticks, with fingerprints of their results. */
  TICKS,
  /** The exact state of every body after a tick. */
  KEYFRAME,
  /** The last block, with the reason for the end. */
  END,
  /**
   * A piece of the whole state after a tick. A simulation can start from a whole state without the
   * blocks before it.
   */
  STATE;

  /** First 8 bytes of a file. */
  static final long MAGIC = 0x4341524f4d524543L; // "CAROMREC"

  /** Version of the file format. Every change of the format raises it. */
  static final int VERSION = 6;

  /** The oldest version that is read: it lacks {@link #KEEP}. */
  static final int OLDEST_VERSION = 5;

  /** Bytes before the first block: magic and version. */
  static final int PREAMBLE_BYTES = 12;

  /** Bytes before a block's content: kind, content's length, stored length and CRC. */
  static final int HEAD_BYTES = 13;

  /** Largest content of a block in bytes. It holds a keyframe of 65,535 bodies with some room. */
  static final int MAX_BYTES = 4 << 20;

  /** Largest number of bytes of a state in one block. */
  static final int STATE_PIECE = 1 << 20;

  /** Largest state in bytes, that of a hundred thousand bodies. A larger one isn't recorded. */
  static final int MAX_STATE_BYTES = 1 << 25;

  // Tags of the entries in a TICKS block.
  static final int JOIN = 1;
  static final int LEAVE = 2;
  static final int TICK = 3;
  static final int STEPPED = 4;
  static final int MESSAGE = 5;
  static final int WATCH = 6;
  static final int ROLE = 7;
  static final int ACCOUNT = 8;
  static final int KEEP = 9;

  private static final Block[] ALL = values();

  static Block of(int number) {
    return number >= 0 && number < ALL.length ? ALL[number] : null;
  }
}
