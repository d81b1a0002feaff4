package carom.physics.particles;

import carom.physics.archive.Archive;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * State of all particles: position, velocity, age and id.
 *
 * <p>Particles 0 to count - 1 are dense and sorted by position; every step sorts them again. A
 * particle keeps its slot as long as it lives. Slot and generation together are its id.
 */
final class ParticleStore {
  float[] x;
  float[] y;
  float[] vx;
  float[] vy;
  float[] age;
  int[] slot;
  int count;

  /** By slot: the particle's index, and the number of earlier particles in the slot. */
  private int[] index;

  private int[] generation;

  /** Number of slots ever used, and a stack of those that are free. */
  private int slots;

  private int[] free;
  private int freeCount;

  ParticleStore(int capacity) {
    allocate(capacity);
  }

  private void allocate(int capacity) {
    x = new float[capacity];
    y = new float[capacity];
    vx = new float[capacity];
    vy = new float[capacity];
    age = new float[capacity];
    slot = new int[capacity];
    index = new int[capacity];
    generation = new int[capacity];
    free = new int[capacity];
  }

  int capacity() {
    return x.length;
  }

  private void grow(int most) {
    int capacity = Math.min(most, capacity() * 2);
    x = Arrays.copyOf(x, capacity);
    y = Arrays.copyOf(y, capacity);
    vx = Arrays.copyOf(vx, capacity);
    vy = Arrays.copyOf(vy, capacity);
    age = Arrays.copyOf(age, capacity);
    slot = Arrays.copyOf(slot, capacity);
    index = Arrays.copyOf(index, capacity);
    generation = Arrays.copyOf(generation, capacity);
    free = Arrays.copyOf(free, capacity);
  }

  /** Adds a particle, which the caller has checked against the limit. Returns its id. */
  long add(float px, float py, float newVx, float newVy, int most) {
    if (count == capacity()) {
      grow(most);
    }
    int s = freeCount > 0 ? free[--freeCount] : slots++;
    x[count] = px;
    y[count] = py;
    vx[count] = newVx;
    vy[count] = newVy;
    age[count] = 0;
    slot[count] = s;
    index[s] = count;
    return id(count++);
  }

  long id(int i) {
    int s = slot[i];
    return (long) generation[s] << 32 | s;
  }

  /** Returns the index of a particle, or -1 if it is gone. */
  int indexOf(long id) {
    int s = (int) id;
    if (s < 0 || s >= slots || generation[s] != (int) (id >>> 32)) {
      return -1;
    }
    int i = index[s];
    return i < count && slot[i] == s ? i : -1;
  }

  /** Releases a particle's slot. The caller then closes the gap with {@link #move}. */
  void release(int i) {
    int s = slot[i];
    generation[s] = generation[s] + 1 & 0x7fffffff;
    free[freeCount++] = s;
  }

  /** Moves a particle to an earlier index, to close gaps in order. */
  void move(int from, int to) {
    if (from == to) {
      return;
    }
    x[to] = x[from];
    y[to] = y[from];
    vx[to] = vx[from];
    vy[to] = vy[from];
    age[to] = age[from];
    slot[to] = slot[from];
    index[slot[to]] = to;
  }

  /**
   * Puts the particles into a new order. The two scratch arrays must have the same capacity as the
   * store.
   */
  void permute(int[] order, float[] floats, int[] ints) {
    permute(x, order, floats);
    permute(y, order, floats);
    permute(vx, order, floats);
    permute(vy, order, floats);
    permute(age, order, floats);
    for (int i = 0; i < count; i++) {
      ints[i] = slot[order[i]];
    }
    System.arraycopy(ints, 0, slot, 0, count);
    for (int i = 0; i < count; i++) {
      index[slot[i]] = i;
    }
  }

  private void permute(float[] values, int[] order, float[] scratch) {
    for (int i = 0; i < count; i++) {
      scratch[i] = values[order[i]];
    }
    System.arraycopy(scratch, 0, values, 0, count);
  }

  void copy(ParticleStore from) {
    if (capacity() < from.slots) {
      allocate(from.capacity());
    }
    count = from.count;
    slots = from.slots;
    freeCount = from.freeCount;
    System.arraycopy(from.x, 0, x, 0, count);
    System.arraycopy(from.y, 0, y, 0, count);
    System.arraycopy(from.vx, 0, vx, 0, count);
    System.arraycopy(from.vy, 0, vy, 0, count);
    System.arraycopy(from.age, 0, age, 0, count);
    System.arraycopy(from.slot, 0, slot, 0, count);
    System.arraycopy(from.index, 0, index, 0, slots);
    System.arraycopy(from.generation, 0, generation, 0, slots);
    System.arraycopy(from.free, 0, free, 0, freeCount);
  }

  /** Passes the state through an archive. */
  void pass(Archive a, int most) {
    int n = a.count("particle slots", slots, most, 2 * Integer.BYTES);
    if (a.reads() && capacity() < n) {
      allocate(n);
    }
    slots = n;
    a.integers("generation of particle", generation, n, 0, Integer.MAX_VALUE);
    count = a.count("particles", count, n, Integer.BYTES + 5 * Float.BYTES);
    a.integers("slot of particle", slot, count, 0, n - 1);
    a.numbers("particle x", x, count, Limits.MAX_POSITION);
    a.numbers("particle y", y, count, Limits.MAX_POSITION);
    a.numbers("particle velocity", vx, count, 3 * Limits.MAX_VELOCITY);
    a.numbers("particle velocity", vy, count, 3 * Limits.MAX_VELOCITY);
    a.numbers("particle age", age, count, Float.MAX_VALUE);
    freeCount = a.count("free particle slots", freeCount, n, Integer.BYTES);
    a.integers("free particle slot", free, freeCount, 0, n - 1);
    if (a.reads()) {
      findPlaces(a);
    }
  }

  /** Finds the index of each slot, and checks that every slot is used once or free once. */
  private void findPlaces(Archive a) {
    Arrays.fill(index, 0, slots, -1);
    for (int i = 0; i < count; i++) {
      a.require(index[slot[i]] < 0, "slot=" + slot[i] + " has two particles");
      index[slot[i]] = i;
    }
    for (int i = 0; i < freeCount; i++) {
      a.require(index[free[i]] < 0, "slot=" + free[i] + " can't be free");
      index[free[i]] = count;
    }
    a.require(
        count + freeCount == slots,
        "particle slots=" + slots + " include some that are neither used nor free");
  }

  long hash() {
    long h = StateHash.mix(StateHash.SEED, (long) count << 32 | slots);
    for (int i = 0; i < count; i++) {
      h = StateHash.mix(h, x[i], y[i]);
      h = StateHash.mix(h, vx[i], vy[i]);
      h = StateHash.mix(h, (long) Float.floatToRawIntBits(age[i]) << 32 | slot[i]);
    }
    for (int s = 0; s < slots; s++) {
      h = StateHash.mix(h, generation[s]);
    }
    for (int i = 0; i < freeCount; i++) {
      h = StateHash.mix(h, free[i]);
    }
    return StateHash.finish(h);
  }
}
