package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.dynamics.contact.ContactTable;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Which pairs the broadphase has depends on where bodies have been; what touches must not. */
class BoxHistoryTest {
  private static final int TICKS = 12;

  /**
   * Couples that are just about as far apart as matters, and slowly come or go or slide by. Fat
   * boxes are hardly larger than the parts, as they are in a crowd.
   */
  private static World<String> couples(Random random) {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0).withAabbMargin(0));
    for (int i = 0; i < 40; i++) {
      float x = 20 * (i % 8);
      float y = 20 * (i / 8);
      BodyType type = i % 3 == 0 ? BodyType.STATIC : BodyType.DYNAMIC;
      w.createBody(new BodyDef(type).position(x, y).shape(new Box(0.5f, 0.5f)), "one");
      float away = 1 + w.def().speculativeDistance() + 2e-4f * jitter(random);
      float aside = jitter(random);
      BodyDef other = new BodyDef(BodyType.DYNAMIC).shape(shape(random));
      other.velocity(2e-3f * jitter(random), 2e-3f * jitter(random));
      boolean upright = random.nextBoolean();
      other.position(upright ? x + aside : x + away, upright ? y + away : y + aside);
      w.createBody(other.angularVelocity(0.02f * jitter(random)), "other");
    }
    return w;
  }

  /** One that reaches half a metre along both axes. */
  private static Shape shape(Random random) {
    return switch (random.nextInt(4)) {
      case 0 -> new Circle(0.5f);
      case 1 -> new Capsule(-0.3f, 0, 0.3f, 0, 0.2f);
      case 2 -> Polygon.of(-0.5f, 0, 0, -0.5f, 0.5f, 0, 0, 0.5f);
      default -> new Box(0.5f, 0.5f);
    };
  }

  /**
   * Goal: a contact at the limit of the speculative distance doesn't hang on the history of fat
   * boxes. Method: go back to the same state with boxes left behind by motion in other directions,
   * and on from there; every hash must come again.
   */
  @Test
  void fatBoxesOfAnotherPastShowInNoBit() {
    int near = 0;
    for (long seed = 1; seed <= 4; seed++) {
      Random random = new Random(seed);
      World<String> w = couples(random);
      WorldState start = w.save(null);
      long[] hashes = new long[TICKS];
      for (int past = 0; past < 6; past++) {
        for (int i = 0; past > 0 && i < w.slotCount(); i++) {
          // From a little aside across the place and as far beyond: the box is as long.
          Body<String> body = w.body(i);
          float dx = 0.3f * jitter(random);
          float dy = 0.3f * jitter(random);
          body.setPose(body.x() + dx, body.y() + dy, 0);
          body.setVelocity(-2 * dx / DT, -2 * dy / DT);
        }
        if (past > 0) {
          w.step(DT);
          w.restore(start);
        }
        for (int tick = 0; tick < TICKS; tick++) {
          w.step(DT);
          hashes[tick] = past == 0 ? w.stateHash() : hashes[tick];
          String where = "seed=" + seed + " past=" + past + " tick=" + tick;
          assertEquals(hashes[tick], w.stateHash(), where);
        }
        ContactTable rows = w.dynamics().contacts();
        for (int row = 0; row < rows.count(); row++) {
          near += rows.points(row) > 0 ? 1 : 0;
        }
        w.restore(start);
      }
    }
    assertTrue(near > 100, "near=" + near);
  }

  private static float jitter(Random random) {
    return random.nextFloat() - 0.5f;
  }
}
