package carom.sim.near;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.physics.math.SimRandom;
import carom.physics.rows.BodyRow;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: a simulation that takes over the exact state of another one's entities goes on as the other
 * does, to the bit. Method: a server's simulation plays with random inputs; now and then a client's
 * takes over all of it and gets the same inputs; the hash of each tick must be the same.
 */
final class NeighbourhoodTest {
  private static final long SEED = Long.getLong("carom.seed", 5);

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void whoTakesOverGoesOnAlike(String game) throws Exception {
    Level level = Level.builtIn(Games.create(game).defaultLevel());
    SimulationHost server = new SimulationHost(Games.create(game), level, 1, 60, Role.AUTHORITY);
    SimulationHost client = new SimulationHost(Games.create(game), level, 1, 60, Role.PREDICTION);
    SimRandom random = new SimRandom(SEED);
    for (int i = 0; i < 6; i++) {
      server.join("p" + i);
    }
    Neighbourhood there = new Neighbourhood();
    Neighbourhood here = new Neighbourhood();
    int alike = 0;
    int touching = 0;
    boolean mirrored = false;
    for (int tick = 1; tick <= 3_000; tick++) {
      for (int id = 0; id < 6; id++) {
        if (random.nextInt(15) == 0) {
          Input in = server.player(id).input();
          in.move(random.between(-1, 1), random.between(-1, 1)).aim(random.between(0, 6));
          in.buttons(
              random.nextInt(3) == 0 ? random.nextInt(32) & ~Input.SECOND : 0); // a jolt is a rule
        }
      }
      server.step();
      there.readAll(server);
      if (mirrored && sameEntities(there, here)) {
        for (int id = 0; id < 6; id++) {
          if (client.player(id) != null) {
            client.player(id).input().set(server.player(id).input());
          }
        }
        client.step();
        here.readAll(client);
        if (sameEntities(there, here)) {
          String what = game + " seed=" + SEED + " tick=" + tick;
          if (there.hash() == here.hash()) {
            alike++;
            touching += there.rows().contacts().count();
          } else {
            // The server's own rules (a respawn, a capped ball) are none of the client's business.
            requireOnlyRulesDiffer(there, here, what);
            mirrored = false;
          }
        } else {
          mirrored = false;
        }
      } else {
        mirrored = false;
      }
      if (!mirrored || tick % 200 == 0) {
        client.mirror().tick(server.tick());
        there.write(
            client,
            new Neighbourhood.Identity() {
              @Override
              public int owner(int key) {
                return server.entity(Neighbourhood.id(key)).ownerId();
              }
            });
        here.readAll(client);
        assertEquals(there.hash(), here.hash(), game + " seed=" + SEED + " tick=" + tick);
        mirrored = true;
      }
    }
    assertTrue(alike > 2_800, game + " alike=" + alike);
    assertTrue(touching > 3_000, game + " touching=" + touching);
  }

  private static boolean sameEntities(Neighbourhood a, Neighbourhood b) {
    if (a.count() != b.count()) {
      return false;
    }
    for (int i = 0; i < a.count(); i++) {
      if (a.key(i) != b.key(i)) {
        return false;
      }
    }
    return true;
  }

  private static void requireOnlyRulesDiffer(Neighbourhood a, Neighbourhood b, String what) {
    int different = 0;
    for (int i = 0; i < a.count(); i++) {
      int at = a.rows().bodies().at(i);
      int end = at + BodyRow.HEAD_INTS; // who is moved by a rule lets others rest anew
      boolean same =
          Arrays.equals(a.rows().bodies().ints(), at, end, b.rows().bodies().ints(), at, end);
      boolean woken =
          a.awake(i) && !b.awake(i); // by a flag that was taken, say: it is no neighbour
      different += same || woken ? 0 : 1;
    }
    assertTrue(different <= 2, what + " different=" + different + " of " + a.count());
  }
}
