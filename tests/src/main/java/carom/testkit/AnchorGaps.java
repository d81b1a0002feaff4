package carom.testkit;

import carom.client.view.ClientView;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.rows.JointDefRow;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.joint.JointTable;
import java.util.Arrays;

/**
 * Measures how far the pictures of one client draw joints apart: the distance of both anchors of a
 * hinge, and of a wheel from its axis. A blow tears joints open in the world, too; so what counts
 * is by how much a picture exceeds what there was lately, in the server's world or in the client's
 * prediction.
 */
public final class AnchorGaps {
  /** Ticks for which a joint is excused by what it was in a world. */
  private static final int LATELY = 40;

  private final Simulation server;
  private final SimulatedClient client;

  /** By tick and joint: how far it was open in a world. */
  private final double[][] truth = new double[LATELY][];

  private int tick = -1;
  private double worst;
  private double worstTruth;
  private String where = "";
  private long seen;

  /** Creates a measure of a client's pictures. The server tells which joints there are. */
  public AnchorGaps(Simulation server, SimulatedClient client) {
    this.server = server;
    this.client = client;
    Arrays.fill(truth, new double[0]);
  }

  /** Runs for a number of seconds and looks at every picture. */
  public void run(Stepper stepper, double seconds) {
    long endNs = stepper.nowNs() + (long) (seconds * 1e9);
    while (stepper.nowNs() - endNs < 0) {
      stepper.step();
      look();
    }
  }

  /** Looks at the present picture. */
  public void look() {
    JointTable<Entity> joints = server.joints();
    if (server.tick() != tick) {
      tick = server.tick();
      truth[tick % LATELY] = new double[joints.limit()];
    }
    lookAtWorld(joints);
    if (client.view().predictedWorld() != null) {
      lookAtWorld(client.view().predictedWorld().joints());
    }
    for (int j = 0; j < joints.limit(); j++) {
      Joint<Entity> joint = joints.get(j);
      if (isMeasured(joint)) {
        ClientView.Drawn a = client.view().find(joint.bodyA().user().id());
        ClientView.Drawn b = client.view().find(joint.bodyB().user().id());
        if (a != null && b != null) {
          look(j, joint, a, b);
        }
      }
    }
  }

  private static boolean isMeasured(Joint<Entity> joint) {
    return joint != null
        && joint.bodyA() != null
        && !joint.bodyA().user().isLevel()
        && (joint.type() == JointType.REVOLUTE || joint.type() == JointType.WHEEL);
  }

  /** Notes how far joints are open in a world. */
  private void lookAtWorld(JointTable<Entity> joints) {
    double[] now = truth[tick % LATELY];
    for (int i = 0; i < joints.limit(); i++) {
      Joint<Entity> joint = joints.get(i);
      int index = joint == null ? 0 : JointTable.index(joints.key(i));
      if (isMeasured(joint) && index < now.length) {
        double dx = joint.anchorBX() - joint.anchorAX();
        double dy = joint.anchorBY() - joint.anchorAY();
        double gap = gap(joint.type(), dx, dy, joint.axisX(), joint.axisY());
        now[index] = Math.max(now[index], gap);
        worstTruth = Math.max(worstTruth, gap);
      }
    }
  }

  private void look(int index, Joint<Entity> joint, ClientView.Drawn a, ClientView.Drawn b) {
    double c = Math.cos(a.angle());
    double s = Math.sin(a.angle());
    double ax = number(index, JointDefRow.ANCHOR_AX);
    double ay = number(index, JointDefRow.ANCHOR_AY);
    double bx = number(index, JointDefRow.ANCHOR_BX);
    double by = number(index, JointDefRow.ANCHOR_BY);
    double dx =
        b.x() + Math.cos(b.angle()) * bx - Math.sin(b.angle()) * by - a.x() - c * ax + s * ay;
    double dy =
        b.y() + Math.sin(b.angle()) * bx + Math.cos(b.angle()) * by - a.y() - s * ax - c * ay;
    double ux = number(index, JointDefRow.AXIS_X);
    double uy = number(index, JointDefRow.AXIS_Y);
    double open = gap(joint.type(), dx, dy, c * ux - s * uy, s * ux + c * uy);
    double lately = 0;
    for (double[] then : truth) {
      lately = Math.max(lately, index < then.length ? then[index] : 0);
    }
    seen++;
    if (open - lately > worst) {
      worst = open - lately;
      where = "tick=" + tick + " " + joint + " open=" + open + " lately=" + lately;
      where += " predicted=" + a.predicted() + "," + b.predicted();
    }
  }

  private static double gap(JointType type, double dx, double dy, double ux, double uy) {
    return type == JointType.REVOLUTE ? Math.hypot(dx, dy) : Math.abs(dx * uy - dy * ux);
  }

  private double number(int index, int field) {
    return Float.intBitsToFloat(server.joints().definition(index, field));
  }

  /** Returns by how much a picture exceeded the worlds at most, metres. */
  public double worst() {
    return worst;
  }

  /** Returns how far a joint was open at most in a world, metres. */
  public double worstTruth() {
    return worstTruth;
  }

  /** Returns how many joints in pictures were looked at. */
  public long seen() {
    return seen;
  }

  @Override
  public String toString() {
    return "gap=" + worst + " of " + seen + " " + where + ", in the worlds " + worstTruth;
  }
}
