package carom.docs;

import static carom.docs.Drawing.BLUE;
import static carom.docs.Drawing.FAINT;
import static carom.docs.Drawing.GREEN;
import static carom.docs.Drawing.INK;
import static carom.docs.Drawing.NOTHING;
import static carom.docs.Drawing.ORANGE;
import static carom.docs.Drawing.RED;

import carom.physics.JointType;
import carom.physics.WorldDef;
import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * The figures of the engine's pages in docs, with shapes and manifolds of the engine itself. {@code
 * main} writes them; {@link PhysicsDrawingsTest} compares the files with what is drawn here.
 */
final class PhysicsDrawings {
  private static final Transform HERE = new Transform();

  private PhysicsDrawings() {}

  /** All figures by file name. */
  static Map<String, String> all() {
    Map<String, String> figures = new TreeMap<>();
    figures.put("physics-shapes.svg", shapes());
    figures.put("physics-contact.svg", contact());
    figures.put("physics-joints.svg", joints());
    figures.put("physics-step.svg", step());
    figures.put("physics-mover.svg", mover());
    return figures;
  }

  /**
   * Writes the files.
   *
   * @param args the folder
   */
  public static void main(String[] args) throws IOException {
    for (Map.Entry<String, String> figure : all().entrySet()) {
      Files.writeString(Path.of(args[0], figure.getKey()), figure.getValue());
    }
  }

  // ---- shapes

  private static String shapes() {
    Drawing d = new Drawing(760, 330, "Circle, box, polygons, capsule, segment, chain, compound");
    cell(d, 0, 0, "Circle", "a point and a radius");
    d.shape(BLUE, new Circle(0.8f), HERE);
    radius(d, 0, 0, 0.8);
    cell(d, 1, 0, "Box", "half width, half height");
    d.shape(BLUE, new Box(0.9f, 0.55f), HERE);
    d.dashes(FAINT, 0, 0, 0.9, 0);
    d.dashes(FAINT, 0, 0, 0, 0.55);
    cell(d, 2, 0, "Polygon", "convex hull of its points");
    corners(d, Polygon.of(-0.9f, -0.5f, 0.7f, -0.7f, 1, 0.1f, 0.1f, 0.8f, -0.8f, 0.4f));
    cell(d, 3, 0, "Rounded polygon", "a polygon and a radius");
    d.shape(BLUE, Polygon.rounded(0.25f, -0.6f, -0.5f, 0.7f, -0.4f, 0, 0.5f), HERE);
    radius(d, 0.7, -0.4, 0.25);
    cell(d, 0, 1, "Capsule", "two points and a radius");
    d.shape(BLUE, new Capsule(-0.5f, -0.2f, 0.5f, 0.2f, 0.4f), HERE);
    radius(d, 0.5, 0.2, 0.4);
    cell(d, 1, 1, "Segment", "a line without mass, two-sided");
    Segment segment = new Segment(-0.9f, -0.3f, 0.9f, 0.4f);
    d.path(BLUE, 2.5, NOTHING, ends(segment));
    normal(d, segment, 1);
    normal(d, segment, -1);
    cell(d, 2, 1, "Chain", "one-sided: solid from the left");
    Chain chain = Chain.open(-1.1f, 0.1f, -0.4f, -0.4f, 0.4f, 0.1f, 1.1f, -0.1f);
    for (Convex link : chain.parts()) {
      d.path(BLUE, 2.5, NOTHING, ends(link));
      normal(d, link, 1);
    }
    for (int i = 0; i < chain.pointCount(); i++) {
      d.dot(BLUE, chain.pointX(i), chain.pointY(i), 3);
      d.small("middle", chain.pointX(i), chain.pointY(i) - 0.27, "" + i);
    }
    cell(d, 3, 1, "Compound", "a body of several parts");
    Compound compound =
        Compound.of(
            new Box(0.9f, 0.2f, 0, -0.3f),
            new Circle(0.35f, -0.5f, 0.2f),
            new Circle(0.3f, 0.6f, 0));
    for (Convex part : compound.parts()) {
      d.shape(BLUE, part, HERE);
    }
    centre(d, compound.mass(1).centerX(), compound.mass(1).centerY());
    return d.svg();
  }

