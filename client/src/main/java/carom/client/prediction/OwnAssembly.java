package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.net.snapshot.table.JointWords;
import carom.physics.Body;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ExactRows;
import carom.physics.rows.JointRow;
import carom.physics.rows.RowKind;
import carom.sim.SimulationHost;
import carom.sim.entity.Assembly;
import carom.sim.entity.HostEntity;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * Makes the bodies that joints tie to the own one, where no exact state is known yet: from their
 * quantised records. A car would lose its wheels otherwise until the first update comes. Used when
 * a prediction begins; allocates.
 */
final class OwnAssembly {
  private static final int MOST = 64;

  private final SnapshotRecords records;
  private final Pose pose = new Pose();
  private int[] keys = new int[MOST];
  private int count;

  /** Creates an object that reads from some records. */
  public OwnAssembly(SnapshotRecords records) {
    this.records = records;
  }

  /**
   * Adds rows for the members and their joints.
   *
   * @param own the own body's row
   * @param tick after which the rows hold
   * @param rows empty; receives all rows, the own one included
   */
  public void add(int[] own, int tick, ExactRows rows) {
    find(own[BodyRow.KEY], tick);
    int[] row = new int[BodyRow.INTS];
    for (int i = 0; i < count; i++) {
      if (keys[i] == own[BodyRow.KEY]) {
        rows.add(RowKind.BODY, own, 0);
      } else {
        row[BodyRow.KEY] = keys[i];
        row[BodyRow.ARCHETYPE] = records.archetype(Neighbourhood.id(keys[i])).index();
        row[BodyRow.COS] = Float.floatToRawIntBits(1);
        rows.add(RowKind.BODY, row, 0);
      }
    }
    int[] joint = new int[JointRow.INTS];
    for (int i = 0; i < records.jointLimit(); i++) {
      joint[JointRow.KEY] = records.jointKey(i);
      if (joint[JointRow.KEY] >= 0) {
        joint[JointRow.END_A] = place(records.jointWord(i, JointWords.END_A));
        joint[JointRow.END_B] = place(records.jointWord(i, JointWords.END_B));
        if (isMember(joint[JointRow.END_A]) && isMember(joint[JointRow.END_B])) {
          rows.add(RowKind.JOINT, joint, 0);
        }
      }
    }
  }

  private static boolean isMember(int end) {
    return end != Integer.MAX_VALUE;
  }

  /** Puts the members where their records say; they have been made at the origin. */
  public void place(SimulationHost simulation, int ownKey, int tick) {
    for (int i = 0; i < count; i++) {
      HostEntity e = simulation.entity(Neighbourhood.id(keys[i]));
      if (keys[i] != ownKey && e != null && records.readPose(keys[i], tick, pose)) {
        Body<HostEntity> body = e.body();
        body.setPose(pose.x, pose.y, pose.angle);
        body.setVelocity(pose.vx, pose.vy);
        body.setAngularVelocity(pose.omega);
      }
    }
  }

  /** Finds the members: what joints tie to the own body, as far as records tell. */
  private void find(int ownKey, int tick) {
    count = 0;
    keys[count++] = ownKey;
    boolean grew = true;
    while (grew) {
      grew = false;
      for (int i = 0; i < records.jointLimit(); i++) {
        if (records.jointKey(i) >= 0) {
          int a = records.jointWord(i, JointWords.END_A);
          int b = records.jointWord(i, JointWords.END_B);
          grew |= contains(a) && add(b, tick);
          grew |= contains(b) && add(a, tick);
        }
      }
    }
    Arrays.sort(keys, 0, count);
  }

  private boolean add(int key, int tick) {
    if (key < 0 || contains(key) || count == MOST || !records.isKnown(key)) {
      return false;
    }
    if (!records.readPose(key, tick, pose)) {
      return false;
    }
    keys[count++] = key;
    return true;
  }

  private boolean contains(int key) {
    for (int i = 0; i < count; i++) {
      if (keys[i] == key) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns whether all joints of an assembly are known.
   *
   * @param root id of its root
   */
  public boolean isKnown(Assembly assembly, int root) {
    int known = 0;
    for (int i = 0; i < records.jointLimit(); i++) {
      known += records.jointKey(i) >= 0 && records.jointWord(i, JointWords.ROOT) == root ? 1 : 0;
    }
    return known >= assembly.jointCount();
  }

  /** Returns the place of an entity, or what else the end of a joint is. */
  private int place(int end) {
    if (end < 0) {
      return end;
    }
    for (int i = 0; i < count; i++) {
      if (keys[i] == end) {
        return i;
      }
    }
    return Integer.MAX_VALUE;
  }
}
