package carom.replay;

/** Receiver of the blocks of a recording. */
public interface BlockSink {
  /**
   * Takes one block.
   *
   * @param type kind of the block
   * @param bytes content, which this method copies before it returns
   * @param length number of bytes in the content
   * @return false when the sink can't take this block; the recording then ends before it
   */
  boolean take(Block type, byte[] bytes, int length);
}
