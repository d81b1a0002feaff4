package carom.replay;

/** The kinds of blocks; a file names them by their order. */
public enum Block {
  /** The first one: {@link RecordingHeader}. */
  HEADER,
  /** What happened in up to a second of ticks, and fingerprints of what came of it. */
  TICKS,
  /** The exact state of every body after a tick. */
  KEYFRAME,
  /** The last one: how the recording ended. */
  END,
  /**
   * A piece of the whole state after a tick, from which the game can be computed on without what
   * came before.
   */
  STATE;

  /** What a file begins with. */
  static final long MAGIC = 0x4341524f4d524543L; // "CAROMREC"

  /** Version of the format; whoever changes a byte of it raises this. */
  static final int VERSION = 3;

  /** Bytes before the first block: magic and version. */
  static final int PREAMBLE_BYTES = 12;

  /** Bytes before a block's content: type, content's length, stored length, CRC. */
  static final int HEAD_BYTES = 13;

  /** Largest content: a keyframe of 65,535 bodies and some room. */
  static final int MAX_BYTES = 4 << 20;

  /** Most bytes of a state in one block. */
  static final int STATE_PIECE = 1 << 20;

  /** Largest state, bytes: that of a hundred thousand bodies. A larger one isn't recorded. */
  static final int MAX_STATE_BYTES = 1 << 25;

  // What a TICKS block consists of.
  static final int JOIN = 1;
  static final int LEAVE = 2;
  static final int TICK = 3;
  static final int STEPPED = 4;

  private static final Block[] ALL = values();

  static Block of(int number) {
    return number >= 0 && number < ALL.length ? ALL[number] : null;
  }
}
