package carom.net.codec;

import java.util.Arrays;

/**
 * Keeps slices for later, one after the other. One thread; allocates only while it grows beyond
 * what it ever held.
 */
public final class SliceList extends SliceWriter {

  private long[] slices = new long[64];
  private int size;

  /** Creates an empty list. */
  public SliceList() {}

  /** Forgets all slices, also one that was begun. */
  public void clear() {
    size = 0;
    begin(0, ALL);
  }

  /** Forgets the slices from an index on; must follow a cut. */
  public void shorten(int size) {
    this.size = 2 * size;
  }

  /** Adds slices of another list; must follow a cut. */
  public void addAll(SliceList other, int from, int to) {
    int length = 2 * (to - from);
    if (size + length > slices.length) {
      slices = Arrays.copyOf(slices, Math.max(2 * slices.length, size + length));
    }
    System.arraycopy(other.slices, 2 * from, slices, size, length);
    size += length;
  }

  /** What some slices take of a message, bits; never less than they do, by a tenth of one each. */
  public double bits(int from, int to) {
    double bits = 0;
    for (int i = from; i < to; i++) {
      long width = width(i);
      int digits = Long.SIZE - 1 - Long.numberOfLeadingZeros(width);
      // The mantissa less 1 is a little less than its logarithm.
      bits += BITS + 1 - digits - (double) width / (1L << digits);
    }
    return bits;
  }

  /** Slices that are done. */
  public int size() {
    return size >> 1;
  }

  @Override
  void slice(long first, long width) {
    if (size == slices.length) {
      slices = Arrays.copyOf(slices, 2 * size);
    }
    slices[size] = first;
    slices[size + 1] = width;
    size += 2;
  }

  /** The first number and the width of each slice; until the list grows. */
  long[] numbers() {
    return slices;
  }

  private long width(int index) {
    return slices[2 * index + 1];
  }
}
