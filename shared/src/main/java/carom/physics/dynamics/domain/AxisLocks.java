package carom.physics.dynamics.domain;

import carom.physics.dynamics.body.BodyStore;
import java.util.Arrays;

/**
 * Tells by slot of {@link SolverSlots} along which axes a body's velocity is locked: there its
 * inverse mass is zero.
 *
 * <p>Blocks with a contact of a locked body are solved without vectors, by code that asks here; the
 * vectors of all other blocks know one mass per body. Joints read the locks of their bodies
 * themselves. What the nets of joints add to a locked velocity, {@link #hold} takes back before
 * bodies move. A world without locked bodies asks nothing.
 *
 * <p>Velocities are pairs of floats in the arrays that are given: x, then y.
 */
public final class AxisLocks {
  private byte[] ofSlot = new byte[0];
  private boolean any;

  /** Makes locks of no body. */
  public AxisLocks() {}

  /** Begins a step of as many slots; no body is locked until {@link #load}. */
  public void begin(boolean anyLocks, int slots) {
    any = anyLocks;
    if (any) {
      if (ofSlot.length < slots) {
        ofSlot = new byte[Math.max(slots, 2 * ofSlot.length)];
      }
      Arrays.fill(ofSlot, 0, slots, (byte) 0);
    }
  }

  /** Returns whether one of the bodies of two slots is locked. */
  public boolean isEither(int a, int b) {
    return any && (ofSlot[a] | ofSlot[b]) != 0;
  }

  private boolean isLocked(int slot, int axis) {
    return any && (ofSlot[slot] & axis) != 0;
  }

  /**
   * Takes over the locks of a body. Its velocity along them becomes what {@link #hold} keeps, and
   * nothing accelerates it there.
   *
   * @param velocities have its velocity at {@code at}
   * @param ax accelerations by slot, x
   * @param ay accelerations by slot, y
   */
  public void load(
      int slot, BodyStore bodies, int body, float[] velocities, int at, float[] ax, float[] ay) {
    if (!any) {
      return;
    }
    ofSlot[slot] = (byte) bodies.linearLocks(body);
    if (isLocked(slot, BodyStore.LOCK_X)) {
      bodies.vx[body] = velocities[at];
      ax[slot] = 0;
    }
    if (isLocked(slot, BodyStore.LOCK_Y)) {
      bodies.vy[body] = velocities[at + 1];
      ay[slot] = 0;
    }
  }

  /**
   * Gives the body of a slot along its locked axes the velocity that it had when the step began.
   *
   * @param body the bodies by slot
   */
  public void hold(int slot, BodyStore bodies, int[] body, float[] velocities, int at) {
    if (isLocked(slot, BodyStore.LOCK_X)) {
      velocities[at] = bodies.vx[body[slot]];
    }
    if (isLocked(slot, BodyStore.LOCK_Y)) {
      velocities[at + 1] = bodies.vy[body[slot]];
    }
  }

  /**
   * Returns the sum of the inverse masses of two bodies along a unit vector, n M^-1 n.
   *
   * @param a slot of one
   * @param massA its inverse mass, 1/kg
   */
  public float inverseMasses(int a, float massA, int b, float massB, float nx, float ny) {
    if (!isEither(a, b)) {
      return massA + massB; // as vectors compute it
    }
    float alongX = along(a, massA, BodyStore.LOCK_X) + along(b, massB, BodyStore.LOCK_X);
    float alongY = along(a, massA, BodyStore.LOCK_Y) + along(b, massB, BodyStore.LOCK_Y);
    return alongX * (nx * nx) + alongY * (ny * ny);
  }

  /**
   * Returns by how much an impulse along a unit vector n moves two bodies apart along t = (-ny,
   * nx), and one along t along n: t M^-1 n, 1/kg. 0 without locks, and where n is along an axis.
   */
  public float coupling(int a, float massA, int b, float massB, float nx, float ny) {
    if (!isEither(a, b)) {
      return 0;
    }
    float alongX = along(a, massA, BodyStore.LOCK_X) + along(b, massB, BodyStore.LOCK_X);
    float alongY = along(a, massA, BodyStore.LOCK_Y) + along(b, massB, BodyStore.LOCK_Y);
    return (alongY - alongX) * (nx * ny);
  }

  /** Returns the share of a unit vector's square that lies along axes of a body that are free. */
  public float freedom(int slot, float nx, float ny) {
    return along(slot, nx * nx, BodyStore.LOCK_X) + along(slot, ny * ny, BodyStore.LOCK_Y);
  }

  private float along(int slot, float mass, int axis) {
    return isLocked(slot, axis) ? 0 : mass;
  }

  /** Applies an impulse to a body: its velocity changes along the axes that aren't locked. */
  public void apply(int slot, float inverseMass, float px, float py, float[] velocities, int at) {
    velocities[at] += along(slot, inverseMass, BodyStore.LOCK_X) * px;
    velocities[at + 1] += along(slot, inverseMass, BodyStore.LOCK_Y) * py;
  }
}
