package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.link.ConnectionPhase;
import carom.server.Backend;
import carom.server.config.ServerConfig;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: with {@code --room-rule skill} players get to those who are about as good, and nobody waits
 * for ever. Method: a fleet in virtual time, tokens that claim a skill.
 */
final class SkillScenarioTest {
  @TempDir Path folder;

  private FleetRig rig(String... servers) throws Exception {
    FleetRig rig = new FleetRig(folder, 4);
    rig.roomRule = ServerConfig.RoomRule.SKILL;
    for (String server : servers) {
      rig.node(server, 3).server.admit(Backend.rule(folder));
    }
    rig.run(1);
    return rig;
  }

  private static GameClient come(FleetRig rig, String server, int skill, String party)
      throws Exception {
    String name = "p" + rig.clients.size();
    return rig.client(
        ClientConfig.of(name)
            .with(ClientConfig.PARTY, party)
            .with(ClientConfig.TOKEN, Backend.token(name, skill, 2_000)),
        server);
  }

  private static boolean plays(GameClient client) {
    return client.view().phase() == ConnectionPhase.PLAYING;
  }

  /** Returns the seconds until a client plays, at most 20. */
  private static double secondsUntil(FleetRig rig, GameClient client) {
    double seconds = 0;
    while (!plays(client) && seconds < 20) {
      rig.run(0.1);
      seconds += 0.1;
    }
    return seconds;
  }

  @Test
  void aPlayerWaitsForEqualsTheLongerTheLessEqual() throws Exception {
    try (FleetRig rig = rig("a")) {
      GameClient first = come(rig, "a", 1_500, "");
      assertTrue(secondsUntil(rig, first) < 1, "there is nobody to wait for");
      GameClient equal = come(rig, "a", 1_590, "");
      assertTrue(secondsUntil(rig, equal) < 1);
      assertEquals(first.view().room(), equal.view().room());

      GameClient better = come(rig, "a", 1_785, ""); // 240 from the mean of both
      rig.run(2);
      String message = better.view().message();
      assertTrue(message.startsWith("Looking for players of about your skill; in "), message);
      assertEquals(3.5, 2 + secondsUntil(rig, better), 0.7, "(240 - 100) / 40 s, and to load");
      assertEquals(first.view().room(), better.view().room());

      GameClient best = come(rig, "a", 3_000, "");
      assertEquals(10, secondsUntil(rig, best), 1, "then any room will do");
      assertEquals(first.view().room(), best.view().room(), "the fullest");
    }
  }

  @Test
  void twoWhoWaitAndSuitEachOtherBeginInAnEmptyRoom() throws Exception {
    try (FleetRig rig = rig("a")) {
      GameClient first = come(rig, "a", 1_500, "");
      rig.run(1);
      GameClient one = come(rig, "a", 2_500, "");
      rig.run(3);
      assertEquals(ConnectionPhase.JOINING, one.view().phase());
      GameClient other = come(rig, "a", 2_450, "");
      rig.run(2);
      assertTrue(plays(one) && plays(other));
      assertEquals(one.view().room(), other.view().room());
      assertNotEquals(first.view().room(), one.view().room());
      String rooms = rig.nodes.get("a").member.run(List.of("rooms"));
      assertTrue(rooms.contains("2475") && rooms.contains("1500"), rooms);
    }
  }

  @Test
  void theyMeetAlsoWhenTheyWaitAtDifferentServers() throws Exception {
    for (String late : new String[] {"a", "b"}) {
      try (FleetRig rig = rig("a", "b")) {
        GameClient first = come(rig, "a", 1_500, "");
        rig.run(2);
        GameClient one = come(rig, late.equals("a") ? "b" : "a", 2_500, "");
        rig.run(2);
        assertEquals(ConnectionPhase.JOINING, one.view().phase());
        GameClient other = come(rig, late, 2_450, "");
        rig.run(4);
        assertTrue(plays(one) && plays(other), () -> one.view().message() + other.view().message());
        assertEquals(one.view().room(), other.view().room());
        assertNotEquals(first.view().room(), one.view().room());
      }
    }
  }

  @Test
  void roomsOfOtherServersCountByTheSkillThatTheyTell() throws Exception {
    try (FleetRig rig = rig("a", "b")) {
      GameClient low = come(rig, "a", 1_000, "");
      rig.run(1);
      GameClient high = rig.client(named("high", "6", 2_000), "b");
      rig.run(1);
      assertEquals("6", high.view().room(), "who names a room goes there");
      GameClient equal = come(rig, "a", 1_950, "");
      rig.run(1.5);
      assertEquals("6", equal.view().room());
      assertNotEquals("6", low.view().room());
      rig.owners("6").get(0).kill();
      rig.run(2);
      GameClient later = come(rig, "a", 1_980, "");
      rig.run(1.5);
      assertEquals("6", later.view().room(), "what the token claims outlives a server");
    }
  }

  private static ClientConfig named(String name, String room, int skill) throws Exception {
    return ClientConfig.of(name)
        .with(ClientConfig.ROOM, room)
        .with(ClientConfig.TOKEN, Backend.token(name, skill, 2_000));
  }

  @Test
  void friendsDoNotWaitForEqualsButForEachOther() throws Exception {
    try (FleetRig rig = rig("a", "b")) {
      GameClient first = come(rig, "a", 1_500, "");
      rig.run(1);
      GameClient friend = come(rig, "b", 2_500, "duo");
      GameClient weaker = come(rig, "a", 900, "duo");
      rig.run(2);
      assertTrue(plays(friend) && plays(weaker));
      assertEquals(friend.view().room(), weaker.view().room());
      assertNotEquals(first.view().room(), friend.view().room());
    }
  }
}
