package carom.physics.broadphase;

import java.util.Arrays;
import java.util.function.Consumer;

/** Collected pairs or ids in canonical order. */
public final class Pairs {
  private long[] found = new long[64];
  private int count;

  /** Collects what a search reports; pairs that come twice stay twice. */
  public static long[] of(Consumer<PairVisitor> search) {
    Pairs pairs = new Pairs();
    search.accept((a, b) -> pairs.add(((long) a << 32) + b));
    return pairs.sorted();
  }

  public static long[] of(SpatialIndex index) {
    return of(index::pairs);
  }

  public static long[] query(SpatialIndex index, float x0, float y0, float x1, float y1) {
    Pairs ids = new Pairs();
    index.query(
        x0,
        y0,
        x1,
        y1,
        id -> {
          ids.add(id);
          return true;
        });
    return ids.sorted();
  }

  private void add(long value) {
    if (count == found.length) {
      found = Arrays.copyOf(found, 2 * count);
    }
    found[count++] = value;
  }

  private long[] sorted() {
    long[] result = Arrays.copyOf(found, count);
    Arrays.sort(result);
    return result;
  }
}
