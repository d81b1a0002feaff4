package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.MessageListener;
import carom.net.transport.Impairment;
import carom.server.metrics.Counter;
import carom.sim.message.Emote;
import carom.suite.Needs;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: reliable messages are heard once and in order, whatever the network does, also those sent
 * while a link was broken. Method: clients chat in virtual time; what each hears is compared with
 * what was said.
 */
class MessageScenarioTest {
  private static final Impairment BAD =
      Impairment.NONE
          .withBursts(10, 4)
          .withLatency(75, 30)
          .withReorder(5, 5)
          .withSeed(Stepper.SEED);

  /** What one client hears. */
  private static final class Ear implements MessageListener {
    final List<String> lines = new ArrayList<>();
    final List<String> emotes = new ArrayList<>();
    int missed;

    Ear(SimulatedClient client) {
      client.game().messages(this);
    }

    @Override
    public void said(int player, boolean team, String text) {
      lines.add((team ? "team " : "") + player + ": " + text);
    }

    @Override
    public void emoted(int player, Emote emote) {
      emotes.add(player + " " + emote);
    }

    @Override
    public void missed(int count) {
      missed += count;
    }
  }

  @Test
  void everybodyHearsEachLineOnceAndInOrderOnABadNetwork() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", BAD, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", BAD, InputSource.IDLE);
      Ear annHears = new Ear(ann);
      Ear bobHears = new Ear(bob);
      List<String> said = new ArrayList<>();
      for (int i = 0; i < 10; i++) {
        assertTrue(ann.game().chat("line " + i));
        said.add(ann.view().playerId() + ": line " + i);
        stepper.run(0.6);
      }
      assertTrue(ann.game().emote(Emote.WOW));
      stepper.run(1);
      assertEquals(said, annHears.lines);
      assertEquals(said, bobHears.lines);
      assertEquals(List.of(ann.view().playerId() + " WOW"), bobHears.emotes);
      assertEquals(0, stepper.count(Counter.MESSAGES_DROPPED));
    }
  }

  @Test
  void linesSaidWhileALinkIsBrokenAreHeardOnceWhenItIsBack() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", Impairment.NONE, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", Impairment.NONE, InputSource.IDLE);
      Ear annHears = new Ear(ann);
      Ear bobHears = new Ear(bob);
      List<String> said = new ArrayList<>();
      for (int i = 0; i < 12; i++) {
        if (i % 4 == 1) {
          bob.cut();
        }
        assertTrue(ann.game().chat("to Bob " + i));
        assertTrue(bob.game().chat("to Ann " + i));
        stepper.run(1);
      }
      stepper.run(5);
      assertTrue(bob.stats().reconnects() > 0, "the link was never lost");
      for (int i = 0; i < 12; i++) {
        said.add("to Bob " + i);
        said.add("to Ann " + i);
      }
      assertEquals(sorted(said), sorted(texts(annHears)));
      assertEquals(sorted(said), sorted(texts(bobHears)));
      List<String> fromAnn = new ArrayList<>(texts(bobHears));
      fromAnn.removeIf(text -> text.startsWith("to Ann"));
      for (int i = 0; i < 12; i++) {
        assertEquals("to Bob " + i, fromAnn.get(i), "in the order they were said");
      }
      assertEquals(0, annHears.missed + bobHears.missed);
    }
  }

  private static List<String> texts(Ear ear) {
    return ear.lines.stream().map(line -> line.substring(line.indexOf(' ') + 1)).toList();
  }

  private static List<String> sorted(List<String> list) {
    return list.stream().sorted().toList();
  }

  @Test
  void aClientKnowsWhenItSaysTooMuch() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", Impairment.NONE, InputSource.IDLE);
      Ear hears = new Ear(ann);
      int taken = 0;
      for (int i = 0; i < 20; i++) {
        taken += ann.game().chat("spam " + i) ? 1 : 0;
      }
      assertFalse(ann.game().chat("   "), "there is nothing to say");
      stepper.run(3);
      assertEquals(4, taken);
      assertEquals(4, hears.lines.size());
      assertTrue(ann.game().chat("again"));
    }
  }

  @Needs("sockets")
  @Test
  void linesArriveOverSockets() {
    try (Stepper stepper = Stepper.overSockets("arena")) {
      SimulatedClient ann = stepper.join("Ann", Impairment.NONE, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", Impairment.NONE, InputSource.IDLE);
      Ear hears = new Ear(bob);
      assertTrue(ann.game().chat("Zoë says 愛"));
      stepper.runUntil("Bob hears Ann", () -> !hears.lines.isEmpty(), 5);
      assertEquals(List.of(ann.view().playerId() + ": Zoë says 愛"), hears.lines);
    }
  }
}
