package carom.game;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.Role;
import carom.sim.SetUp;
import carom.sim.SimulationHost;
import carom.sim.entity.AssemblyDef;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.message.MessageKind;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Goal: of two things that are known by their name, the second is refused by name and line. */
class SetUpTest {
  private static final String YARD =
      """
      { "name": "Yard", "game": "twice", "gravity": [0, 0],
        "bounds": { "min": [-9, -9], "max": [9, 9] },
        "bodies": [{ "name": "pin", "at": [3, 0], "shape": { "type": "circle", "radius": 1 } }] }
      """;

  private static final Map<String, Consumer<SetUp>> WAYS =
      Map.of(
          "archetype=pin", s -> s.archetype(disc()),
          "event=pin", s -> s.event("pin", 0, 1, ""),
          "assembly=pin", s -> s.assembly(new AssemblyDef("pin").body("hub", disc(), 0, 0)),
          "message kind pin", s -> s.message(MessageKind.named("pin").fromClient()));

  private static ArchetypeDef disc() {
    return new ArchetypeDef("pin").shape(new Circle(1), new Material(1, 0, 0));
  }

  /** Registers something in each of the ways. */
  private static final class Twice extends PlainGame {
    private final List<Consumer<SetUp>> ways;

    Twice(List<Consumer<SetUp>> ways) {
      super("twice", "yard");
      this.ways = ways;
    }

    @Override
    public void setUp(SetUp s) {
      ways.forEach(way -> way.accept(s));
    }
  }

  private static SimulationHost start(List<Consumer<SetUp>> ways) {
    try {
      Level yard = Level.parse("yard", YARD.getBytes(UTF_8));
      return new SimulationHost(new Twice(ways), yard, 1, 60, Role.AUTHORITY);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void thingsOfOneSortHaveNamesOfTheirOwn() {
    WAYS.forEach(
        (name, way) -> {
          var refused =
              assertThrows(IllegalArgumentException.class, () -> start(List.of(way, way)), name);
          String words = GameFault.refusal(Twice.class, refused);
          assertTrue(words.startsWith(name) && words.contains(SetUpTest.class.getName()), words);
        });
  }

  @Test
  void thingsOfSeveralSortsAndPiecesOfTheLevelMayShareAName() {
    SimulationHost s = start(List.copyOf(WAYS.values()));
    assertEquals("pin", s.entity(0).archetype().name());
  }
}
