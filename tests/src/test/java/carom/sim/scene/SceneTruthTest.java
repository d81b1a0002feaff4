package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.EventLists;
import carom.suite.Optimized;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Scenes show what their descriptions promise. {@code carom.physics.truth} varies the experiments;
 * how far from the origin bodies may be is in its FarMotionTest, as a scene is near it.
 */
@Optimized("computes for long")
final class SceneTruthTest {
  private static SceneRun start(String name) {
    return Scenes.get(name).start();
  }

  private static List<Body<String>> dynamics(SceneRun run) {
    List<Body<String>> found = new ArrayList<>();
    run.world()
        .forEachBody(
            b -> {
              if (b.type() == BodyType.DYNAMIC) {
                found.add(b);
              }
            });
    return found;
  }

  private static long awake(SceneRun run) {
    return dynamics(run).stream().filter(Body::awake).count();
  }

  @Test
  void theCradleSendsTwoOutForTwoIn() {
    SceneRun run = start("newton_cradle");
    List<Body<String>> balls = dynamics(run);
    double lift = 3.6;
    float[] rest = new float[balls.size()];
    double[] out = new double[balls.size()];
    for (int i = 0; i < rest.length; i++) {
      rest[i] = balls.get(i).x() + (i < 2 ? (float) lift : 0);
    }
    for (int tick = 0; tick < 210; tick++) {
      run.step();
      for (int i = 0; i < rest.length; i++) {
        out[i] = Math.max(out[i], balls.get(i).x() - rest[i]);
      }
    }
    assertEquals(7, rest.length);
    for (int i = 0; i < rest.length; i++) {
      if (i < 5) {
        assertTrue(out[i] < 0.1 * lift, "ball " + i + " swings out by " + out[i]);
      } else {
        assertEquals(lift, out[i], 0.1 * lift, "ball " + i);
      }
    }
  }

  @Test
  void theCharacterStaysInThePicture() {
    SceneRun run = start("mover");
    List<Body<String>> upright = new ArrayList<>();
    run.world()
        .forEachBody(
            b -> {
              if (b.type() == BodyType.KINEMATIC && b.x() == -5 && b.y() == 3) {
                upright.add(b);
              }
            });
    Body<String> character = upright.get(0);
    float left = 0;
    float right = 0;
    float top = 0;
    for (int tick = 0; tick < 7200; tick++) {
      run.step();
      left = Math.min(left, character.x());
      right = Math.max(right, character.x());
      top = Math.max(top, character.y());
      assertTrue(character.y() > 0.7f && character.y() < 10, "tick=" + tick + " " + character);
      assertTrue(Math.abs(character.x()) < 17.5f, "tick=" + tick + " " + character);
    }
    assertTrue(left < -12 && right > 15, "left=" + left + " right=" + right);
    assertTrue(top > 4, "top=" + top);
  }

  @Test
  void noBulletPassesAWall() {
    SceneRun run = start("bullets");
    List<Body<String>> crates = dynamics(run);
    final float top = 9.5f; // a shot may bounce off another one and over the walls
    Set<Body<String>> over = new HashSet<>();
    int shots = 0;
    for (int tick = 0; tick < 1260; tick++) {
      run.step();
      int now = 0;
      for (Body<String> body : dynamics(run)) {
        if (!crates.contains(body)) {
          now++;
          boolean isBehind = body.x() >= 4;
          if (isBehind && body.y() > top) {
            over.add(body);
          }
          String about = "tick " + tick + " body " + body.index() + " x=" + body.x();
          assertTrue(!isBehind || over.contains(body), about + " y=" + body.y());
        }
      }
      shots = now;
    }
    assertTrue(over.size() <= 1, "shots that flew over the walls: " + over.size());
    assertEquals(20, shots);
    for (Body<String> crate : crates) {
      assertTrue(crate.x() > 4, "no crate was hit: x=" + crate.x());
    }
  }

