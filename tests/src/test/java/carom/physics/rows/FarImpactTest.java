package carom.physics.rows;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Impacts depend on nothing but the bodies that meet: a world that lacks all that is far away, or
 * took its bodies over by exact rows, goes on alike to the bit. Prediction is such a world.
 */
final class FarImpactTest {
  private static final float DT = 1 / 60f;
  private static final int STEPS = 600;
  private static final int BODIES = 24;
  private static final float FAR = 1000;

  /** Bodies that bounce in a bin, and others far away. */
  private static final class Place {
    final World<String> world = new World<>(new WorldDef());
    final List<Body<String>> near = new ArrayList<>();
    final List<Body<String>> far = new ArrayList<>();

    Place(long seed, boolean hasFar) {
      bin(0);
      bin(FAR);
      SplittableRandom random = new SplittableRandom(seed);
      SplittableRandom farRandom = new SplittableRandom(seed + 1);
      for (int i = 0; i < BODIES; i++) {
        if (hasFar) { // before and between, so that slots and rows of the near ones are others
          far.add(body(random(farRandom), FAR, farRandom));
        }
        near.add(body(random(random), 0, random));
      }
    }

    private static Material random(SplittableRandom random) {
      return new Material(1, .3f, random.nextInt(4) == 0 ? 0 : (float) random.nextDouble(.2, 1));
    }

    private void bin(float x) {
      Material m = new Material(1, .4f, .1f);
      world.createBody(new BodyDef().shape(new Box(6, 1), m).position(x, -1), "floor");
      world.createBody(new BodyDef().shape(new Box(1, 20), m).position(x - 6, 20), "wall");
      world.createBody(new BodyDef().shape(new Box(1, 20), m).position(x + 6, 20), "wall");
    }

    private Body<String> body(Material m, float x, SplittableRandom random) {
      Shape shape = random.nextBoolean() ? new Circle(.4f) : new Box(.4f, .4f);
      float left = x + (float) random.nextDouble(-4, 4);
      float up = (float) random.nextDouble(.5, 16);
      BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(shape, m).position(left, up);
      return world.createBody(def, "body");
    }

    /** Throws a body of each place up, and steps. */
    void step(SplittableRandom random) {
      int which = random.nextInt(BODIES);
      float x = (float) random.nextDouble(-3, 3);
      float y = (float) random.nextDouble(0, 6);
      int other = random.nextInt(BODIES);
      if (random.nextInt(20) == 0) {
        near.get(which).applyImpulse(x, y);
      }
      if (!far.isEmpty() && random.nextInt(5) == 0) {
        far.get(other).applyImpulse(x, y);
      }
      world.step(DT);
    }

    ExactRows rows() {
      ExactRows rows = new ExactRows();
      near.forEach(body -> rows.addBody(body.index()));
      assertEquals(0, world.readRows(rows));
      return rows;
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void whatBouncesFarAwayChangesNoBit(long seed) {
    Place whole = new Place(seed, true);
    Place part = new Place(seed, false);
    goOnAlike(whole, part, 0, STEPS, seed);
  }

  @ParameterizedTest
  @ValueSource(longs = {5, 6, 7, 8})
  void aWorldThatTookBouncingBodiesOverGoesOnAlike(long seed) {
    Place whole = new Place(seed, true);
    SplittableRandom random = new SplittableRandom(seed);
    int most = 0;
    for (int taken = 0; taken < STEPS; taken += 50) {
      for (int i = random.nextInt(50); i > 0; i--) {
        whole.step(new SplittableRandom(seed + taken + i));
      }
      Place part = new Place(seed, false);
      ExactRows rows = whole.rows();
      most = Math.max(most, rows.contacts().count());
      ExactRows sent = new ExactRows();
      for (RowKind kind : RowKind.values()) {
        for (int i = 0; i < rows.of(kind).count(); i++) {
          sent.add(kind, rows.of(kind).ints(), rows.of(kind).at(i));
        }
      }
      for (int i = 0; i < BODIES; i++) {
        sent.setSlot(i, part.near.get(i).index());
      }
      part.world.writeRows(sent);
      goOnAlike(whole, part, taken, taken + 50, seed);
    }
    assertTrue(most > BODIES, "contacts=" + most + " seed=" + seed);
  }

  private static void goOnAlike(Place whole, Place part, int from, int to, long seed) {
    for (int step = from; step < to; step++) {
      assertEquals(whole.rows().hash(), part.rows().hash(), "step=" + step + " seed=" + seed);
      whole.step(new SplittableRandom(seed * STEPS + step));
      part.step(new SplittableRandom(seed * STEPS + step));
    }
  }
}
