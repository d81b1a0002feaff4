package carom.lab.trace;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.List;

/** Records scenes of the library as traces for the codec. */
public final class SceneTrace {
  private SceneTrace() {}

  /**
   * Records the dynamic and kinematic bodies that a scene begins with.
   *
   * @param name see {@link Scenes#get}
   * @param seconds how long, at least 1
   * @throws IllegalArgumentException if there is no such scene, its bodies come and go, or they are
   *     more than a trace of 2 GB holds
   */
  public static Trace of(String name, int seconds) {
    Scene scene = Scenes.get(name);
    SceneRun run = scene.start();
    List<Body<String>> bodies = new ArrayList<>();
    run.world()
        .forEachBody(
            body -> {
              if (body.type() != BodyType.STATIC) {
                bodies.add(body);
              }
            });
    int ticks = seconds * scene.tickRate();
    long count = (long) bodies.size() * ticks * TraceCodec.FULL;
    if (count == 0 || bodies.size() > TraceCodec.MAX_BODIES || count > Integer.MAX_VALUE / 4 - 16) {
      throw new IllegalArgumentException(
          "scene="
              + name
              + ": bodies="
              + bodies.size()
              + " for seconds="
              + seconds
              + " don't fit into a trace of 2 GB; take fewer seconds");
    }
    float[] numbers = new float[(int) count];
    int at = 0;
    for (int tick = 0; tick < ticks; tick++) {
      run.step();
      for (Body<String> body : bodies) {
        if (!body.isValid()) {
          throw new IllegalArgumentException(
              "scene=" + name + ": its bodies come and go; a trace's don't");
        }
        numbers[at++] = body.x();
        numbers[at++] = body.y();
        numbers[at++] = body.angle();
        numbers[at++] = body.velocityX();
        numbers[at++] = body.velocityY();
        numbers[at++] = body.angularVelocity();
      }
    }
    return Trace.of(bodies.size(), scene.tickRate(), numbers);
  }
}
