package carom.net.admission;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The places of those that wait to get in. There are some for guests that have proven nothing, and
 * others for guests that have proven something, so that the first never displace the second.
 *
 * <p>When all places of a kind are taken, the guest that has waited longest gives way. A host or a
 * network that holds more than its share gives way itself, however long others have waited. Shares
 * count only then: as long as there are places, a whole school behind one router gets in.
 *
 * <p>Each operation costs the same however many wait, but for {@link #sort}. One thread.
 *
 * @param <T> a guest; equal only to itself
 */
public final class Entrance<T extends Entrance.Guest> {
  /** Tells what a guest has proven. It only goes on. Any thread may change it. */
  public enum Proof {
    /** The guest has proven nothing. */
    UNPROVEN,
    /** The guest has proven that it can be reached, has worked, or knows what to say. */
    PROVEN,
    /** The guest has proven all there is to prove, and waits no longer. */
    IN
  }

  /** Somebody who waits. */
  public interface Guest {
    /** Returns where it comes from; always the same. */
    AddressGroup origin();

    /** Returns what it has proven by now. */
    Proof proof();
  }

  /** A network's share of the places is one in so many, and a host's is half of that. */
  private static final int SHARES = 16;

  private static final int LEAST_BITS = 12;
  private static final int MORE_BITS = 4;

  private final Waiting unproven;
  private final Waiting proven;
  private final Consumer<T> evict;

  /**
   * Creates an entrance without waiting connections.
   *
   * @param unprovenPlaces places of guests that have proven nothing, at least 1
   * @param provenPlaces places of guests that have proven something, at least 1
   * @param evict sends a guest away that gives way. It may call {@link #remove}
   */
  public Entrance(int unprovenPlaces, int provenPlaces, Consumer<T> evict) {
    unproven = new Waiting(unprovenPlaces);
    proven = new Waiting(provenPlaces);
    this.evict = evict;
  }

  /** Lets a newcomer wait. Another one may give way. */
  public void add(T guest) {
    place(guest, unproven);
  }

  /** Notes that a guest is gone, wherever it was. */
  public void remove(T guest) {
    unproven.remove(guest);
    proven.remove(guest);
  }

  /** Moves guests on by what they have proven meanwhile. Its cost grows with those who wait. */
  public void sort() {
    for (T guest : unproven.all()) {
      if (guest.proof() != Proof.UNPROVEN) {
        unproven.remove(guest);
        moveOn(guest, unproven);
      }
    }
    for (T guest : proven.all()) {
      if (guest.proof() == Proof.IN) {
        proven.remove(guest);
      }
    }
  }

  /**
   * Returns how much work a newcomer must prove, in bits of {@link WorkProof}: none while at least
   * half of the places are free, and then the more, the fewer are.
   */
  public int workBits() {
    double fill = Math.max(unproven.fill(), proven.fill());
    return fill < 0.5 ? 0 : LEAST_BITS + (int) Math.round((fill - 0.5) * 2 * MORE_BITS);
  }

  private void place(T guest, Waiting waiting) {
    while (waiting.isFull()) {
      T first = waiting.takeFirst(guest.origin());
      if (!moveOn(first, waiting)) {
        evict.accept(first);
      }
    }
    waiting.add(guest);
  }

  /** Finds a place for a guest that has been taken out. Returns false if it has proven no more. */
  private boolean moveOn(T guest, Waiting from) {
    Proof proof = guest.proof();
    if (proof == Proof.PROVEN && from == unproven) {
      place(guest, proven);
      return true;
    }
    return proof == Proof.IN;
  }

  /** Guests in the order of their coming, of all and of each group. */
  private final class Waiting {
    private final int places;
    private final Set<T> order = new LinkedHashSet<>();
    private final Map<String, Set<T>> hosts = new HashMap<>();
    private final Map<String, Set<T>> networks = new HashMap<>();

    Waiting(int places) {
      this.places = places;
    }

    boolean isFull() {
      return order.size() >= places;
    }

    double fill() {
      return (double) order.size() / places;
    }

    List<T> all() {
      return new ArrayList<>(order);
    }

    void add(T guest) {
      order.add(guest);
      hosts.computeIfAbsent(guest.origin().host(), x -> new LinkedHashSet<>()).add(guest);
      networks.computeIfAbsent(guest.origin().network(), x -> new LinkedHashSet<>()).add(guest);
    }

    void remove(T guest) {
      if (order.remove(guest)) {
        removeFrom(hosts, guest.origin().host(), guest);
        removeFrom(networks, guest.origin().network(), guest);
      }
    }

    private void removeFrom(Map<String, Set<T>> groups, String name, T guest) {
      Set<T> group = groups.get(name);
      group.remove(guest);
      if (group.isEmpty()) {
        groups.remove(name);
      }
    }

    /** Takes out the guest that gives way to a newcomer of an origin. */
    T takeFirst(AddressGroup newcomer) {
      Set<T> host = hosts.getOrDefault(newcomer.host(), Set.of());
      Set<T> network = networks.getOrDefault(newcomer.network(), Set.of());
      Set<T> group = order;
      if (host.size() >= Math.max(1, places / SHARES / 2)) {
        group = host;
      } else if (network.size() >= Math.max(1, places / SHARES)) {
        group = network;
      }
      T first = group.iterator().next();
      remove(first);
      return first;
    }
  }
}
