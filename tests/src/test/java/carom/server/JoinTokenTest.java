package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.seal.PlayerKey;
import carom.server.access.AccessLists;
import carom.server.config.DataFolder;
import carom.server.config.ServerConfig;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.time.Instant;
import java.util.Base64;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: the operator's backend decides who joins. Method: a whole server in virtual time. */
final class JoinTokenTest {
  private static final long NOW = 1_800_000_000L;

  private final Rig rig =
      new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 4), new TestGame(3));
  @TempDir private Path folder;
  private KeyPair backend;
  private long now = NOW;
  private int uses;

  @BeforeEach
  void demandTokens() throws Exception {
    if (backend == null) {
      backend = KeyPairGenerator.getInstance("Ed25519").generateKeyPair();
    }
    Path file = folder.resolve("join.pem");
    byte[] key = backend.getPublic().getEncoded();
    Files.writeString(
        file,
        "-----BEGIN PUBLIC KEY-----\n"
            + Base64.getEncoder().encodeToString(key)
            + "\n-----END PUBLIC KEY-----\n");
    AccessLists lists =
        new AccessLists(new DataFolder(folder), false, () -> Instant.ofEpochSecond(now));
    lists.demandTokens(file, "us", uses);
    rig.server.admit(lists);
  }

  @AfterEach
  void close() {
    rig.close();
  }

  private static String base64(byte[] bytes) {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  private String token(String claims) throws Exception {
    String text =
        base64("{\"alg\":\"EdDSA\"}".getBytes(StandardCharsets.UTF_8))
            + "."
            + base64(claims.getBytes(StandardCharsets.UTF_8));
    Signature signature = Signature.getInstance("Ed25519");
    signature.initSign(backend.getPrivate());
    signature.update(text.getBytes(StandardCharsets.US_ASCII));
    return text + "." + base64(signature.sign());
  }

  private FakeClient join(String name, String token, long secret) {
    FakeClient client = rig.connect();
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION, Protocol.physicsDigest(), name, secret, "", "", "", token));
    for (int i = 0; i < 60 && client.refused == null && !client.ready; i++) {
      rig.step();
    }
    return client;
  }

  @Test
  void aTokenNamesAccountAndName() throws Exception {
    FakeClient ann =
        join("anything", token("{\"sub\":\"7\",\"exp\":1800000060,\"name\":\"Ann\"}"), 0);
    assertNull(ann.refused);
    assertNotNull(ann.welcome);
    for (int i = 0; i < 20; i++) {
      rig.step();
    }
    assertEquals("Ann", ann.roster.entries().get(0).name());
    Files.writeString(folder.resolve("bans.txt"), "account 8 cheats\n");
    demandTokens();
    FakeClient bob = join("Bob", token("{\"sub\":\"8\",\"exp\":1800000060}"), 0);
    assertEquals(RefusalReason.BANNED, bob.refused.reason());
  }

  @Test
  void withoutAGoodTokenNobodyJoins() throws Exception {
    String good = token("{\"sub\":\"7\",\"exp\":1800000060}");
    for (String token : new String[] {"", "x", good.substring(0, good.length() - 2), good + "A"}) {
      FakeClient client = join("Eve", token, 0);
      assertNotNull(client.refused, token);
      assertEquals(RefusalReason.TOKEN_INVALID, client.refused.reason());
    }
    now += 60;
    FakeClient late = join("Ann", good, 0);
    assertEquals(RefusalReason.TOKEN_INVALID, late.refused.reason());
    assertTrue(late.refused.text().contains("expired"), late.refused.text());
  }

  @Test
  void aPlayerComesBackWithoutAToken() throws Exception {
    FakeClient ann = join("Ann", token("{\"sub\":\"7\",\"exp\":1800000060}"), 0);
    for (int i = 0; i < 10; i++) {
      rig.step();
    }
    long secret = ann.welcome.sessionSecret();
    ann.link.close("lost");
    now += 3_600;
    for (int i = 0; i < 120; i++) {
      rig.step();
    }
    FakeClient again = join("Ann", "", secret);
    assertNull(again.refused);
    assertEquals(ann.welcome.playerId(), again.welcome.playerId());
    FakeClient thief = join("Ann", "", secret + 1);
    assertEquals(RefusalReason.TOKEN_INVALID, thief.refused.reason());
  }

  @Test
  void anAccountThatIsBannedWhileItIsAwayDoesNotComeBack() throws Exception {
    FakeClient ann = join("Ann", token("{\"sub\":\"7\",\"exp\":1800000060}"), 0);
    for (int i = 0; i < 10; i++) {
      rig.step();
    }
    ann.link.close("lost");
    Files.writeString(folder.resolve("bans.txt"), "account 7 cheats\n");
    demandTokens();
    FakeClient again = join("Ann", "", ann.welcome.sessionSecret());
    assertEquals(RefusalReason.BANNED, again.refused.reason());
  }

  @Test
  void anAccountHasAsManySeatsAsATokenHasUses() throws Exception {
    uses = 1;
    demandTokens();
    String seven = token("{\"sub\":\"7\",\"exp\":1800000060}");
    FakeClient ann = join("Ann", seven, 0);
    assertNotNull(ann.welcome);
    FakeClient again = join("Ann", seven, 0);
    for (int i = 0; i < 1_200 && again.refused == null && again.welcome == null; i++) {
      rig.step();
    }
    assertNull(again.welcome);
    assertEquals(RefusalReason.TOKEN_INVALID, again.refused.reason());
    assertTrue(again.refused.text().startsWith("Your account plays here"), again.refused.text());
    FakeClient bob = join("Bob", token("{\"sub\":\"8\",\"exp\":1800000060}"), 0);
    assertNotNull(bob.welcome, "another account");
    ann.link.close("lost");
    rig.step();
    FakeClient back = join("Ann", "", ann.welcome.sessionSecret());
    assertNull(back.refused, "the seat is its own");
    back.link.send(new ClientMessage.Leave());
    for (int i = 0; i < 60; i++) {
      rig.step();
    }
    FakeClient anew = join("Ann", seven, 0);
    assertNotNull(anew.welcome, "the seat is free");
    uses = 2;
    demandTokens();
    assertNotNull(join("Ann", seven, 0).welcome, "two seats");
  }

  @Test
  void noTokenClaimsTheAccountOfAKey() throws Exception {
    FakeClient thief = join("Eve", token("{\"sub\":\"key:x\",\"exp\":1800000060}"), 0);
    assertEquals(RefusalReason.TOKEN_INVALID, thief.refused.reason());
    assertTrue(thief.refused.text().contains("own keys"), thief.refused.text());
    FakeClient key = rig.connect();
    String proof = PlayerKey.random().proof(key.link.binding());
    key.link.close("only its link is of use");
    assertEquals(
        RefusalReason.TOKEN_INVALID, join("Eve", proof, 0).refused.reason(), "tokens are demanded");
  }
}
