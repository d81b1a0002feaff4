package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.MessageListener;
import carom.fixtures.DuelGame;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.message.Message;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.NextMatch;
import carom.suite.Needs;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: what players ask of the roster happens, everybody is told, and the picture follows. Method:
 * clients of a game with teams and deaths in virtual time, with latency and loss; server and views
 * are compared. One test plays over sockets.
 */
class RosterScenarioTest {
  private static final Impairment BAD =
      Impairment.NONE.withLatency(75, 5).withLoss(2).withSeed(Stepper.SEED);

  /** Views are smaller than the distance between the teams. */
  private static Stepper duel() {
    return Stepper.of(DuelGame.level(), ServerConfig.defaults().with(ServerConfig.VIEW, 40));
  }

  private static RosterEntry row(SimulatedClient of, SimulatedClient at) {
    return at.view().participant(of.view().playerId());
  }

  private static HostPlayer participant(Stepper stepper, SimulatedClient client) {
    return stepper.room().simulation().participant(client.view().playerId());
  }

  private static boolean shows(SimulatedClient at, SimulatedClient whose) {
    for (int i = 0; i < at.view().entityCount(); i++) {
      if (at.view().entity(i).ownerId() == whose.view().playerId()) {
        return true;
      }
    }
    return false;
  }

  private static final class Ear implements MessageListener {
    final List<String> said = new ArrayList<>();
    final List<String> heard = new ArrayList<>();
    int newest = -1;

    Ear(SimulatedClient client) {
      client.game().messages(this);
    }

    @Override
    public void said(int player, boolean team, String text) {
      said.add(player + ": " + text);
    }

    @Override
    public void heard(Message m) {
      if (m.is(DuelGame.SOLD)) {
        heard.add(m.count("item") + " " + m.text("note"));
      } else {
        assertTrue(m.count("number") > newest, "an older pointer after a newer one");
        newest = m.count("number");
      }
    }
  }

