package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.server.metrics.Counter;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.PlayerRole;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: what a modified client asks of the roster costs it its session, or nothing, and never the
 * others. Method: raw messages, more and others than a client of ours sends.
 */
final class RosterHostileTest {
  private int number;

  private void send(Rig rig, FakeClient client, Message message) {
    byte[] bytes = rig.room.simulation().messageKinds().encode(message, Direction.FROM_CLIENT);
    sendRaw(client, bytes);
  }

  private void sendRaw(FakeClient client, byte[] bytes) {
    client.link.send(new ClientMessage.GameMessage(++number, bytes));
  }

  private static FakeClient joined(Rig rig, String name) {
    FakeClient client = rig.join(name);
    client.link.send(new ClientMessage.Heard(0));
    rig.seconds(0.2);
    return client;
  }

  @Test
  void aFloodOfRolesJoinsAndLeavesNoMoreThanOnceASecond() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      FakeClient bob = joined(rig, "Bob");
      List<PlayerRole> roles = new ArrayList<>();
      for (int tick = 0; tick < 300; tick++) {
        send(rig, ann, BuiltInKinds.ROLE.of(PlayerRole.values()[(tick + 1) % 2]));
        rig.step();
        PlayerRole role = rig.room.simulation().participant(0).role();
        if (roles.isEmpty() || roles.get(roles.size() - 1) != role) {
          roles.add(role);
        }
      }
      assertTrue(roles.size() > 2 && roles.size() <= 14, "changes=" + roles.size());
      assertTrue(rig.room.counters().get(Counter.MESSAGES_DROPPED) > 100);
      assertFalse(bob.closed);
      assertNotNull(rig.room.simulation().player(1).entity());
    }
  }

  @Test
  void aFloodOfReadinessAndTeamsHurtsNobody() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      FakeClient bob = joined(rig, "Bob");
      for (int tick = 0; tick < 120; tick++) {
        for (int i = 0; i < 8; i++) {
          send(rig, ann, BuiltInKinds.READY.of(i % 2 == 0));
          send(rig, ann, BuiltInKinds.TEAM.of((tick * 8 + i) % 256));
        }
        rig.step();
      }
      int rosters = 0;
      for (Object message : bob.messages) {
        rosters += message instanceof carom.net.protocol.ServerMessage.Roster ? 1 : 0;
      }
      assertTrue(rosters < 20, "rosters=" + rosters);
      assertEquals(0, rig.room.simulation().player(0).team(), "the game has no teams");
      assertFalse(bob.closed);
    }
  }

  @Test
  void aRoleOrTeamOutOfRangeEndsTheSession() {
    for (byte[] bytes :
        List.of(
            new byte[] {5, 2}, new byte[] {6, (byte) 0x80, 2}, new byte[] {4, 2}, new byte[] {6})) {
      try (Rig rig = new Rig()) {
        FakeClient ann = joined(rig, "Ann");
        assertEquals("carom.ready", rig.room.simulation().messageKinds().get(4).name());
        assertEquals("carom.role", rig.room.simulation().messageKinds().get(5).name());
        assertEquals("carom.team", rig.room.simulation().messageKinds().get(6).name());
        number = 0;
        sendRaw(ann, bytes);
        rig.seconds(0.2);
        assertNotNull(ann.goodbye, java.util.Arrays.toString(bytes));
        assertEquals(GoodbyeReason.PROTOCOL_ERROR, ann.goodbye.reason());
        assertNull(rig.room.simulation().participant(0));
      }
    }
  }

  @Test
  void whoLooksAtNobodyOrAtItselfSeesWhatItSaw() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      for (int follows : new int[] {0, 5, 1_023, -1}) {
        ann.link.send(new ClientMessage.Look(0, 0, 9, 9, follows));
        rig.seconds(0.3);
        assertFalse(ann.closed);
      }
      rig.room.simulation().role(rig.room.simulation().participant(0), PlayerRole.SPECTATOR);
      for (int follows : new int[] {0, 5, 1_023, -1}) {
        ann.link.send(new ClientMessage.Look(0, 0, 9, 9, follows));
        rig.seconds(0.3);
        assertFalse(ann.closed);
      }
      assertEquals(0, rig.room.counters().get(Counter.SESSIONS_FAILED));
    }
  }

  @Test
  void anInputOfASpectatorDoesNothing() {
    try (Rig rig = new Rig()) {
      FakeClient ann = joined(rig, "Ann");
      rig.room.simulation().role(rig.room.simulation().participant(0), PlayerRole.SPECTATOR);
      ann.input.move(1, 0);
      rig.seconds(0.5);
      assertEquals(0, rig.room.simulation().participant(0).input().moveX());
      ann.input.clear();
    }
  }
}
