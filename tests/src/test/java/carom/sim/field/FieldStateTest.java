package carom.sim.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.Role;
import carom.sim.SetUp;
import carom.sim.SimState;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.entity.Contact;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Values of fields in a simulation: written, counted down, hashed, saved, restored, refused. */
final class FieldStateTest {
  private static final Count AMMO = Field.count("ammo", 0, 9).startsAt(5);
  private static final Countdown RELOAD = Field.countdown("reload");
  private static final Flag SECRET = Field.flag("secret").to(Audience.NOBODY);
  private static final EntityRef TARGET = Field.entity("target");
  private static final Ratio FUEL = Field.ratio("fuel").of(Scope.ENTITY).startsAt(1);
  private static final PlayerRef TOUCHED = Field.player("touched").of(Scope.ENTITY);
  private static final PlayerRef KING = Field.player("king").of(Scope.MATCH);
  private static final Count GOALS = Field.count("goals", 0, 99).of(Scope.MATCH).times(2);
  private static final List<Field<?>> ALL =
      List.of(AMMO, RELOAD, SECRET, TARGET, FUEL, TOUCHED, KING, GOALS);

  /** Balls without gravity, and callbacks that a test gives. */
  private static final class Balls extends PlainGame {
    private final List<Field<?>> fields;
    private Archetype ball;
    private Runnable inInput = () -> {};
    private Runnable inCollision = () -> {};
    private Runnable inHit = () -> {};

    Balls(List<Field<?>> fields) {
      super("balls");
      this.fields = fields;
    }

    @Override
    public List<Field<?>> fields() {
      return fields;
    }

    @Override
    public void setUp(SetUp s) {
      ball =
          s.archetype(new ArchetypeDef("ball").shape(new Circle(0.5f), new Material(1, 0, 0.5f)));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(ball, 3 * p.id(), 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      inInput.run();
    }

    @Override
    public boolean collision(Simulation s, Contact c) {
      inCollision.run();
      return true;
    }

    @Override
    public void hit(Simulation s, Contact c) {
      inHit.run();
    }
  }

  private final Balls game = new Balls(ALL);