  /** Begins a cell of a table of figures: 190 by 160 pixels, its middle is the origin. */
  private static void cell(Drawing d, int column, int row, String name, String what) {
    double x = 95 + 190 * column;
    double y = 80 + 160 * row;
    d.view(x, y - 8, 55);
    d.bold("middle", 0, -1.17, name);
    d.small("middle", 0, -1.45, what);
  }

  private static void radius(Drawing d, double x, double y, double r) {
    d.dot(INK, x, y, 2);
    d.path(INK, 1, NOTHING, x, y, x + r * 0.8, y + r * 0.6);
    d.small("start", x + r * 0.8 + 0.04, y + r * 0.6, "r");
  }

  private static void corners(Drawing d, Convex shape) {
    d.shape(BLUE, shape, HERE);
    for (int i = 0; i < shape.vertexCount(); i++) {
      d.dot(BLUE, shape.vertexX(i), shape.vertexY(i), 3);
      d.small("middle", shape.vertexX(i) * 0.78, shape.vertexY(i) * 0.7 - 0.07, "" + i);
    }
  }

  private static double[] ends(Convex line) {
    return new double[] {line.vertexX(0), line.vertexY(0), line.vertexX(1), line.vertexY(1)};
  }

  /**
   * An arrow along the normal of a line, or against it: the way that touching bodies are pushed.
   */
  private static void normal(Drawing d, Convex line, int side) {
    double x = (line.vertexX(0) + line.vertexX(1)) / 2;
    double y = (line.vertexY(0) + line.vertexY(1)) / 2;
    double length = 0.4 * side;
    d.arrow(RED, x, y, x + length * line.normalX(0), y + length * line.normalY(0));
  }

  private static void centre(Drawing d, double x, double y) {
    d.circle(INK, 1, NOTHING, x, y, 0.07);
    d.path(INK, 1, NOTHING, x - 0.12, y, x + 0.12, y);
    d.path(INK, 1, NOTHING, x, y - 0.12, x, y + 0.12);
  }

  // ---- the contact

  private static String contact() {
    Drawing d = new Drawing(760, 360, "A manifold of two boxes, and the impulses at a point");
    manifold(d);
    impulses(d);
    return d.svg();
  }

  /** A tilted box on another one: one point overlaps, the other is still apart. */
  private static void manifold(Drawing d) {
    d.view(215, 205, 110);
    Box a = new Box(1.5f, 0.4f);
    Box b = new Box(0.75f, 0.5f);
    Transform ta = new Transform(0, -0.4f, 0);
    Transform tb = new Transform(0, 0.53f, 0.12f);
    Manifold m = new Manifold();
    new Collider().collide(a, ta, b, tb, 0.5f, m);
    d.shape(BLUE, a, ta);
    d.shape(ORANGE, b, tb);
    d.text(BLUE, "middle", 0, -0.45, "A");
    d.text(ORANGE, "middle", 0, 0.5, "B");
    numbers(d, BLUE, a, ta);
    numbers(d, ORANGE, b, tb);
    point(d, m, ta.x + m.x0, ta.y + m.y0, m.separation0, m.id0);
    point(d, m, ta.x + m.x1, ta.y + m.y1, m.separation1, m.id1);
    d.view(0, 0, 1);
    d.bold("start", 20, -28, "Manifold");
    d.small("start", 20, -44, "The normal is a unit vector from A to B.");
    d.small("start", 20, -328, "id = vertex of A x 256 + vertex of B. Numbers are the");
    d.small("start", 20, -344, "collider's; the overlap is drawn much too large.");
  }

