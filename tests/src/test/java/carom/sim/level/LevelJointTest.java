package carom.sim.level;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.arena.ArenaGame;
import carom.physics.JointType;
import carom.sim.Role;
import carom.sim.SchemaChecker;
import carom.sim.SimulationHost;
import carom.sim.entity.EntityJoint;
import carom.text.Json;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Joints in level files. */
final class LevelJointTest {
  private static final String FILE =
      """
      {"name": "t", "game": "arena", "gravity": [0, -10],
       "bounds": {"min": [-20, -20], "max": [20, 20]},
       "spawns": [{"name": "ball", "at": [0, 9]}],
       "zones": [
         {"name": "goal", "team": 1, "min": [-20, -2], "max": [-19, 2]},
         {"name": "goal", "team": 2, "min": [19, -2], "max": [20, 2]},
         {"name": "home", "team": 1, "min": [-8, -4], "max": [-4, 4]},
         {"name": "home", "team": 2, "min": [4, -4], "max": [8, 4]}],
       "statics": [{"name": "post", "at": [-6, 0], "shape": {"type": "circle", "radius": 0.2}}],
       "bodies": [
         {"name": "plank", "at": [-5, 0], "shape": {"type": "box", "width": 0.9, "height": 0.2},
          "repeat": {"columns": 4, "step": [1, 0]}},
         {"name": "wheel", "at": [3, 0], "shape": {"type": "circle", "radius": 0.4}},
         {"name": "cog", "at": [5, 0], "shape": {"type": "circle", "radius": 0.4}}],
       "joints": [%s]}
      """;

  private static Level level(String joints) throws Exception {
    return Level.parse("t.json", FILE.formatted(joints).getBytes(UTF_8));
  }

  private static final String ALL =
      """
      {"type": "revolute", "name": "hinge", "a": "post", "b": "plank[0]", "at": [-5.5, 0],
       "limits": [-30, 45], "breaks": {"force": 5000}},
      {"type": "distance", "a": "plank[0]", "b": "plank[1]", "from": [-5, 0], "to": [-4, 0],
       "spring": {"hertz": 4, "damping": 0.5}},
      {"type": "rope", "b": "plank[1]", "from": [-4, 3], "to": [-4, 0], "length": 3.5},
      {"type": "weld", "a": "plank[2]", "b": "plank[3]", "at": [-2.5, 0]},
      {"type": "prismatic", "b": "plank[3]", "at": [-2, 0], "axis": [0, 1], "limits": [-1, 1],
       "motor": {"speed": 1, "max": 50}},
      {"type": "wheel", "a": "plank[3]", "b": "wheel", "at": [3, 0], "axis": [0, 1],
       "motor": {"speed": 90, "max": 20}, "spring": {"hertz": 3}},
      {"type": "motor", "b": "cog", "maxForce": 10, "maxTorque": 5},
      {"type": "mouse", "b": "cog", "at": [5, 0], "maxForce": 10},
      {"type": "gear", "a": "wheel", "b": "cog", "ratio": -1},
      {"type": "rack", "a": "cog", "b": "plank[3]", "axis": [1, 0], "ratio": 0.4},
      {"type": "pulley", "a": "plank[0]", "b": "plank[1]", "from": [-5, 0], "to": [-4, 0],
       "groundFrom": [-5, 5], "groundTo": [-4, 5], "ratio": 1},
      {"type": "ratchet", "name": "winch", "b": "wheel", "at": [3, 0], "tooth": -30,
       "motor": {"speed": -90, "max": 20}},
      {"type": "groove", "name": "slot", "a": "plank[2]", "b": "cog", "from": [-3.4, 0],
       "to": [-2.6, 0], "at": [5, 0]},
      {"type": "friction", "name": "drag", "b": "cog", "at": [5, 0], "maxForce": 5,
       "maxTorque": 2},
      {"type": "distance", "name": "piston", "b": "cog", "from": [5, 4], "to": [5, 0],
       "limits": [1, 5], "motor": {"speed": 0.5, "max": 40}}
      """;

