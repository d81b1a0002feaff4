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

  long first(int index) {
    return slices[2 * index];
  }

  long width(int index) {
    return slices[2 * index + 1];
  }
}
