package carom.client.desktop.game;

import java.util.Arrays;

/**
 * Remembers by slot which entity an effect saw in the last frame, and until when it shows nothing
 * of that entity. Render thread only; allocates only to grow.
 */
final class SeenEntities {
  private int[] generations = new int[0];
  private double[] quietUntil = new double[0];

  /** Forgets all entities. */
  void clear() {
    Arrays.fill(generations, -1);
  }

  /**
   * Returns the number of slots that there is memory for, at least one more than {@code id}.
   *
   * @param id a slot
   */
  int sizeFor(int id) {
    int size = generations.length;
    if (id >= size) {
      int larger = Math.max(64, Math.max(id + 1, 2 * size));
      generations = Arrays.copyOf(generations, larger);
      Arrays.fill(generations, size, larger, -1);
      quietUntil = Arrays.copyOf(quietUntil, larger);
    }
    return generations.length;
  }

  /** Takes note of the entity in a slot. Returns whether the last frame had it, too. */
  boolean sees(int id, int generation) {
    if (generations[id] == generation) {
      return true;
    }
    generations[id] = generation;
    quietUntil[id] = 0;
    return false;
  }

  /** Returns whether an entity's last effect was so recent that it has no other one. */
  boolean isQuiet(int id, double now) {
    return now < quietUntil[id];
  }

  /** Lets an entity have no effect until a moment. */
  void quieten(int id, double until) {
    quietUntil[id] = until;
  }
}
