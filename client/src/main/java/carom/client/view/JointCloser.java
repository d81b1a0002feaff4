package carom.client.view;

import carom.client.interpolation.Pose;
import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.TableInbox;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.rows.JointDefRow;
import carom.physics.rows.JointRow;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * Moves the bodies of a picture together where joints would be drawn apart. Bodies are blended and
 * smoothed one by one, each on a way of its own: two that turn while they go from the past to the
 * present come apart by centimetres. Only what exceeds the gap in the predicted world is closed, so
 * a blow shows as it is. What is not predicted may be stretched in truth, as a long rope is: only
 * assemblies are closed there. One stay's; allocates only to grow.
 *
 * <p>Each pass goes through all joints and shifts both bodies of each, the own body and statics
 * excepted. Angles stay as they are.
 */
final class JointCloser {
  private static final int PASSES = 4;

  /** Gap that a player wouldn't see, metres. */
  private static final float LEAST = 5e-4f;

  /** Share of a gap that a predicted body is moved by, relative to one that isn't. */
  private static final float STIFFNESS = 0.95f;

  /** Rate at which more of a gap is closed the farther bodies are blended into the prediction. */
  private static final float BEGIN = 5;

  // Columns of a joint's numbers, in this order.
  private static final int ARM_X = 0;
  private static final int ARM_Y = 1;
  private static final int AXIS_X = 2;
  private static final int AXIS_Y = 3;
  private static final int ALLOWED = 4;
  private static final int STRENGTH = 5;
  private static final int STRIDE = 6;

  private static final int REVOLUTE = JointType.REVOLUTE.ordinal();
  private static final int WELD = JointType.WELD.ordinal();
  private static final int WHEEL = JointType.WHEEL.ordinal();

  private final ClientView view;
  private final TableInbox tables;

  /** Null if nothing is predicted. */
  private final SimulationHost predicted;

  private ClientView.Drawn[] drawnA = {};
  private ClientView.Drawn[] drawnB = {};

  /**
   * Numbers that close each joint. They are the vector from the origin of A to its anchor less the
   * same of B, the axis along which the anchors may differ (0 for none), the most gap, and the
   * share of the rest that is closed, 0..1.
   */
  private float[] numbers = {};

  private int count;
  private boolean isOpen;
  private final Pose still = new Pose();

  JointCloser(ClientView view, TableInbox tables, SimulationHost predicted) {
    this.view = view;
    this.tables = tables;
    this.predicted = predicted;
  }

  /**
   * Closes the joints of the picture.
   *
   * @param held by row: one more than the joint's index in the predicted world, or 0
   */
  void close(int[] held) {
    count = 0;
    isOpen = false;
    int limit = tables.room(JointWords.TABLE);
    for (int row = 0; row < limit; row++) {
      if (tables.isPresent(JointWords.TABLE, row)) {
        int type = word(row, JointWords.DEFINITION + JointDefRow.TYPE);
        if (type == REVOLUTE || type == WELD || type == WHEEL) {
          gather(row, type, row < held.length ? held[row] - 1 : -1);
        }
      }
    }
    for (int pass = 0; isOpen && pass < PASSES; pass++) {
      for (int i = 0; i < count; i++) {
        close(i);
      }
    }
    Arrays.fill(drawnA, 0, count, null);
    Arrays.fill(drawnB, 0, count, null);
  }

  private void gather(int row, int type, int index) {
    int endA = word(row, JointWords.END_A);
    int endB = word(row, JointWords.END_B);
    ClientView.Drawn a = find(endA);
    ClientView.Drawn b = find(endB);
    if ((a == null && !isFixed(endA)) || (b == null && !isFixed(endB))) {
      return;
    }
    if (count == drawnA.length) {
      drawnA = Arrays.copyOf(drawnA, Math.max(16, 2 * count));
      drawnB = Arrays.copyOf(drawnB, drawnA.length);
      numbers = Arrays.copyOf(numbers, drawnA.length * STRIDE);
    }
    drawnA[count] = a;
    drawnB[count] = b;
    int at = count * STRIDE;
    Pose poseA = a == null ? fixed(endA) : a.pose;
    float c = (float) Math.cos(poseA.angle);
    float s = (float) Math.sin(poseA.angle);
    float armX = turnX(row, JointDefRow.ANCHOR_AX, c, s) + (a == null ? poseA.x : 0);
    float armY = turnY(row, JointDefRow.ANCHOR_AX, c, s) + (a == null ? poseA.y : 0);
    boolean slides = type == WHEEL;
    numbers[at + AXIS_X] = slides ? turnX(row, JointDefRow.AXIS_X, c, s) : 0;
    numbers[at + AXIS_Y] = slides ? turnY(row, JointDefRow.AXIS_X, c, s) : 0;
    Pose poseB = b == null ? fixed(endB) : b.pose;
    c = (float) Math.cos(poseB.angle);
    s = (float) Math.sin(poseB.angle);
    numbers[at + ARM_X] =
        armX - turnX(row, JointDefRow.ANCHOR_BX, c, s) - (b == null ? poseB.x : 0);
    numbers[at + ARM_Y] =
        armY - turnY(row, JointDefRow.ANCHOR_BX, c, s) - (b == null ? poseB.y : 0);
    float most = Math.max(a == null ? 0 : a.predicted, b == null ? 0 : b.predicted);
    boolean ofAssembly = word(row, JointWords.ROOT) >= 0;
    numbers[at + STRENGTH] = ofAssembly ? 1 : Math.min(1, BEGIN * most);
    numbers[at + ALLOWED] = most == 0 ? 0 : allowed(index, slides);
    isOpen |= excess(count) > LEAST;
    count++;
  }