  private static SimulationHost start(Game game, Role role) {
    String json =
        "{\"name\":\"t\",\"game\":\"balls\",\"gravity\":[0,0],\"bounds\":{\"min\":[-9,-9],"
            + "\"max\":[9,9]},\"statics\":[{\"at\":[0,-8],\"shape\":{\"type\":\"box\","
            + "\"width\":9,\"height\":1}}]}";
    try {
      return new SimulationHost(
          game, Level.parse("t", json.getBytes(StandardCharsets.UTF_8)), 7, 60, role);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void valuesStartAsDeclaredAndStopAtTheirLimits() {
    SimulationHost s = start(game, Role.AUTHORITY);
    HostPlayer p = s.join("ann");
    assertEquals(5, p.get(AMMO));
    assertEquals(1, p.entity().get(FUEL));
    p.add(AMMO, -20);
    assertEquals(0, p.get(AMMO));
    p.add(AMMO, Integer.MAX_VALUE);
    assertEquals(9, p.get(AMMO));
    assertThrows(IllegalArgumentException.class, () -> p.set(AMMO, 10));
    assertThrows(IllegalArgumentException.class, () -> p.entity().set(FUEL, -0.1f));
    assertEquals(9, p.get(AMMO), "what is refused changes nothing");
    p.resetFields();
    assertEquals(5, p.get(AMMO));
    assertThrows(IllegalArgumentException.class, () -> p.get(GOALS, 0));
  }

  @Test
  void aCountdownRunsDownByItselfAndChangesOnlyWhenSet() {
    SimulationHost s = start(game, Role.AUTHORITY);
    HostPlayer p = s.join("ann");
    p.set(RELOAD, 3);
    long stamp = p.fieldValues().stamp();
    for (int left = 3; left >= 0; left--) {
      assertEquals(left, p.get(RELOAD));
      s.step();
    }
    assertEquals(0, p.get(RELOAD));
    assertEquals(stamp, p.fieldValues().stamp());
  }

  @Test
  void referencesMeanNobodyOnceTheirTargetIsGone() {
    SimulationHost s = start(game, Role.AUTHORITY);
    HostPlayer ann = s.join("ann");
    HostPlayer bob = s.join("bob");
    ann.set(TARGET, bob.entity());
    ann.entity().set(TOUCHED, bob);
    s.set(KING, bob);
    assertSame(bob.entity(), ann.get(TARGET));
    assertSame(bob, ann.entity().get(TOUCHED));
    assertSame(bob, s.get(KING));
    s.leave(bob);
    s.join("eve"); // has bob's id, and her body the id of his
    assertNull(ann.get(TARGET));
    assertNull(ann.entity().get(TOUCHED));
    assertNull(s.get(KING));
  }

  @Test
  void levelGeometryHasTheStartValuesAndRefusesWrites() {
    SimulationHost s = start(game, Role.AUTHORITY);
    HostEntity wall = s.statics().get(0);
    assertEquals(1, wall.get(FUEL));
    String message =
        assertThrows(IllegalStateException.class, () -> wall.set(FUEL, 0.5f)).getMessage();
    assertTrue(message.contains("entity.fuel"), message);
    HostPlayer p = s.join("ann");
    assertThrows(IllegalArgumentException.class, () -> p.set(TARGET, wall));
  }

  @Test
  void aClientTakesOnlyTheWritesThatItCanPredict() {
    SimulationHost s = start(game, Role.PREDICTION);
    HostPlayer own = s.mirror().join(0, "ann");
    HostPlayer other = s.mirror().join(1, "bob");
    HostEntity body = s.mirror().spawn(0, 0, game.ball, 0, 0, 0, 0);
    s.mirror().spawn(1, 0, game.ball, 0.9f, 0, 0, HostEntity.NO_OWNER).body().setVelocity(-9, 0);
    List<String> hits = new ArrayList<>();
    game.inHit =
        () -> {
          own.set(AMMO, 9);
          hits.add("hit");
        };
    game.inInput =
        () -> {
          own.add(AMMO, -1);
          own.set(SECRET, true);
          body.set(FUEL, 0.5f);
          other.set(AMMO, 0);
          s.set(GOALS, 0, 3);
        };
    s.step();
    assertEquals(List.of("hit"), hits);
    assertEquals(4, own.get(AMMO));
    assertEquals(0.5f, body.get(FUEL), 1e-4f);
    assertEquals(false, own.get(SECRET), "only the server is told");
    assertEquals(5, other.get(AMMO));
    assertEquals(0, s.get(GOALS, 0));
    own.set(AMMO, 1);
    assertEquals(4, own.get(AMMO), "between steps the server's word counts alone");
    own.fieldValues().mirror(s.schema().word(AMMO, Scope.PLAYER), 1);
    assertEquals(1, own.get(AMMO));
  }

  @Test
  void collisionMustChangeNothing() {
    SimulationHost s = start(game, Role.AUTHORITY);
    HostPlayer p = s.join("ann");
    s.spawn(game.ball, 0.5f, 0, 0, null);
    game.inCollision = () -> p.add(AMMO, 1);
    String message = assertThrows(IllegalStateException.class, s::step).getMessage();
    assertTrue(message.contains("player.ammo can't be written in Game.collision"), message);
    p.add(AMMO, 1);
    assertEquals(6, p.get(AMMO), "after the step writes count again");
  }

  @Test
  void savedReadAndRestoredStatesHaveTheSameValuesAndHashes() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    String message = "seed=" + seed;
    for (int round = 0; round < 40; round++) {
      SimulationHost s = start(new Balls(ALL), Role.AUTHORITY);
      for (int i = 0; i < 1 + random.nextInt(5); i++) {
        s.join("p" + i);
      }
      change(s, random);
      long hash = s.stateHash();
      SimState saved = s.save(null);
      ArchiveWriter archive = new ArchiveWriter();
      saved.write(archive);
      byte[] bytes = Arrays.copyOf(archive.array(), archive.length());
      SimulationHost fresh = start(new Balls(ALL), Role.AUTHORITY);
      fresh.restore(fresh.read(new ArchiveReader(bytes)));
      assertEquals(hash, fresh.stateHash(), message);
      change(s, random);
      s.step();
      s.restore(saved);
      assertEquals(hash, s.stateHash(), message);
      for (int id = 0; id < s.playerCapacity(); id++) {
        assertEquals(
            s.player(id).fieldValues().toString(),
            fresh.player(id).fieldValues().toString(),
            message);
      }
      assertEquals(s.fieldValues().toString(), fresh.fieldValues().toString(), message);
      s.add(GOALS, 1, s.get(GOALS, 1) == 99 ? -1 : 1);
      assertNotEquals(hash, s.stateHash(), message);
    }
  }

  /** Gives every word of every target a random value of its range. */
  private static void change(SimulationHost s, Random random) {
    List<FieldValues> targets = new ArrayList<>(List.of(s.fieldValues()));
    for (int id = 0; id < s.playerCapacity(); id++) {
      targets.add(s.player(id).fieldValues());
      targets.add(s.player(id).entity().fieldValues());
    }
    for (FieldValues values : targets) {
      for (int i = 0; i < values.size(); i++) {
        Field<?> field = s.schema().field(values.scope(), i);
        values.mirror(
            i, field.min() + (int) (random.nextDouble() * (1L + field.max() - field.min())));
      }
    }
  }

  @Test
  void aStateOfOtherFieldsOrWithADamagedValueIsRefusedByName() {
    SimulationHost s = start(game, Role.AUTHORITY);
    s.join("ann");
    ArchiveWriter archive = new ArchiveWriter();
    s.save(null).write(archive);
    byte[] bytes = Arrays.copyOf(archive.array(), archive.length());
    List<Field<?>> others = new ArrayList<>(ALL);
    others.set(0, Field.count("ammo", 0, 8).startsAt(5));
    String other =
        assertThrows(
                ArchiveException.class,
                () -> start(new Balls(others), Role.AUTHORITY).read(new ArchiveReader(bytes)))
            .getMessage();
    assertTrue(other.contains("field player.ammo is"), other);
    int refused = 0;
    for (int at = 0; at < bytes.length; at++) {
      byte[] damaged = bytes.clone();
      damaged[at] ^= (byte) 0x80;
      try {
        s.read(new ArchiveReader(damaged));
      } catch (ArchiveException e) {
        refused++;
      }
    }
    assertTrue(refused > bytes.length / 4, "refused=" + refused + " of " + bytes.length);
  }

  @Test
  void aFieldThatIsNotDeclaredIsRefusedByName() {
    SimulationHost s = start(new Balls(List.of(AMMO)), Role.AUTHORITY);
    String message = assertThrows(IllegalArgumentException.class, () -> s.get(KING)).getMessage();
    assertEquals("field match.king isn't declared; return it from Game.fields", message);
  }
}
