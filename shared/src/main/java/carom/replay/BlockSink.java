package carom.replay;

/** Takes the blocks of a recording. */
public interface BlockSink {
  /**
   * Takes one block.
   *
   * @param type one of {@link Block}'s
   * @param bytes copied before this returns
   * @param length how many of them
   * @return false when it can't take this one: the recording has a hole then, and goes no further
   */
  boolean take(Block type, byte[] bytes, int length);
}
