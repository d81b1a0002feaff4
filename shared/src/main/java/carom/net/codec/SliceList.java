package carom.net.codec;

import java.util.Arrays;

/**
 * Growing list of slices that can be written into messages later. Use it from one thread; it
 * allocates only to grow beyond its largest size so far.
 */
public final class SliceList extends SliceWriter {

  private long[] slices = new long[64];
  private int size;

  /** Creates an empty list. */
  public SliceList() {}

  /** Removes all slices, including an unfinished one. */
  public void clear() {
    size = 0;
    begin(0, ALL);
  }

  /** Removes the slices from index {@code size} on. Call it only right after a cut. */
  public void shorten(int size) {
    this.size = 2 * size;
  }

  /**
   * Appends the slices at {@code from} to {@code to - 1} of another list. Call it only right after
   * a cut.
   */
  public void addAll(SliceList other, int from, int to) {
    int length = 2 * (to - from);
    if (size + length > slices.length) {
      slices = Arrays.copyOf(slices, Math.max(2 * slices.length, size + length));
    }
    System.arraycopy(other.slices, 2 * from, slices, size, length);
    size += length;
  }

  /**
   * Returns an upper bound of the bits that the slices at {@code from} to {@code to - 1} take in a
   * message. It exceeds the exact cost by less than a tenth of a bit for each slice.
   */
  public double bits(int from, int to) {
    double bits = 0;
    for (int i = from; i < to; i++) {
      long width = width(i);
      int digits = Long.SIZE - 1 - Long.numberOfLeadingZeros(width);
      // For a mantissa m of 1..2, m - 1 is at most log2(m).
      bits += BITS + 1 - digits - (double) width / (1L << digits);
    }
    return bits;
  }

  /** Returns the number of finished slices. */
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

  /**
   * Returns the backing array, with the first number and the width of each slice. It is valid until
   * the list grows.
   */
  long[] numbers() {
    return slices;
  }

  private long width(int index) {
    return slices[2 * index + 1];
  }
}