  /** Returns how far a joint is open in the predicted world, 0 if it isn't there. */
  private float allowed(int index, boolean slides) {
    if (index < 0) {
      return 0;
    }
    Joint<HostEntity> joint = predicted.joints().get(index);
    float dx = joint.anchorBX() - joint.anchorAX();
    float dy = joint.anchorBY() - joint.anchorAY();
    return slides
        ? Math.abs(dx * joint.axisY() - dy * joint.axisX())
        : (float) Math.sqrt(dx * dx + dy * dy);
  }

  private float gapX(int i) {
    float from = drawnA[i] == null ? 0 : drawnA[i].pose.x;
    return (drawnB[i] == null ? 0 : drawnB[i].pose.x) - from - numbers[i * STRIDE + ARM_X];
  }

  private float gapY(int i) {
    float from = drawnA[i] == null ? 0 : drawnA[i].pose.y;
    return (drawnB[i] == null ? 0 : drawnB[i].pose.y) - from - numbers[i * STRIDE + ARM_Y];
  }

  private float excess(int i) {
    float dx = gapX(i);
    float dy = gapY(i);
    float along = dx * numbers[i * STRIDE + AXIS_X] + dy * numbers[i * STRIDE + AXIS_Y];
    float open = (float) Math.sqrt(Math.max(0, dx * dx + dy * dy - along * along));
    return open - numbers[i * STRIDE + ALLOWED];
  }

  private void close(int i) {
    int at = i * STRIDE;
    float dx = gapX(i);
    float dy = gapY(i);
    float along = dx * numbers[at + AXIS_X] + dy * numbers[at + AXIS_Y];
    dx -= along * numbers[at + AXIS_X];
    dy -= along * numbers[at + AXIS_Y];
    float open = (float) Math.sqrt(dx * dx + dy * dy);
    float excess = open - numbers[at + ALLOWED];
    float shareA = mobility(drawnA[i]);
    float shareB = mobility(drawnB[i]);
    if (excess <= 0 || shareA + shareB == 0) {
      return;
    }
    float by = numbers[at + STRENGTH] * excess / open / (shareA + shareB);
    move(drawnA[i], by * shareA * dx, by * shareA * dy);
    move(drawnB[i], -by * shareB * dx, -by * shareB * dy);
  }

  private float mobility(ClientView.Drawn drawn) {
    return drawn == null || drawn == view.own() ? 0 : 1 - STIFFNESS * drawn.predicted;
  }

  private static void move(ClientView.Drawn drawn, float dx, float dy) {
    if (drawn != null) {
      drawn.pose.x += dx;
      drawn.pose.y += dy;
    }
  }

  private ClientView.Drawn find(int end) {
    ClientView.Drawn drawn = end < 0 ? null : view.find(Neighbourhood.id(end));
    return drawn == null || drawn.generation() != Neighbourhood.generation(end) ? null : drawn;
  }

  private boolean isFixed(int end) {
    return end == JointRow.GROUND || (end < 0 && ~end < view.level.statics().size());
  }

  /** Returns where a static body is, or the origin of the world. */
  private Pose fixed(int end) {
    if (end == JointRow.GROUND) {
      still.set(0, 0, 0, 0, 0, 0);
    } else {
      Level.Placement place = view.level.statics().get(~end);
      still.set(place.x(), place.y(), place.angle(), 0, 0, 0);
    }
    return still;
  }

  private float turnX(int row, int field, float c, float s) {
    return c * number(row, field) - s * number(row, field + 1);
  }

  private float turnY(int row, int field, float c, float s) {
    return s * number(row, field) + c * number(row, field + 1);
  }

  private float number(int row, int field) {
    return Float.intBitsToFloat(word(row, JointWords.DEFINITION + field));
  }

  private int word(int row, int word) {
    return tables.get(JointWords.TABLE, row, word);
  }
}
