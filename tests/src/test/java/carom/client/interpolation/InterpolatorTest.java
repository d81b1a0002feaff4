package carom.client.interpolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class InterpolatorTest {
  private static final int RATE = 60;
  private final Interpolator interpolator = new Interpolator(RATE);
  private final Known known = new Known();
  private final Pose pose = new Pose();

  @Test
  void constantVelocityIsExact() {
    known.add(10, 1, 2, 0.1f, 3, -6, 0.6f);
    known.add(16, 1.3f, 1.4f, 0.16f, 3, -6, 0.6f);
    for (double tick = 10; tick <= 16; tick += 0.25) {
      assertEquals(0, index0(tick));
      float t = (float) ((tick - 10) / RATE);
      assertEquals(1 + 3 * t, pose.x, 1e-5);
      assertEquals(2 - 6 * t, pose.y, 1e-5);
      assertEquals(0.1 + 0.6 * t, pose.angle, 1e-5);
    }
  }

  @Test
  void constantAccelerationIsExact() {
    float a = -10;
    float s = 12f / RATE;
    known.add(0, 0, 5, 0, 1, 2, 0);
    known.add(12, s, 5 + 2 * s + a / 2 * s * s, 0, 1, 2 + a * s, 0);
    for (double tick = 0; tick <= 12; tick += 0.5) {
      interpolator.sample(known, tick, pose);
      float t = (float) (tick / RATE);
      assertEquals(5 + 2 * t + a / 2 * t * t, pose.y, 1e-4);
      assertEquals(2 + a * t, pose.vy, 1e-4);
    }
  }

  @Test
  void hasNoCornerWhereTwoCurvesMeet() {
    known.add(0, 0, 0, 0, 2, 0, 0);
    known.add(6, 0.25f, 0, 0, 3, 0, 0);
    known.add(12, 0.6f, 0, 0, 4, 0, 0);
    interpolator.sample(known, 5.99, pose);
    float before = pose.x;
    interpolator.sample(known, 6, pose);
    float at = pose.x;
    interpolator.sample(known, 6.01, pose);
    float after = pose.x;
    assertEquals((at - before) / 0.01 * RATE, (after - at) / 0.01 * RATE, 0.1);
  }

  @Test
  void aBodyAtRestDoesNotSlideBeforeItStarts() {
    known.add(100, 1, 1, 0, 0, 0, 0);
    known.add(400, 1, 1, 0, 0, 0, 0); // the end of its rest, as the decoder notes it
    known.add(401, 1.1f, 1, 0, 6, 0, 0);
    interpolator.sample(known, 399.5, pose);
    assertEquals(1, pose.x, 0);
    interpolator.sample(known, 400.5, pose);
    assertTrue(pose.x > 1 && pose.x < 1.1f, "x=" + pose.x);
  }

  @Test
  void aBounceIsALineAndNotALoop() {
    known.add(0, 0, 0.1f, 0, 0, -9, 0);
    known.add(2, 0, 0.1f, 0, 0, 9, 0);
    for (double tick = 0; tick <= 2; tick += 0.25) {
      interpolator.sample(known, tick, pose);
      assertEquals(0.1f, pose.y, 1e-6, "at " + tick);
    }
  }

  @Test
  void aJumpIsATeleport() {
    known.add(0, 0, 0, 0, 1, 0, 0);
    known.add(2, 10, 0, 0, 1, 0, 0);
    interpolator.sample(known, 1.9, pose);
    assertEquals(0, pose.x, 0.05);
    interpolator.sample(known, 2, pose);
    assertEquals(10, pose.x, 1e-6);
  }

  @Test
  void guessesAheadForALimitedTime() {
    known.add(0, 0, 0, 0, 6, 0, 0);
    interpolator.sample(known, 3, pose);
    assertEquals(0.3, pose.x, 1e-5);
    assertEquals(Interpolator.NONE, interpolator.toTick());
    interpolator.sample(known, 15, pose);
    float end = pose.x;
    interpolator.sample(known, 60, pose);
    assertEquals(end, pose.x, 1e-5);
    assertTrue(end > 6 * Interpolator.STRAIGHT_MS / 1000f, "x=" + end);
    assertTrue(end < 6 * Interpolator.EXTRAPOLATION_MS / 1000f, "x=" + end);
  }

  @Test
  void aGuessFadesToRestWithoutAJerk() {
    // Goal: bounded deceleration, down to rest at 250 ms. Method: differences of the guessed way.
    known.add(0, 0, 0, 0, 6, 0, 3);
    double step = 0.25;
    double seconds = step / RATE;
    double oldSpeed = 6;
    interpolator.sample(known, 0, pose);
    double x = pose.x;
    for (double tick = step; tick < 30; tick += step) {
      interpolator.sample(known, tick, pose);
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
    known.add(0, 0, 0, 0, 5, 0, 0);
    known.teleports++;
    known.add(6, 0.5f, 0, 0, 5, 0, 0);
    interpolator.sample(known, 5.9, pose);
    assertEquals(0, pose.x, 0);
    interpolator.sample(known, 6, pose);
    assertEquals(0.5f, pose.x, 0);
  }

  @Test
  void noCurveLeavesItsChordByMuch() {
    // Goal: no overshoot, whatever the velocities are; falling bodies may bulge. Method: random
    // pairs of states; the curve stays within a third of the chord around it, and its slack.
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 2_000; i++) {
      Known pair = new Known();
      int gap = 1 + random.nextInt(12);
      float x = (float) random.nextDouble(-1, 1);
      float y = (float) random.nextDouble(-1, 1);
      pair.add(0, 0, 0, 0, speed(random), speed(random), 0);
      pair.add(gap, x, y, 0, speed(random), speed(random), 0);
      double chord = Math.hypot(x, y);
      for (double tick = 0; tick <= gap; tick += gap / 16.0) {
        interpolator.sample(pair, tick, pose);
        double along = Math.max(0, Math.min(1, (pose.x * x + pose.y * y) / (chord * chord)));
        double away = Math.hypot(pose.x - along * x, pose.y - along * y);
        double slack = 0.05 * gap / RATE;
        assertTrue(away <= chord / 2 + slack, "pair " + i + " tick " + tick + " away=" + away);
      }
    }
  }

  private static float speed(SplittableRandom random) {
    return (float) random.nextDouble(-10, 10);
  }

  @Test
  void turnsTheShortWayUnlessItSpinsFast() {
    known.add(0, 0, 0, 3.0f, 0, 0, 1);
    known.add(6, 0, 0, -3.0f, 0, 0, 1);
    interpolator.sample(known, 3, pose);
    assertTrue(Math.abs(Pose.wrap(pose.angle - 3.14f)) < 0.05, "angle=" + pose.angle);

    Known fast = new Known(); // 40 rad/s for 0.2 s = 8 rad = one turn and 1.717
    fast.add(0, 0, 0, 0, 0, 0, 40);
    fast.add(12, 0, 0, Pose.wrap(8), 0, 0, 40);
    interpolator.sample(fast, 6, pose);
    assertEquals(4, pose.angle, 1e-3);
  }

  @Test
  void isThereFromItsFirstTickToItsLast() {
    known.add(10, 0, 0, 0, 0, 0, 0);
    known.gone(20);
    assertEquals(-1, interpolator.sample(known, 9.9, pose));
    assertTrue(interpolator.sample(known, 10, pose) >= 0);
    assertTrue(interpolator.sample(known, 19.9, pose) >= 0);
    assertEquals(-1, interpolator.sample(known, 20, pose));
  }

  @Test
  void anotherEntityInTheSlotIsNotBlendedWithTheFirst() {
    known.add(10, 0, 0, 0, 0, 0, 0);
    known.generation++;
    known.add(12, 0.5f, 0, 0, 0, 0, 0);
    interpolator.sample(known, 11.5, pose);
    assertEquals(0, pose.x, 0);
    assertEquals(0, interpolator.sample(known, 12, pose));
    assertEquals(0.5f, pose.x, 0);
  }

  private int index0(double tick) {
    return interpolator.sample(known, tick, pose) >= 0 ? 0 : -1;
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
        float vx,
        float vy,
        float omega) {}

    private final List<State> newestFirst = new ArrayList<>();
    int generation;
    int teleports;

    void add(int tick, float x, float y, float angle, float vx, float vy, float omega) {
      newestFirst.add(0, new State(tick, true, generation, teleports, x, y, angle, vx, vy, omega));
    }

    void gone(int tick) {
      newestFirst.add(0, new State(tick, false, 0, 0, 0, 0, 0, 0, 0, 0));
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
    public float vx(int index) {
      return newestFirst.get(index).vx;
    }

    @Override
    public float vy(int index) {
      return newestFirst.get(index).vy;
    }

    @Override
    public float omega(int index) {
      return newestFirst.get(index).omega;
    }
  }
}
