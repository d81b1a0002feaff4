package carom.client.look;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.WildCalls;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import java.lang.reflect.Executable;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * The law of refused calls, for views: a declaration that nobody means is refused by name and adds
 * nothing, or the look can be written with it.
 */
class ViewLawTest {
  private static final List<Class<?>> TYPES =
      List.of(
          ViewSetup.class,
          Action.class,
          Background.class,
          CameraSetup.class,
          HudItem.class,
          Particles.class,
          Reaction.class,
          Shake.class,
          SlowMotion.class,
          SoundFile.class,
          Sprite.class);

  /** What the window asks, each frame. */
  private static final Set<String> OF_WINDOWS =
      Set.of(
          "Particles.speed(float)",
          "Particles.seconds(float)",
          "Particles.size(float)",
          "SoundFile.pitch(float)",
          "Sprite.frame(float, double, double)",
          "ViewSetup.blow(String)",
          "ViewSetup.event(String)",
          "ViewSetup.trail(String)");

  private final long seed = Long.getLong("carom.seed", new Random().nextLong());
  private final Random random = new Random(seed);
  private final Set<String> faults = new TreeSet<>();

  @Test
  void aDeclarationThatNobodyMeansIsRefusedByNameOrWorks() {
    Count health = Field.count("health", 0, 100);
    Ratio ofEntities = Field.ratio("power").of(Scope.ENTITY);
    List<Executable> calls = WildCalls.of(TYPES);
    calls.removeIf(call -> OF_WINDOWS.contains(WildCalls.name(call)));
    int refused = 0;
    for (int round = 0; round < 80; round++) {
      ViewSetup setup = new ViewSetup();
      WildCalls wild = new WildCalls(random, "ball", "W", "left", "a.png");
      wild.see(setup, setup.camera(), setup.sprite("ball", "a.png"), setup.background("b.png"));
      wild.see(Action.button("jump", 1), Action.moveX("left", "right"), Particles.burst(4));
      wild.see(new Reaction(), Shake.by(0.3f), SlowMotion.last(1), SoundFile.of("a.wav"));
      wild.see(HudItem.bar("health", health), health, ofEntities);
      StringBuilder way = new StringBuilder();
      for (int i = 0; i < 30; i++) {
        String before = written(setup, "");
        WildCalls.Outcome outcome = wild.call(calls.get(random.nextInt(calls.size())));
        wild.see(outcome.result());
        way.append(outcome).append("; ");
        if (outcome.thrown() != null) {
          refused++;
          String complaint = WildCalls.complaint(outcome.thrown());
          if (complaint != null) {
            faults.add(outcome + ": " + complaint);
          }
          if (!before.equals(written(setup, ""))) {
            faults.add(outcome + " added something, and threw " + outcome.thrown());
          }
        } else {
          for (int k = 0; k < outcome.arguments().length; k++) {
            if (outcome.hasNull(k)) {
              faults.add(outcome + " took the null at " + k);
            }
          }
          written(setup, way.toString());
        }
      }
    }
    assertTrue(faults.isEmpty(), () -> "seed=" + seed + "\n" + String.join("\n", faults));
    assertTrue(refused > 300, "too few declarations were refused: " + refused);
  }

  /** Returns the look as the page gets it. */
  private String written(ViewSetup setup, String way) {
    try {
      return new String(LookWriter.write("wild", setup, Map.of("a.png", "a.png")), UTF_8);
    } catch (RuntimeException e) {
      faults.add("can't be written: " + e + " after " + way);
      return "";
    }
  }
}
