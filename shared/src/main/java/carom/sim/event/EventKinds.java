package carom.sim.event;

import carom.sim.Event;
import carom.sim.Game;
import java.util.ArrayList;
import java.util.List;

/**
 * The kinds of events of one simulation, in the order they were added. Server and client add the
 * same in the same order; closed once set-up is over.
 */
public final class EventKinds {
  /** Most kinds; an index fits 8 bits. */
  public static final int MAX = 256;

  private final List<EventKind> list = new ArrayList<>();
  private boolean closed;

  public EventKinds() {}

  /**
   * Registers a kind that is silent, see {@link #add(String, int, float, String, Sound, float)}.
   */
  public EventKind add(String name, int rgb, float radius, String label) {
    return add(name, rgb, radius, label, Sound.NONE, 0);
  }

  /**
   * Registers a kind; call it in {@link Game#setUp} only.
   *
   * @param name for logs and tests
   * @param rgb colour of its flash, 0xrrggbb
   * @param radius of its flash, metres, 0..100; 0 = it doesn't flash
   * @param label short text that rises from where it happens; empty = none
   * @param sound what it sounds like
   * @param fullStrength {@link Event#strength} from which on it is as loud as can be, finite, 0 and
   *     above; 0 = it always is
   * @throws IllegalStateException after set-up, or beyond {@value #MAX}
   * @throws IllegalArgumentException when radius or fullStrength is outside its range
   */
  public EventKind add(
      String name, int rgb, float radius, String label, Sound sound, float fullStrength) {
    if (closed) {
      throw new IllegalStateException(
          "event kind=" + name + " comes after set-up; register it in Game.setUp");
    }
    if (list.size() == MAX) {
      throw new IllegalStateException("event kind=" + name + " exceeds the limit of " + MAX);
    }
    if (!(radius >= 0 && radius <= 100)) {
      throw new IllegalArgumentException(
          "radius=" + radius + " of event kind " + name + " is outside 0..100");
    }
    if (!(fullStrength >= 0 && fullStrength < Float.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "fullStrength="
              + fullStrength
              + " of event kind "
              + name
              + " is not finite, 0 and above");
    }
    EventKind kind = new EventKind(list.size(), name, rgb, radius, label, sound, fullStrength);
    list.add(kind);
    return kind;
  }

  /** How many there are. */
  public int size() {
    return list.size();
  }

  /** The kind at an index in 0..size-1, or null outside: an index may come from the wire. */
  public EventKind get(int index) {
    return index >= 0 && index < list.size() ? list.get(index) : null;
  }

  public void close() {
    closed = true;
  }
}
