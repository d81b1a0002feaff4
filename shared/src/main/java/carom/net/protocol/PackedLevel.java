package carom.net.protocol;

import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/** Compression of a level file on the wire, as one zlib stream (RFC 1950). */
public final class PackedLevel {
  private static final int MIN_BUFFER = 1_024;

  private PackedLevel() {}

  /**
   * Packs a level file as small as zlib can, in about 50 ms per megabyte. A server packs each level
   * once.
   */
  public static byte[] pack(byte[] level) {
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
    try {
      deflater.setInput(level);
      deflater.finish();
      byte[] packed = new byte[Math.max(MIN_BUFFER, level.length / 4)];
      int length = 0;
      while (!deflater.finished()) {
        if (length == packed.length) {
          packed = Arrays.copyOf(packed, 2 * length);
        }
        length += deflater.deflate(packed, length, packed.length - length);
      }
      return Arrays.copyOf(packed, length);
    } finally {
      deflater.end();
    }
  }

  /**
   * Unpacks a level file from an untrusted peer. The content never makes it throw, and it allocates
   * exactly {@code size} bytes for the file.
   *
   * @param size size of the level file in bytes, 0..{@link ProtocolLimits#MAX_LEVEL_BYTES}
   * @return the file, or null when the bytes are not exactly one packed file of that size
   */
  public static byte[] unpack(byte[] packed, int size) {
    if (size < 0 || size > ProtocolLimits.MAX_LEVEL_BYTES) {
      return null;
    }
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(packed);
      byte[] level = new byte[size];
      int length = 0;
      while (length < size) {
        int more = inflater.inflate(level, length, size - length);
        if (more == 0) {
          return null; // the stream ends early or needs a dictionary
        }
        length += more;
      }
      boolean whole = inflater.finished() || inflater.inflate(new byte[1]) == 0;
      return whole && inflater.finished() && inflater.getRemaining() == 0 ? level : null;
    } catch (DataFormatException e) {
      return null;
    } finally {
      inflater.end();
    }
  }
}