  private static void numbers(Drawing d, String colour, Convex shape, Transform t) {
    for (int i = 0; i < shape.vertexCount(); i++) {
      double x = shape.vertexX(i) * 0.9;
      double y = shape.vertexY(i) * 0.8;
      d.text(
          colour,
          "middle",
          t.x + t.cos * x - t.sin * y,
          t.y + t.sin * x + t.cos * y - 0.03,
          "" + i);
    }
  }

  private static void point(Drawing d, Manifold m, double x, double y, float gap, int id) {
    d.dot(RED, x, y, 4);
    d.arrow(RED, x, y, x + 0.6 * m.normalX, y + 0.6 * m.normalY);
    d.text(RED, "start", x + 0.05, y + 0.62, "n");
    double at = x < 0 ? -1.85 : 0.95;
    d.text(RED, "start", at, 0.5, gap < 0 ? "overlap" : "gap");
    d.small("start", at, 0.36, "separation");
    d.small("start", at, 0.23, String.format(Locale.ROOT, "%.3f m", gap));
    d.small("start", at, 0.1, "id " + (id >> 8) + " x 256 + " + (id & 255));
  }

  private static void impulses(Drawing d) {
    double friction = 0.6;
    d.view(590, 240, 120);
    d.ground(-1, 1, 0);
    d.path(GREEN, 1, GREEN, 0, 0, -friction, 1, friction, 1);
    d.dot(RED, 0, 0, 4);
    d.arrow(RED, 0, 0, 0, 1);
    d.arrow(GREEN, 0, 0, -friction * 0.7, 0);
    d.arrow(INK, 0, 0, -friction * 0.7, 1);
    d.text(RED, "start", 0.05, 0.75, "pn");
    d.text(GREEN, "middle", -friction * 0.7, 0.06, "pt");
    d.text(INK, "middle", -friction * 0.7, 1.05, "acts on B");
    d.small("middle", 0, -0.25, "tangent: the normal turned left");
    d.arrow(FAINT, 0.25, -0.4, -0.25, -0.4);
    d.view(0, 0, 1);
    d.bold("start", 440, -28, "Impulses at a point");
    d.small("start", 440, -44, "pn is never negative. The cone: |pt| is at");
    d.small("start", 440, -59, "most friction x pn.");
    d.small("start", 440, -328, "A feels the opposite. The materials' frictions give");
    d.small("start", 440, -344, "their geometric mean; here 0.6.");
  }

  // ---- joints

  private static String joints() {
    Drawing d = new Drawing(760, 650, "The kinds of joints");
    for (JointType type : JointType.values()) {
      joint(d, type);
    }
    cell(d, 2, 2, "distance, spring", "frequency, damping ratio");
    box(d, ORANGE, -0.75, 0.1, 0.3, 0.3);
    box(d, ORANGE, 0.75, 0.1, 0.3, 0.3);
    d.spring(INK, -0.75, 0.1, 0.75, 0.1);
    anchors(d, -0.75, 0.1, 0.75, 0.1);
    cell(d, 3, 2, "distance, rope", "pulls, never pushes");
    d.ground(-0.4, 0.4, 0.8);
    box(d, ORANGE, 0.15, -0.5, 0.3, 0.25);
    d.path(INK, 1.5, NOTHING, 0, 0.8, -0.22, 0.35, -0.1, -0.05, 0.15, -0.5);
    anchors(d, 0, 0.8, 0.15, -0.5);
    cell(d, 0, 3, "distance, motor", "a piston: speed, force");
    box(d, BLUE, -0.75, 0, 0.3, 0.3);
    box(d, ORANGE, 0.6, 0, 0.3, 0.3);
    d.path(INK, 2, NOTHING, -0.75, 0, 0.6, 0);
    anchors(d, -0.75, 0, 0.6, 0);
    d.arrow(RED, 0.1, 0.5, 0.9, 0.5);
    cell(d, 1, 3, "revolute, ratchet", "turns one way, tooth by tooth");
    d.circle(ORANGE, 1.5, ORANGE, 0, 0, 0.6);
    d.dot(INK, 0, 0, 3);
    d.path(BLUE, 3, NOTHING, 1.1, 0.7, 0.5, 0.35);
    d.arc(RED, 0, 0, 0.4, -0.6, 2.6, true);
    cell(d, 2, 3, "wheel, groove", "a point on a line of A");
    box(d, BLUE, 0, -0.1, 1.2, 0.4);
    d.path(INK, 3, NOTHING, -0.9, -0.1, 0.9, -0.1);
    tilted(d, 0.25, 0.1, 0.3, 0.3, 0.6);
    d.dot(INK, 0.3, -0.1, 3.5);
    d.arrow(RED, 0.6, -0.3, 1.1, -0.3);
    d.arrow(RED, 0, -0.3, -0.6, -0.3);
    cell(d, 3, 3, "motor, friction", "to rest, limited force");
    tilted(d, -0.1, 0, 0.45, 0.3, 0.35);
    d.dot(INK, -0.1, 0, 3);
    d.arrow(FAINT, 0.4, 0.15, 1.1, 0.4);
    d.arrow(RED, -0.1, 0, -0.8, -0.25);
    return d.svg();
  }

