package carom.server.replication;

import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.Table;
import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.JointTable;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * Keeps the table of joints that clients are told: what each was made with, and what the game has
 * changed about it since. Ticks in which no joint comes or goes cost a look at one number for each.
 * The room's thread; allocates only to grow.
 */
final class JointCapture {
  private final SimulationHost simulation;
  private final Table table = new Table(JointWords.LAYOUT);
  private final int[] words = new int[JointWords.WORDS];
  private final int[] definition = new int[JointDefRow.INTS];
  private long version;
  private int limit;

  /** By index: how often its settings had been changed when it was captured last. */
  private int[] changes = {};

  JointCapture(SimulationHost simulation) {
    this.simulation = simulation;
    JointTable.forEachOfLevel(
        simulation.level(),
        (index, endA, endB, made) -> {
          JointWords.put(words, endA, endB, JointTable.LEVEL, index, made, 0);
          table.place(index, 0, words, 0);
        });
  }

  /** Returns the table. */
  Table table() {
    return table;
  }

  /** Takes over the joints after the simulation's last step. */
  void capture() {
    JointTable<HostEntity> joints = simulation.joints();
    boolean isNew = joints.version() != version;
    version = joints.version();
    limit = Math.max(limit, joints.limit());
    if (changes.length < limit) {
      changes = Arrays.copyOf(changes, 2 * limit);
    }
    for (int i = 0; i < limit; i++) {
      Joint<HostEntity> joint = i < joints.limit() ? joints.get(i) : null;
      if (joint == null) {
        table.remove(i, simulation.tick());
      } else if (isNew || simulation.world().jointChanges(i) != changes[i]) {
        capture(i, joint);
      }
    }
  }

  private void capture(int index, Joint<HostEntity> joint) {
    JointTable<HostEntity> joints = simulation.joints();
    changes[index] = simulation.world().jointChanges(index);
    joints.definition(index, definition, 0);
    int endA = end(joint.bodyA());
    int endB = end(joint.bodyB());
    JointWords.put(words, endA, endB, joints.root(index), joints.number(index), definition, 0);
    simulation.world().readJoint(joint, definition, 0);
    JointWords.putSettings(words, definition);
    int generation = JointTable.generation(joints.key(index));
    table.put(index, generation, words, 0, simulation.tick());
  }

  private static int end(Body<HostEntity> body) {
    if (body == null) {
      return JointRow.GROUND;
    }
    HostEntity e = body.user();
    boolean isEntity = e != null && !e.isLevel();
    return isEntity ? Neighbourhood.key(e.id(), e.generation()) : ~body.index();
  }
}
