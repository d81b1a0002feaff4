package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The two Eulers against their exact discrete solutions (Hairer, Lubich, Wanner, "Geometric
 * Numerical Integration", I.1).
 */
class IntegratorTest {
  private static final double H = 1 / 60.0;

  private static World<String> world(Integrator integrator, float gravity) {
    return new World<>(
        new WorldDef().withGravity(0, gravity).withSubsteps(1).withIntegrator(integrator));
  }

  /**
   * After n steps the symplectic one is at {@code g h^2 n (n + 1) / 2}, the explicit one at {@code
   * g h^2 n (n - 1) / 2}: {@code g h t / 2} further, or less far, than the true {@code g t^2 / 2}.
   */
  @ParameterizedTest
  @EnumSource
  void freeFallIsTheExactDiscreteSolution(Integrator integrator) {
    World<String> w = world(integrator, -10);
    Body<String> b = disc(w, 0, 0, 0.5f, Material.DEFAULT);
    int side = integrator == Integrator.SYMPLECTIC_EULER ? 1 : -1;
    for (int n = 1; n <= 240; n++) {
      w.step(DT);
      double t = n * H;
      double y = -10 * H * H * n * (n + side) / 2;
      assertEquals(y, b.y(), 1e-5 * Math.abs(y) + 1e-6);
      assertEquals(-10 * t, b.velocityY(), 1e-5 * 10 * t);
      assertEquals(side * -10 * H * t / 2, b.y() + 5 * t * t, 2e-5 * Math.abs(y) + 1e-6);
    }
  }

  @Test
  void halfTheStepHalvesTheErrorOfBoth() {
    for (Integrator integrator : Integrator.values()) {
      double[] error = new double[2];
      for (int i = 0; i < 2; i++) {
        WorldDef def = new WorldDef().withSubsteps(1 + i).withIntegrator(integrator);
        World<String> w = new World<>(def);
        Body<String> b = disc(w, 0, 0, 0.5f, Material.DEFAULT);
        steps(w, 60);
        error[i] = b.y() + 5;
      }
      assertEquals(2, error[0] / error[1], 0.01, integrator.toString());
    }
  }

  /** x and v of an oscillator after n steps; the spring's force is applied by hand. */
  private static double[][] oscillate(Integrator integrator, double w, int n) {
    World<String> world = world(integrator, 0);
    Body<String> b = disc(world, 1, 0, 0.5f, Material.DEFAULT);
    float k = (float) (b.mass() * w * w);
    double[][] states = new double[n + 1][];
    for (int i = 0; i <= n; i++) {
      states[i] = new double[] {b.x(), b.velocityX()};
      b.applyForce(-k * b.x(), 0);
      world.step(DT);
    }
    return states;
  }

  /** (v^2 + w^2 x^2) grows by exactly 1 + h^2 w^2 per step. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 3, 6, 12, 18})
  void explicitEulerGainsEnergyByTheKnownFactor(double w) {
    int n = 100;
    double[][] states = oscillate(Integrator.EXPLICIT_EULER, w, n);
    for (int i = 0; i <= n; i++) {
      double energy = states[i][1] * states[i][1] + w * w * states[i][0] * states[i][0];
      double expected = w * w * Math.pow(1 + H * H * w * w, i);
      assertEquals(expected, energy, 1e-4 * expected, "step " + i);
    }
  }

  /** v^2 + w^2 x^2 - h w^2 x v stays what it is, hence the orbit stays an ellipse. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 3, 6, 12, 30, 100})
  void symplecticEulerKeepsItsOrbit(double w) {
    double[][] states = oscillate(Integrator.SYMPLECTIC_EULER, w, 10_000);
    double most = 0;
    for (double[] s : states) {
      double kept = s[1] * s[1] + w * w * s[0] * s[0] - H * w * w * s[0] * s[1];
      assertEquals(w * w, kept, 2e-3 * w * w);
      most = Math.max(most, Math.abs(s[0]));
    }
    double amplitude = 1 / Math.sqrt(1 - H * H * w * w / 4);
    assertTrue(most <= 1.001 * amplitude, "amplitude " + most + " of " + amplitude);
    assertTrue(most >= 0.97 * amplitude, "amplitude " + most + " of " + amplitude);
  }

  @Test
  void boxesRestUnderExplicitEulerToo() {
    World<String> w = new World<>(new WorldDef().withIntegrator(Integrator.EXPLICIT_EULER));
    w.createBody(new BodyDef().shape(new Box(50, 1)).position(0, -1), "");
    Body<String> low = box(w, 0, 0.6f, 0.5f, 0.5f, Material.DEFAULT);
    Body<String> high = box(w, 0, 1.7f, 0.5f, 0.5f, Material.DEFAULT);
    steps(w, 300);
    assertEquals(0.5, low.y(), 0.005);
    assertEquals(1.5, high.y(), 0.01);
    assertEquals(0, high.x(), 5e-3);
  }

  @Test
  void spinIsExactWithBoth() {
    for (Integrator integrator : Integrator.values()) {
      World<String> w = world(integrator, 0);
      Body<String> b = box(w, 0, 0, 1, 0.2f, Material.DEFAULT);
      b.applyTorque(b.inertia() * 60);
      steps(w, 31);
      double turns = integrator == Integrator.SYMPLECTIC_EULER ? 31 : 30;
      assertEquals(1, b.angularVelocity(), 1e-5);
      assertEquals(turns / 60, b.angle(), 1e-5);
    }
  }

  @Test
  void oneMustBeChosen() {
    WorldDef def = new WorldDef();
    Exception e = assertThrows(IllegalArgumentException.class, () -> def.withIntegrator(null));
    assertTrue(e.getMessage().contains("integrator=null"));
  }
}
