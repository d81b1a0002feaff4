package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.server.metrics.Counter;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.PlayerRole;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Goal: an operator can speak, mute and make players watch. Method: a server and raw clients. */
final class ModeratorTest {
  private int number;

  private static String ask(Rig rig, Supplier<String> question) {
    CompletableFuture<String> answer = CompletableFuture.supplyAsync(question);
    while (!answer.isDone()) {
      rig.step();
      Thread.onSpinWait();
    }
    return answer.join();
  }

  private static FakeClient joined(Rig rig, String name) {
    FakeClient client = rig.join(name);
    client.link.send(new ClientMessage.Heard(0));
    rig.seconds(0.2);
    return client;
  }

  private void say(Rig rig, FakeClient client, String text) {
    Message line = BuiltInKinds.SAY.of(false, text);
    byte[] bytes = rig.room.simulation().messageKinds().encode(line, Direction.FROM_CLIENT);
    client.link.send(new ClientMessage.GameMessage(++number, bytes));
    rig.seconds(0.7);
  }

  private static List<String> heard(Rig rig, FakeClient client) {
    List<String> lines = new ArrayList<>();
    for (ServerMessage message : client.messages) {
      if (message instanceof ServerMessage.GameMessage m) {
        Message said =
            rig.room
                .simulation()
                .messageKinds()
                .decode(m.bytes(), 0, m.bytes().length, Direction.FROM_SERVER);
        assertNotNull(said);
        lines.add(said.count("player") + ": " + said.text("text"));
      }
    }
    return lines;
  }

  @Test
  void theOperatorSpeaksToAllWithoutCharactersThatCanNotBeShown() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      ask(rig, () -> "" + rig.room.operator().say("ten\u001b minutes"));
      rig.seconds(0.2);
      assertEquals(List.of("-1: ten minutes"), heard(rig, ann));
    }
  }

  @Test
  void whoIsMutedIsNotHeardUntilTheOperatorSaysSo() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      FakeClient bob = joined(rig, "Bob");
      say(rig, ann, "one");
      assertEquals("muted Ann", ask(rig, () -> rig.room.operator().mute("ann", true)));
      say(rig, ann, "two");
      assertEquals("unmuted Ann", ask(rig, () -> rig.room.operator().mute("ANN", false)));
      say(rig, ann, "three");
      assertEquals(List.of("0: one", "0: three"), heard(rig, bob));
      assertEquals(1, rig.room.counters().get(Counter.MESSAGES_MUTED));
      String nobody = ask(rig, () -> rig.room.operator().mute("Eve", true));
      assertTrue(nobody.startsWith("name=\"Eve\" doesn't play here"), nobody);
    }
  }

  @Test
  void theOperatorMakesAPlayerWatch() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      assertEquals("Ann watches", ask(rig, () -> rig.room.operator().spectate("Ann")));
      rig.seconds(0.5);
      assertEquals(PlayerRole.SPECTATOR, rig.room.simulation().participant(0).role());
      assertTrue(ann.roster.entries().get(0).spectator());
      assertFalse(ann.closed);
      assertEquals("Ann watches already", ask(rig, () -> rig.room.operator().spectate("Ann")));
    }
  }
}