  @Test
  void theTowersSleepAndTheBallWakesThoseItTouches() {
    SceneRun run = start("sleep_field");
    run.steps(140);
    assertEquals(0, awake(run));
    run.steps(30);
    assertTrue(awake(run) > 1, "the ball has reached a tower");
    assertTrue(awake(run) < dynamics(run).size() / 2, "the others sleep on");
    run.steps(1200);
    assertEquals(0, awake(run), "after a while all rest again");
  }

  @Test
  void theRackFollowsThePinionAndTheGearsTheMotor() {
    SceneRun run = start("gears");
    List<Body<String>> bodies = dynamics(run);
    Body<String> drive = bodies.get(0);
    Body<String> rack = bodies.get(4);
    double turned = 0;
    float before = rack.y();
    for (int tick = 0; tick < 140; tick++) {
      run.step();
      turned += drive.angularVelocity() * run.tickSeconds();
    }
    // Pitch circles roll on each other: the rack moves as far as the motor's circle of 1.25 m.
    assertEquals(1.25 * Math.abs(turned), Math.abs(rack.y() - before), 0.05);
    assertTrue(Math.abs(turned) > 2.5, "turned=" + turned);
  }

  @Test
  void waterTurnsTheWheelAndKeepsCratesAfloat() {
    SceneRun run = start("water_wheel");
    run.steps(600);
    Body<String> wheel = dynamics(run).get(0);
    assertTrue(wheel.angularVelocity() > 0.5, "rad/s " + wheel.angularVelocity());
    assertTrue(run.particles().get(0).particles().count() > 1000);
  }

  @Test
  void sandStaysInItsGlassWhenThatIsTurnedOver() {
    SceneRun run = start("hourglass");
    var sand = run.particles().get(0).particles();
    int grains = sand.count();
    run.steps(1860);
    assertEquals(grains, sand.count());
    for (int i = 0; i < grains; i++) {
      assertTrue(
          Math.abs(sand.x(i)) < 3.2 && Math.abs(sand.y(i) - 6) < 5.4,
          "a grain is at " + sand.x(i) + " " + sand.y(i));
    }
  }

  /** No slider of any floor is slowed while it is on the floor, and none is thrown up. */
  @Test
  void seamsSlowNothing() {
    SceneRun run = start("seams");
    List<Body<String>> sliders = dynamics(run);
    float[] speeds = {20, 5, 2};
    for (int tick = 0; tick < 1500; tick++) {
      run.step();
      for (int i = 0; i < sliders.size(); i++) {
        Body<String> b = sliders.get(i);
        String where = "tick=" + tick + " floor=" + i / 6 + " " + b;
        assertTrue(b.x() > 24.4 || Math.abs(b.y() - 4 * (i / 6) - 0.5) < 0.02, where);
        if (b.x() < 24.4) {
          assertEquals(speeds[i % 6 / 2], b.velocityX(), 0.001 * speeds[i % 6 / 2], where);
        }
      }
    }
    for (Body<String> b : sliders) {
      assertTrue(b.x() > 24.4, "it has come to the end: " + b);
    }
  }

  private static double kinetic(SceneRun run) {
    double sum = 0;
    for (Body<String> b : dynamics(run)) {
      double w = b.angularVelocity();
      double square =
          (double) b.velocityX() * b.velocityX() + (double) b.velocityY() * b.velocityY();
      sum += 0.5 * (b.mass() * square + b.inertia() * w * w);
    }
    return sum;
  }

  /** Kinetic energy and that of height, both of the middle of the last substep. */
  private static double energy(SceneRun run) {
    double sum = kinetic(run);
    double g = -run.world().gravityY();
    for (Body<String> b : dynamics(run)) {
      sum += b.mass() * g * (b.centerY() - b.velocityY() / 480);
    }
    return sum;
  }

  @ParameterizedTest
  @CsvSource({"gas_isolated, .005", "gas_closed, .02"})
  void aGasKeepsItsEnergy(String name, double share) {
    SceneRun run = start(name);
    double before = kinetic(run);
    run.steps(600);
    assertEquals(1, kinetic(run) / before, share);
  }

