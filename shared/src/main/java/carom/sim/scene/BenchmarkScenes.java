package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.SimRandom;
import carom.physics.math.Transform;
import carom.physics.particles.ParticleDef;
import carom.physics.particles.Particles;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Makes the scenes on which the engine is measured, in any size. Every number is computed in double
 * precision and then rounded, so that other engines can be given the same numbers.
 *
 * <p>Nothing sleeps in them and continuous collision is off, as in the other engines when they are
 * measured. Use {@link Scene#with} with a definition of your own to have both.
 */
public final class BenchmarkScenes {
  /** Number of boxes in a stack that sleeps. */
  private static final int STACK = 5;

  private static final Material IDEAL = new Material(1, 0, 1);

  /** Distance of the bodies of a pile at the start, m; no shape of a pile is wider. */
  private static final double PITCH = 0.8;

  private static final List<Shape> SIMPLE =
      List.of(
          new Circle(0.25f), new Box(0.25f, 0.25f), Polygon.regular(5, 0.3f), new Box(0.3f, 0.15f));

  private static final List<Shape> POLYGONS =
      List.of(
          Polygon.regular(3, 0.3f),
          Polygon.regular(6, 0.3f),
          Polygon.of(-0.3f, -0.15f, 0.3f, -0.15f, 0.1f, 0.15f, -0.2f, 0.15f),
          Polygon.regular(8, 0.3f),
          Polygon.regular(5, 0.3f));

  /** A bowl, a girder and a dumbbell, of three parts each, as {@code pile_compounds} has them. */
  public static final List<Shape> COMPOUNDS =
      List.of(
          Compound.of(
              new Box(0.25f, 0.08f, 0, -0.15f),
              new Box(0.08f, 0.15f, -0.17f, 0.08f),
              new Box(0.08f, 0.15f, 0.17f, 0.08f)),
          Compound.of(
              new Box(0.25f, 0.07f, 0, 0.18f),
              new Box(0.07f, 0.11f),
              new Box(0.25f, 0.07f, 0, -0.18f)),
          Compound.of(
              new Box(0.2f, 0.06f), new Circle(0.13f, -0.2f, 0), new Circle(0.13f, 0.2f, 0)));

  private static final List<Shape> MIXED =
      List.of(
          new Circle(0.25f),
          Polygon.regular(3, 0.3f),
          COMPOUNDS.get(0),
          POLYGONS.get(2),
          new Box(0.3f, 0.15f),
          COMPOUNDS.get(1),
          Polygon.regular(6, 0.3f));

  private BenchmarkScenes() {}

  private static WorldDef def() {
    return new WorldDef().withSleeping(false).withContinuous(false);
  }

  private static Scene scene(String name, String what, View view, Consumer<SceneWorld<?>> builder) {
    return new Scene(name, what, view, builder).with(def());
  }

  /**
   * Makes one pyramid of boxes of 1 m on a floor.
   *
   * @param base boxes in the lowest row; {@code base (base + 1) / 2} in all
   * @return a scene
   */
  public static Scene pyramid(int base) {
    return scene(
        "large_pyramid",
        "one pyramid of " + base + " rows",
        new View(0, base * 0.45f, base * 1.1f, base * 1.05f),
        s -> {
          ground(s);
          pyramid(s, base, 0.5, 0, 0);
        });
  }

  /** Makes a static box of half-extents (100, 1) whose surface is y = 0. */
  static void ground(SceneWorld<?> s) {
    s.body(new BodyDef().shape(new Box(100, 1)).position(0, -1));
  }

  /** Makes rows of boxes of half-extents (h, h) from y0 upwards, centred at cx. */
  static void pyramid(SceneWorld<?> s, int base, double h, double cx, double y0) {
    Shape box = new Box((float) h, (float) h);
    for (int i = 0; i < base; i++) {
      for (int j = i; j < base; j++) {
        put(s, box, cx + (i + 1) * h + 2 * (j - i) * h - h * base, y0 + (2 * i + 1) * h);
      }
    }
  }

  private static double in(SimRandom rng, double a, double b) {
    return a + (b - a) * rng.nextFloat();
  }

  private static Body<?> put(SceneWorld<?> s, Shape shape, double x, double y) {
    return s.body(new BodyDef(BodyType.DYNAMIC).shape(shape).position((float) x, (float) y));
  }

  /**
   * Makes pyramids of ten rows on shelves above each other.
   *
   * @param shelves number of shelves
   * @param perShelf pyramids on each; 55 boxes each
   * @return a scene
   */
  public static Scene manyPyramids(int shelves, int perShelf) {
    double half = perShelf * 5.5;
    return scene(
        "many_pyramids",
        shelves * perShelf + " pyramids of ten rows on " + shelves + " shelves",
        new View(0, shelves * 5.5f, 2 * (float) half, shelves * 11f),
        s -> {
          for (int i = 0; i < shelves; i++) {
            s.body(
                new BodyDef()
                    .shape(new Box((float) (half + 1), 0.1f))
                    .position(0, (float) (11 * i - 0.1)));
            for (int j = 0; j < perShelf; j++) {
              pyramid(s, 10, 0.5, -half + (j + 0.5) * 11, 11 * i);
            }
          }
        });
  }

  /**
   * Makes a square drum that turns slowly, with small boxes inside.
   *
   * @param perSide rows and columns of boxes; 45 fill half of the drum
   * @return a scene
   */
  public static Scene tumbler(int perSide) {
    return scene(
        "tumbler",
        perSide * perSide + " boxes in a turning drum",
        new View(0, 10, 30, 30),
        s -> {
          s.body(
              new BodyDef(BodyType.KINEMATIC)
                  .shape(new Box(0.5f, 10, 10, 0))
                  .shape(new Box(0.5f, 10, -10, 0))
                  .shape(new Box(10, 0.5f, 0, 10))
                  .shape(new Box(10, 0.5f, 0, -10))
                  .position(0, 10)
                  .angularVelocity((float) StrictMath.toRadians(25)));
          Shape box = new Box(0.125f, 0.125f);
          for (int i = 0; i < perSide; i++) {
            for (int j = 0; j < perSide; j++) {
              put(s, box, -9 + 0.4 * j, 1 + 0.4 * i);
            }
          }
        });
  }

  /**
   * Makes discs, squares, pentagons and planks, turned at random, that fall into a bin.
   *
   * @param bodies number of bodies
   * @param columns number of bodies side by side at the start
   * @param width of the bin inside, m; at least 0.9 per column
   * @return a scene
   */
  public static Scene pile(int bodies, int columns, double width) {
    return pile(
        "pile", bodies + " bodies of four shapes fall into a bin", bodies, columns, width, SIMPLE);
  }

  /** Makes 2,000 polygons of three to eight corners that fall into a bin. */
  static Scene pileOfPolygons() {
    return pile(
        "pile_polygons", "2000 polygons of five kinds fall into a bin", 2000, 50, 45, POLYGONS);
  }

  /** Makes 1,500 bodies of three parts each that fall into a bin. */
  static Scene pileOfCompounds() {
    return pile(
        "pile_compounds",
        "1500 bowls, girders and dumbbells fall into a bin",
        1500,
        40,
        36,
        COMPOUNDS);
  }

  /** Makes 2,000 bodies of every kind of shape that fall into a bin. */
  static Scene pileOfAll() {
    return pile("pile_mixed", "2000 bodies of seven shapes fall into a bin", 2000, 50, 45, MIXED);
  }

  private static Scene pile(
      String name, String what, int bodies, int columns, double width, List<Shape> shapes) {
    return scene(
        name,
        what,
        new View(0, (float) width * 0.3f, (float) width + 6, (float) width * 0.7f),
        s -> {
          bin(s, width, 90);
          pile(s, bodies, columns, shapes);
        });
  }

  /** Makes a floor at y = 0 with two walls. */
  static void bin(SceneWorld<?> s, double width, double height) {
    float half = (float) (width / 2);
    s.body(new BodyDef().shape(new Box((float) (width / 2 + 2), 1)).position(0, -1));
    Shape wall = new Box(1, (float) (height / 2));
    s.body(new BodyDef().shape(wall).position(-half - 1, (float) (height / 2)));
    s.body(new BodyDef().shape(wall).position(half + 1, (float) (height / 2)));
  }

  private static void pile(SceneWorld<?> s, int bodies, int columns, List<Shape> shapes) {
    SimRandom rng = new SimRandom(1);
    for (int k = 0; k < bodies; k++) {
      int column = k % columns;
      int row = k / columns;
      double x = (column - (columns - 1) / 2.0) * PITCH + in(rng, -0.1, 0.1);
      double y = 1 + PITCH * row + in(rng, -0.1, 0.1);
      double angle = in(rng, -Math.PI, Math.PI);
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(shapes.get(k % shapes.size()))
              .position((float) x, (float) y)
              .angle((float) angle));
    }
  }

  /**
   * Makes a net of discs, hinged to their neighbours, that hangs by the middle of its upper edge.
   *
   * @param perSide rows and columns
   * @return a scene
   */
  public static Scene jointGrid(int perSide) {
    return scene(
        "joint_grid",
        "a net of " + perSide * perSide + " discs hangs by the middle of its upper edge",
        new View(perSide * 0.5f, -perSide * 0.6f, perSide * 1.2f, perSide * 1.4f),
        s -> jointGrid(s, perSide));
  }

  private static <T> void jointGrid(SceneWorld<T> s, int n) {
    Shape disc = new Circle(0.4f);
    Filter together = Filter.DEFAULT.withGroup(-1);
    // The middle columns are held: of 100, those from 47 to 53.
    int first = n / 2 - Math.max(1, 3 * n / 100);
    int last = n / 2 + Math.max(1, 3 * n / 100);
    List<Body<T>> bodies = new ArrayList<>();
    for (int k = 0; k < n; k++) {
      for (int i = 0; i < n; i++) {
        boolean held = i == 0 && k >= first && k <= last;
        Body<T> body =
            s.body(
                new BodyDef(held ? BodyType.STATIC : BodyType.DYNAMIC)
                    .shape(disc, Material.DEFAULT, together)
                    .position(k, -i));
        if (i > 0) {
          s.joint(JointDef.revolute(bodies.get(k * n + i - 1), body, k, 0.5f - i));
        }
        if (k > 0) {
          s.joint(JointDef.revolute(bodies.get((k - 1) * n + i), body, k - 0.5f, -i));
        }
        bodies.add(body);
      }
    }
  }

  /**
   * Makes a heavy block that flies into a wall of small boxes, without gravity.
   *
   * @param columns of boxes
   * @param rows of boxes
   * @return a scene
   */
  public static Scene smash(int columns, int rows) {
    Scene scene =
        scene(
            "smash",
            "a heavy block flies into " + columns * rows + " boxes, without gravity",
            new View(columns * 0.2f + 15, 0, columns * 0.4f + 70, rows * 0.4f + 20),
            s -> {
              s.body(
                  new BodyDef(BodyType.DYNAMIC)
                      .shape(new Box(4, 4), Material.DEFAULT.withDensity(8))
                      .position(-20, 0)
                      .velocity(40, 0));
              Shape box = new Box(0.2f, 0.2f);
              for (int i = 0; i < columns; i++) {
                for (int j = 0; j < rows; j++) {
                  put(s, box, 0.4 * i + 30, 0.4 * (j - rows / 2));
                }
              }
            });
    return scene.with(scene.def().withGravity(0, 0));
  }

  /**
   * Makes frictionless, perfectly elastic discs of 0.5 m in a closed square, without gravity. They
   * cover 2 percent of it.
   *
   * @param discs number of discs
   * @return a scene
   */
  public static Scene gas(int discs) {
    double side = 3.1333 * Math.sqrt(discs);
    Scene scene =
        scene(
            "gas",
            discs + " perfectly elastic discs in a closed square",
            new View(0, 0, (float) side + 2, (float) side + 2),
            s -> {
              closedSquare(s, side);
              discs(s, discs, side, 5, 1);
            });
    return scene.with(scene.def().withGravity(0, 0));
  }

  private static void closedSquare(SceneWorld<?> s, double side) {
    float far = (float) (side / 2 + 5);
    Shape upright = new Box(5, (float) (side / 2 + 10));
    Shape lying = new Box((float) (side / 2 + 10), 5);
    s.body(new BodyDef().shape(upright, IDEAL).position(-far, 0));
    s.body(new BodyDef().shape(upright, IDEAL).position(far, 0));
    s.body(new BodyDef().shape(lying, IDEAL).position(0, -far));
    s.body(new BodyDef().shape(lying, IDEAL).position(0, far));
  }

  private static void discs(SceneWorld<?> s, int n, double side, double speed, float gravityScale) {
    SimRandom rng = new SimRandom(2);
    int m = (int) Math.ceil(Math.sqrt(n));
    double pitch = side / m;
    double jitter = Math.max(0, pitch / 2 - 0.26);
    Shape disc = new Circle(0.25f);
    for (int k = 0; k < n; k++) {
      int column = k % m;
      int row = k / m;
      double x = (column + 0.5) * pitch - side / 2 + in(rng, -jitter, jitter);
      double y = (row + 0.5) * pitch - side / 2 + in(rng, -jitter, jitter);
      double direction = in(rng, -Math.PI, Math.PI);
      double v = speed * Math.sqrt(rng.nextFloat());
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(disc, IDEAL)
              .position((float) x, (float) y)
              .gravityScale(gravityScale)
              .velocity(
                  (float) (v * StrictMath.cos(direction)),
                  (float) (v * StrictMath.sin(direction))));
    }
  }

  /**
   * Makes stacks of five boxes, asleep from the start on shelves above each other. Next to them,
   * elastic discs without weight fly in a closed square and never sleep. Nothing else moves, so a
   * step should cost what the discs cost.
   *
   * @param asleep number of boxes, a multiple of 5
   * @param awake number of discs
   * @return a scene
   */
  public static Scene asleep(int asleep, int awake) {
    double side = 3.1333 * Math.sqrt(awake);
    int stacks = asleep / STACK;
    int perShelf = (int) Math.ceil(Math.sqrt(2.5 * stacks));
    double width = 0.6 * perShelf;
    Scene scene =
        scene(
            "asleep",
            asleep + " boxes sleep, " + awake + " discs fly",
            new View(0, 0, (float) side + 2, (float) side + 2),
            s -> {
              closedSquare(s, side);
              discs(s, awake, side, 5, 0);
              double left = side / 2 + 20;
              Shape shelf = new Box((float) (width / 2), 0.1f);
              for (int i = 0; i * perShelf < stacks; i++) {
                double x = left + width / 2;
                s.body(new BodyDef().shape(shelf).position((float) x, (float) (4 * i - 0.1)));
              }
              Shape box = new Box(0.25f, 0.25f);
              for (int k = 0; k < stacks; k++) {
                double x = left + 0.6 * (k % perShelf + 0.5);
                int shelfBelow = k / perShelf;
                double y = 4.0 * shelfBelow + 0.25;
                for (int j = 0; j < STACK; j++) {
                  s.body(
                      new BodyDef(BodyType.DYNAMIC)
                          .shape(box)
                          .position((float) x, (float) (y + 0.5 * j))
                          .awake(false));
                }
              }
            });
    return scene.with(new WorldDef().withContinuous(false));
  }

  /**
   * Makes water that slumps in a tank.
   *
   * @param particles number of particles
   * @return a scene
   */
  public static Scene water(int particles) {
    float spacing = 0.1f;
    float half = (float) (spacing * Math.sqrt(particles / 2.0));
    return new Scene(
        "water",
        particles + " particles of water slump in a tank",
        new View(0, half, 4 * half, 3 * half),
        s -> {
          bin(s, 4 * half, 6 * half);
          Particles water =
              s.particles(
                  new ParticleDef(ParticleDef.Kind.WATER, spacing).maxCount(particles),
                  SceneColors.WATER);
          water.fill(new Box(half, half), new Transform(-half, half, 0), 0, 0);
        });
  }
}
