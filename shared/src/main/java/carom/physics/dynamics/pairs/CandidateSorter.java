package carom.physics.dynamics.pairs;

import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.dynamics.store.ParallelFor;

/**
 * Brings together what the workers found, in the order of the keys. Each worker sorts one range of
 * keys. A range ends where an equal share of the table's rows does, so that ranges are about as
 * long.
 */
final class CandidateSorter {
  /** Number of candidates below which one thread sorts them all. */
  private static final int FEWEST_TO_SHARE = 2_048;

  private final ContactTable contacts;
  private final ParallelFor parallel;
  private final KeySorter sorter = new KeySorter();
  private final ParallelFor.Range sorting = this::sortRanges;
  private long[] keys = new long[64];
  private int count;

  // The sort at present.
  private CandidateList[] lists;
  private int ranges;

  CandidateSorter(ContactTable contacts, ParallelFor parallel) {
    this.contacts = contacts;
    this.parallel = parallel;
  }

  /** Returns the number of sorted keys that there is room for. */
  int capacity() {
    return keys.length;
  }

  /** Returns the number of keys that {@link #sort} returned, repetitions included. */
  int count() {
    return count;
  }

  /**
   * Sorts the keys of all lists.
   *
   * @param found what each worker found
   * @return the keys, ascending, in the first {@link #count} entries; valid until the next call
   */
  long[] sort(CandidateList[] found) {
    lists = found;
    int sum = 0;
    for (CandidateList list : lists) {
      sum += list.count;
    }
    if (keys.length <= sum) { // there is always one to spare, see CandidateList.sortRange
      keys = new long[2 * Integer.highestOneBit(sum)];
    }
    count = 0;
    ranges = sum < FEWEST_TO_SHARE ? 1 : lists.length;
    if (ranges == 1) {
      for (CandidateList list : lists) {
        append(list.keys, list.count);
      }
      keys = sorter.sort(keys, count);
      return keys;
    }
    for (CandidateList list : lists) {
      if (list.range.length < keys.length) {
        list.range = new long[keys.length];
      }
    }
    parallel.each(ranges, sorting);
    for (CandidateList list : lists) {
      append(list.range, list.rangeCount);
    }
    return keys;
  }

  private void append(long[] from, int n) {
    System.arraycopy(from, 0, keys, count, n);
    count += n;
  }

  private void sortRanges(int from, int to, int worker) {
    for (int range = from; range < to; range++) {
      lists[range].sortRange(lists, start(range), start(range + 1));
    }
  }

  /** Returns the least key of a range; for the number of ranges, one above all keys. */
  private long start(int range) {
    if (range == 0) {
      return 0;
    }
    int rows = contacts.count();
    return range == ranges || rows == 0
        ? Long.MAX_VALUE
        : contacts.key[(int) ((long) rows * range / ranges)];
  }
}
