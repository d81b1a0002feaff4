package carom.server.replication;

import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.Table;
import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.rows.JointRow;
import carom.sim.Entity;
import carom.sim.Simulation;
import carom.sim.joint.JointTable;
import carom.sim.near.Neighbourhood;

/**
 * Keeps the table of joints that clients are told: what each was made with, once. Ticks in which no
 * joint comes or goes cost nothing. The room's thread; allocates only to grow.
 */
final class JointCapture {
  private final Simulation simulation;
  private final Table table = new Table(JointWords.LAYOUT);
  private final int[] words = new int[JointWords.WORDS];
  private long version;
  private int limit;

  JointCapture(Simulation simulation) {
    this.simulation = simulation;
  }

  /** Returns the table. */
  Table table() {
    return table;
  }

  /** Takes over the joints after the simulation's last step. */
  void capture() {
    JointTable<Entity> joints = simulation.joints();
    if (joints.version() == version) {
      return;
    }
    version = joints.version();
    limit = Math.max(limit, joints.limit());
    for (int i = 0; i < limit; i++) {
      Joint<Entity> joint = i < joints.limit() ? joints.get(i) : null;
      if (joint == null) {
        table.remove(i, simulation.tick());
        continue;
      }
      words[JointWords.END_A] = end(joint.bodyA());
      words[JointWords.END_B] = end(joint.bodyB());
      words[JointWords.ROOT] = joints.root(i);
      words[JointWords.NUMBER] = joints.number(i);
      joints.definition(i, words, JointWords.DEFINITION);
      int generation = JointTable.generation(joints.key(i));
      table.put(i, generation, words, 0, simulation.tick());
    }
  }

  private static int end(Body<Entity> body) {
    if (body == null) {
      return JointRow.GROUND;
    }
    Entity e = body.user();
    boolean isEntity = e != null && !e.isLevel();
    return isEntity ? Neighbourhood.key(e.id(), e.generation()) : ~body.index();
  }
}
