package carom.net.kryo.server;

import java.util.ArrayDeque;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.ToIntFunction;

/**
 * The connections by the number that their datagrams carry. Finding one allocates nothing and takes
 * no lock. A place is used again under another number, so datagrams of an earlier link miss.
 *
 * <p>One thread at a time adds and removes; any thread may look up.
 *
 * @param <T> a connection
 */
final class LinkTable<T> {
  private static final int PLACE_BITS = 18;
  private static final int PLACE_MASK = (1 << PLACE_BITS) - 1;

  private final AtomicReferenceArray<T> places;
  private final ToIntFunction<T> numberOf;
  private final ArrayDeque<Integer> free = new ArrayDeque<>();
  private int used; // places that were ever taken
  private int generation = ThreadLocalRandom.current().nextInt(1 << 31 - PLACE_BITS);

  /**
   * Creates an empty table.
   *
   * @param size largest number of connections, 1..262,143
   * @param numberOf returns the number that a connection was added with, or 0 before
   */
  public LinkTable(int size, ToIntFunction<T> numberOf) {
    this.numberOf = numberOf;
    places = new AtomicReferenceArray<>(size + 1);
  }

  /** Adds a connection and returns its number, which is never 0. */
  public int add(T connection) {
    int place = used < places.length() - 1 ? ++used : free.remove();
    places.set(place, connection);
    return ++generation << PLACE_BITS | place;
  }

  /** Returns the connection with a number, or null. */
  public T get(int number) {
    int place = number & PLACE_MASK;
    T connection = place < places.length() ? places.get(place) : null;
    return connection != null && numberOf.applyAsInt(connection) == number ? connection : null;
  }

  /** Removes a connection. Does nothing if it isn't there. */
  public void remove(T connection) {
    int place = numberOf.applyAsInt(connection) & PLACE_MASK;
    if (place != 0 && places.compareAndSet(place, connection, null)) {
      free.add(place);
    }
  }
}
