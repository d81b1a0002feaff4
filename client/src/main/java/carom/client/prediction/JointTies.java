package carom.client.prediction;

import carom.physics.rows.JointRow;
import carom.physics.rows.Rows;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * Tells which bodies of a {@link Neighbourhood} joints hold together. A client that corrects bodies
 * without exact state must not tear them apart. Mutable, reused; allocates only to grow.
 */
final class JointTies {
  private boolean[] tied = new boolean[16];
  private boolean[] tiedToOwn = new boolean[16];

  /** Creates an object that knows no set yet. */
  public JointTies() {}

  /**
   * Looks which bodies have joints, and which hang on the own one.
   *
   * @param ownPlace the own body's place in the set, or negative
   */
  public void find(Neighbourhood set, int ownPlace) {
    int count = set.count();
    if (tied.length < count) {
      tied = new boolean[2 * count];
      tiedToOwn = new boolean[2 * count];
    }
    Arrays.fill(tied, 0, count, false);
    Arrays.fill(tiedToOwn, 0, count, false);
    Rows joints = set.rows().joints();
    if (ownPlace >= 0) {
      tiedToOwn[ownPlace] = true;
    }
    boolean grew = joints.count() > 0;
    while (grew) {
      grew = false;
      for (int i = 0; i < joints.count(); i++) {
        int a = joints.get(i, JointRow.END_A);
        int b = joints.get(i, JointRow.END_B);
        if (a >= 0 && b >= 0) {
          tied[a] = true;
          tied[b] = true;
          grew |= tiedToOwn[a] != tiedToOwn[b];
          tiedToOwn[a] = tiedToOwn[b] = tiedToOwn[a] || tiedToOwn[b];
        }
      }
    }
  }

  /** Returns whether a joint ties a body of the set to another one. */
  public boolean isTied(int place) {
    return tied[place];
  }

  /** Returns whether joints tie a body of the set to the own one, directly or through others. */
  public boolean isTiedToOwn(int place) {
    return tiedToOwn[place];
  }
}
