package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.seal.PlayerKey;
import carom.server.config.ServerConfig;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Goal: a player's own key is an account. Method: a whole server in virtual time. */
final class PlayerKeyTest {
  private final PlayerKey key = PlayerKey.random();
  private final Rig rig =
      new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 4), new TestGame(3));

  @AfterEach
  void close() {
    rig.close();
  }

  private FakeClient join(FakeClient client, String token, long secret) {
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION, Protocol.physicsDigest(), "Ann", secret, "", "", "", token));
    for (int i = 0; i < 60 && client.refused == null && !client.ready; i++) {
      rig.step();
    }
    for (int i = 0; i < 10; i++) {
      rig.step();
    }
    return client;
  }

  private String account() {
    return rig.server.rooms().get(0).session(0).seat().account();
  }

  @Test
  void aKeyIsAnAccountAlsoWhenThePlayerComesBack() {
    FakeClient ann = rig.connect();
    join(ann, key.proof(ann.link.binding()), 0);
    assertNotNull(ann.welcome);
    assertEquals(key.account(), account());
    ann.link.close("lost");
    for (int i = 0; i < 120; i++) {
      rig.step();
    }
    FakeClient again = join(rig.connect(), "", ann.welcome.sessionSecret());
    assertNull(again.refused);
    assertEquals(key.account(), account());
  }

  @Test
  void aProofThatAnotherServerWasShownIsRefused() {
    FakeClient there = rig.connect();
    FakeClient here = join(rig.connect(), key.proof(there.link.binding()), 0);
    assertEquals(RefusalReason.TOKEN_INVALID, here.refused.reason());
    assertTrue(here.refused.text().contains("signature"), here.refused.text());
  }

  @Test
  void withoutAKeyAPlayerIsAStranger() {
    join(rig.connect(), "", 0);
    assertEquals("", account());
  }
}
