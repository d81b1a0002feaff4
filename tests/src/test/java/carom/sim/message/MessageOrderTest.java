package carom.sim.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.game.GuardedGame;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.Role;
import carom.sim.SetUp;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Player;
import carom.sim.level.Level;
import carom.sim.outbox.Delivery;
import carom.sim.outbox.Delivery.Recipients;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: messages enter a simulation at a tick and in an order that depends on nothing else, and the
 * built-in ones do in every game what the page says. Method: a game that writes down what it gets.
 */
final class MessageOrderTest {
  private static final MessageKind ADD = MessageKind.named("add").fromClient().count("n", 0, 99);
  private static final MessageKind SUM = MessageKind.named("sum").fromServer().count("n", 0, 999);

  private static final class Notes extends PlainGame {
    final List<String> heard = new ArrayList<>();
    String censored = "";

    Notes() {
      super("notes");
    }

    @Override
    public void setUp(SetUp s) {
      s.message(ADD);
      s.message(SUM);
    }

    @Override
    public void message(Match s, Player p, Message m) {
      heard.add(s.tick() + ": " + p.id() + " " + m);
      s.addScore(p, m.count("n"));
      if (m.count("n") == 13) {
        throw new IllegalStateException("unlucky");
      }
      s.send(SUM.of(s.score(p))).to(p);
    }

    @Override
    public void beforeStep(Match s) {
      heard.add(s.tick() + ": step");
    }

    @Override
    public String chat(Match s, Player p, String text) {
      return text.equals(censored) ? null : text.replace("darn", "****");
    }
  }

  private final Notes game = new Notes();
  private final SimulationHost s = simulation(new GuardedGame(game, (what, where, why) -> {}));
  private final HostPlayer ann = s.join("Ann");
  private final HostPlayer bob = s.join("Bob");

  private static SimulationHost simulation(Game game) {
    String json =
        "{\"name\":\"n\",\"game\":\"notes\",\"gravity\":[0,0],"
            + "\"bounds\":{\"min\":[-9,-9],\"max\":[9,9]},\"statics\":[]}";
    try {
      Level level = Level.parse("notes", json.getBytes(java.nio.charset.StandardCharsets.UTF_8));
      return new SimulationHost(game, level, 1, 60, Role.AUTHORITY);
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
  }

  private List<Delivery> sent() {
    List<Delivery> sent = new ArrayList<>();
    s.outbox().drainMessages(sent::add);
    return sent;
  }

  @Test
  void messagesAreHandledBeforeTheStepByPlayerAndThenByArrival() {
    s.receive(bob, ADD.of(1));
    s.receive(ann, ADD.of(2));
    s.receive(bob, ADD.of(3));
    s.receive(ann, ADD.of(4));
    assertEquals(List.of(), game.heard, "nothing happens between steps");
    s.step();
    s.step();
    assertEquals(
        List.of(
            "1: 0 add n=2", "1: 0 add n=4", "1: 1 add n=1", "1: 1 add n=3", "1: step", "2: step"),
        game.heard);
    assertEquals(6, ann.score());
    List<Delivery> sent = sent();
    assertEquals(4, sent.size());
    assertEquals(Recipients.ONE, sent.get(1).recipients());
    assertEquals(ann.id(), sent.get(1).id());
    assertEquals("sum n=6", sent.get(1).message().toString());
    assertEquals(List.of(), sent());
  }

  @Test
  void onePlayerCannotFillAStep() {
    for (int i = 0; i < WaitingMessages.MAX_PER_PLAYER; i++) {
      assertTrue(s.receive(ann, ADD.of(1)));
    }
    assertFalse(s.receive(ann, ADD.of(1)));
    assertTrue(s.receive(bob, ADD.of(1)), "others are not affected");
    s.step();
    assertTrue(s.receive(ann, ADD.of(1)));
    assertEquals(WaitingMessages.MAX_PER_PLAYER, ann.score());
  }

  @Test
  void messagesOfAPlayerWhoLeftAreForgottenAndAFailureStopsNoOther() {
    s.receive(ann, ADD.of(1));
    s.leave(ann);
    HostPlayer cid = s.join("Cid");
    assertEquals(ann.id(), cid.id());
    s.receive(bob, ADD.of(13));
    s.receive(bob, ADD.of(5));
    s.step();
    assertEquals(0, cid.score());
    assertEquals(18, bob.score());
  }

  @Test
  void whatWaitsIsAnInputAndNotPartOfASavedState() {
    SimState before = s.save(null);
    s.receive(ann, ADD.of(7));
    s.restore(before);
    s.step();
    assertEquals(0, ann.score());
  }

  @Test
  void kindsThatClientsSendCannotBeSentByTheGame() {
    assertThrows(IllegalArgumentException.class, () -> s.send(ADD.of(1)));
    assertThrows(
        IllegalArgumentException.class, () -> s.send(MessageKind.named("unknown").of()).toAll());
  }

  @Test
  void chatGoesToAllOrToTheTeamAndThroughTheGame() {
    bob.team(2);
    game.censored = "secret";
    s.receive(ann, BuiltInKinds.SAY.of(false, "  darn it "));
    s.receive(ann, BuiltInKinds.SAY.of(false, "secret"));
    s.receive(ann, BuiltInKinds.SAY.of(false, "   "));
    s.receive(bob, BuiltInKinds.SAY.of(true, "left!"));
    s.step();
    List<Delivery> sent = sent();
    assertEquals(2, sent.size());
    assertEquals("**** it", sent.get(0).message().text("text"));
    assertEquals(ann.id(), sent.get(0).message().count("player"));
    assertEquals(Recipients.ALL, sent.get(0).recipients());
    assertEquals(Recipients.TEAM, sent.get(1).recipients());
    assertEquals(2, sent.get(1).id());
    assertTrue(sent.get(1).message().flag("team"));
  }

  @Test
  void aPlayerWithoutABodyShowsNoEmote() {
    assertNull(ann.entity());
    s.receive(ann, BuiltInKinds.EMOTE.of(Emote.WOW));
    s.step();
    assertEquals(List.of(), sent());
  }
}
