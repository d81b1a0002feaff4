package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Circle;
import org.junit.jupiter.api.Test;

/** What a saved state holds, and how little of it is copied. */
class SaveTest {
  @Test
  void aBodyCostsAtMostAHundredBytesFromTickToTick() {
    World<String> w = Scenes.space();
    for (int i = 0; i < 1000; i++) {
      Scenes.disc(w, 2 * i, 0, 0.5f, Material.DEFAULT);
    }
    WorldState state = w.save(null);
    assertTrue(state.bytes() > 100_000, "the first save copies all: " + state.bytes());
    w.step(DT);
    w.save(state);
    assertTrue(state.bytes() <= 100 * 1000, "bytes=" + state.bytes() + " for 1,000 bodies");
  }

  @Test
  void whatStepsDontChangeIsSavedWhenItChanged() {
    World<String> w = Scenes.space();
    Body<String> a = Scenes.disc(w, 0, 0, 0.5f, Material.DEFAULT);
    Body<String> b = Scenes.disc(w, 3, 0, 0.5f, Material.DEFAULT);
    Joint<String> j = w.createJoint(JointDef.prismatic(a, b, 1, 0, 1, 0));
    WorldState first = w.save(null);
    long before = w.stateHash();
    a.setLinearDamping(1);
    a.setAngularDamping(2);
    a.setGravityScale(3);
    j.setMotor(1, 2);
    j.setLimits(-1, 1);
    j.setSpring(2, 0.5f);
    j.setRest(0.1f);
    WorldState second = w.save(null);
    long after = w.stateHash();
    w.restore(first);
    assertEquals(before, w.stateHash());
    assertEquals(0, a.linearDamping());
    w.restore(second);
    assertEquals(after, w.stateHash());
    assertEquals(3, a.gravityScale());
    assertEquals(0.1f, j.rest());
  }

  @Test
  void statesOfOneWorldCanBeOverwrittenInAnyOrder() {
    World<String> w = Scenes.pile(60, 5);
    WorldState[] states = {w.save(null), w.save(null), w.save(null)};
    long[] hashes = new long[3];
    for (int round = 0; round < 60; round++) {
      int i = round * 7 % 3;
      w.step(DT);
      if (round % 5 == 0) {
        Body<String> body = w.body(3 + round);
        body.setLinearDamping(0.01f * round);
        if (round % 10 == 0) {
          w.destroyBody(body);
        }
      }
      if (round % 4 == 0) {
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Circle(0.2f)).position(0, 30 + round), "new");
      }
      w.save(states[i]);
      hashes[i] = w.stateHash();
      int other = (i + 1) % 3;
      if (round > 10 && round % 3 == 0) {
        w.restore(states[other]);
        assertEquals(hashes[other], w.stateHash(), "round=" + round);
        w.restore(states[i]);
        assertEquals(hashes[i], w.stateHash(), "round=" + round);
      }
    }
  }
}
