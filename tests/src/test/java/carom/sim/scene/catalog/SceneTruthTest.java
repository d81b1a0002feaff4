package carom.sim.scene.catalog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.SceneRun;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Scenes show what their descriptions promise. */
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
    int shots = 0;
    for (int tick = 0; tick < 1260; tick++) {
      run.step();
      int now = 0;
      for (Body<String> body : dynamics(run)) {
        if (!crates.contains(body)) {
          now++;
          assertTrue(body.x() < 4, "tick " + tick + " body " + body.index() + " x=" + body.x());
        }
      }
      shots = now;
    }
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
}
