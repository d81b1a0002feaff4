package carom.net.codec;

/**
 * A prefix code for differences that are mostly small: zero takes one bit, three classes of growing
 * width follow, the last holds any int. Each number has exactly one form. Immutable.
 *
 * <pre>
 * bits in order of writing   meaning (z = zigzag of the difference)
 * 0                          z = 0
 * 1 0    + small bits        z = 1 + these bits
 * 1 1 0  + medium bits       z = 1 + 2^small + these bits
 * 1 1 1 0 + large bits       z = 1 + 2^small + 2^medium + these bits
 * 1 1 1 1 + 5 + width bits   z = 1 + 2^small + 2^medium + 2^large + these bits (5 bits: width - 1)
 * </pre>
 */
public final class ResidualCode {

  private final int small;
  private final int medium;
  private final int large;
  private final int mediumBase;
  private final int largeBase;
  private final int anyBase;

  /** Creates a code with these widths in bits, each 1..16. */
  public ResidualCode(int small, int medium, int large) {
    this.small = small;
    this.medium = medium;
    this.large = large;
    mediumBase = 1 + (1 << small);
    largeBase = mediumBase + (1 << medium);
    anyBase = largeBase + (1 << large);
  }

  /** Writes a difference. */
  public void write(BitWriter w, int residual) {
    int z = Bits.zigzag(residual);
    if (z == 0) {
      w.write(0, 1);
    } else if (z > 0 && z < mediumBase) {
      w.write(0b01 | (z - 1) << 2, 2 + small);
    } else if (z > 0 && z < largeBase) {
      w.write(0b011 | (z - mediumBase) << 3, 3 + medium);
    } else if (z > 0 && z < anyBase) {
      w.write(0b0111 | (z - largeBase) << 4, 4 + large);
    } else {
      int rest = z - anyBase;
      int width = Math.max(1, Bits.width(rest));
      w.write(0b1111 | (width - 1) << 4, 9);
      w.write(rest, width);
    }
  }

  /** Bits that {@link #write} takes. */
  public int size(int residual) {
    int z = Bits.zigzag(residual);
    if (z < 0 || z >= anyBase) {
      return 9 + Math.max(1, Bits.width(z - anyBase));
    }
    if (z < mediumBase) {
      return z == 0 ? 1 : 2 + small;
    }
    return z < largeBase ? 3 + medium : 4 + large;
  }

  /** Reads a difference. */
  public int read(BitReader r) {
    if (!r.readBit()) {
      return 0;
    }
    if (!r.readBit()) {
      return Bits.unzigzag(1 + r.read(small));
    }
    if (!r.readBit()) {
      return Bits.unzigzag(mediumBase + r.read(medium));
    }
    if (!r.readBit()) {
      return Bits.unzigzag(largeBase + r.read(large));
    }
    int width = 1 + r.read(5);
    return Bits.unzigzag(anyBase + r.read(width));
  }
}
