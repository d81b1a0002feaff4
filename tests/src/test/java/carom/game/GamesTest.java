package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Slice;
import carom.physics.Body;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.sim.field.FieldValues;
import carom.sim.field.Scope;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.suite.Optimized;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What every game that ships must do. */
@Optimized("measures what is allocated")
public class GamesTest {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  public static SimulationHost start(String game, long seed, Role role) {
    try {
      Level level = Level.builtIn(Games.create(game).defaultLevel());
      return new SimulationHost(Games.create(game), level, seed, 60, role);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void findsGamesByName() {
    assertTrue(Games.names().containsAll(List.of("arena", "platformer")));
    assertEquals("arena", Games.create(Games.DEFAULT).name());
    assertNotSame(Games.create("arena"), Games.create("arena"));
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> Games.create("areno"));
    assertTrue(e.getMessage().contains("did you mean \"arena\"?"), e.getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "cars", "platformer", "playground", "shooter"})
  void equalInputsGiveEqualHashes(String game) {
    List<Long> first = hashes(game, 11, 400);
    assertEquals(first, hashes(game, 11, 400));
    assertNotEquals(first.subList(0, 60), hashes(game, 12, 60));
  }

  private static List<Long> hashes(String game, long seed, int ticks) {
    SimulationHost s = start(game, seed, Role.AUTHORITY);
    List<Long> hashes = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      s.join("bot " + i);
    }
    for (int tick = 0; tick < ticks; tick++) {
      if (tick == 200) {
        s.leave(s.player(3));
      }
      if (tick == 260) {
        s.join("late");
      }
      Bots.wander(s, seed);
      s.step();
      hashes.add(s.stateHash());
    }
    return hashes;
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "cars", "platformer", "playground", "shooter"})
  void continuesBitByBitAfterRestore(String game) {
    SimulationHost s = start(game, 5, Role.AUTHORITY);
    for (int i = 0; i < 8; i++) {
      s.join("bot " + i);
    }
    run(s, 5, 200);
    SimState saved = s.save(null);
    long then = s.stateHash();
    run(s, 5, 40);
    s.leave(s.player(2));
    s.join("somebody else");
    run(s, 5, 160);
    long later = s.stateHash();

    for (int again = 0; again < 2; again++) {
      s.restore(saved);
      assertEquals(then, s.stateHash());
      run(s, 5, 40);
      s.leave(s.player(2));
      s.join("somebody else");
      run(s, 5, 160);
      assertEquals(later, s.stateHash());
    }
    assertEquals(200, saved.tick());
  }

  private static void run(SimulationHost s, long seed, int ticks) {
    for (int i = 0; i < ticks; i++) {
      Bots.wander(s, seed);
      s.step();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "cars", "platformer", "playground", "shooter"})
  void fiftyPlayersAtOnceStayInTheField(String game) {
    SimulationHost s = start(game, 9, Role.AUTHORITY);
    for (int i = 0; i < 50; i++) {
      s.join("bot " + i);
    }
    Level.Bounds b = s.level().bounds();
    for (int tick = 0; tick < Slice.of(500, 900); tick++) {
      Bots.wander(s, 9);
      s.step();
      for (int id = 0; id < s.entityCapacity(); id++) {
        HostEntity e = s.entity(id);
        if (e == null || !e.isDynamic()) {
          continue; // the shooter's lava waits below the field
        }
        Body<HostEntity> body = e.body();
        float all = body.x() + body.y() + body.velocityX() + body.velocityY() + body.cos();
        assertTrue(Float.isFinite(all), "seed 9 tick " + tick + " " + e);
        boolean inside =
            body.x() > b.minX() - 2
                && body.x() < b.maxX() + 2
                && body.y() > b.minY() - 2
                && body.y() < b.maxY() + 30;
        assertTrue(inside, "seed 9 tick " + tick + " " + e + " " + body.x() + "," + body.y());
      }
    }
    int alive = 0;
    for (int i = 0; i < 50; i++) {
      alive += s.player(i).entity() == null ? 0 : 1;
    }
    assertTrue(alive > 25, "alive=" + alive);
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "cars", "platformer", "playground", "shooter"})
  void joiningAndLeavingLeavesNothingBehind(String game) {
    SimulationHost s = start(game, 3, Role.AUTHORITY);
    run(s, 3, 10);
    int before = s.entityCount();
    for (int round = 0; round < 3; round++) {
      for (int i = 0; i < 30; i++) {
        HostPlayer p = s.join("guest " + i);
        assertEquals(i, p.id());
        assertEquals(p.entity(), s.entity(p.entity().id()));
      }
      run(s, 3, 5);
      for (int i = 29; i >= 0; i--) {
        HostEntity body = s.player(i).entity();
        s.leave(s.player(i));
        assertFalse(body.body().isValid());
      }
      assertEquals(0, s.playerCapacity());
    }
    int extra = s.entityCount() - before;
    assertTrue(extra >= -8 && extra <= 4, "balls may come, coins may go, but extra=" + extra);
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void predictionMovesALonePlayerLikeTheServer(String game) {
    SimulationHost server = start(game, 1, Role.AUTHORITY);
    SimulationHost client = start(game, 1, Role.PREDICTION);
    run(server, 1, 10); // the arena's ball and the platformer's foes have come
    HostPlayer p = server.join("alone");
    HostPlayer mirror = client.mirror().join(p.id(), "alone");
    mirror(server, client, mirror);
    for (int tick = 1; tick <= 120; tick++) {
      Bots.wander(server, 4);
      p.input().move(p.input().moveX() * 0.3f, p.input().moveY() * 0.3f);
      mirror.input().set(p.input());
      server.step();
      client.step();
      if (server.entityCount() != client.entityCount()) {
        break; // a coin was collected: only the server knows
      }
      assertSamePose(p.entity().body(), mirror.entity().body(), "tick " + tick);
      tellNobody(p.fieldValues(), mirror.fieldValues());
      assertEquals(p.fieldValues().toString(), mirror.fieldValues().toString());
    }
    assertTrue(client.tick() > 20, () -> "tick=" + client.tick());
  }

  /** Copies what no client is told. */
  private static void tellNobody(FieldValues from, FieldValues to) {
    for (int i = 0; i < from.size(); i++) {
      if (from.schema().field(Scope.PLAYER, i).audience() == Audience.NOBODY) {
        to.mirror(i, from.word(i));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void savingAndRestoringAllocatesNothingAndATickNextToNothing(String game) {
    SimulationHost s = start(game, 6, Role.AUTHORITY);
    for (int i = 0; i < 20; i++) {
      s.join("bot " + i);
    }
    run(s, 6, 600);
    SimState state = s.save(null);
    long saving = Long.MAX_VALUE;
    long stepping = Long.MAX_VALUE;
    for (int round = 0; round < 5; round++) {
      long before = allocated();
      for (int i = 0; i < 50; i++) {
        s.save(state);
        s.restore(state);
      }
      saving = Math.min(saving, allocated() - before);
      before = allocated();
      for (int i = 0; i < 50; i++) {
        s.step();
      }
      stepping = Math.min(stepping, allocated() - before);
    }
    assertTrue(saving < 64, "bytes=" + saving + " in 50 saves and restores");
    assertTrue(
        stepping < 4096, "bytes=" + stepping + " in 50 ticks"); // coins and the fallen come back
  }

  private static long allocated() {
    return THREADS.getCurrentThreadAllocatedBytes();
  }

  private static void mirror(SimulationHost server, SimulationHost client, HostPlayer player) {
    client.mirror().tick(server.tick());
    for (int id = 0; id < server.entityCapacity(); id++) {
      HostEntity e = server.entity(id);
      if (e != null) {
        Body<HostEntity> from = e.body();
        Body<HostEntity> to =
            client
                .mirror()
                .spawn(
                    id,
                    e.generation(),
                    client.archetypes().get(e.archetype().index()),
                    from.x(),
                    from.y(),
                    from.angle(),
                    e.ownerId())
                .body();
        to.setCenterPose(from.centerX(), from.centerY(), from.cos(), from.sin());
      }
    }
    assertEquals(server.statics().size(), client.statics().size());
    assertEquals(server.player(player.id()).entity().id(), player.entity().id());
  }

  private static void assertSamePose(Body<HostEntity> a, Body<HostEntity> b, String when) {
    assertEquals(bits(a.centerX()), bits(b.centerX()), when);
    assertEquals(bits(a.centerY()), bits(b.centerY()), when);
    assertEquals(bits(a.cos()), bits(b.cos()), when);
    assertEquals(bits(a.sin()), bits(b.sin()), when);
    assertEquals(bits(a.velocityX()), bits(b.velocityX()), when);
    assertEquals(bits(a.velocityY()), bits(b.velocityY()), when);
    assertEquals(bits(a.angularVelocity()), bits(b.angularVelocity()), when);
  }

  private static int bits(float value) {
    return Float.floatToIntBits(value);
  }
}