  @Test
  void everyTypeOfJointIsRead() throws Exception {
    Level level = level(ALL);
    assertEquals("", SchemaChecker.levels().check(Json.parse(FILE.formatted(ALL).getBytes(UTF_8))));
    SimulationHost s = new SimulationHost(new ArenaGame(), level, 1, 60, Role.AUTHORITY);
    Set<JointType> seen = EnumSet.noneOf(JointType.class);
    for (int i = 0; i < level.joints().size(); i++) {
      seen.add(s.world().joint(i).type());
    }
    assertEquals(EnumSet.allOf(JointType.class), seen);
    EntityJoint hinge = s.joint("hinge");
    assertEquals("post", hinge.a().archetype().name());
    assertEquals(s.entity(0), hinge.b());
    assertEquals(Math.toRadians(45), hinge.upper(), 1e-5);
    assertEquals(-5.5f, hinge.anchorBX(), 1e-5f);
    assertEquals(Math.toRadians(-30), s.joint("winch").ratio(), 1e-5);
    assertEquals(0, s.joint("winch").toothAngle());
    assertEquals(JointType.WHEEL, s.joint("slot").type());
    assertEquals(0.8, s.joint("slot").upper() - s.joint("slot").lower(), 1e-5);
    assertTrue(s.joint("drag").isDriven());
    assertEquals(0.5f, s.joint("piston").motorSpeed());
    String message =
        assertThrows(IllegalArgumentException.class, () -> s.joint("door")).getMessage();
    assertTrue(message.contains("door"), message);
    for (int i = 0; i < 120; i++) {
      s.step();
    }
    assertNotNull(s.joint("hinge"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "{\"type\": \"hinge\", \"b\": \"wheel\"} | joints[0].type=\"hinge\" must be one of"
            + " [revolute",
        "{\"type\": \"revolute\", \"b\": \"whel\", \"at\": [0, 0]} | did you mean \"wheel\"?",
        "{\"type\": \"revolute\", \"b\": \"wheel\"} | joints[0].at is missing",
        "{\"type\": \"revolute\", \"at\": [0, 0]} | joints[0].b is missing",
        "{\"type\": \"revolute\", \"b\": \"plank\", \"at\": [0, 0]} | has 4 bodies; write plank[0]",
        "{\"type\": \"revolute\", \"b\": \"plank[4]\", \"at\": [0, 0]} | must have a number in"
            + " 0..3",
        "{\"type\": \"revolute\", \"b\": \"plank[x]\", \"at\": [0, 0]} | must have a number in"
            + " 0..3",
        "{\"type\": \"revolute\", \"b\": \"post\", \"at\": [0, 0]} | holds no dynamic body",
        "{\"type\": \"revolute\", \"a\": \"cog\", \"b\": \"cog\", \"at\": [0, 0]} | needs two"
            + " bodies",
        "{\"type\": \"revolute\", \"b\": \"cog\", \"at\": [0, 0], \"axis\": [1, 0]} |"
            + " joints[0].axis is unknown",
        "{\"type\": \"revolute\", \"b\": \"cog\", \"at\": [0, 0], \"limits\": [9, 1]} | upper",
        "{\"type\": \"revolute\", \"b\": \"cog\", \"at\": [0, 0], \"breaks\": {}} | neither"
            + " \"force\" nor",
        "{\"type\": \"revolute\", \"b\": \"cog\", \"at\": [0, 0], \"motor\": {\"speed\": 1}} |"
            + " motor.max is missing",
        "{\"type\": \"wheel\", \"b\": \"cog\", \"at\": [0, 0], \"axis\": [0, 0]} | is not a"
            + " direction",
        "{\"type\": \"gear\", \"b\": \"cog\", \"ratio\": 1} | joints[0].a is missing",
        "{\"type\": \"ratchet\", \"b\": \"cog\", \"at\": [5, 0]} | joints[0].tooth is missing",
        "{\"type\": \"ratchet\", \"b\": \"cog\", \"at\": [5, 0], \"tooth\": 0} | tooth=0.0",
        "{\"type\": \"groove\", \"b\": \"cog\", \"at\": [5, 0], \"from\": [1, 1], \"to\": [1, 1]}"
            + " | length=0.0",
        "{\"type\": \"friction\", \"b\": \"cog\", \"at\": [5, 0], \"maxForce\": 1} |"
            + " joints[0].maxTorque is missing",
      })
  void whatIsWrongIsNamedWithItsPlace(String joint, String expected) {
    String message = assertThrows(LevelException.class, () -> level(joint)).getMessage();
    assertTrue(message.contains(expected), message);
    assertTrue(message.startsWith("t.json:"), message);
  }
}
