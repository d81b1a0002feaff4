package carom.testkit;

import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.Arrays;
import java.util.Locale;

/**
 * Measures what saving and restoring a world costs: bytes per body and contact, and microseconds
 * per 1,000 bodies each way (median).
 */
public final class SaveBench {
  private static final int ROUNDS = 400;

  private SaveBench() {}

  /**
   * Prints one row for bodies in free fall and one for bodies that lie on each other.
   *
   * @param args number of bodies, 10000 by default
   */
  public static void main(String[] args) {
    int bodies = args.length > 0 ? Integer.parseInt(args[0]) : 10_000;
    measure("apart", bodies, 0.8f);
    measure("piled", bodies, 0.5f);
  }

  private static void measure(String name, int bodies, float spacing) {
    World<Object> world = new World<>(new WorldDef().withSleeping(false));
    world.createBody(new BodyDef().shape(new Box(1e4f, 1)).position(0, -1), null);
    for (int i = 0; i < bodies; i++) {
      int column = i / 20;
      float x = column * spacing;
      float y = 0.25f + i % 20 * spacing;
      BodyDef def = new BodyDef(BodyType.DYNAMIC).position(x, y);
      world.createBody(
          i % 2 == 0 ? def.shape(new Box(0.25f, 0.25f)) : def.shape(new Circle(0.25f)), null);
    }
    for (int i = 0; i < 10; i++) {
      world.step(1 / 60f);
    }
    WorldState state = world.save(null);
    double[] save = new double[ROUNDS];
    double[] restore = new double[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
      long t0 = System.nanoTime();
      world.save(state);
      long t1 = System.nanoTime();
      world.restore(state);
      long t2 = System.nanoTime();
      save[i] = t1 - t0;
      restore[i] = t2 - t1;
    }
    System.out.printf(
        Locale.ROOT,
        "%s: %d bodies, %d contact rows (%d touch), save %.2f us, restore %.2f us per 1,000 bodies,"
            + " %d bytes%n",
        name,
        bodies,
        world.profile().pairs(),
        world.profile().contacts(),
        median(save) / bodies,
        median(restore) / bodies,
        state.bytes());
  }

  private static double median(double[] values) {
    Arrays.sort(values);
    return values[values.length / 2];
  }
}