  @Test
  void everybodyIsToldTeamReadinessAndPing() {
    try (Stepper stepper = duel()) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(1));
      stepper.run(4);
      assertEquals(1, row(ann, bob).team());
      assertEquals(2, row(bob, ann).team());
      assertTrue(row(ann, bob).alive());
      assertFalse(row(ann, bob).ready());
      assertTrue(ann.game().ready(true));
      stepper.run(1);
      assertTrue(row(ann, bob).ready());
      assertTrue(row(ann, ann).ready());
      assertFalse(row(bob, ann).ready());
      int ping = row(bob, ann).pingMs();
      assertTrue(ping >= 140 && ping <= 230, "ping=" + ping + " of a round trip of 150 ms");
    }
  }

  @Test
  void aRefusalIsToldInWordsToTheOneThatAsked() {
    try (Stepper stepper = duel()) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", BAD, InputSource.IDLE);
      Ear annHears = new Ear(ann);
      Ear bobHears = new Ear(bob);
      ann.game().team(2);
      stepper.run(2.5);
      ann.game().team(200);
      stepper.run(1);
      assertEquals(
          List.of("-1: East has more players than West", "-1: There is no team 200, only 1 to 2"),
          annHears.said);
      assertEquals(List.of(), bobHears.said);
      assertEquals(1, participant(stepper, ann).team());
    }
  }

  @Test
  void aPlayerWatchesAndPlaysAgainWithoutGhostsOrAStormOfCorrections() {
    try (Stepper stepper = duel()) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.wander(1));
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      stepper.run(4);
      assertNotNull(ann.view().own());
      ann.game().role(PlayerRole.SPECTATOR);
      stepper.run(1.5);
      assertTrue(participant(stepper, ann).isSpectator());
      assertNull(stepper.player(ann));
      assertNull(ann.view().own());
      assertFalse(shows(ann, ann), "a ghost of the own body");
      assertFalse(shows(bob, ann), "a ghost at another client");
      assertTrue(row(ann, bob).spectator());
      assertFalse(row(ann, bob).alive());
      assertEquals(HostPlayer.NO_TEAM, row(ann, bob).team());
      long corrections = ann.stats().corrections();
      stepper.run(3);
      assertEquals(corrections, ann.stats().corrections(), "while watching");
      ann.game().role(PlayerRole.PLAYER);
      stepper.run(1.5);
      assertNotNull(ann.view().own());
      assertTrue(row(ann, bob).alive());
      assertEquals(-1, ann.view().watchedPlayer());
      corrections = ann.stats().corrections();
      stepper.run(5);
      assertEquals(corrections, ann.stats().corrections(), "alone, prediction is exact");
      for (int i = 0; i < 6; i++) {
        ann.game().role(PlayerRole.values()[(i + 1) % 2]);
        stepper.run(1.1);
      }
      assertFalse(participant(stepper, ann).isSpectator());
      assertNotNull(ann.view().own());
      assertTrue(ann.stats().corrections() < corrections + 10, ann.stats().corrections() + "");
    }
  }

  @Test
  void theViewOfADeadPlayerFollowsAnotherFarAwayUntilItIsBack() {
    try (Stepper stepper = duel()) {
      boolean[] dies = {false};
      SimulatedClient ann =
          stepper.join("Ann", BAD, (view, tick, out) -> out.hold(Input.SECOND, dies[0]));
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      stepper.run(3);
      assertFalse(shows(ann, bob), "400 m away");
      dies[0] = true;
      stepper.run(0.5);
      dies[0] = false;
      stepper.run(0.7);
      assertNull(ann.view().own());
      assertEquals(-1, ann.view().watchedPlayer(), "for a moment the picture stays");
      stepper.run(2);
      assertEquals(bob.view().playerId(), ann.view().watchedPlayer());
      assertNotNull(ann.view().watched());
      assertEquals(
          DuelGame.APART, ann.view().watched().x(), 40, "the picture is where the other plays");
      assertFalse(row(ann, bob).alive());
      stepper.run(DuelGame.OUT_SECONDS);
      assertNotNull(ann.view().own());
      assertEquals(-1, ann.view().watchedPlayer());
      assertEquals(-DuelGame.APART, ann.view().own().x(), 1);
      stepper.run(3);
      assertFalse(shows(ann, bob));
    }
  }

  @Test
  void aSpectatorGoesRoundAmongThosePlayersThatAreAlive() {
    try (Stepper stepper = duel()) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      List<SimulatedClient> others = stepper.join(3);
      ann.game().role(PlayerRole.SPECTATOR);
      stepper.run(2);
      List<Integer> watched = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        watched.add(ann.view().watchedPlayer());
        ann.game().watchNext(1);
        stepper.run(1.5);
        assertNotNull(ann.view().watched(), "turn " + i);
      }
      assertEquals(3, watched.stream().distinct().count(), watched.toString());
      assertEquals(watched.get(0), watched.get(3));
      assertFalse(watched.contains(ann.view().playerId()));
      ann.game().watchNext(-1);
      stepper.run(0.5);
      assertEquals(watched.get(0), ann.view().watchedPlayer());
      int left = ann.view().watchedPlayer();
      others.stream().filter(c -> c.view().playerId() == left).findFirst().orElseThrow().leave();
      stepper.run(2);
      assertNotEquals(left, ann.view().watchedPlayer());
      assertNotNull(ann.view().watched());
    }
  }

  @Test
  void aSpectatorIsOneStillAfterABrokenLink() {
    try (Stepper stepper = duel()) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      ann.game().role(PlayerRole.SPECTATOR);
      stepper.run(1);
      ann.cut();
      stepper.run(3);
      assertTrue(ann.stats().reconnects() > 0);
      assertTrue(row(ann, bob).spectator());
      assertNotNull(ann.view().watched());
    }
  }

  @Test
  void aSpectatorWatchesTheNextMatchToo() {
    try (Stepper stepper = duel()) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      ann.game().role(PlayerRole.SPECTATOR);
      stepper.run(1);
      stepper.room().simulation().playNext(NextMatch.level("arena"));
      stepper.runUntil("the arena begins", () -> stepper.count(Counter.MATCHES) == 1, 5);
      stepper.run(3);
      assertEquals("arena", ann.view().game());
      assertTrue(participant(stepper, ann).isSpectator());
      assertTrue(row(ann, bob).spectator());
      assertNull(ann.view().own());
      assertEquals(bob.view().playerId(), ann.view().watchedPlayer());
      assertNotNull(ann.view().watched());
      ann.game().role(PlayerRole.PLAYER);
      stepper.run(1);
      assertNotNull(ann.view().own());
    }
  }

  @Needs("sockets")
  @Test
  void aGamesMessagesGoBothWaysOverSocketsOnABadNetwork() {
    try (Stepper stepper = Stepper.overSockets(DuelGame.level(), ServerConfig.defaults())) {
      SimulatedClient ann = stepper.join("Ann", BAD, Scripts.wander(1));
      SimulatedClient bob = stepper.join("Bob", BAD, Scripts.wander(2));
      Ear annHears = new Ear(ann);
      Ear bobHears = new Ear(bob);
      List<String> bought = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        assertTrue(ann.game().send(DuelGame.BUY.of(i, "愛 " + i)));
        bought.add(i + " 愛 " + i);
        assertTrue(ann.game().send(DuelGame.POINT.of(i)));
        stepper.run(0.2);
      }
      stepper.run(1);
      assertEquals(bought, annHears.heard, "reliable: each one once, in order");
      assertEquals(List.of(), bobHears.heard, "not for Bob");
      assertTrue(bobHears.newest >= 15, "newest=" + bobHears.newest + ": most arrive");
      ann.game().role(PlayerRole.SPECTATOR);
      bob.game().ready(true);
      stepper.runUntil(
          "Bob is ready and sees that Ann watches, and she watches Bob",
          () ->
              row(ann, bob).spectator()
                  && row(bob, ann).ready()
                  && ann.view().watchedPlayer() == bob.view().playerId(),
          5);
    }
  }
}
