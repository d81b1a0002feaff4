package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.fixtures.FieldGame;
import carom.fixtures.FieldGame.Phase;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;

/**
 * Goal: each client has the fields that it may know, predicts those that its input writes, and has
 * nothing else. Method: real server and clients in virtual time at 150 ms and 2 % loss.
 */
class FieldScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private static Stepper stepper() {
    return Stepper.of(FieldGame.level(true), ServerConfig.defaults());
  }

  @Test
  void healthIsSeenByAllAmmunitionByItsOwnerAlone() {
    try (Stepper stepper = stepper()) {
      SimulatedClient ann = stepper.join("ann", FAR, Scripts.wander(Stepper.SEED));
      SimulatedClient bob = stepper.join("bob", FAR, Scripts.wander(Stepper.SEED + 1));
      stepper.run(20.3);
      HostPlayer a = stepper.player(ann);
      final FieldView own = ann.view().player(a.id());
      final FieldView seen = bob.view().player(a.id());
      assertTrue(a.get(FieldGame.HEALTH) < 85, stepper.describe());
      assertTrue(a.get(FieldGame.AMMO) < 395, stepper.describe());
      assertTrue(a.get(FieldGame.LUCK) > 100, stepper.describe());
      assertEquals(a.get(FieldGame.HEALTH), seen.get(FieldGame.HEALTH), stepper.describe());
      assertEquals(a.get(FieldGame.HEALTH), own.get(FieldGame.HEALTH), stepper.describe());
      int ownAmmo = own.get(FieldGame.AMMO);
      assertEquals(a.get(FieldGame.AMMO), ownAmmo, 1, stepper.describe());
      assertEquals(FieldGame.AMMO.start(), seen.get(FieldGame.AMMO), "bob doesn't know it");
      assertEquals(FieldGame.PLAN.start(), seen.get(FieldGame.PLAN), "another team");
      assertEquals(FieldGame.LUCK.start(), own.get(FieldGame.LUCK), "it stays on the server");
    }
  }

  @Test
  void aTeamKnowsItsPlanAndForgetsItWhenAPlayerLeavesIt() {
    try (Stepper stepper = stepper()) {
      SimulatedClient ann = stepper.join("ann", FAR, Scripts.hold(0, 0));
      SimulatedClient bob = stepper.join("bob", FAR, Scripts.hold(0, 0));
      int a = stepper.player(ann).id();
      stepper.player(bob).team(stepper.player(ann).team());
      stepper.run(3.3);
      int plan = stepper.player(ann).get(FieldGame.PLAN);
      assertTrue(plan > 0, stepper.describe());
      assertEquals(plan, bob.view().player(a).get(FieldGame.PLAN), stepper.describe());
      stepper.player(bob).team(1 - stepper.player(ann).team());
      stepper.run(0.5);
      assertEquals(0, bob.view().player(a).get(FieldGame.PLAN), stepper.describe());
    }
  }

  @Test
  void aPhaseReachesAllClientsAndPredictedInputFollowsIt() {
    try (Stepper stepper = stepper()) {
      SimulatedClient ann = stepper.join("ann", FAR, Scripts.wander(Stepper.SEED));
      SimulatedClient bob = stepper.join("bob", FAR, Scripts.wander(Stepper.SEED + 1));
      stepper.run(4);
      final long corrections = ann.stats().corrections();
      final long compared = ann.stats().compared();
      stepper.run(20.3);
      Phase phase = stepper.room().simulation().get(FieldGame.PHASE);
      assertEquals(phase, ann.view().match().get(FieldGame.PHASE), stepper.describe());
      assertEquals(phase, bob.view().match().get(FieldGame.PHASE), stepper.describe());
      assertEquals(0, ann.stats().corrections() - corrections, stepper.describe());
      assertTrue(ann.stats().compared() - compared > 600, stepper.describe());
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
    }
  }

  @Test
  void aCooldownInAFieldIsPredictedWithoutACorrection() {
    try (Stepper stepper = stepper()) {
      SimulatedClient ann = stepper.join("ann", FAR, Scripts.wander(Stepper.SEED));
      stepper.run(30);
      assertTrue(stepper.player(ann).get(FieldGame.AMMO) < 390, "it dashed");
      assertEquals(0, ann.stats().corrections(), stepper.describe());
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
    }
  }

  @Test
  void theFieldsOfABodyAreSeenByOthersAndByItsOwnerAtOnce() {
    try (Stepper stepper = stepper()) {
      SimulatedClient ann = stepper.join("ann", FAR, Scripts.hold(1, 0));
      SimulatedClient bob = stepper.join("bob", FAR, Scripts.hold(0, 0));
      stepper.run(4);
      ann.play(Scripts.hold(0, 0));
      stepper.run(2);
      HostEntity body = stepper.body(ann);
      int burnt = body.get(FieldGame.BURNT);
      assertTrue(burnt > 100, stepper.describe());
      assertEquals(burnt, fields(ann.view(), body).get(FieldGame.BURNT), stepper.describe());
      assertEquals(burnt, fields(bob.view(), body).get(FieldGame.BURNT), stepper.describe());
    }
  }

  @Test
  void theFieldsOfAPlayerNearArePredictedWithItsInputs() {
    // Two players jostle. Each client computes the other's dashes from relayed inputs, which needs
    // the other's cooldown, and the hash of the predicted set covers that.
    try (Stepper stepper = Stepper.of(FieldGame.level(false), ServerConfig.defaults())) {
      SimulatedClient ann = stepper.join("ann", FAR, Scripts.wander(Stepper.SEED));
      stepper.join("bob", FAR, Scripts.wander(Stepper.SEED + 1));
      stepper.run(5);
      final long agreed = ann.stats().disagreements();
      stepper.run(30);
      String about = stepper.describe();
      assertTrue(ann.stats().awakeBodies() > 3_000, "bob is near most of the time; " + about);
      assertTrue(ann.stats().disagreements() - agreed <= 2, about);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
      assertTrue(100 * ann.stats().exactBodies() >= 98 * ann.stats().awakeBodies(), about);
    }
  }

  private static FieldView fields(ClientView view, HostEntity body) {
    return view.fields(view.find(body.id()));
  }
}
