package carom.lab.bench;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Shape;
import carom.physics.math.SimRandom;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneWorld;
import carom.sim.scene.View;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Tells at which step piles of 1,500 compounds sleep: the 26 piles of {@code
 * docs/lab/compounds.md}. Arguments: the most steps, then the names of piles (all if there are
 * none). With {@code scenes FOLDER} it instead writes them for programs that measure other engines.
 *
 * <p>A name is a letter for the shapes, a seed, and {@code w} (wide: 40 columns in a bin of 36 m)
 * or {@code h} (high: 12 columns in a bin of 14.4 m).
 */
public final class CompoundPiles {
  private static final int BODIES = 1500;

  /** Distance of the bodies at the start, m. */
  private static final double PITCH = 0.8;

  private static final int MOST_STEPS = 1500;

  private static final List<String> NAMES =
      List.of(
          ("C1w C2w C3w C4w C5w C6w X1w X2w T1w T2w E1w E2w M1w M2w "
                  + "C1h C2h X1h X2h X3h X4h T1h T2h E1h E2h M1h M2h")
              .split(" "));

  private static final Shape PLUS =
      Compound.of(new Box(0.3f, 0.06f), new Box(0.06f, 0.3f), new Box(0.12f, 0.12f));

  private static final Shape TEE =
      Compound.of(
          new Box(0.28f, 0.06f, 0, 0.2f),
          new Box(0.06f, 0.2f, 0, -0.06f),
          new Box(0.14f, 0.05f, 0, -0.25f));

  private static final Shape CLAMP =
      Compound.of(
          new Box(0.06f, 0.28f, -0.15f, 0),
          new Box(0.15f, 0.05f, 0.06f, 0.23f),
          new Box(0.15f, 0.05f, 0.06f, -0.23f));

  private CompoundPiles() {}

  /**
   * Prints a line for each pile, or writes the scenes.
   *
   * @param args the most steps and names of piles; or {@code scenes} and a folder
   * @throws IOException if a scene can't be written
   */
  public static void main(String[] args) throws IOException {
    if (args.length == 2 && args[0].equals("scenes")) {
      for (String name : NAMES) {
        write(name, Path.of(args[1], name + ".txt"));
      }
      return;
    }
    int steps = args.length > 0 ? Integer.parseInt(args[0]) : MOST_STEPS;
    List<String> names = args.length > 1 ? List.of(args).subList(1, args.length) : NAMES;
    for (String name : names) {
      System.out.println(name + ": " + fate(pile(name).start().world(), steps));
    }
  }

  private static String fate(World<String> world, int steps) {
    for (int step = 1; step <= steps; step++) {
      world.step(1f / Scene.DEFAULT_TICK_RATE);
      if (awake(world) == 0) {
        return "asleep at step " + step;
      }
    }
    return awake(world) + " of " + BODIES + " awake";
  }

  private static int awake(World<String> world) {
    List<Body<String>> bodies = new ArrayList<>(BODIES);
    world.forEachBody(
        body -> {
          if (body.type() == BodyType.DYNAMIC && body.awake()) {
            bodies.add(body);
          }
        });
    return bodies.size();
  }

  private static void write(String name, Path to) throws IOException {
    BenchScene how = new BenchScene(name, 0, MOST_STEPS, Gate.FINITE, false, () -> pile(name));
    try (SceneFile file = SceneFile.of(how)) {
      Files.copy(file.scene(), to);
    }
  }

  /** Returns the pile of a name. */
  public static Scene pile(String name) {
    List<Shape> shapes = shapes(name.charAt(0));
    int seed = Integer.parseInt(name.substring(1, name.length() - 1));
    boolean wide = name.endsWith("w");
    WorldDef def = new WorldDef().withContinuous(false);
    return new Scene(
            name.toLowerCase(Locale.ROOT),
            "1500 compounds fall into a bin",
            new View(0, 10, 40, 30),
            s -> fill(s, shapes, seed, wide ? 40 : 12, wide ? 18 : 7.2f, wide ? 45 : 100))
        .with(def);
  }

  private static List<Shape> shapes(char letter) {
    switch (letter) {
      case 'C':
        return BenchmarkScenes.COMPOUNDS;
      case 'X':
        return List.of(PLUS);
      case 'T':
        return List.of(TEE);
      case 'E':
        return List.of(CLAMP);
      case 'M':
        List<Shape> all = new ArrayList<>(BenchmarkScenes.COMPOUNDS);
        all.addAll(List.of(PLUS, TEE, CLAMP));
        return all;
      default:
        throw new IllegalArgumentException("shapes=" + letter + " must be C, X, T, E or M");
    }
  }

  private static void fill(
      SceneWorld<?> s, List<Shape> shapes, int seed, int columns, float half, float height) {
    s.body(new BodyDef().shape(new Box(half + 2, 1)).position(0, -1));
    s.body(new BodyDef().shape(new Box(1, height)).position(-half - 1, height));
    s.body(new BodyDef().shape(new Box(1, height)).position(half + 1, height));
    SimRandom rng = new SimRandom(seed);
    for (int k = 0; k < BODIES; k++) {
      double x = (k % columns - (columns - 1) / 2.0) * PITCH + in(rng, -0.1, 0.1);
      int row = k / columns;
      double y = 1 + PITCH * row + in(rng, -0.1, 0.1);
      double angle = in(rng, -Math.PI, Math.PI);
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(shapes.get(k % shapes.size()))
              .position((float) x, (float) y)
              .angle((float) angle));
    }
  }

  private static double in(SimRandom rng, double a, double b) {
    return a + (b - a) * rng.nextFloat();
  }
}
