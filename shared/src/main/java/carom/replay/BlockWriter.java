package carom.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/**
 * Writer of compressed blocks to a stream, each with its lengths and a checksum. If the process
 * dies, the file can be read up to its last whole block. Use it from one thread; it allocates
 * nothing once it has seen its largest block.
 */
public final class BlockWriter implements AutoCloseable {
  private final OutputStream out;
  private final Deflater deflater = new Deflater(Deflater.BEST_SPEED);
  private final CRC32 crc = new CRC32();
  private final byte[] head = new byte[Block.HEAD_BYTES];
  private byte[] stored = new byte[1 << 12];
  private long written;

  /**
   * Begins a recording by writing magic and version.
   *
   * @param out stream that this writer owns from now on
   */
  public BlockWriter(OutputStream out) throws IOException {
    this.out = out;
    byte[] preamble =
        ByteBuffer.allocate(Block.PREAMBLE_BYTES)
            .putLong(Block.MAGIC)
            .putInt(Block.VERSION)
            .array();
    out.write(preamble);
    written = preamble.length;
  }

  /** Writes a block and flushes the stream. */
  public void write(Block type, byte[] bytes, int length) throws IOException {
    if (length > Block.MAX_BYTES) {
      throw new IllegalArgumentException(
          "block length=" + length + " is above the limit of " + Block.MAX_BYTES + " bytes");
    }
    deflater.reset();
    deflater.setInput(bytes, 0, length);
    deflater.finish();
    int bound = length + length / 1_000 + 64; // incompressible data grows by 5 bytes in 16 KiB
    if (stored.length < bound) {
      stored = new byte[bound];
    }
    int count = deflater.deflate(stored);
    ByteBuffer.wrap(head).put((byte) type.ordinal()).putInt(length).putInt(count);
    crc.reset();
    crc.update(head, 0, Block.HEAD_BYTES - 4);
    crc.update(stored, 0, count);
    ByteBuffer.wrap(head).putInt(Block.HEAD_BYTES - 4, (int) crc.getValue());
    out.write(head);
    out.write(stored, 0, count);
    out.flush();
    written += Block.HEAD_BYTES + count;
  }

  /** Returns the number of bytes written so far. */
  public long written() {
    return written;
  }

  @Override
  public void close() throws IOException {
    deflater.end();
    out.close();
  }
}
