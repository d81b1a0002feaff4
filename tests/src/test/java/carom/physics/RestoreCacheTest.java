package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * What a world keeps beside its state (where searches for faces ended, manifolds, fat boxes and
 * trees, hashes of what rarely changes) may be of another time after a restore, and must show in
 * nothing: neither in what follows nor in what can be read.
 */
class RestoreCacheTest {
  private static final int TICKS = 160;

  /** Changes that depend on the tick and the state alone, before the step of that tick. */
  private static void edit(World<String> w, int tick, long seed) {
    Random random = new Random(seed * 1_000_003 + tick);
    if (tick % 6 == 0) {
      BodyDef def =
          new BodyDef(BodyType.DYNAMIC).position(random.nextFloat() * 8 - 4, 12 + tick % 5);
      float half = 0.2f + 0.3f * random.nextFloat();
      w.createBody(
          random.nextBoolean() ? def.shape(new Box(half, half)) : def.shape(new Circle(half)),
          "tick " + tick);
    }
    Body<String> one = w.body(random.nextInt(w.slotCount()));
    if (one != null && one.type() == BodyType.DYNAMIC) {
      switch (tick % 11) {
        case 3 -> one.setVelocity(random.nextFloat() * 6 - 3, 4);
        case 5 -> one.setLinearDamping(random.nextFloat());
        case 7 -> one.setPose(one.x() + 0.3f, one.y() + 2, random.nextFloat());
        case 8 -> w.destroyBody(one);
        case 9 -> one.sleep();
        case 10 -> one.applyForce(random.nextFloat() * 50, 80);
        default -> {}
      }
    }
  }

  /** All that can be read of the contacts, by body. */
  private static List<String> contacts(World<String> w) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < w.slotCount(); i++) {
      int body = i;
      if (w.body(i) != null) {
        List<String> own = new ArrayList<>();
        w.body(i)
            .forEachContact(
                (other, nx, ny, impulse) ->
                    own.add(body + " " + other.index() + " " + nx + " " + ny + " " + impulse));
        own.sort(null);
        all.addAll(own);
      }
    }
    return all;
  }

  @Test
  void whatIsKeptBesideTheStateShowsInNothing() {
    for (long seed = 1; seed <= 3; seed++) {
      World<String> straight = Scenes.pile(40, 4);
      long[] hashes = new long[TICKS + 1];
      List<List<String>> contacts = new ArrayList<>();
      hashes[0] = straight.stateHash();
      contacts.add(contacts(straight));
      for (int tick = 1; tick <= TICKS; tick++) {
        edit(straight, tick, seed);
        straight.step(DT);
        hashes[tick] = straight.stateHash();
        contacts.add(contacts(straight));
      }

      World<String> jumping = Scenes.pile(40, 4);
      Random random = new Random(seed);
      WorldState[] states = {jumping.save(null), jumping.save(null), jumping.save(null)};
      int[] tickOf = new int[states.length];
      int tick = 0;
      for (int jump = 0; jump < 60; jump++) {
        for (int i = random.nextInt(20); i >= 0 && tick < TICKS; i--) {
          tick++;
          edit(jumping, tick, seed);
          jumping.step(DT);
          String where = "seed=" + seed + " jump=" + jump + " tick=" + tick;
          assertEquals(hashes[tick], jumping.stateHash(), where);
          assertEquals(contacts.get(tick), contacts(jumping), where);
        }
        int s = random.nextInt(states.length);
        if (random.nextBoolean()) {
          jumping.save(states[s]);
          tickOf[s] = tick;
        } else {
          jumping.restore(states[s]);
          tick = tickOf[s];
          assertEquals(hashes[tick], jumping.stateHash(), "restored, seed=" + seed);
          assertEquals(contacts.get(tick), contacts(jumping), "restored, seed=" + seed);
        }
      }
    }
  }
}
