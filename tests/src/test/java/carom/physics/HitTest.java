package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Impacts are told once, with the speed and the impulse of the textbook. */
class HitTest {
  /** What was heard of one impact. */
  private record Hit(float speed, float impulse, float x, float y) {}

  private static List<Hit> listen(World<String> w) {
    List<Hit> hits = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void hit(Collision<String> c) {
            hits.add(new Hit(c.hitSpeed(), c.impulse(), c.hitX(), c.hitY()));
          }
        });
    return hits;
  }

  /** J = (1 + e) v m1 m2 / (m1 + m2). */
  @ParameterizedTest
  @CsvSource({"5,0,1,1", "5,1,1,1", "3,0.5,1,4", "20,0.8,9,1", "1.5,0.3,2,3"})
  void impulseIsThatOfTheCollisionLaw(float speed, float e, float density1, float density2) {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, -1, 0, 0.5f, new Material(density1, 0, e));
    Body<String> b = disc(w, 1, 0, 0.5f, new Material(density2, 0, e));
    a.setVelocity(speed, 0);
    List<Hit> hits = listen(w);
    steps(w, 120);
    assertEquals(1, hits.size(), hits.toString());
    double reduced = a.mass() * b.mass() / (a.mass() + b.mass());
    double bounce = speed > 1 ? e : 0;
    assertEquals(speed, hits.get(0).speed(), 1e-5 * speed);
    assertEquals((1 + bounce) * speed * reduced, hits.get(0).impulse(), 1e-4 * speed * reduced);
  }

  @Test
  void aBoxThatLandsFlatIsHitInTheMiddle() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = box(w, 3, 2.5f, 0.5f, 0.5f, Material.DEFAULT);
    List<Hit> hits = listen(w);
    steps(w, 120);
    assertEquals(1, hits.size(), hits.toString());
    assertEquals(3, hits.get(0).x(), 0.05);
    assertEquals(0, hits.get(0).y(), 0.2);
    assertEquals(Math.sqrt(2 * 10 * 2), hits.get(0).speed(), 0.2);
    double weight = b.mass() * 10 * DT;
    assertEquals(hits.get(0).speed() * b.mass(), hits.get(0).impulse(), 1.5 * weight);
  }

  @Test
  void everyBounceIsOneHitUntilTheyAreTooSlow() {
    World<String> w = Scenes.floor(new Material(1, 0.6f, 0.8f));
    disc(w, 0, 3.5f, 0.5f, new Material(1, 0.6f, 0.8f));
    List<Hit> hits = listen(w);
    steps(w, 600);
    double expected = Math.sqrt(2 * 10 * 3);
    for (Hit hit : hits) {
      assertEquals(expected, hit.speed(), 0.25, hits.toString());
      expected *= 0.8;
    }
    assertTrue(expected < 1.2, "the last was " + expected / 0.8);
  }

  @ParameterizedTest
  @ValueSource(floats = {0.5f, 2, 10})
  void theWorldSaysHowFastIsWorthTelling(float threshold) {
    for (float speed : new float[] {0.9f * threshold, 1.1f * threshold}) {
      World<String> w = new World<>(new WorldDef().withGravity(0, 0).withHitSpeed(threshold));
      disc(w, -1, 0, 0.5f, Material.DEFAULT).setVelocity(speed, 0);
      disc(w, 1, 0, 0.5f, Material.DEFAULT);
      List<Hit> hits = listen(w);
      steps(w, 600);
      assertEquals(speed > threshold ? 1 : 0, hits.size());
    }
  }

  @Test
  void pilesThatRestAreSilent() {
    World<String> w = Scenes.stack(8);
    List<Hit> hits = listen(w);
    steps(w, 300);
    assertEquals(List.of(), hits);
  }

  @Test
  void aShotAtAThinWallIsOneHit() {
    World<String> w = Scenes.space();
    w.createBody(new BodyDef().shape(new Box(0.005f, 5)).position(10, 0), "wall");
    Body<String> shot =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(0.05f, 0.05f))
                .velocity(500, 0)
                .bullet(true),
            "shot");
    List<Hit> hits = listen(w);
    steps(w, 30);
    assertEquals(1, hits.size(), hits.toString());
    assertEquals(500, hits.get(0).speed(), 0.01);
    assertEquals(500 * shot.mass(), hits.get(0).impulse(), 0.02 * 500 * shot.mass());
  }

  @Test
  void hitFollowsPostSolveOfTheSameContact() {
    World<String> w = Scenes.space();
    disc(w, -0.51f, 0, 0.5f, Material.DEFAULT).setVelocity(5, 0);
    disc(w, 0.5f, 0, 0.5f, Material.DEFAULT);
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            heard.add("begin " + c.hitSpeed());
          }

          @Override
          public boolean preSolve(Collision<String> c) {
            heard.add("pre " + c.hitSpeed());
            return true;
          }

          @Override
          public void postSolve(Collision<String> c) {
            heard.add("post " + c.hitSpeed());
          }

          @Override
          public void hit(Collision<String> c) {
            heard.add("hit " + c.hitSpeed());
          }
        });
    w.step(DT);
    assertEquals(List.of("begin 0.0", "pre 0.0", "post 0.0", "hit 5.0"), heard);
  }

  @Test
  void whatIsVetoedHitsNothing() {
    World<String> w = Scenes.space();
    disc(w, -1, 0, 0.5f, Material.DEFAULT).setVelocity(5, 0);
    disc(w, 1, 0, 0.5f, Material.DEFAULT);
    int[] hits = new int[1];
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            return false;
          }

          @Override
          public void hit(Collision<String> c) {
            hits[0]++;
          }
        });
    steps(w, 120);
    assertEquals(0, hits[0]);
  }

  @Test
  void listeningChangesNothing() {
    World<String> heard = Scenes.pile(40, 9);
    World<String> silent = Scenes.pile(40, 9);
    List<Hit> hits = listen(heard);
    steps(heard, 200);
    steps(silent, 200);
    assertTrue(hits.size() > 20);
    assertEquals(silent.stateHash(), heard.stateHash());
  }
}
