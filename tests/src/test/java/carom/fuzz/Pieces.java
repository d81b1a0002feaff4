package carom.fuzz;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.List;

/** Inputs that hold several pieces: each has a byte of kind, two of its length, and its bytes. */
public final class Pieces {
  private final byte[] data;
  private int at;
  private int kind;

  /** Begins with the first piece of an input. */
  public Pieces(byte[] data) {
    this.data = data;
  }

  /** Returns the next piece, cut off where the input ends, or null after the last. */
  public byte[] next() {
    if (data.length - at < 3) {
      return null;
    }
    kind = data[at] & 0xff;
    int length = (data[at + 1] & 0xff) << 8 | data[at + 2] & 0xff;
    int from = at + 3;
    at = Math.min(data.length, from + length);
    return Arrays.copyOfRange(data, from, at);
  }

  /** Returns the kind of the piece that {@link #next} returned, 0..255. */
  public int kind() {
    return kind;
  }

  /** Adds a piece to an input. Of a piece above 65,535 bytes only these are taken. */
  public static void add(ByteArrayOutputStream out, int kind, byte[] bytes) {
    int length = Math.min(bytes.length, 0xffff);
    out.write(kind);
    out.write(length >> 8);
    out.write(length);
    out.write(bytes, 0, length);
  }

  /** Returns an input of pieces of kind 0. */
  public static byte[] of(List<byte[]> pieces) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    pieces.forEach(piece -> add(out, 0, piece));
    return out.toByteArray();
  }
}
