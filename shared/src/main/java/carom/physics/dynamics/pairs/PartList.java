package carom.physics.dynamics.pairs;

import carom.physics.dynamics.body.BodyStore;
import java.util.Arrays;

/** A list of shape parts that grows and keeps its memory when it is cleared. */
final class PartList {
  /** The parts' numbers, the first {@link #count} entries. */
  int[] ids = new int[64];

  int count;

  /** Makes room for so many parts; the entries are lost if there was too little. */
  void ensureCapacity(int least) {
    if (ids.length < least) {
      ids = new int[2 * least];
    }
  }

  /** Appends a part. */
  void add(int part) {
    if (count == ids.length) {
      ids = Arrays.copyOf(ids, count * 2);
    }
    ids[count++] = part;
  }

  /** Replaces the list by all parts of some bodies. */
  void setPartsOf(BodyStore bodies, int[] which, int n) {
    count = 0;
    for (int i = 0; i < n; i++) {
      int first = bodies.firstPart[which[i]];
      int end = first + bodies.partCount[which[i]];
      for (int part = first; part < end; part++) {
        add(part);
      }
    }
  }
}
