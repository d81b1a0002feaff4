package carom.physics.broadphase;

/** Finds the k-th smallest of distinct numbers in expected linear time, in any order. */
final class Select {
  /** Number of numbers up to which a sample doesn't pay. */
  private static final int SAMPLED = 400;

  private static final int SORTED = 12;

  private Select() {}

  /**
   * Reorders {@code a[lo..hi]} so that {@code a[k]} is the number that sorting would put there,
   * with no larger number before it and no smaller one after it.
   *
   * <p>The algorithm is Floyd and Rivest's SELECT ("Expected time bounds for selection", 1975): a
   * small sample gives a pivot very near the k-th number. The sample is drawn pseudo-randomly, so
   * no order of the input is a bad one; the partition moves numbers without a branch that depends
   * on them.
   *
   * @param a distinct numbers; the difference of any two fits a long
   * @param lo first index
   * @param hi last index, not below {@code lo}
   * @param k index from {@code lo} to {@code hi}
   */
  static void nth(long[] a, int lo, int hi, int k) {
    int left = lo;
    int right = hi;
    int random = 0x2545F491;
    while (right - left >= SORTED) {
      int n = right - left + 1;
      if (n > SAMPLED) {
        int sample = 2 * (int) Math.sqrt(n);
        int from = Math.max(left, Math.min(k - sample / 2, right - sample + 1));
        for (int i = from; i < from + sample; i++) {
          random ^= random << 13;
          random ^= random >>> 17;
          random ^= random << 5;
          swap(a, i, left + (int) ((random & 0xFFFFFFFFL) * n >>> 32));
        }
        // aim a little beyond k, towards the larger side: what remains is then the smaller one
        long rank = (long) (k - left) * sample / n;
        int aside = (int) Math.sqrt(sample) / 2;
        int toward = k - left < right - k ? aside : -aside;
        int pivot = (int) Math.max(0, Math.min(sample - 1, rank + toward));
        nth(a, from, from + sample - 1, from + pivot);
        swap(a, left, from + pivot);
      } else {
        medianOfThree(a, left, right);
      }
      int at = partition(a, left, right);
      if (at == k) {
        return;
      }
      if (at < k) {
        left = at + 1;
      } else {
        right = at - 1;
      }
    }
    sort(a, left, right);
  }

  /**
   * Partitions around {@code a[left]} without branches on the data and returns where that number
   * ends up.
   */
  private static int partition(long[] a, int left, int right) {
    long pivot = a[left];
    int end = left + 1;
    for (int i = left + 1; i <= right; i++) {
      long value = a[i];
      a[i] = a[end];
      a[end] = value;
      end += (int) (value - pivot >>> 63);
    }
    swap(a, left, end - 1);
    return end - 1;
  }

  /** Puts the median of the first, middle and last number first. */
  private static void medianOfThree(long[] a, int left, int right) {
    int mid = (left + right) >>> 1;
    long low = Math.min(a[left], a[right]);
    long high = Math.max(a[left], a[right]);
    if (a[mid] > low && a[mid] < high) {
      swap(a, left, mid);
    } else if ((a[right] > a[left]) == (a[right] < a[mid])) {
      swap(a, left, right);
    }
  }

  private static void sort(long[] a, int left, int right) {
    for (int i = left + 1; i <= right; i++) {
      long value = a[i];
      int j = i - 1;
      while (j >= left && a[j] > value) {
        a[j + 1] = a[j];
        j--;
      }
      a[j + 1] = value;
    }
  }

  private static void swap(long[] a, int i, int j) {
    long value = a[i];
    a[i] = a[j];
    a[j] = value;
  }
}
