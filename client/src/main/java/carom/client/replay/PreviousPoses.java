package carom.client.replay;

import carom.client.interpolation.Pose;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import java.util.Arrays;

/**
 * The pose of each entity of a simulation one tick ago, to draw between two ticks. One replay's;
 * allocates only to grow.
 */
final class PreviousPoses {
  /** A body that moved farther than this in a tick has jumped and isn't interpolated, metres. */
  private static final float JUMP_METRES = 3;

  /** By entity id: x, y and angle. */
  private float[] poses = {};

  /** By entity id: the generation, or -1 for none. */
  private int[] generations = {};

  /** Forgets all poses. */
  void clear() {
    Arrays.fill(generations, -1);
  }

  /** Notes the present poses; call it before a tick. */
  void read(SimulationHost s) {
    int limit = s.entityCapacity();
    if (generations.length < limit) {
      poses = new float[6 * limit];
      generations = new int[2 * limit];
    }
    clear();
    for (int id = 0; id < limit; id++) {
      HostEntity e = s.entity(id);
      if (e != null) {
        poses[3 * id] = e.body().x();
        poses[3 * id + 1] = e.body().y();
        poses[3 * id + 2] = e.body().angle();
        generations[id] = e.generation();
      }
    }
  }

  /**
   * Moves a pose back towards the one of a tick ago.
   *
   * @param pose the present one
   * @param fraction of the tick that has passed, 0..1
   */
  void interpolate(HostEntity e, float fraction, Pose pose) {
    int id = e.id();
    if (id >= generations.length || generations[id] != e.generation()) {
      return;
    }
    float dx = pose.x - poses[3 * id];
    float dy = pose.y - poses[3 * id + 1];
    if (dx * dx + dy * dy < JUMP_METRES * JUMP_METRES) {
      float turn = Pose.wrap(pose.angle - poses[3 * id + 2]);
      pose.x -= (1 - fraction) * dx;
      pose.y -= (1 - fraction) * dy;
      pose.angle -= (1 - fraction) * turn;
    }
  }
}
