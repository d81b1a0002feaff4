package carom.sim.event;

import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.List;

/**
 * The kinds of events of one simulation, in the order they were added. Server and client add the
 * same kinds in the same order. No kind can be added after set-up.
 */
public final class EventKinds {
  /** Most kinds. An index fits 8 bits. */
  public static final int MAX = 256;

  private final List<EventKind> list = new ArrayList<>();
  private boolean closed;

  /** Creates an empty list. */
  public EventKinds() {}

  /**
   * Registers a kind. Call it in {@code Game.setUp} only.
   *
   * @param name for logs and tests
   * @param rgb colour of its flash, 0xrrggbb
   * @param radius of its flash, metres, 0..100; 0 for no flash
   * @param label short text that rises from where it happens; empty for none
   * @param sound its sound
   * @param fullStrength {@code Event.strength} from which on the sound is loudest, finite, 0 and
   *     above; 0 if it always is
   * @throws IllegalStateException after set-up, or beyond {@value #MAX}
   * @throws IllegalArgumentException when radius or fullStrength is outside its range
   */
  public EventKind add(
      String name, int rgb, float radius, String label, Sound sound, float fullStrength) {
    Limits.notNull("name", name);
    Limits.notNull("label", label);
    Limits.notNull("sound", sound);
    if (closed) {
      throw new IllegalStateException(
          "event kind=" + name + " is registered after set-up; register it in Game.setUp");
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

  /** Returns the number of kinds. */
  public int size() {
    return list.size();
  }

  /** Returns the kind at an index, or null if there is none. The index may come from the wire. */
  public EventKind get(int index) {
    return index >= 0 && index < list.size() ? list.get(index) : null;
  }

  /** Closes the list: no kind can be added any more. */
  public void close() {
    closed = true;
  }
}