  // ---- the mover

  private static String mover() {
    Drawing d = new Drawing(760, 230, "How a mover walks");
    panel(d, 130, "along the ground", "as fast uphill as on the level");
    d.path(INK, 2, NOTHING, -1.9, -0.8, -0.3, -0.8, 1.7, 0.3);
    capsule(d, BLUE, -1.2, -0.8);
    d.arrow(RED, -0.8, -0.45, -0.3, -0.45);
    capsule(d, ORANGE, 0.55, -0.26);
    d.arrow(RED, 0.95, 0.32, 1.4, 0.57);
    panel(d, 380, "up a step", "lift, forward, down");
    d.path(INK, 2, NOTHING, -1.8, -0.8, 0.3, -0.8, 0.3, -0.35, 1.8, -0.35);
    capsule(d, BLUE, -0.05, -0.8);
    capsule(d, ORANGE, 0.8, -0.35);
    d.path(RED, 1.5, NOTHING, -0.45, 0, -0.45, 0.95, 0.8, 0.95);
    d.arrow(RED, 0.8, 0.95, 0.8, 0.72);
    panel(d, 630, "out of a wedge", "the nearest point between planes");
    d.path(INK, 2, NOTHING, -1.6, 0.9, 0, -0.9, 1.6, 0.9);
    capsule(d, ORANGE, 0, -0.62);
    d.dashes(RED, -1.2, 0.7, 0.1, -0.75);
    d.dashes(RED, 1.2, 0.7, -0.1, -0.75);
    d.arrow(INK, 0, 0.9, 0, 0.5);
    return d.svg();
  }

  /** A drawing of its own around a place, 55 pixels per metre, with two lines of words below. */
  private static void panel(Drawing d, double x, String title, String words) {
    d.view(x, 95, 55);
    d.bold("middle", 0, -1.75, title);
    d.small("middle", 0, -2.1, words);
  }

  /** A capsule that stands at a place. */
  private static void capsule(Drawing d, String colour, double x, double y) {
    d.shape(colour, new Capsule(0, 0.28f, 0, 0.75f, 0.28f), HERE.set((float) x, (float) y, 0));
    HERE.setIdentity();
  }

