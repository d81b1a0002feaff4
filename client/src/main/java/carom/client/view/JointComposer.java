package carom.client.view;

import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.TableInbox;
import carom.physics.JointType;
import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import carom.sim.SimulationHost;
import carom.sim.entity.JointTable;
import carom.sim.level.Level;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * Puts the joints into a picture: between the bodies where these are drawn, predicted or
 * interpolated. A joint of predicted bodies has the settings of the prediction, so that the own
 * grapple follows at once; if it broke there, it is gone. One stay's; allocates only to grow.
 */
final class JointComposer {
  /** Weight from which a body counts as predicted. */
  private static final float PREDICTED = 0.5f;

  private static final JointType[] TYPES = JointType.values();

  // Flags of JointDefRow.FLAGS.
  private static final int LIMITED = 2;
  private static final int DRIVEN = 4;
  private static final int SPRUNG = 8;

  private final ClientView view;
  private final TableInbox tables;

  /** Null if nothing is predicted. */
  private final SimulationHost predicted;

  private final JointCloser closer;

  /** By row: one more than the joint's index in the predicted world, or 0. */
  private int[] held = {};

  /** The joint as the predicted world has it. */
  private final int[] present = new int[JointDefRow.INTS];

  // Where the end of a joint is that is being composed.
  private int entity;
  private float x;
  private float y;
  private float angle;
  private float alpha;
  private boolean isPredicted;

  JointComposer(ClientView view, TableInbox tables, SimulationHost predicted) {
    this.view = view;
    this.tables = tables;
    this.predicted = predicted;
    closer = new JointCloser(view, tables, predicted);
  }

  /** Composes the joints between the entities that the view has. */
  void compose() {
    view.clearJoints();
    findHeld();
    closer.close(held);
    int limit = tables.room(JointWords.TABLE);
    for (int row = 0; row < limit; row++) {
      if (tables.isPresent(JointWords.TABLE, row)) {
        compose(row);
      }
    }
  }

  private void findHeld() {
    Arrays.fill(held, 0);
    if (predicted != null) {
      JointTable<?> joints = predicted.joints();
      for (int i = 0; i < joints.limit(); i++) {
        if (joints.get(i) != null) {
          int row = JointTable.index(joints.key(i));
          if (row >= held.length) {
            held = Arrays.copyOf(held, 2 * row + 1);
          }
          held[row] = i + 1;
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
    final float x1 = x;
    final float y1 = y;
    final float angle1 = angle;
    if (!find(word(row, JointWords.END_B)) || (bodyA < 0 && entity < 0)) {
      return;
    }
    boolean bothPredicted = predicted != null && predictedA && isPredicted;
    if (bothPredicted && (row >= held.length || held[row] == 0)) {
      return; // it broke
    }
    readSettings(row, bothPredicted);
    JointView joint = view.addJoint();
    joint.index = row;
    joint.type = TYPES[type];
    joint.bodyA = bodyA;
    joint.bodyB = entity;
    float ax = present(JointDefRow.ANCHOR_AX);
    float ay = present(JointDefRow.ANCHOR_AY);
    joint.ax = turnedX(x1, angle1, ax, ay);
    joint.ay = turnedY(y1, angle1, ax, ay);
    float bx = number(row, JointDefRow.ANCHOR_BX);
    float by = number(row, JointDefRow.ANCHOR_BY);
    joint.bx = turnedX(x, angle, bx, by);
    joint.by = turnedY(y, angle, bx, by);
    joint.groundAX = number(row, JointDefRow.BASE_AX);
    joint.groundAY = number(row, JointDefRow.BASE_AY);
    joint.groundBX = number(row, JointDefRow.BASE_BX);
    joint.groundBY = number(row, JointDefRow.BASE_BY);
    int flags = present[JointDefRow.FLAGS];
    joint.sprung = (flags & SPRUNG) != 0;
    joint.limited = (flags & LIMITED) != 0;
    joint.driven = (flags & DRIVEN) != 0;
    joint.rest = present(JointDefRow.REST);
    joint.lower = present(JointDefRow.LOWER);
    joint.upper = present(JointDefRow.UPPER);
    joint.motorSpeed = present(JointDefRow.MOTOR_SPEED);
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

  /** Reads the settings of now: those of the prediction, or those that the server told. */
  private void readSettings(int row, boolean ofPrediction) {
    if (ofPrediction) {
      predicted.world().readJoint(predicted.joints().get(held[row] - 1), present, 0);
      return;
    }
    for (int i = 0; i < JointRow.SETTING_INTS; i++) {
      int field = JointRow.definedBy(i);
      int made = word(row, JointWords.DEFINITION + field);
      int told = word(row, JointWords.SETTINGS + i);
      present[field] = JointWords.setting(JointRow.SETTINGS + i, made, told);
    }
  }

  private float present(int field) {
    return Float.intBitsToFloat(present[field]);
  }

  private static float turnedX(float x, float angle, float dx, float dy) {
    return (float) (x + Math.cos(angle) * dx - Math.sin(angle) * dy);
  }

  private static float turnedY(float y, float angle, float dx, float dy) {
    return (float) (y + Math.sin(angle) * dx + Math.cos(angle) * dy);
  }

  private float number(int row, int field) {
    return Float.intBitsToFloat(word(row, JointWords.DEFINITION + field));
  }

  private int word(int row, int word) {
    return tables.get(JointWords.TABLE, row, word);
  }
}
