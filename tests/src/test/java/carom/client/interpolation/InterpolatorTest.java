package carom.client.interpolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class InterpolatorTest {
  private static final int RATE = 60;
  private final Interpolator interpolator = new Interpolator(RATE);
  private final Known known = new Known();
  private final Sample sample = new Sample();
  private final Pose pose = sample.pose;

  /** Adds states from a tick on, a gap apart, of a body that gravity may pull. */
  private void fly(int ticks, int gap, float vx, float vy, float omega, float gravity) {
    for (int tick = 0; tick <= ticks; tick += gap) {
      float t = (float) tick / RATE;
      known.add(tick, vx * t, vy * t - gravity / 2 * t * t, Pose.wrap(omega * t));
    }
  }

  @Test
  void constantVelocityIsExact() {
    fly(18, 6, 3, -6, 0.6f, 0);
    for (double tick = 0; tick <= 18; tick += 0.25) {
      assertTrue(existsAt(tick));
      float t = (float) (tick / RATE);
      assertEquals(3 * t, pose.x, 1e-5);
      assertEquals(-6 * t, pose.y, 1e-5);
      assertEquals(0.6 * t, pose.angle, 1e-5);
      assertEquals(3, pose.vx, 1e-4);
      assertEquals(0.6, pose.omega, 1e-4);
    }
  }

  @Test
  void constantAccelerationIsExact() {
    fly(24, 4, 1, 2, 0, 10);
    for (double tick = 4; tick <= 20; tick += 0.5) {
      interpolator.sample(known, tick, sample);
      float t = (float) (tick / RATE);
      assertEquals(2 * t - 5 * t * t, pose.y, 1e-4);
      assertEquals(2 - 10 * t, pose.vy, 1e-4);
    }
  }

  @Test
  void hasNoCornerWhereTwoCurvesMeet() {
    for (int tick = 0; tick <= 24; tick += 6) {
      known.add(tick, tick * tick * 0.002f, 0, 0);
    }
    interpolator.sample(known, 11.99, sample);
    float before = pose.x;
    interpolator.sample(known, 12, sample);
    float at = pose.x;
    interpolator.sample(known, 12.01, sample);
    float after = pose.x;
    assertEquals((at - before) / 0.01 * RATE, (after - at) / 0.01 * RATE, 0.1);
  }

  @Test
  void aBodyAtRestDoesNotSlideBeforeItStarts() {
    known.still(100, 1, 1);
    known.still(400, 1, 1); // the end of its rest, as the decoder notes it
    known.add(401, 1.1f, 1, 0);
    interpolator.sample(known, 399.5, sample);
    assertEquals(1, pose.x, 0);
    interpolator.sample(known, 400.5, sample);
    assertTrue(pose.x > 1 && pose.x < 1.1f, "x=" + pose.x);
  }

  @Test
  void aBodyThatStandsStillIsNotGuessedAhead() {
    fly(6, 2, 3, 0, 0, 0);
    interpolator.sample(known, 9, sample);
    assertEquals(0.45, pose.x, 1e-4);
    known.still(8, 0.32f, 0);
    interpolator.sample(known, 20, sample);
    assertEquals(0.32f, pose.x, 0);
    assertEquals(0, pose.vx, 0);
  }

  @Test
  void aBounceIsACornerAndNotALoop() {
    // down at 9 m/s, up again from between ticks 6 and 8
    for (int tick = 0; tick <= 14; tick += 2) {
      known.add(tick, 0, Math.abs(tick - 7) * 9f / RATE, 0);
    }
    for (double tick = 0; tick <= 14; tick += 0.25) {
      interpolator.sample(known, tick, sample);
      double height = tick >= 6 && tick <= 8 ? 9.0 / RATE : Math.abs(tick - 7) * 9 / RATE;
      assertEquals(height, pose.y, 1e-5, "at " + tick);
    }
  }

  @Test
  void aJumpIsATeleport() {
    fly(4, 2, 1, 0, 0, 0);
    known.add(6, 10, 0, 0);
    interpolator.sample(known, 5.9, sample);
    assertEquals(4f / RATE, pose.x, 1e-6, "it waits at its last place");
    interpolator.sample(known, 6, sample);
    assertEquals(10, pose.x, 1e-6);
  }

  @Test
  void whatSetsOffFastIsNoTeleport() {
    fly(6, 2, 90, 0, 0, 0); // three metres in two ticks, and nothing before
    interpolator.sample(known, 1, sample);
    assertEquals(1.5, pose.x, 1e-4);
  }

  @Test
  void guessesAheadForALimitedTime() {
    for (int tick = -12; tick <= 0; tick += 2) {
      known.add(tick, 6f * tick / RATE, 0, 0);
    }
    interpolator.sample(known, 3, sample);
    assertEquals(0.3, pose.x, 1e-5);
    assertEquals(Sample.NONE, sample.toTick);
    interpolator.sample(known, 15, sample);
    float end = pose.x;
    interpolator.sample(known, 60, sample);
    assertEquals(end, pose.x, 1e-5);
    assertTrue(end > 6 * Interpolator.STRAIGHT_MS / 1000f, "x=" + end);
    assertTrue(end < 6 * Interpolator.EXTRAPOLATION_MS / 1000f, "x=" + end);
  }

  @Test
  void aGuessGoesOnFalling() {
    fly(12, 2, 2, 0, 0, 10);
    interpolator.sample(known, 15, sample);
    assertEquals(0.5, pose.x, 1e-4);
    double straight = -5 * 0.2 * 0.2 - 10 * 0.2 * 0.05;
    assertEquals(straight, pose.y, 0.004, "with the speed of the last state");
  }

  @Test
  void aGuessFadesToRestWithoutAJerk() {
    // Goal: bounded deceleration, down to rest at 250 ms. Method: differences of the guessed way.
    for (int tick = -12; tick <= 0; tick += 2) {
      known.add(tick, 6f * tick / RATE, 0, 3f * tick / RATE);
    }
    double step = 0.25;
    double seconds = step / RATE;
    double oldSpeed = 6;
    interpolator.sample(known, 0, sample);
    double x = pose.x;
    for (double tick = step; tick < 30; tick += step) {
      interpolator.sample(known, tick, sample);
      double speed = (pose.x - x) / seconds;
      assertEquals(pose.vx, speed, 0.15, "the told speed is the drawn one, tick " + tick);
      assertTrue(speed <= oldSpeed + 1e-2, "tick " + tick + " speed=" + speed);
      assertTrue((oldSpeed - speed) / seconds < 60, "tick " + tick + " speed=" + speed);
      x = pose.x;
      oldSpeed = speed;
    }
    assertEquals(0, oldSpeed, 1e-3);
    assertEquals(0, pose.omega, 0);
  }

  @Test
  void aMarkedTeleportIsACutHoweverShort() {
    known.add(0, 0, 0, 0);
    known.teleports++;
    known.add(6, 0.5f, 0, 0);
    interpolator.sample(known, 5.9, sample);
    assertEquals(0, pose.x, 0);
    interpolator.sample(known, 6, sample);
    assertEquals(0.5f, pose.x, 0);
  }

  @Test
  void noCurveLeavesItsChordByMuch() {
    // Goal: no overshoot, wherever the poses beside are; falling bodies may bulge. Method: random
    // poses; the curve stays within a third of the chord around it, and its slack.
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 2_000; i++) {
      Known four = new Known();
      int gap = 1 + random.nextInt(12);
      float x = (float) random.nextDouble(-1, 1);
      float y = (float) random.nextDouble(-1, 1);
      four.add(-1 - random.nextInt(6), speed(random) / 10, speed(random) / 10, 0);
      four.add(0, 0, 0, 0);
      four.add(gap, x, y, 0);
      four.add(gap + 1 + random.nextInt(6), speed(random) / 10, speed(random) / 10, 0);
      double chord = Math.hypot(x, y);
      for (double tick = 0; tick <= gap; tick += gap / 16.0) {
        interpolator.sample(four, tick, sample);
        double along = Math.max(0, Math.min(1, (pose.x * x + pose.y * y) / (chord * chord)));
        double away = Math.hypot(pose.x - along * x, pose.y - along * y);
        double slack = 0.05 * gap / RATE;
        assertTrue(away <= chord / 2 + slack, "chord " + i + " tick " + tick + " away=" + away);
      }
    }
  }

  private static float speed(SplittableRandom random) {
    return (float) random.nextDouble(-10, 10);
  }

  @Test
  void turnsTheShortWayUnlessItSpinsFast() {
    known.add(0, 0, 0, 3.0f);
    known.add(6, 0, 0, -3.0f);
    interpolator.sample(known, 3, sample);
    assertTrue(Math.abs(Pose.wrap(pose.angle - 3.14f)) < 0.05, "angle=" + pose.angle);

    Known fast = new Known(); // 40 rad/s for 0.2 s = 8 rad = one turn and 1.717
    fast.add(-3, 0, 0, -2);
    fast.add(0, 0, 0, 0);
    fast.add(12, 0, 0, Pose.wrap(8)); // some states between were lost
    interpolator.sample(fast, 6, sample);
    assertEquals(4, pose.angle, 1e-3);
  }

  @Test
  void isThereFromItsFirstTickToItsLast() {
    known.add(10, 0, 0, 0);
    known.gone(20);
    assertFalse(existsAt(9.9));
    assertTrue(existsAt(10));
    assertTrue(existsAt(19.9));
    assertFalse(existsAt(20));
  }

  @Test
  void anotherEntityInTheSlotIsNotBlendedWithTheFirst() {
    known.add(10, 0, 0, 0);
    known.generation++;
    known.add(12, 0.5f, 0, 0);
    interpolator.sample(known, 11.5, sample);
    assertEquals(0, pose.x, 0);
    interpolator.sample(known, 12, sample);
    assertEquals(0, sample.index);
    assertEquals(0.5f, pose.x, 0);
  }

  private boolean existsAt(double tick) {
    interpolator.sample(known, tick, sample);
    return sample.exists();
  }

  /** A hand-written history. */
  private static final class Known implements StateHistory {
    private record State(
        int tick,
        boolean alive,
        int generation,
        int teleports,
        float x,
        float y,
        float angle,
        boolean still) {}

    private final List<State> newestFirst = new ArrayList<>();
    int generation;
    int teleports;

    void add(int tick, float x, float y, float angle) {
      newestFirst.add(0, new State(tick, true, generation, teleports, x, y, angle, false));
    }

    void still(int tick, float x, float y) {
      newestFirst.add(0, new State(tick, true, generation, teleports, x, y, 0, true));
    }

    void gone(int tick) {
      newestFirst.add(0, new State(tick, false, 0, 0, 0, 0, 0, false));
    }

    @Override
    public int size() {
      return newestFirst.size();
    }

    @Override
    public int tick(int index) {
      return newestFirst.get(index).tick;
    }

    @Override
    public boolean alive(int index) {
      return newestFirst.get(index).alive;
    }

    @Override
    public int generation(int index) {
      return newestFirst.get(index).generation;
    }

    @Override
    public int teleports(int index) {
      return newestFirst.get(index).teleports;
    }

    @Override
    public float x(int index) {
      return newestFirst.get(index).x;
    }

    @Override
    public float y(int index) {
      return newestFirst.get(index).y;
    }

    @Override
    public float angle(int index) {
      return newestFirst.get(index).angle;
    }

    @Override
    public boolean still(int index) {
      return newestFirst.get(index).still;
    }
  }
}
