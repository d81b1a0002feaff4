package carom.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Circle;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: a server that is updated reads the checkpoints and saved matches of the build before, and
 * one that can't says so by the layout's number. Method: the state of a match with all that a state
 * can hold, as it was written in the past.
 *
 * <p>If this fails, the layout of states has changed. Raise {@link SimState#LAYOUT}, and write the
 * file anew by {@code ./gradlew test --tests StateLayoutTest -Dcarom.renew=true}. Arithmetic
 * doesn't matter here: no tick is computed.
 */
final class StateLayoutTest {
  private static final String FOLDER = "src/test/resources/states";
  private static final String FILE = "layout-" + SimState.LAYOUT + ".state";

  private static final String LEVEL =
      """
      {"name": "all", "game": "all", "gravity": [0, -10],
       "bounds": {"min": [-20, -8], "max": [20, 20]},
       "spawns": [{"at": [-6, 3]}, {"at": [6, 3]}],
       "pools": [{"type": "water", "name": "basin", "min": [-12, -5], "max": [-4, 4], "spacing": 0.4,
         "most": 200, "fill": [{"min": [-12, -5], "max": [-8, -3]}]}],
       "statics": [
         {"at": [0, -6], "shape": {"type": "box", "width": 40, "height": 2}},
         {"at": [-13, 0], "shape": {"type": "box", "width": 2, "height": 12}}],
       "bodies": [
         {"name": "plank", "at": [4, 2], "shape": {"type": "box", "width": 0.9, "height": 0.2},
          "repeat": {"columns": 3, "step": [1, 0]}},
         {"name": "crate", "at": [0, -4.5], "shape": {"type": "box", "width": 1, "height": 1},
          "repeat": {"rows": 3, "step": [0, 1]}}],
       "joints": [
         {"type": "revolute", "b": "plank[0]", "at": [3.5, 2]},
         {"type": "revolute", "a": "plank[0]", "b": "plank[1]", "at": [4.5, 2],
          "breaks": {"force": 900}},
         {"type": "rope", "b": "plank[2]", "from": [7, 4], "to": [6.5, 2], "length": 2.5}]}
      """;

  private static final Count AMMO = Field.count("ammo", 0, 9).of(Scope.PLAYER);
  private static final Flag SECRET = Field.flag("secret").of(Scope.MATCH).to(Audience.NOBODY);
  private static final Ratio FUEL = Field.ratio("fuel").of(Scope.ENTITY).startsAt(1);
  private static final EntityRef TARGET = Field.entity("target").of(Scope.PLAYER);

  private static final class AllGame extends PlainGame {
    private Archetype ball;

    AllGame() {
      super("all");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(AMMO, SECRET, FUEL, TARGET);
    }

    @Override
    public boolean looksBack() {
      return true;
    }

    @Override
    public void setUp(SetUp s) {
      ball =
          s.archetype(
              new ArchetypeDef("ball").shape(new Circle(0.4f), new Material(1, 0.3f, 0.5f)));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(ball, 2 - p.id(), 5, 0, p);
      p.set(AMMO, 3 + p.id());
      p.set(TARGET, p.entity());
      p.entity().set(FUEL, 0.25f);
      s.set(SECRET, true);
    }
  }

  private static SimulationHost start() throws LevelException {
    Level level = Level.parse("all", LEVEL.getBytes(StandardCharsets.UTF_8));
    return new SimulationHost(new AllGame(), level, 7, 60, Role.AUTHORITY);
  }

  private static byte[] bytes(SimulationHost s) {
    ArchiveWriter out = new ArchiveWriter();
    s.save(null).write(out);
    return out.toBytes();
  }

  @Test
  void aStateOfThePastIsReadAndWrittenAsItWas() throws Exception {
    if (Boolean.getBoolean("carom.renew")) {
      SimulationHost s = start();
      s.join("Ann");
      s.join("Zoë");
      for (int i = 0; i < 90; i++) {
        s.step();
      }
      Files.createDirectories(Path.of(FOLDER));
      Files.write(Path.of(FOLDER, FILE), bytes(s));
      return;
    }
    byte[] past;
    try (InputStream in = getClass().getResourceAsStream("/states/" + FILE)) {
      assertNotNull(in, FILE + " is missing; write it with -Dcarom.renew=true");
      past = in.readAllBytes();
    }
    SimulationHost s = start();
    s.restore(s.read(new ArchiveReader(past)));
    assertEquals(90, s.tick());
    assertEquals("Zoë", s.participant(1).name());
    assertEquals(4, s.participant(1).get(AMMO));
    assertEquals(0.25f, s.participant(0).entity().get(FUEL), 0.01f);
    assertArrayEquals(past, bytes(s), "the layout of states has changed: see this class");
  }
}
