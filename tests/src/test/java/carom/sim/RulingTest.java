package carom.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.ForceGame;
import carom.fixtures.PlainGame;
import carom.physics.Body;
import carom.physics.rows.BodyRow;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Player;
import carom.sim.ruling.Ruling;
import carom.sim.ruling.RulingLog;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Goal: what rules do to a body can be told, and done again elsewhere to the bit. */
final class RulingTest {
  private static final String CRATES =
      ", \"bodies\": [{\"at\": [0, -4.5], \"shape\": {\"type\": \"box\", \"width\": 1, \"height\":"
          + " 1}, \"repeat\": {\"rows\": 4, \"step\": [0, 1]}}]";

  private final int[] row = new int[BodyRow.INTS];

  private static SimulationHost tower(int ticks) {
    SimulationHost s =
        new SimulationHost(new ForceGame(), ForceGame.level(-10, CRATES), 1, 60, Role.AUTHORITY);
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
    return s;
  }

  @Test
  void aRulingDoesElsewhereWhatTheRulesDid() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    for (int ticks : new int[] {20, 400}) { // awake, asleep
      check(seed, ticks, b -> b.applyImpulse(random.nextFloat(), 2));
      check(seed, ticks, b -> b.applyForce(40 * random.nextFloat(), 1));
      check(seed, ticks, b -> b.applyForce(1, 2, b.x() + 0.3f, b.y()));
      check(seed, ticks, b -> b.setVelocity(random.nextFloat(), 5));
      check(seed, ticks, b -> b.setAngularVelocity(random.nextFloat()));
      check(seed, ticks, b -> b.setPose(3, 4 * random.nextFloat(), random.nextFloat()));
      check(seed, ticks, Body::wake);
    }
  }

  private void check(long seed, int ticks, Consumer<Body<HostEntity>> rule) {
    SimulationHost server = tower(ticks);
    SimulationHost client = tower(ticks);
    int[] before = new int[BodyRow.INTS];
    int[] after = new int[BodyRow.INTS];
    Body<HostEntity> body = server.entity(3).body();
    body.readRow(before, 0);
    rule.accept(body);
    body.readRow(after, 0);
    Ruling ruling = new Ruling();
    ruling.setDifference(before, after);
    assertTrue(ruling.isSane());
    ruling.apply(client.entity(3), client.archetypes(), row);
    for (int i = 0; i < 120; i++) {
      server.step();
      client.step();
      assertEquals(server.stateHash(), client.stateHash(), "seed=" + seed + " ticks after: " + i);
    }
  }

  @Test
  void numbersThatNoBodyCanHaveAreNoRuling() {
    Ruling ruling = new Ruling();
    ruling.mask = 1 << BodyRow.VX - BodyRow.MOTION;
    ruling.row[BodyRow.VX] = Float.floatToRawIntBits(1e30f);
    assertFalse(ruling.isSane());
    ruling.row[BodyRow.VX] = Float.floatToRawIntBits(Float.NaN);
    assertFalse(ruling.isSane());
    ruling.row[BodyRow.VX] = Float.floatToRawIntBits(3);
    assertTrue(ruling.isSane());
  }

  /** Pushes a crate when a player joins, when one leaves, and on demand before each step. */
  private static final class Pusher extends PlainGame {
    private boolean pushes;

    Pusher() {
      super("pusher");
    }

    @Override
    public void join(Match s, Player p) {
      push(s);
    }

    @Override
    public void leave(Match s, Player p) {
      push(s);
    }

    @Override
    public void beforeStep(Match s) {
      if (pushes) {
        push(s);
      }
    }

    private static void push(Match s) {
      s.entity(3).applyImpulse(1, 2);
    }
  }

  @Test
  void whatJoinLeaveAndBeforeStepDoToABodyIsOneRuling() {
    Pusher game = new Pusher();
    SimulationHost server =
        new SimulationHost(game, ForceGame.level(-10, CRATES), 1, 60, Role.AUTHORITY);
    SimulationHost client = tower(0);
    for (int n = 0; n < 4; n++) {
      game.pushes = n >= 2;
      HostEntity crate = server.entity(3);
      server.interference().watch(crate);
      final long told = server.interference().rulings().next();
      if (n % 2 == 0) {
        server.join(0, "Ann");
      } else {
        server.leave(server.player(0));
      }
      server.step();
      assertEquals(told + 1, server.interference().rulings().next());
      assertEquals(server.tick(), server.interference().lastTick(crate));
      Ruling ruling = server.interference().rulings().get(told);
      assertEquals(server.tick(), ruling.tick);
      assertEquals(Ruling.Moment.BEFORE_STEP, ruling.moment);
      ruling.apply(client.entity(3), client.archetypes(), row);
      client.step();
      int[] expected = new int[BodyRow.INTS];
      client.entity(3).body().readRow(expected, 0);
      crate.body().readRow(row, 0);
      assertArrayEquals(expected, row, "n=" + n);
    }
  }

  @Test
  void theLogKeepsTheLatest() {
    RulingLog log = new RulingLog();
    for (int i = 0; i < RulingLog.MOST + 10; i++) {
      log.add().tick = i;
    }
    assertEquals(10, log.oldest());
    assertEquals(RulingLog.MOST + 10, log.next());
    assertEquals(10, log.get(10).tick);
    assertEquals(RulingLog.MOST + 9, log.get(log.next() - 1).tick);
  }
}
