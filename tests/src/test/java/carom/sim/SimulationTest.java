package carom.sim;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.Body;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Circle;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.level.ScriptedMotion;
import carom.sim.outbox.Outbox;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SimulationTest {
  private static final Count STEPS = Field.count("steps", 0, 1_000_000);
  private static final Flag DOOR = Field.flag("door").of(Scope.MATCH);
  private static final Ratio FUEL = Field.ratio("fuel").of(Scope.ENTITY);

  /** Does nothing but register one kind. */
  private static final class Quiet extends PlainGame {
    Archetype disc;

    Quiet() {
      super("quiet");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(STEPS, DOOR, FUEL);
    }

    @Override
    public void setUp(SetUp s) {
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0)));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, p.id(), 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.add(STEPS, 1);
    }
  }

  private final Quiet game = new Quiet();

  private SimulationHost start(Role role, String bodies) {
    String json =
        "{\"name\":\"t\",\"game\":\"quiet\",\"gravity\":[0,0],"
            + "\"bounds\":{\"min\":[-9,-9],\"max\":[9,9]},\"statics\":[{\"at\":[0,-8],"
            + "\"shape\":{\"type\":\"box\",\"width\":9,\"height\":1}}],\"bodies\":["
            + bodies
            + "]}";
    try {
      return new SimulationHost(game, Level.parse("t", json.getBytes(UTF_8)), 7, 60, role);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void givesTheSmallestFreeIdWithAnotherGeneration() {
    SimulationHost s = start(Role.AUTHORITY, "");
    HostEntity a = s.spawn(game.disc, 0, 0, 0, null);
    HostEntity b = s.spawn(game.disc, 2, 0, 0, null);
    s.spawn(game.disc, 4, 0, 0, null);
    assertEquals(1, b.id());
    s.despawn(b);
    s.despawn(a);
    assertNull(s.entity(0));
    HostEntity again = s.spawn(game.disc, 0, 0, 0, null);
    assertEquals(0, again.id());
    assertEquals(1, again.generation());
    s.despawn(a); // the old handle harms nobody
    assertSame(again, s.entity(0));
    assertEquals(1, s.spawn(game.disc, 2, 0, 0, null).id());
    assertEquals(3, s.entityCount());
  }

  @Test
  void generationsWrapAtTwoHundredAndFiftySix() {
    SimulationHost s = start(Role.AUTHORITY, "");
    for (int i = 0; i < 300; i++) {
      HostEntity e = s.spawn(game.disc, 0, 0, 0, null);
      assertEquals(0, e.id());
      assertEquals(i & 0xff, e.generation());
      s.despawn(e);
    }
  }

  @Test
  void staticsComeFirstOnBothRolesAndHaveNoId() {
    SimulationHost server = start(Role.AUTHORITY, "");
    SimulationHost client = start(Role.PREDICTION, "");
    assertEquals(1, client.statics().size());
    assertTrue(client.statics().get(0).isLevel());
    assertEquals(server.statics().get(0).body().index(), client.statics().get(0).body().index());
    assertNull(client.entity(HostEntity.LEVEL));
  }

  @Test
  void aPredictionOnlyMirrors() {
    SimulationHost s = start(Role.PREDICTION, "");
    assertThrows(IllegalStateException.class, () -> s.spawn(game.disc, 0, 0, 0, null));
    assertThrows(IllegalStateException.class, () -> s.join("ann"));
    HostPlayer p = s.mirror().join(200, "ann");
    assertThrows(IllegalStateException.class, () -> p.score(1));
    assertNull(p.entity());
    HostEntity e = s.mirror().spawn(500, 9, game.disc, 1, 2, 0, 200);
    assertSame(e, p.entity());
    assertSame(p, e.owner());
    assertEquals(501, s.entityCapacity());
    assertThrows(
        IllegalStateException.class, () -> s.mirror().spawn(500, 10, game.disc, 0, 0, 0, 200));
    s.despawn(e);
    assertNull(p.entity());
    s.notice("nobody hears this");
    s.outbox().drainNotices(text -> assertNull(text));
  }

  @Test
  void thePredictionRefusesWhatTheServerAlone() {
    SimulationHost s = start(Role.AUTHORITY, "");
    assertThrows(IllegalStateException.class, () -> s.mirror().tick(5));
    assertThrows(IllegalStateException.class, () -> s.mirror().join(0, "ann"));
    assertThrows(IllegalStateException.class, () -> s.mirror().spawn(0, 0, game.disc, 0, 0, 0, -1));
  }

  @Test
  void everythingThatDecidesTheFutureIsInTheHash() {
    List<Runnable> changes = new ArrayList<>();
    SimulationHost s = start(Role.AUTHORITY, "");
    HostPlayer p = s.join("ann");
    changes.add(() -> p.score(1));
    changes.add(() -> p.team(2));
    changes.add(() -> p.set(STEPS, 7));
    changes.add(() -> p.input().hold(Input.JUMP, true));
    changes.add(() -> s.set(DOOR, true));
    changes.add(() -> p.entity().set(FUEL, 0.5f));
    changes.add(() -> s.random().nextLong());
    changes.add(() -> p.entity().tag(4));
    changes.add(() -> p.entity().body().setVelocity(1, 0));
    changes.add(() -> s.spawn(game.disc, 5, 5, 0, null));
    changes.add(() -> s.despawn(s.entity(1)));
    changes.add(s::step);
    SimState start = s.save(null);
    long hash = s.stateHash();
    for (Runnable change : changes) {
      long before = s.stateHash();
      change.run();
      assertNotEquals(before, s.stateHash());
    }
    s.restore(start);
    assertEquals(hash, s.stateHash());
    assertEquals(0, p.score());
    assertEquals(0, p.entity().tag());
  }

  @Test
  void restoreBringsBackWhoHasGoneAndRemovesWhoCame() {
    SimulationHost s = start(Role.AUTHORITY, "");
    HostPlayer ann = s.join("ann");
    HostEntity body = ann.entity();
    SimState saved = s.save(null);
    s.leave(ann);
    HostPlayer bob = s.join("bob");
    s.join("cy");
    assertEquals(0, bob.id());
    s.restore(saved);
    assertSame(ann, s.player(0));
    assertSame(body, ann.entity());
    assertTrue(body.body().isValid());
    assertSame(body, body.body().user());
    assertEquals(1, s.playerCapacity());
    assertEquals(1, s.entityCount());
    assertFalse(s.entityCapacity() > 1);
    s.step();
    assertThrows(IllegalArgumentException.class, () -> start(Role.AUTHORITY, "").restore(saved));
  }

  @Test
  void pathsAreAFunctionOfTheTick() {
    String path =
        "{\"type\":\"kinematic\",\"at\":[-3,1],\"shape\":{\"type\":\"circle\",\"radius\":1},"
            + "\"motion\":{\"to\":[3,4],\"period\":4}}";
    SimulationHost s = start(Role.AUTHORITY, path);
    ScriptedMotion m = s.entity(0).archetype().motion();
    for (int tick = 1; tick <= 600; tick++) {
      s.step();
      assertEquals(m.x(tick, 60), s.entity(0).body().x(), 1e-4f);
      assertEquals(m.y(tick, 60), s.entity(0).body().y(), 1e-4f);
    }
    assertEquals(-3, m.x(240, 60));
    assertEquals(3, m.x(120, 60));
    assertEquals(4, m.y(360, 60));
  }

  @Test
  void noticesAreBounded() {
    SimulationHost s = start(Role.AUTHORITY, "");
    for (int i = 0; i < 20; i++) {
      s.notice("n" + i + "x".repeat(200));
    }
    List<String> heard = new ArrayList<>();
    s.outbox().drainNotices(heard::add);
    assertEquals(Outbox.MAX_NOTICES, heard.size());
    assertEquals(Outbox.MAX_NOTICE_LENGTH, heard.get(0).length());
    assertEquals(4, s.outbox().droppedNotices());
  }

  @Test
  void thousandAndTwentyFourPlayersAreEnough() {
    SimulationHost s = start(Role.AUTHORITY, "");
    for (int i = 0; i < SimulationHost.MAX_PLAYERS; i++) {
      s.join("p" + i);
    }
    IllegalStateException e = assertThrows(IllegalStateException.class, () -> s.join("late"));
    assertTrue(e.getMessage().contains("1024"), e.getMessage());
  }

  @Test
  void suggestsWhatWasMeant() {
    assertEquals("friction", Suggestion.nearest("frction", List.of("density", "friction")));
    assertEquals("at", Suggestion.nearest("ta", List.of("at", "zones")));
    assertNull(Suggestion.nearest("xyzzy", List.of("density", "friction")));
  }

  @Test
  void locksAndSleepSpeedsOfAnArchetypeAreThoseOfItsBodies() {
    MotionLocks locks = new MotionLocks(false, true, true);
    ArchetypeDef def = new ArchetypeDef("lift").shape(new Circle(0.5f), new Material(1, 0, 0));
    World<String> w = new World<>(new WorldDef());
    Archetype lift = new Archetypes().add(def.motionLocks(locks).sleepSpeed(0.5f));
    Body<String> body = w.createBody(lift.body(0, 3, 0), "lift");
    assertEquals(locks, body.motionLocks());
    assertEquals(0.5f, body.sleepSpeed());
    SimulationHost s =
        start(
            Role.AUTHORITY,
            "{\"at\":[1,2],\"lockX\":true,\"shape\":{\"type\":\"circle\",\"radius\":1}}");
    Body<HostEntity> ofLevel = s.entity(0).body();
    assertEquals(new MotionLocks(true, false, false), ofLevel.motionLocks());
    ofLevel.applyImpulse(3, 3);
    s.step();
    assertEquals(1f, ofLevel.x());
    assertTrue(ofLevel.y() > 2);
  }
}
