package carom.physics.truth;

import static carom.physics.truth.Lab.DT;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.JointType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.collision.Mtv;
import carom.physics.collision.Sat;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Scenes in which contacts act on the pieces of joint trees, and a meter of their energy. */
enum TreeScenes {
  EDGE("chain 16, end 1000, over an edge") {
    @Override
    void build(World<String> w) {
      edge(w, Link.HINGE, 16, 1000, 6);
    }
  },
  EDGE_HALF("the same, edge amid a link") {
    @Override
    void build(World<String> w) {
      edge(w, Link.HINGE, 16, 1000, 6.5);
    }
  },
  EDGE_LIGHT("chain 16, end 100, over an edge") {
    @Override
    void build(World<String> w) {
      edge(w, Link.HINGE, 16, 100, 6);
    }
  },
  EDGE_RODS("rods 16, end 1000, over an edge") {
    @Override
    void build(World<String> w) {
      edge(w, Link.ROD, 16, 1000, 6);
    }
  },
  EDGE_BOUNCY("the same on a table with e = 0.5") {
    @Override
    void build(World<String> w) {
      edge(w, Link.HINGE, 16, 1000, 6);
      w.body(0).setMaterial(0, M.withRestitution(.5f));
    }
  },
  EDGE_WELDS("hinges and welds in turn, end 1000, over an edge") {
    @Override
    void build(World<String> w) {
      edge(w, Link.HINGE_OR_WELD, 16, 1000, 6);
    }
  },
  EDGE_EQUAL("16 equal links over an edge") {
    @Override
    void build(World<String> w) {
      edge(w, Link.HINGE, 16, 1, 6);
    }
  },
  TABLE300("table top 300 kg on legs") {
    @Override
    void build(World<String> w) {
      table(w, 300);
    }
  },
  DUMBBELL("a beam of 1 kg pieces with 300 kg at both ends on legs") {
    @Override
    void build(World<String> w) {
      dumbbell(w, 300, 1);
    }
  },
  DUMBBELL_FLAT("the same, lying on its pieces") {
    @Override
    void build(World<String> w) {
      dumbbell(w, 300, 0);
    }
  },
  BRIDGE("bridge of 60 planks, boxes of 100 kg") {
    @Override
    void build(World<String> w) {
      bridge(w, 60, 100);
    }
  },
  BRIDGE1000("bridge of 60 planks, boxes of 1000 kg") {
    @Override
    void build(World<String> w) {
      bridge(w, 60, 1000);
    }
  },
  PEG("chain over a peg, 300 and 400 kg") {
    @Override
    void build(World<String> w) {
      peg(w, 300, 400);
    }
  },
  PEG1000("chain over a peg, 1000 and 1500 kg") {
    @Override
    void build(World<String> w) {
      peg(w, 1000, 1500);
    }
  },
  WALL("wrecking ball 1000 kg, the chain hits a wall") {
    @Override
    void build(World<String> w) {
      wall(w, 1000, 0);
    }
  },
  WALL_E("the same, e = 0.5") {
    @Override
    void build(World<String> w) {
      wall(w, 1000, .5f);
    }
  },
  FLOOR("chain 30, end 1000, falls on the floor") {
    @Override
    void build(World<String> w) {
      floor(w);
      Body<String> last = null;
      for (int i = 0; i < 30; i++) {
        Body<String> b = box(w, i + .5, 12, .5, .1, i == 29 ? 1000 : 1);
        w.createJoint(JointDef.revolute(last, b, i, 12));
        last = b;
      }
    }
  };

  private static final Material M = Material.DEFAULT;

  private enum Link {
    HINGE,
    ROD,
    HINGE_OR_WELD
  }

  final String what;

  TreeScenes(String what) {
    this.what = what;
  }

  /** Fills an empty world. */
  abstract void build(World<String> w);

  private static void floor(World<String> w) {
    w.createBody(new BodyDef().shape(new Box(100, 1)).position(0, -1), "floor");
  }

