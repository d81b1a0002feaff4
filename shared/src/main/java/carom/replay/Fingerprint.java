package carom.replay;

import carom.physics.Body;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import java.util.Arrays;

/**
 * Sums over all entities after a tick. From two of them, two simulations of the same game learn
 * that they differ, and in which body and by how much if only one body differs.
 *
 * <p>Let h(i) be a 32-bit hash of entity i's state, {@code weight} the sum of h(i), and {@code
 * moment} the sum of (i + 1) h(i). If one entity k differs, the differences of the two sums have
 * the quotient k + 1. {@code fields} has the sum of each of the state's seven numbers as bits,
 * modulo 2^32. So the other side's state of entity k is this side's state plus the difference of
 * the sums. The hash of that state must then explain the difference of the weights; otherwise
 * several entities differ.
 */
final class Fingerprint {
  /**
   * Number of values in a body's state: x, y, cos, sin, vx, vy and omega of its origin, in metres,
   * m/s and rad/s.
   */
  static final int FIELDS = 7;

  long weight;
  long moment;
  final int[] fields = new int[FIELDS];

  private final int[] state = new int[FIELDS];

  /** Computes the sums of a simulation's present state. */
  void take(SimulationHost s) {
    weight = 0;
    moment = 0;
    for (int f = 0; f < FIELDS; f++) {
      fields[f] = 0;
    }
    for (int id = 0, limit = s.entityCapacity(); id < limit; id++) {
      HostEntity e = s.entity(id);
      if (e == null) {
        continue;
      }
      read(e, state);
      long h = hash(state) & 0xffffffffL;
      weight += h;
      moment += (id + 1) * h;
      for (int f = 0; f < FIELDS; f++) {
        fields[f] += state[f];
      }
    }
  }

  void clear() {
    weight = 0;
    moment = 0;
    Arrays.fill(fields, 0);
  }

  void set(Fingerprint other) {
    weight = other.weight;
    moment = other.moment;
    System.arraycopy(other.fields, 0, fields, 0, FIELDS);
  }

  boolean sameAs(Fingerprint other) {
    boolean same = weight == other.weight && moment == other.moment;
    for (int f = 0; f < FIELDS; f++) {
      same &= fields[f] == other.fields[f];
    }
    return same;
  }

  /**
   * Returns the one entity in which another side's sums differ from this side's. This side's sums
   * must be those of the simulation's present state.
   *
   * @param theirs sums of the other side
   * @param out receives the other side's state of the entity, as float bits
   * @return the entity's id, or -1 when several entities differ or one is missing
   */
  int locate(SimulationHost s, Fingerprint theirs, int[] out) {
    long byWeight = theirs.weight - weight;
    long byMoment = theirs.moment - moment;
    if (byWeight == 0 || byMoment % byWeight != 0) {
      return -1;
    }
    long id = byMoment / byWeight - 1;
    HostEntity e = id >= 0 && id < s.entityCapacity() ? s.entity((int) id) : null;
    if (e == null) {
      return -1;
    }
    read(e, state);
    for (int f = 0; f < FIELDS; f++) {
      out[f] = state[f] + theirs.fields[f] - fields[f];
    }
    return (hash(out) & 0xffffffffL) - (hash(state) & 0xffffffffL) == byWeight ? (int) id : -1;
  }

  /** Reads an entity's state as float bits. */
  static void read(HostEntity e, int[] out) {
    Body<HostEntity> body = e.body();
    out[0] = Float.floatToRawIntBits(body.x());
    out[1] = Float.floatToRawIntBits(body.y());
    out[2] = Float.floatToRawIntBits(body.cos());
    out[3] = Float.floatToRawIntBits(body.sin());
    out[4] = Float.floatToRawIntBits(body.velocityX());
    out[5] = Float.floatToRawIntBits(body.velocityY());
    out[6] = Float.floatToRawIntBits(body.angularVelocity());
  }

  /**
   * Returns a hash of a state. It takes four multiplications, one for two values, and any changed
   * bit changes about half of the result.
   */
  private static int hash(int[] v) {
    long h = mix(0, v[0], v[1]);
    h = mix(h, v[2], v[3]);
    h = mix(h, v[4], v[5]);
    h = mix(h, v[6], 0);
    return (int) (h >>> 32);
  }

  private static long mix(long hash, int a, int b) {
    long h = (hash ^ ((long) a << 32 | (b & 0xffffffffL))) * 0x9e3779b97f4a7c15L;
    return h ^ (h >>> 29);
  }
}
