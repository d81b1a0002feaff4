package carom.client.view;

import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.TableInbox;
import carom.physics.JointType;
import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import carom.sim.Simulation;
import carom.sim.joint.JointTable;
import carom.sim.level.Level;
import carom.sim.near.Neighbourhood;
import java.util.BitSet;

/**
 * Puts the joints into a picture: between the bodies where these are drawn, predicted or
 * interpolated. A joint of predicted bodies that broke in the prediction is gone at once. One
 * stay's; allocates only to grow.
 */
final class JointComposer {
  /** Weight from which a body counts as predicted. */
  private static final float PREDICTED = 0.5f;

  private static final JointType[] TYPES = JointType.values();

  /** Flag of {@link JointDefRow#FLAGS}: there is a spring on the coordinate. */
  private static final int SPRUNG = 8;

  private final ClientView view;
  private final TableInbox tables;

  /** Null if nothing is predicted. */
  private final Simulation predicted;

  private final BitSet held = new BitSet();

  // Where the end of a joint is that is being composed.
  private int entity;
  private float x;
  private float y;
  private float angle;
  private float alpha;
  private boolean isPredicted;

  JointComposer(ClientView view, TableInbox tables, Simulation predicted) {
    this.view = view;
    this.tables = tables;
    this.predicted = predicted;
  }

  /** Composes the joints between the entities that the view has. */
  void compose() {
    view.clearJoints();
    findHeld();
    int limit = tables.room(JointWords.TABLE);
    for (int row = 0; row < limit; row++) {
      if (tables.isPresent(JointWords.TABLE, row)) {
        compose(row);
      }
    }
  }

  private void findHeld() {
    held.clear();
    if (predicted != null) {
      JointTable<?> joints = predicted.joints();
      for (int i = 0; i < joints.limit(); i++) {
        if (joints.get(i) != null) {
          held.set(JointTable.index(joints.key(i)));
        }
      }
    }
  }

  private void compose(int row) {
    int type = word(row, JointWords.DEFINITION + JointDefRow.TYPE);
    if (type < 0 || type >= TYPES.length || !find(word(row, JointWords.END_A))) {
      return;
    }
    final int bodyA = entity;
    final float alphaA = alpha;
    final boolean predictedA = isPredicted;
    final float ax = anchorX(row, JointDefRow.ANCHOR_AX);
    final float ay = anchorY(row, JointDefRow.ANCHOR_AX);
    if (!find(word(row, JointWords.END_B)) || (bodyA < 0 && entity < 0)) {
      return;
    }
    if (predictedA && isPredicted && !held.get(row)) {
      return; // it broke
    }
    JointView joint = view.addJoint();
    joint.index = row;
    joint.type = TYPES[type];
    joint.bodyA = bodyA;
    joint.bodyB = entity;
    joint.ax = ax;
    joint.ay = ay;
    joint.bx = anchorX(row, JointDefRow.ANCHOR_BX);
    joint.by = anchorY(row, JointDefRow.ANCHOR_BX);
    joint.groundAX = number(row, JointDefRow.BASE_AX);
    joint.groundAY = number(row, JointDefRow.BASE_AY);
    joint.groundBX = number(row, JointDefRow.BASE_BX);
    joint.groundBY = number(row, JointDefRow.BASE_BY);
    joint.sprung = (word(row, JointWords.DEFINITION + JointDefRow.FLAGS) & SPRUNG) != 0;
    joint.rest = number(row, JointDefRow.REST);
    joint.alpha = Math.min(alphaA, alpha);
  }

  /** Finds where an end is; false if it isn't in the picture. */
  private boolean find(int end) {
    entity = -1;
    alpha = 1;
    isPredicted = true;
    x = 0;
    y = 0;
    angle = 0;
    if (end == JointRow.GROUND) {
      return true;
    }
    if (end < 0) {
      if (~end >= view.level.statics().size()) {
        return false;
      }
      Level.Placement place = view.level.statics().get(~end);
      x = place.x();
      y = place.y();
      angle = place.angle();
      return true;
    }
    ClientView.Drawn drawn = view.find(Neighbourhood.id(end));
    if (drawn == null || drawn.generation() != Neighbourhood.generation(end)) {
      return false;
    }
    entity = drawn.id();
    alpha = drawn.alpha();
    isPredicted = drawn.predicted() > PREDICTED;
    x = drawn.x();
    y = drawn.y();
    angle = drawn.angle();
    return true;
  }

  private float anchorX(int row, int field) {
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    return (float) (x + c * number(row, field) - s * number(row, field + 1));
  }

  private float anchorY(int row, int field) {
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    return (float) (y + s * number(row, field) + c * number(row, field + 1));
  }

  private float number(int row, int field) {
    return Float.intBitsToFloat(word(row, JointWords.DEFINITION + field));
  }

  private int word(int row, int word) {
    return tables.get(JointWords.TABLE, row, word);
  }
}