  private static void joint(Drawing d, JointType type) {
    int at = type.ordinal();
    String name = type.name().toLowerCase(Locale.ROOT);
    int column = at % 4;
    int row = at / 4;
    switch (type) {
      case REVOLUTE -> {
        cell(d, column, row, name, "a hinge: one point in common");
        box(d, BLUE, -0.5, 0, 0.6, 0.18);
        tilted(d, 0.42, 0.32, 0.6, 0.18, 0.65);
        anchors(d, 0, 0, 0, 0);
        d.arc(RED, 0, 0, 0.75, -0.4, 0.35, true);
      }
      case DISTANCE -> {
        cell(d, column, row, name, "a rod: two points, one length");
        box(d, BLUE, -0.75, -0.2, 0.3, 0.3);
        box(d, ORANGE, 0.75, 0.3, 0.3, 0.3);
        d.path(INK, 2, NOTHING, -0.75, -0.2, 0.75, 0.3);
        anchors(d, -0.75, -0.2, 0.75, 0.3);
      }
      case PRISMATIC -> {
        cell(d, column, row, name, "a slider: along an axis of A");
        d.dashes(INK, -1.2, -0.2, 1.2, 0.4);
        box(d, BLUE, -0.7, -0.075, 0.28, 0.35);
        tilted(d, 0.3, 0.175, 0.4, 0.25, 0.245);
        d.arrow(RED, 0.5, 0.6, 1.1, 0.75);
        d.arrow(RED, 0.2, 0.53, -0.4, 0.38);
      }
      case WELD -> {
        cell(d, column, row, name, "one point and one angle");
        box(d, BLUE, -0.45, 0, 0.45, 0.35);
        tilted(d, 0.42, 0.1, 0.45, 0.3, 0.25);
        d.path(INK, 3, NOTHING, 0, 0.3, 0, -0.25);
      }
      case WHEEL -> {
        cell(d, column, row, name, "slides on an axis, turns");
        box(d, BLUE, 0, 0.55, 0.9, 0.2);
        d.circle(ORANGE, 1.5, ORANGE, 0, -0.35, 0.4);
        d.spring(INK, 0, 0.35, 0, -0.35);
        d.dot(INK, 0, -0.35, 3);
        d.arc(RED, 0, -0.35, 0.58, -0.6, 0.8, true);
      }
      case MOTOR -> {
        cell(d, column, row, name, "to a pose, limited force");
        tilted(d, -0.55, -0.25, 0.35, 0.25, 0.5);
        d.path(FAINT, 1, NOTHING, 0.3, 0.5, 0.3, 0, 1, 0, 1, 0.5, 0.3, 0.5);
        d.arrow(RED, -0.3, -0.08, 0.3, 0.15);
      }
      case MOUSE -> {
        cell(d, column, row, name, "a point to a place, by force");
        tilted(d, -0.3, -0.25, 0.5, 0.3, 0.3);
        d.spring(INK, 0.05, 0, 0.85, 0.6);
        d.dot(INK, 0.05, 0, 3);
        d.path(RED, 2, NOTHING, 0.75, 0.6, 0.95, 0.6);
        d.path(RED, 2, NOTHING, 0.85, 0.5, 0.85, 0.7);
      }
      case GEAR -> {
        cell(d, column, row, name, "turns of B per turn of A");
        d.circle(BLUE, 1.5, BLUE, -0.5, 0, 0.65);
        d.circle(ORANGE, 1.5, ORANGE, 0.5, 0, 0.35);
        d.dot(INK, -0.5, 0, 3);
        d.dot(INK, 0.5, 0, 3);
        d.arc(RED, -0.5, 0, 0.45, 0.3, 2.6, true);
        d.arc(RED, 0.5, 0, 0.2, 2.8, 0.5, true);
      }
      case RACK -> {
        cell(d, column, row, name, "metres of B per turn of A");
        d.circle(BLUE, 1.5, BLUE, 0, 0.25, 0.5);
        d.dot(INK, 0, 0.25, 3);
        box(d, ORANGE, 0, -0.4, 1.1, 0.15);
        d.arc(RED, 0, 0.25, 0.3, 0.3, 2.6, true);
        d.arrow(RED, 0.2, -0.4, 0.9, -0.4);
      }
      case PULLEY -> {
        cell(d, column, row, name, "two lengths, one sum");
        d.ground(-1, 1, 0.85);
        box(d, BLUE, -0.7, -0.55, 0.3, 0.25);
        box(d, ORANGE, 0.7, -0.05, 0.3, 0.25);
        d.path(INK, 1.5, NOTHING, -0.7, -0.55, -0.7, 0.7, 0.7, 0.7, 0.7, -0.05);
        d.dot(INK, -0.7, 0.7, 3);
        d.dot(INK, 0.7, 0.7, 3);
      }
      default -> throw new IllegalStateException("no drawing of " + type);
    }
  }

