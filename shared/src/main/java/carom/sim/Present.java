package carom.sim;

import java.util.Iterator;
import java.util.NoSuchElementException;
import java.util.function.IntFunction;
import java.util.function.IntSupplier;

/** Walks over what is there of the ids below a limit. What comes and goes meanwhile may be seen. */
final class Present<T> implements Iterator<T> {
  private final IntSupplier limit;
  private final IntFunction<? extends T> byId;
  private int id;
  private T next;

  Present(IntSupplier limit, IntFunction<? extends T> byId) {
    this.limit = limit;
    this.byId = byId;
  }

  @Override
  public boolean hasNext() {
    for (next = null; next == null && id < limit.getAsInt(); id++) {
      next = byId.apply(id);
    }
    if (next != null) {
      id--; // asked again, it finds the same
    }
    return next != null;
  }

  @Override
  public T next() {
    if (!hasNext()) {
      throw new NoSuchElementException();
    }
    id++;
    return next;
  }
}
