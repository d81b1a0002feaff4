package carom.sim;

import java.util.Iterator;
import java.util.NoSuchElementException;
import java.util.function.IntFunction;
import java.util.function.IntSupplier;

/**
 * The things that are present among the ids below a limit, for loops. One that comes or goes
 * meanwhile may be seen or not.
 *
 * <p>A loop that ends gives its iterator back, so that rules that loop in each tick allocate
 * nothing. One that is left early keeps it, and costs the next loop a new one.
 */
final class Present<T> implements Iterable<T> {
  private final IntSupplier limit;
  private final IntFunction<? extends T> byId;

  /** The first iterator that no loop uses; they are a list. */
  private Walk free;

  Present(IntSupplier limit, IntFunction<? extends T> byId) {
    this.limit = limit;
    this.byId = byId;
  }

  @Override
  public Iterator<T> iterator() {
    Walk walk = free == null ? new Walk() : free;
    free = walk.after;
    walk.after = null;
    walk.id = -1;
    walk.seek();
    return walk;
  }

  private final class Walk implements Iterator<T> {
    private int id;
    private T next;
    private Walk after;

    private void seek() {
      next = null;
      while (next == null && ++id < limit.getAsInt()) {
        next = byId.apply(id);
      }
    }

    @Override
    public boolean hasNext() {
      if (next != null && byId.apply(id) != next) {
        seek(); // it went meanwhile
      }
      if (next == null && id >= 0) {
        id = Integer.MIN_VALUE; // given back once
        after = free;
        free = this;
      }
      return next != null;
    }

    @Override
    public T next() {
      if (!hasNext()) {
        throw new NoSuchElementException();
      }
      T present = next;
      seek();
      return present;
    }
  }
}
