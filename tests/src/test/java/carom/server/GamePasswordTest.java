package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.server.access.GamePassword;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: only those who know the password come in. Method: a server and raw clients. */
final class GamePasswordTest {
  private static final String RIGHT = "open sesame, please";

  @TempDir private Path folder;
  private final Rig rig = new Rig();

  @BeforeEach
  void demand() throws Exception {
    Path file = Files.writeString(folder.resolve("game.password"), RIGHT + "\n");
    rig.server.demand(new GamePassword(Secret.of(file), new LoginThrottle(() -> rig.nowNs)));
  }

  @AfterEach
  void close() {
    rig.close();
  }

  private FakeClient hello(String address, String password, long secret) {
    FakeClient client = rig.connectFrom(address);
    if (password != null) {
      client.link.send(new ClientMessage.Password(password));
    }
    client.hello("Ann", secret);
    for (int i = 0; i < 60 && client.refused == null && !client.ready; i++) {
      rig.step();
    }
    return client;
  }

  @Test
  void theRightOneLetsInAndAReturningPlayerNeedsNone() {
    FakeClient ann = hello("203.0.113.7", RIGHT, 0);
    assertNull(ann.refused);
    assertNotNull(ann.welcome);
    rig.seconds(1);
    ann.link.close("the line is cut");
    rig.seconds(2);
    FakeClient back = hello("203.0.113.7", null, ann.welcome.sessionSecret());
    assertNull(back.refused);
    assertEquals(ann.welcome.playerId(), back.welcome.playerId());
  }

  @Test
  void otherOnesAreRefusedAndLimitedForEachAddress() {
    FakeClient none = hello("203.0.113.7", null, 0);
    assertEquals(RefusalReason.PASSWORD_WRONG, none.refused.reason());
    assertEquals("", none.refused.text());
    for (int i = 0; i < LoginThrottle.MOST; i++) {
      FakeClient wrong = hello("203.0.113.7", RIGHT + i, 0);
      assertEquals(RefusalReason.PASSWORD_WRONG, wrong.refused.reason());
      assertEquals("Yours is wrong.", wrong.refused.text());
    }
    FakeClient right = hello("203.0.113.7", RIGHT, 0);
    assertTrue(right.refused.text().startsWith("Too many wrong ones"), right.refused.text());
    assertNull(hello("203.0.113.8", RIGHT, 0).refused, "another address");
    rig.seconds(61);
    assertNull(hello("203.0.113.7", RIGHT, 0).refused, "a minute later");
  }

  @Test
  void whoWatchesMustKnowItToo() {
    FakeClient stranger = rig.connectFrom("203.0.113.7");
    stranger.link.send(new ClientMessage.Watch(Protocol.VERSION, Protocol.physicsDigest(), 1));
    rig.seconds(0.2);
    assertEquals(RefusalReason.PASSWORD_WRONG, stranger.refused.reason());
    FakeClient friend = rig.connectFrom("203.0.113.7");
    friend.link.send(new ClientMessage.Password(RIGHT));
    friend.link.send(new ClientMessage.Watch(Protocol.VERSION, Protocol.physicsDigest(), 1));
    rig.seconds(0.2);
    assertEquals(RefusalReason.NOT_SHOWN, friend.refused.reason());
  }

  @Test
  void noTextTellsIt() {
    assertFalse(new ClientMessage.Password(RIGHT).toString().contains(RIGHT));
  }
}