  private static Body<String> box(
      World<String> w, double x, double y, double hx, double hy, double m) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(new Box((float) hx, (float) hy), M.withDensity((float) (m / (4 * hx * hy))))
            .position((float) x, (float) y),
        "link");
  }

  private static void edge(World<String> w, Link link, int links, double end, double edge) {
    w.createBody(new BodyDef().shape(new Box(20, 20)).position((float) edge - 20, -20.1f), "table");
    Body<String> last = null;
    for (int i = 0; i < links; i++) {
      double half = link == Link.ROD ? .3 : .5;
      Body<String> b = box(w, i + .5, 0, half, .1, i == links - 1 ? end : 1);
      if (link == Link.ROD) {
        w.createJoint(JointDef.distance(last, b, Math.max(0, i - .5f), 0, i + .5f, 0));
      } else if (link == Link.HINGE_OR_WELD && i % 2 != 0) {
        w.createJoint(JointDef.weld(last, b, i, 0));
      } else {
        w.createJoint(JointDef.revolute(last, b, i, 0));
      }
      last = b;
    }
  }

  private static void table(World<String> w, double top) {
    floor(w);
    Body<String> plate = box(w, 0, 3.3, 3, .3, top);
    for (int side = -1; side <= 1; side += 2) {
      Body<String> last = plate;
      for (int i = 0; i < 3; i++) {
        Body<String> b = box(w, 2.5 * side, 2.5 - i, .2, .5, 1);
        w.createJoint(JointDef.weld(last, b, 2.5f * side, 3 - i));
        last = b;
      }
    }
  }

  private static void dumbbell(World<String> w, double end, int legs) {
    floor(w);
    List<Body<String>> row = new ArrayList<>();
    float y = .2f + legs;
    for (int i = 0; i < 8; i++) {
      Body<String> b = box(w, i + .5, y, .5, .1, 1);
      if (i > 0) {
        w.createJoint(JointDef.weld(row.get(i - 1), b, i, y));
      }
      row.add(b);
    }
    for (int i = 0; i < 8; i += 7) {
      Body<String> load = box(w, i + .5, y + .6, .5, .5, end);
      w.createJoint(JointDef.weld(row.get(i), load, i + .5f, y + .1f));
      for (int k = 0; k < legs; k++) {
        Body<String> leg = box(w, i + .5, y - .6, .2, .5, 1);
        w.createJoint(JointDef.weld(row.get(i), leg, i + .5f, y - .1f));
      }
    }
  }

  private static void bridge(World<String> w, int planks, double mass) {
    Body<String> last = null;
    for (int i = 0; i < planks; i++) {
      Body<String> b = box(w, i + .5, 0, .5, .1, 1);
      w.createJoint(JointDef.revolute(last, b, i, 0));
      last = b;
    }
    w.createJoint(JointDef.revolute(last, w.createBody(new BodyDef(), "rock"), planks - .5f, 0));
    for (int i = 0; i < 4; i++) {
      box(w, planks / 2.0 - 3 + 2 * i, 1, .5, .5, mass);
    }
  }

  private static void peg(World<String> w, double left, double right) {
    w.createBody(new BodyDef().shape(new Circle(1.5f)).position(0, 0), "peg");
    // All links start level, and fall over the peg.
    Body<String> last = null;
    for (int i = 0; i < 30; i++) {
      Body<String> b = box(w, i - 14.5, 1.61, .45, .1, i == 0 ? left : i == 29 ? right : 1);
      if (last != null) {
        w.createJoint(JointDef.revolute(last, b, i - 15, 1.61f));
      }
      last = b;
    }
  }

  private static void wall(World<String> w, double ball, float e) {
    Material m = M.withRestitution(e);
    w.createBody(new BodyDef().shape(new Box(4, 10), m).position(-5, -17), "wall");
    Body<String> last = null;
    for (int i = 0; i < 14; i++) {
      Body<String> b = box(w, i + .5, 0, .4, .1, 1);
      w.createJoint(JointDef.revolute(last, b, i, 0));
      last = b;
    }
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.8f), m.withDensity((float) (ball / (Math.PI * .64))))
                .position(14.8f, 0),
            "ball");
    w.createJoint(JointDef.revolute(last, b, 14, 0));
  }

  /** What a run shows. */
  static final class Result {
    /** Most energy above that of the start, J. */
    double gained;

    /** Most energy above the least so far, J. */
    double rise;

    /** Most potential energy below that of the start, J. */
    double dropped;

    /** Worst error of a joint, m. */
    double gap;

    /** Greatest height of a body above its place at the start, m. */
    double jump;

    /** Kinetic energy at the end, J. */
    double kinetic;

    /** Deepest overlap, m. */
    double overlap;

    /** Potential energy that was lost between start and end, J. */
    double fallen;

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "gained %10.1f rise %8.1f J of drop %9.0f (%8.3f %%), gap %.4f m, jump %.3f m, at end"
              + " %9.3f J, overlap %.4f, fallen %.0f",
          gained,
          rise,
          dropped,
          100 * gained / Math.max(dropped, 1e-9),
          gap,
          jump,
          kinetic,
          overlap,
          fallen);
    }
  }

  private static double potential(World<String> w) {
    double[] e = new double[1];
    w.forEachBody(b -> e[0] += b.type() == BodyType.DYNAMIC ? b.mass() * Lab.G * b.centerY() : 0);
    return e[0];
  }

  /**
   * Returns whether joints store energy for long: bridges, which are held twice and thus soft, and
   * what is solved joint by joint.
   */
  boolean isElastic() {
    return this == BRIDGE || this == BRIDGE1000 || this == TABLE300;
  }

  /** Runs the scene. */
  Result run(int ticks) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    build(w);
    return measure(w, ticks);
  }

  /** Runs {@link #EDGE} with the edge in another place, metres from the chain's beginning. */
  static Result runEdgeAt(double edge, int ticks) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    edge(w, Link.HINGE, 16, 1000, edge);
    return measure(w, ticks);
  }

  private static Result measure(World<String> w, int ticks) {
    Result r = new Result();
    List<Body<String>> all = new ArrayList<>();
    w.forEachBody(all::add);
    double[] y = new double[all.size()];
    for (int i = 0; i < y.length; i++) {
      y[i] = all.get(i).centerY();
    }
    double before = potential(w);
    double least = 0;
    for (int t = 0; t < ticks; t++) {
      w.step(DT);
      double p = potential(w);
      double energy = p + Lab.kinetic(w) - before;
      r.gained = Math.max(r.gained, energy);
      least = Math.min(least, energy);
      r.rise = Math.max(r.rise, energy - least);
      r.dropped = Math.max(r.dropped, before - p);
      r.fallen = before - p;
      for (int i = 0; i < y.length; i++) {
        r.jump = Math.max(r.jump, all.get(i).centerY() - y[i]);
      }
      r.gap = Math.max(r.gap, gap(w));
      r.overlap = Math.max(r.overlap, overlap(w));
    }
    r.kinetic = Lab.kinetic(w);
    return r;
  }

  /** Returns the worst error of a joint, m. */
  private static double gap(World<String> w) {
    double worst = 0;
    for (int i = 0; i < w.jointCount(); i++) {
      Joint<String> j = w.joint(i);
      double apart = Math.hypot(j.anchorBX() - j.anchorAX(), j.anchorBY() - j.anchorAY());
      worst = Math.max(worst, j.type() == JointType.DISTANCE ? Math.abs(apart - j.rest()) : apart);
    }
    return worst;
  }

  /** Returns the deepest overlap of a moving body with a static one, m. */
  private static double overlap(World<String> w) {
    double[] deepest = new double[1];
    Sat sat = new Sat();
    Mtv mtv = new Mtv();
    Transform one = new Transform();
    Transform two = new Transform();
    w.forEachBody(
        fixed -> {
          if (fixed.type() == BodyType.STATIC) {
            one.set(fixed.x(), fixed.y(), fixed.cos(), fixed.sin());
            w.forEachBody(
                b -> {
                  two.set(b.x(), b.y(), b.cos(), b.sin());
                  if (b.type() == BodyType.DYNAMIC
                      && fixed.shapeCount() > 0
                      && sat.mtv(
                          fixed.shape(0).parts().get(0),
                          one,
                          b.shape(0).parts().get(0),
                          two,
                          mtv)) {
                    deepest[0] = Math.max(deepest[0], mtv.length());
                  }
                });
          }
        });
    return deepest[0];
  }
}