  private static void box(
      Drawing d, String colour, double x, double y, double halfWidth, double halfHeight) {
    d.shape(
        colour, new Box((float) halfWidth, (float) halfHeight), HERE.set((float) x, (float) y, 0));
    HERE.setIdentity();
  }

  private static void tilted(
      Drawing d, double x, double y, double halfWidth, double halfHeight, double angle) {
    Transform pose = new Transform((float) x, (float) y, (float) angle);
    d.shape(ORANGE, new Box((float) halfWidth, (float) halfHeight), pose);
  }

  private static void anchors(Drawing d, double x0, double y0, double x1, double y1) {
    d.dot(INK, x0, y0, 3.5);
    d.dot(INK, x1, y1, 3.5);
  }

  // ---- the step

  private static final String[][] BEFORE = {
    {"Broadphase", "fat boxes, pairs"},
    {"Narrowphase", "a manifold a pair"},
    {"Wake", "what awake bodies", "touch"},
    {"Callbacks", "end, begin, preSolve"},
  };
  private static final String[][] SUBSTEP = {
    {"Impacts", "blows, one", "after the other"},
    {"Velocities", "v += h a, damping"},
    {"Warm start", "last impulses", "again"},
    {"Solve", "joints, contacts,", "with bias"},
    {"Positions", "x += h v"},
    {"Relax", "joints, contacts,", "without bias"},
  };
  private static final String[][] AFTER = {
    {"Continuous", "fast bodies to their", "first impact"},
    {"Callbacks", "postSolve, hit,", "broken joints"},
    {"Deferred", "what callbacks", "asked for"},
    {"Sleep", "islands at rest"},
  };

  private static String step() {
    Drawing d = new Drawing(760, 345, "The stages of a step, with its substeps");
    d.view(0, 0, 1);
    row(d, 40, 70, BEFORE, 120, FAINT);
    d.path(BLUE, 1.5, BLUE, 15, -121, 745, -121, 745, -232, 15, -232);
    String times = "x " + new WorldDef().substeps();
    d.text(
        BLUE, "start", 25, -140, "substeps " + times + ", h = dt / " + new WorldDef().substeps());
    row(d, 26, 186, SUBSTEP, 102, BLUE);
    d.path(BLUE, 1.5, NOTHING, 687, -215, 687, -224, 77, -224, 77, -217);
    d.arrow(BLUE, 77, -223, 77, -215);
    row(d, 40, 294, AFTER, 120, FAINT);
    down(d, 520, 88);
    down(d, 100, 222);
    d.bold("start", 20, -26, "A step");
    return d.svg();
  }

  private static void row(
      Drawing d, double x, double middle, String[][] stages, double width, String colour) {
    double gap = 20;
    for (int i = 0; i < stages.length; i++) {
      double left = x + i * (width + gap);
      d.path(
          colour,
          1.5,
          colour,
          left,
          -middle + 29,
          left + width,
          -middle + 29,
          left + width,
          -middle - 29,
          left,
          -middle - 29);
      String[] words = stages[i];
      d.bold("middle", left + width / 2, -middle + (words.length > 2 ? 10 : 4), words[0]);
      for (int line = 1; line < words.length; line++) {
        double below = words.length > 2 ? 8 - 15 * line : -13;
        d.small("middle", left + width / 2, -middle + below, words[line]);
      }
      if (i > 0) {
        d.arrow(INK, left - gap + 2, -middle, left - 2, -middle);
      }
    }
  }

  private static void down(Drawing d, double x, double y) {
    d.arrow(INK, x, -y - 11, x, -y - 31);
  }
}
