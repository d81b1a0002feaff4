package carom.sim.pool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.platformer.PlatformerGame;
import carom.physics.Body;
import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What pools do to themselves and to bodies, and that a client can follow them. */
final class PoolsTest {
  private static final int RATE = 60;
  private static final String POOLS =
      """
      { "type": "water", "name": "lake", "min": [-10, 0], "max": [0, 8], "spacing": 0.3,
        "fill": [{ "min": [-10, 0], "max": [0, 3] }],
        "spouts": [{ "name": "spring", "at": [-8, 7], "direction": [0, -1], "speed": 4, "open": false }] },
      { "type": "sand", "name": "heap", "min": [0.5, 0], "max": [10, 8], "spacing": 0.3,
        "fill": [{ "min": [3, 0], "max": [7, 3] }] }
      """;

  private static Level level(String pools) {
    String json =
        """
        { "name": "Pools", "game": "platformer", "gravity": [0, -20],
          "bounds": { "min": [-12, -2], "max": [12, 12] },
          "spawns": [{ "at": [-5, 6] }, { "name": "flag", "at": [9, 9] }],
          "pools": [ %s ],
          "statics": [
            { "at": [0, -0.5], "shape": { "type": "box", "width": 24, "height": 1 } },
            { "at": [-10.5, 4], "shape": { "type": "box", "width": 1, "height": 8 } },
            { "at": [0.25, 4], "shape": { "type": "box", "width": 0.5, "height": 8 } },
            { "at": [10.5, 4], "shape": { "type": "box", "width": 1, "height": 8 } } ],
          "bodies": [
            { "name": "crate", "at": [-8, 4], "material": { "density": 0.4 },
              "shape": { "type": "box", "width": 1, "height": 1 } },
            { "name": "stone", "at": [-3, 4], "material": { "density": 4 },
              "shape": { "type": "box", "width": 1, "height": 1 } },
            { "name": "block", "at": [5, 5], "material": { "density": 0.8 },
              "shape": { "type": "box", "width": 1, "height": 1 } } ] }
        """
            .formatted(pools);
    try {
      return Level.parse("pools.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  private static SimulationHost server() {
    return new SimulationHost(new PlatformerGame(), level(POOLS), 1, RATE, Role.AUTHORITY);
  }

  private static SimulationHost client() {
    return new SimulationHost(new PlatformerGame(), level(POOLS), 1, RATE, Role.PREDICTION);
  }

  private static void steps(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  private static Body<HostEntity> body(SimulationHost s, int id) {
    return s.entity(id).body();
  }

  @Test
  void whatIsLighterThanWaterFloatsAndWhatIsHeavierSinks() {
    SimulationHost s = server();
    steps(s, 600);
    float crate = body(s, 0).y();
    float stone = body(s, 1).y();
    assertTrue(crate > 2 && crate < 4, "crate.y=" + crate);
    assertTrue(stone < 0.8f, "stone.y=" + stone);
    assertTrue(s.pools().find("lake").isStill(), "the lake comes to rest");
  }

  @Test
  void sandHoldsWhatIsLighterThanItHalfBuried() {
    SimulationHost s = server();
    steps(s, 600);
    float block = body(s, 2).y();
    float top = 0;
    while (s.pools().find("heap").fullness(5, top) > 0.5f) {
      top += 0.1f;
    }
    assertTrue(top > 0.8f, "top=" + top);
    assertTrue(block > top - 0.5f && block < top + 0.6f, "block.y=" + block + " top=" + top);
  }

  @Test
  void aBodyThatFallsInStirsTheWater() {
    SimulationHost s = server();
    steps(s, 600);
    Pool lake = s.pools().find("lake");
    float level = surface(lake, -5);
    body(s, 1).setPose(-5, 9, 0);
    body(s, 1).setVelocity(0, -12);
    float highest = level;
    for (int i = 0; i < 120; i++) {
      s.step();

      for (int k = 0; k < lake.particles().count(); k++) {
        highest = Math.max(highest, lake.particles().y(k));
      }
    }
    assertTrue(highest > level + 0.5f, "level=" + level + " highest=" + highest);
  }

  private static float surface(Pool pool, float x) {
    float y = pool.def().box().maxY();
    while (y > 0 && pool.fullness(x, y) < 0.5f) {
      y -= 0.05f;
    }
    return y;
  }

  @Test
  void whatTheGameOrdersHappensAfterTheDelay() {
    SimulationHost s = server();
    steps(s, 300);
    Pool lake = s.pools().find("lake");
    int before = lake.particles().count();
    lake.open("spring", true);
    assertTrue(lake.isOpen("spring"));
    steps(s, s.pools().delay() - 6);
    assertEquals(before, lake.particles().count());
    steps(s, 60);
    int poured = lake.particles().count();
    assertTrue(poured > before + 5, "poured=" + (poured - before));
    lake.open("spring", false);
    steps(s, 60);
    int full = lake.particles().count();
    assertTrue(lake.take(-5, 1, 1.5f));
    steps(s, 60);
    assertTrue(lake.particles().count() < full - 20, "count=" + lake.particles().count());
    int taken = lake.particles().count();
    assertTrue(lake.pour(-5, 6, 1, 0, 0));
    steps(s, 40);
    assertTrue(lake.particles().count() > taken + 10, "count=" + lake.particles().count());
  }

  /** Rows arrive late or early, in any order; what is lost comes again. */
  @Test
  void aClientThatFollowsHasTheSameParticlesWheneverRowsArrive() {
    long seed = Long.getLong("carom.seed", 7);
    Random random = new Random(seed);
    SimulationHost server = server();
    SimulationHost client = client();
    steps(server, 100);
    transfer(server, client);
    HostPlayer ann = server.join("Ann");
    Pool lake = server.pools().find("lake");
    int told = 0;
    for (int tick = 101; tick <= 1500; tick++) {
      ann.input().clear();
      ann.input().move(tick / 50 % 2 == 0 ? 1 : -1, 0);
      if (tick == 900) {
        body(server, 1).setPose(-5, 7, 0);
      }
      lake.open("spring", tick > 200 && tick < 300);
      server.step();
      client.pools().follow(tick, 4);
      int period = tick / 6;
      if (random.nextInt(10) == 0 || period - told > 10) {
        for (int p = period + OrderLog.AHEAD; p >= told - 2 && p >= 0; p--) {
          if (server.pools().log().row(p) != null) {
            client.pools().hear(server.pools().log().row(p).clone());
          }
        }
        told = period;
      }
      assertFalse(client.pools().needsState(tick) && tick - client.pools().tick() < 60, "" + tick);
    }
    for (int p = 240; p < 260; p++) {
      if (server.pools().log().row(p) != null) {
        client.pools().hear(server.pools().log().row(p).clone());
      }
    }
    client.pools().follow(1500, 1000);
    assertEquals(1500, client.pools().tick());
    assertSame(server, client, "seed=" + seed);
  }

  private static void assertSame(SimulationHost a, SimulationHost b, String text) {
    for (int i = 0; i < a.pools().count(); i++) {
      assertEquals(
          a.pools().get(i).particles().stateHash(),
          b.pools().get(i).particles().stateHash(),
          text + " pool=" + i);
    }
  }

  private static void transfer(SimulationHost from, SimulationHost to) {
    ArchiveWriter out = new ArchiveWriter();
    from.pools().save(null).write(out);
    to.pools().restore(to.pools().read(new ArchiveReader(out.toBytes())));
  }

  @Test
  void aClientNoticesThatItsParticlesDiffer() {
    SimulationHost server = server();
    SimulationHost client = client();
    assertTrue(client.pools().needsState(0));
    steps(server, 60);
    transfer(server, client);
    assertFalse(client.pools().needsState(60));
    client.pools().get(0).particles().setVelocity(5, 1, 1);
    for (int tick = 61; tick < 160; tick++) {
      server.step();
      if (tick % 6 == 0) {
        client.pools().hear(server.pools().log().row(tick / 6 + OrderLog.AHEAD).clone());
      }
      client.pools().follow(tick, 4);
    }
    assertTrue(client.pools().needsState(160));
    transfer(server, client);
    assertFalse(client.pools().needsState(160));
    assertSame(server, client, "after the transfer");
  }

  @Test
  void anyRowAndAnyStateIsReadWithoutHarm() {
    long seed = Long.getLong("carom.seed", 11);
    Random random = new Random(seed);
    SimulationHost server = server();
    SimulationHost client = client();
    steps(server, 30);
    ArchiveWriter out = new ArchiveWriter();
    server.pools().save(null).write(out);
    byte[] good = out.toBytes();
    for (int i = 0; i < 200; i++) {
      byte[] bad = good.clone();
      for (int k = 0; k <= random.nextInt(4); k++) {
        bad[random.nextInt(Math.min(bad.length, i < 100 ? 400 : bad.length))] ^=
            (byte) (1 << random.nextInt(8));
      }
      try {
        PoolsState read = client.pools().read(new ArchiveReader(bad));
        client.pools().restore(read);
        client.pools().follow(client.pools().tick() + 3, 3);
      } catch (ArchiveException e) {
        assertFalse(e.getMessage().isEmpty());
      }
    }
    transfer(server, client);
    int[] row = new int[OrderLog.WORDS];
    for (int i = 0; i < 300; i++) {
      for (int w = 0; w < row.length; w++) {
        row[w] = random.nextInt();
      }
      row[0] = random.nextInt(4) == 0 ? random.nextInt() : 5 + random.nextInt(20);
      client.pools().hear(row);
      client.pools().follow(30 + i, 2);
    }
    assertTrue(client.pools().get(0).particles().count() <= client.pools().get(0).def().most());
  }

  @Test
  void aSavedSimulationGoesOnBitByBit() {
    SimulationHost s = server();
    steps(s, 100);
    s.pools().find("lake").open("spring", true);
    steps(s, 7);
    SimState saved = s.save(null);
    ArchiveWriter out = new ArchiveWriter();
    saved.write(out);
    steps(s, 100);
    long hash = s.stateHash();
    s.restore(saved);
    assertNotEquals(hash, s.stateHash());
    steps(s, 100);
    assertEquals(hash, s.stateHash());
    SimulationHost other = server();
    other.restore(other.read(new ArchiveReader(out.toBytes())));
    steps(other, 100);
    assertEquals(hash, other.stateHash());
  }

  @Test
  void badDeclarationsAreRefusedWithAdvice() {
    assertRefused("\"spacing\": 0.2, \"min\": [0, 0], \"max\": [100, 100]", "cells=");
    assertRefused("\"min\": [0, 0], \"max\": [10, 10], \"most\": 5000", "most=5000");
    assertRefused("\"min\": [0, 0], \"max\": [10, 10], \"spuots\": []", "spouts");
    assertRefused(
        "\"min\": [0, 0], \"max\": [10, 10], \"spouts\": [{ \"name\": \"a\", \"at\": [1, 1],"
            + " \"direction\": [0, 0] }]",
        "length");
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> server().pools().get(0).open("fountain", true));
    assertTrue(e.getMessage().contains("spout=fountain"), e.getMessage());
    SimulationHost s = server();
    assertThrows(
        IllegalStateException.class, () -> s.pools().add(PoolDef.water("late", 0, 0, 1, 1, 0.3f)));
  }

  private static void assertRefused(String fields, String part) {
    AssertionError e =
        assertThrows(
            AssertionError.class,
            () -> level("{ \"type\": \"water\", \"name\": \"x\", " + fields + " }"));
    assertTrue(e.getMessage().contains(part), e.getMessage());
  }
}
