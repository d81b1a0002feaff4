package carom.sim.spawn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.Material;
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
import carom.sim.entity.Entity;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** {@link SimulationHost#spawn} and {@link SimulationHost#despawn} in {@link Game#input}. */
final class SpawnInInputTest {
  private static final Count POWER = Field.count("power", 0, 100).of(Scope.ENTITY);
  private static final EntityRef LAST = Field.entity("last").to(Audience.OWNER);

  /** ACTION fires as many rockets as {@link #shots}; SECOND despawns all of the player's. */
  private static final class Rules extends PlainGame {
    Archetype man;
    Archetype rocket;
    int shots = 1;
    boolean foreign;
    boolean plain;
    private Match match;
    private Player last;

    Rules() {
      super("test");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(POWER, LAST);
    }

    @Override
    public void setUp(SetUp s) {
      man = s.archetype(disc("man", 0.5f));
      rocket = s.archetype(disc("rocket", 0.2f));
    }

    private static ArchetypeDef disc(String name, float radius) {
      return new ArchetypeDef(name).shape(new Circle(radius), new Material(1, 0.2f, 0));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(man, 4 * p.id(), 0, 0, p);
      match = s;
      last = p;
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      for (int i = 0; in.held(Input.ACTION) && i < shots; i++) {
        if (plain) {
          match.spawn(rocket, 0, 0); // kept from a callback of the server
        }
        Entity fired = (foreign ? last : p).spawn(rocket, p.entity().x(), 1 + i, 0);
        fired.setVelocity(0, 20);
        fired.set(POWER, 40);
        p.set(LAST, fired);
      }
      if (in.held(Input.SECOND)) {
        for (int i = p.spawnedCount() - 1; i >= 0; i--) {
          p.spawned(i).despawn();
        }
      }
    }
  }

  private final Rules rules = new Rules();

  private SimulationHost simulation(Role role) {
    String json =
        "{\"name\": \"test\", \"game\": \"test\", \"gravity\": [0, 0], \"bounds\": {\"min\": [-99,"
            + " -99], \"max\": [99, 99]}}";
    try {
      Level level = Level.parse("test.json", json.getBytes(StandardCharsets.UTF_8));
      return new SimulationHost(rules, level, 1, 60, role);
    } catch (carom.sim.level.LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns a client's simulation in which Ann has a body, as on the server. */
  private SimulationHost client(OwnSpawns own) {
    SimulationHost s = simulation(Role.PREDICTION);
    s.mirror().join(0, "Ann");
    s.mirror().spawn(0, 0, rules.man, 0, 0, 0, 0);
    s.mirror().ownSpawns(own);
    return s;
  }

  private static OwnSpawns told(int key) {
    return new OwnSpawns() {
      @Override
      public boolean predicts(int playerId) {
        return playerId == 0;
      }

      @Override
      public int key(int origin) {
        return key;
      }
    };
  }

  @Test
  void anEntityOfTheInputMovesInItsTickAndIsFoundAgain() {
    SimulationHost s = simulation(Role.AUTHORITY);
    HostPlayer ann = s.join("Ann");
    ann.input().hold(Input.ACTION, true);
    s.step();
    ann.input().hold(Input.ACTION, false);
    HostEntity rocket = ann.spawned(0);
    assertEquals(1, ann.spawnedCount());
    assertEquals(1 + 20 / 60f, rocket.body().y(), 1e-4f);
    assertEquals(Origin.of(1, 0), rocket.origin());
    assertEquals(40, rocket.get(POWER));
    assertSame(rocket, ann.get(LAST));
    assertFalse(rocket.isProvisional());
    ann.input().hold(Input.SECOND, true);
    s.step();
    assertEquals(0, ann.spawnedCount());
    assertNull(ann.get(LAST));
    assertEquals(1, s.entityCount());
  }

  @Test
  void aClientHasTheSameEntityAtOnceUnderItsOrigin() {
    SimulationHost server = simulation(Role.AUTHORITY);
    SimulationHost client = client(told(OwnSpawns.UNKNOWN));
    HostPlayer ann = server.join("Ann");
    HostPlayer mirrored = client.player(0);
    rules.shots = 3;
    for (int tick = 0; tick < 5; tick++) {
      ann.input().hold(Input.ACTION, tick == 1);
      mirrored.input().set(ann.input());
      server.step();
      client.step();
    }
    assertEquals(3, client.mirror().provisionalCount());
    assertEquals(1, client.entityCount());
    for (int i = 0; i < 3; i++) {
      HostEntity mine = client.mirror().provisional(i);
      HostEntity real = ann.spawned(i);
      assertTrue(mine.isProvisional());
      assertEquals(real.origin(), mine.id());
      assertSame(mine, client.entity(mine.id()));
      assertEquals(real.body().x(), mine.body().x());
      assertEquals(real.body().y(), mine.body().y());
      assertEquals(40, mine.get(POWER));
    }
    assertSame(client.mirror().provisional(2), mirrored.get(LAST));
  }

  @Test
  void aTickThatIsComputedAgainSpawnsTheSameEntityAgain() {
    SimulationHost s = client(told(OwnSpawns.UNKNOWN));
    final SimState before = s.save(null);
    s.player(0).input().hold(Input.ACTION, true);
    s.step();
    int id = s.mirror().provisional(0).id();
    final long hash = s.stateHash();
    final SimState after = s.save(null);
    s.restore(before);
    assertEquals(0, s.mirror().provisionalCount());
    assertNull(s.entity(id));
    s.player(0).input().hold(Input.ACTION, true);
    s.step();
    assertEquals(hash, s.stateHash());
    assertEquals(id, s.mirror().provisional(0).id());
    s.player(0).input().hold(Input.ACTION, false);
    s.player(0).input().hold(Input.SECOND, true);
    s.step();
    assertEquals(0, s.mirror().provisionalCount());
    s.restore(after);
    assertEquals(hash, s.stateHash());
    assertSame(s.entity(id), s.player(0).spawned(0));
  }

  @Test
  void whatTheServerHasToldIsSpawnedUnderItsOwnId() {
    SimulationHost s = client(told(7 | 3 << 16));
    s.player(0).input().hold(Input.ACTION, true);
    s.step();
    assertEquals(0, s.mirror().provisionalCount());
    assertEquals(3, s.entity(7).generation());
    assertEquals(Origin.of(1, 0), s.entity(7).origin());
    assertSame(s.entity(7), s.player(0).spawned(0));
  }

  @Test
  void theServersEntityTakesThePlaceOfTheProvisionalOne() {
    SimulationHost s = client(told(OwnSpawns.UNKNOWN));
    s.player(0).input().hold(Input.ACTION, true);
    s.step();
    int origin = s.mirror().provisional(0).id();
    HostEntity real = s.mirror().spawn(7, 3, rules.rocket, 0, 2, 0, 0);
    s.mirror().identify(real, origin);
    assertEquals(0, s.mirror().provisionalCount());
    assertEquals(1, s.player(0).spawnedCount());
    assertSame(real, s.player(0).spawned(0));
    assertSame(real, s.player(0).get(LAST), "a field that meant the provisional one");
  }

  @Test
  void whatTheInputOfOthersSpawnsLivesUntilTheEndOfTheCall() {
    SimulationHost s = client(told(OwnSpawns.UNKNOWN));
    s.mirror().join(1, "Ben");
    s.mirror().spawn(1, 0, rules.man, 4, 0, 0, 1);
    s.player(1).input().hold(Input.ACTION, true);
    s.step();
    assertEquals(0, s.mirror().provisionalCount());
    assertEquals(0, s.player(1).spawnedCount());
  }

  @Test
  void playersWhoSpawnInTheSameTickDontTakeEachOthersEntities() {
    for (int key : new int[] {OwnSpawns.UNKNOWN, 7 | 3 << 16}) {
      SimulationHost s = client(told(key));
      s.mirror().join(1, "Ben");
      s.mirror().spawn(1, 0, rules.man, 4, 0, 0, 1);
      s.player(0).input().hold(Input.ACTION, true);
      s.player(1).input().hold(Input.ACTION, true);
      s.step();
      HostEntity mine = s.player(0).spawned(0);
      assertSame(mine, s.entity(key < 0 ? Origin.of(1, 0) : 7), "key=" + key);
      assertEquals(0, mine.ownerId(), "key=" + key);
      assertEquals(1, s.player(0).spawnedCount());
      assertEquals(0, s.player(1).spawnedCount());
      assertEquals(key < 0 ? 1 : 0, s.mirror().provisionalCount());
    }
  }

  @Test
  void aClientDespawnsInItsInputOnlyWhatIsItsPlayers() {
    SimulationHost s = client(told(OwnSpawns.UNKNOWN));
    s.player(0).input().hold(Input.ACTION, true);
    s.step();
    s.player(0).input().hold(Input.ACTION, false);
    s.player(0).input().hold(Input.SECOND, true);
    s.step();
    assertEquals(0, s.mirror().provisionalCount());
    assertEquals(1, s.entityCount(), "the own body");
  }

  @Test
  void aPlayerHasTheNewestOnesOnBothSides() {
    SimulationHost server = simulation(Role.AUTHORITY);
    SimulationHost client = client(told(OwnSpawns.UNKNOWN));
    rules.shots = 20;
    HostPlayer ann = server.join("Ann");
    HostPlayer mirrored = client.player(0);
    for (int tick = 0; tick < 2; tick++) {
      ann.input().hold(Input.ACTION, true);
      mirrored.input().hold(Input.ACTION, true);
      server.step();
      client.step();
    }
    assertEquals(Origin.MOST_PER_PLAYER, ann.spawnedCount());
    assertEquals(Origin.MOST_PER_PLAYER, client.mirror().provisionalCount());
    assertEquals(41, server.entityCount(), "the server keeps all");
    for (int i = 0; i < Origin.MOST_PER_PLAYER; i++) {
      assertEquals(ann.spawned(i).origin(), mirrored.spawned(i).id());
    }
  }

  @Test
  void aSavedStateHasTheOrigins() {
    SimulationHost s = simulation(Role.AUTHORITY);
    HostPlayer ann = s.join("Ann");
    ann.input().hold(Input.ACTION, true);
    s.step();
    s.step();
    ArchiveWriter archive = new ArchiveWriter();
    s.save(null).write(archive);
    SimulationHost other = simulation(Role.AUTHORITY);
    other.restore(other.read(new ArchiveReader(archive.toBytes())));
    assertEquals(s.stateHash(), other.stateHash());
    assertEquals(2, other.player(0).spawnedCount());
    s.step();
    other.player(0).input().set(ann.input());
    other.step();
    assertEquals(s.stateHash(), other.stateHash());
  }

  @Test
  void theOriginIsPartOfTheState() {
    SimulationHost s = simulation(Role.AUTHORITY);
    HostPlayer ann = s.join("Ann");
    ann.input().hold(Input.ACTION, true);
    s.step();
    SimState saved = s.save(null);
    final long hash = s.stateHash();
    ann.input().hold(Input.ACTION, false);
    ann.input().hold(Input.SECOND, true);
    s.step();
    assertNotEquals(hash, s.stateHash());
    s.restore(saved);
    assertEquals(hash, s.stateHash());
    assertEquals(1, s.player(0).spawnedCount());
  }

  @Test
  void whatAnInputMayNotSpawnIsRefusedWithAdvice() {
    for (Role role : Role.values()) {
      SimulationHost s = role == Role.AUTHORITY ? simulation(role) : client(told(-1));
      HostPlayer ann = role == Role.AUTHORITY ? s.join("Ann") : s.player(0);
      ann.input().hold(Input.ACTION, true);
      rules.last = role == Role.AUTHORITY ? s.join("Bob") : s.mirror().join(1, "Bob");
      rules.foreign = true;
      String message = assertThrows(IllegalArgumentException.class, s::step).getMessage();
      assertTrue(message.contains("owner=Bob") && message.contains("beforeStep"), message);
      rules.foreign = false;
      if (role == Role.AUTHORITY) {
        rules.plain = true;
        message = assertThrows(IllegalStateException.class, s::step).getMessage();
        assertTrue(message.contains("call Player.spawn there"), message);
        rules.plain = false;
      }
      rules.shots = Origin.MOST_PER_CALL + 1;
      message = assertThrows(IllegalStateException.class, s::step).getMessage();
      assertTrue(message.contains("spawns=64"), message);
      rules.shots = 1;
      s.step();
    }
  }

  @Test
  void originsAreInTheOrderOfTicksWhenTheTickWraps() {
    int last = (1 << 24) - 1;
    assertTrue(Origin.isEarlier(Origin.of(last, 5), Origin.of(last + 1, 0)));
    assertFalse(Origin.isEarlier(Origin.of(last + 1, 0), Origin.of(last, 5)));
    assertTrue(Origin.isEarlier(Origin.of(9, 0), Origin.of(9, 1)));
    assertEquals(3, Origin.ticksBetween(Origin.of(last, 0), Origin.of(last + 3, 9)));
    assertEquals(-3, Origin.ticksBetween(Origin.of(last + 3, 9), Origin.of(last, 0)));
    assertTrue(Origin.isProvisional(Origin.of(0, 0)) && Origin.of(last, 63) == Origin.LAST);
  }
}