  @Test
  void theLastDiscOfARowLeavesAsTheFirstCame() {
    SceneRun run = start("blows_in_a_row");
    run.steps(120);
    List<Body<String>> discs = dynamics(run);
    for (int i = 0; i < discs.size(); i++) {
      double expected = i % 5 == 4 ? 3 : 0;
      assertEquals(expected, discs.get(i).velocityX(), 0.03, "row=" + i / 5 + " disc=" + i % 5);
    }
  }

  @Test
  void theLastBallOfThreeRisesAsTheFirstFell() {
    SceneRun run = start("cradle_of_three");
    List<Body<String>> balls = dynamics(run);
    double v = Math.sqrt(2 * 10 * (5 - 5 * Math.cos(.6)));
    double fastest = 0;
    for (int tick = 0; tick < 100; tick++) {
      run.step();
      fastest = Math.max(fastest, balls.get(2).velocityX());
    }
    assertTrue(fastest > 2.9 / 3 * v, "arrived at " + v + ", left at " + fastest);
  }

  /** What thirty blows with e = .95 leave, computed from blow to blow: see ImpactTest. */
  @Test
  void aBreakLosesWhatItsBlowsLose() {
    SceneRun run = start("billiards");
    double before = kinetic(run);
    run.steps(60);
    assertEquals(.786, kinetic(run) / before, .01);
  }

  @ParameterizedTest
  @CsvSource({"tilted_box, .98", "elastic_boxes, .8"})
  void boxesThatBounceGainNoEnergy(String name, double least) {
    SceneRun run = start(name);
    double before = energy(run);
    double most = 0;
    for (int tick = 0; tick < 3600; tick++) {
      run.step();
      most = Math.max(most, energy(run) / before);
    }
    assertTrue(most <= 1.005, "most=" + most);
    assertTrue(energy(run) > least * before, "left: " + energy(run) / before);
  }

  @Test
  void heavyChainsKeepTheirLength() {
    SceneRun run = start("heavy_chains");
    List<Body<String>> links = dynamics(run);
    double shorter = 0;
    double longer = 0;
    for (int tick = 0; tick < 600; tick++) {
      run.step();
      Body<String> end = links.get(29);
      shorter = Math.max(shorter, Math.hypot(end.x() + 40, end.y()));
      end = links.get(129);
      longer = Math.max(longer, Math.hypot(end.x() - 20, end.y()));
    }
    assertTrue(shorter <= 31, "reach=" + shorter);
    assertTrue(longer <= 101, "reach=" + longer);
  }

  @Test
  void sensorsHearOfEveryShot() {
    SceneRun run = start("sensor_shots");
    EventLists<String> events = new EventLists<>();
    run.world().eventLists(events);
    List<Body<String>> bullets = dynamics(run);
    int passed = 0;
    int heard = 0;
    boolean inside = false;
    for (int tick = 0; tick < 300 || inside; tick++) {
      float[] before = new float[bullets.size()];
      for (int i = 0; i < before.length; i++) {
        before[i] = bullets.get(i).x();
      }
      run.step();
      inside = false;
      for (int i = 0; i < before.length; i++) {
        float x = bullets.get(i).x();
        passed += x * before[i] < 0 ? 1 : 0;
        inside |= Math.abs(x) < 0.7f;
      }
      heard += events.sensorBegins().count();
    }
    assertTrue(passed > 20 * 15, "passed=" + passed);
    assertEquals(passed, heard);
  }

  @Test
  void everyPaddleHitsItsBullet() {
    SceneRun run = start("paddles");
    run.steps(28);
    List<Body<String>> bullets = dynamics(run);
    assertEquals(20, bullets.size());
    for (Body<String> b : bullets) {
      assertTrue(b.velocityX() > 99, b.toString());
    }
  }
}
