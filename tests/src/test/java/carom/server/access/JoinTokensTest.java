package carom.server.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.PlayerName;
import carom.server.account.PlayerSkill;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.time.Instant;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: only the operator's own tokens let players in. Method: good ones, and all ways to cheat.
 */
final class JoinTokensTest {
  private static final long NOW = 1_800_000_000L;
  private static final String SERVER = "the-fingerprint";
  private static final String HEAD = "{\"alg\":\"EdDSA\",\"typ\":\"JWT\"}";

  @TempDir Path folder;
  private final KeyPair backend = pair();
  private final JoinTokens tokens =
      new JoinTokens(backend.getPublic(), SERVER, 0, () -> Instant.ofEpochSecond(NOW));

  private static KeyPair pair() {
    try {
      return KeyPairGenerator.getInstance("Ed25519").generateKeyPair();
    } catch (GeneralSecurityException e) {
      throw new AssertionError(e);
    }
  }

  private static String base64(byte[] bytes) {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  private static String token(KeyPair key, String head, String claims) {
    String text =
        base64(head.getBytes(StandardCharsets.UTF_8))
            + "."
            + base64(claims.getBytes(StandardCharsets.UTF_8));
    try {
      Signature signature = Signature.getInstance("Ed25519");
      signature.initSign(key.getPrivate());
      signature.update(text.getBytes(StandardCharsets.US_ASCII));
      return text + "." + base64(signature.sign());
    } catch (GeneralSecurityException e) {
      throw new AssertionError(e);
    }
  }

  private static String claims(String more) {
    return "{\"sub\":\"42\",\"exp\":" + (NOW + 60) + more + "}";
  }

  private void refused(String token, String why) {
    JoinTokens.BadTokenException e =
        assertThrows(JoinTokens.BadTokenException.class, () -> tokens.check(token), token);
    assertTrue(e.getMessage().contains(why), e::getMessage);
  }

  @Test
  void aGoodTokenSaysWhoItIs() throws JoinTokens.BadTokenException {
    assertEquals(
        new JoinTokens.Token("42", "Zo\u00eb", "cup", PlayerSkill.NO_CLAIM),
        tokens.check(
            token(
                backend,
                HEAD,
                claims(",\"name\":\"Zo\u00eb\",\"room\":\"cup\",\"server\":\"" + SERVER + "\""))));
    assertEquals(
        new JoinTokens.Token("42", "", "", PlayerSkill.NO_CLAIM),
        tokens.check(token(backend, HEAD, claims(""))));
  }

  @Test
  void aTokenMayClaimHowGoodAPlayerIs() throws JoinTokens.BadTokenException {
    assertEquals(1_500, tokens.check(token(backend, HEAD, claims(",\"skill\":1500"))).skill());
    for (String wrong : List.of("-1", "1000001", "1.5", "\"1500\"", "true")) {
      refused(token(backend, HEAD, claims(",\"skill\":" + wrong)), "The token's skill is no");
    }
  }

  @Test
  void aTokenThatOthersMayHaveReadNeverCountsAgain() throws JoinTokens.BadTokenException {
    String token = token(backend, HEAD, claims(""));
    tokens.check(token);
    tokens.check(token);
    assertEquals("42", tokens.spend(token).account());
    refused(token, "has been used");
    assertThrows(JoinTokens.BadTokenException.class, () -> tokens.spend(token));
    tokens.check(token(backend, HEAD, claims(",\"name\":\"other\"")));
    String expired = token(backend, HEAD, "{\"sub\":\"42\",\"exp\":" + NOW + "}");
    assertThrows(JoinTokens.BadTokenException.class, () -> tokens.spend(expired));
  }

  @Test
  void spentTokensAreForgottenWhenTheyExpireAndNotBefore() {
    SpentTokens spent = new SpentTokens();
    for (int i = 0; i < SpentTokens.MAX; i++) {
      assertTrue(spent.add(("t" + i).getBytes(StandardCharsets.UTF_8), NOW + i % 2, NOW - 1));
    }
    byte[] more = "more".getBytes(StandardCharsets.UTF_8);
    assertFalse(spent.add(more, NOW + 9, NOW - 1), "no room");
    assertTrue(spent.add(more, NOW + 9, NOW), "half of them have expired");
    assertTrue(spent.has("t1".getBytes(StandardCharsets.UTF_8)));
    assertFalse(spent.has("t2".getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void aTokenOfAnotherTimeServerOrSignerIsRefused() {
    refused(token(backend, HEAD, "{\"sub\":\"42\",\"exp\":" + NOW + "}"), "expired");
    refused(token(backend, HEAD, "{\"sub\":\"42\"}"), "expired");
    refused(token(backend, HEAD, "{\"sub\":\"42\",\"exp\":\"soon\"}"), "no number");
    refused(token(backend, HEAD, claims(",\"nbf\":" + (NOW + 5))), "isn't valid yet");
    refused(token(backend, HEAD, claims(",\"server\":\"other\"")), "another server");
    refused(token(pair(), HEAD, claims("")), "isn't from this game's operator");
    refused(token(backend, HEAD, "{\"exp\":" + (NOW + 60) + "}"), "no account");
    refused(token(backend, HEAD, claims(",\"room\":\" \"")), "can't be used");
    refused("", "Join through");
  }

  @Test
  void noNameKeepsAnAccountOut() throws JoinTokens.BadTokenException {
    String[][] names = {
      {"Ann ", "Ann"},
      {" ", ""},
      {"\u2764\ufe0f", "\u2764"},
      {"\u0645\u06cc\u200c\u062e\u0648", "\u0645\u06cc\u062e\u0648"},
      {"x".repeat(33), "x".repeat(32)},
      {"Ann\u00a0Lee\u0000", "Ann Lee"},
      {"\u0301e\u0301\u0301\u0301\u0301\u0301", "\u00e9\u0301\u0301\u0301"},
      {"\u060a\u0335\u0347\u0344", "\u060a\u0335\u0347\u0308"} // the last mark is two in one
    };
    for (String[] name : names) {
      String claims = claims(",\"name\":" + quoted(name[0]));
      assertEquals(name[1], tokens.check(token(backend, HEAD, claims)).name());
    }
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("JoinTokensTest seed=" + seed);
    SplittableRandom random = new SplittableRandom(seed);
    int[] blocks = {0x20, 0x80, 0x300, 0x600, 0x2000, 0x3000, 0xd800, 0xfe00, 0x1f600, 0xe0100};
    for (int i = 0; i < 20_000; i++) {
      StringBuilder name = new StringBuilder();
      for (int length = random.nextInt(40); length > 0; length--) {
        name.appendCodePoint(blocks[random.nextInt(blocks.length)] + random.nextInt(128));
      }
      String fitted = PlayerName.fitted(name.toString());
      assertTrue(fitted.isEmpty() || PlayerName.problem(fitted) == null, () -> quoted("" + name));
      assertEquals(fitted, PlayerName.fitted(fitted), () -> quoted("" + name));
      if (PlayerName.problem(name.toString()) == null) {
        assertTrue(PlayerName.looksLike(fitted, name.toString()), () -> quoted("" + name));
      }
    }
  }

  /** Returns a text as JSON has it, with ASCII alone. */
  private static String quoted(String text) {
    StringBuilder json = new StringBuilder("\"");
    text.chars().forEach(c -> json.append(String.format(Locale.ROOT, "\\u%04x", c)));
    return json.append('"').toString();
  }

  @Test
  void theHeaderChoosesNoAlgorithm() {
    for (String head :
        List.of("{\"alg\":\"none\"}", "{\"alg\":\"HS256\"}", "{}", "{\"alg\":[\"EdDSA\"]}")) {
      assertThrows(
          JoinTokens.BadTokenException.class,
          () -> tokens.check(token(backend, head, claims(""))),
          head);
    }
    String good = token(backend, HEAD, claims(""));
    refused(good.substring(0, good.lastIndexOf('.') + 1), "operator");
  }

  @Test
  void whatMustBeUnderstoodAndIsNotIsRefused() {
    for (String crit : List.of("[\"exp\"]", "[\"b64\"]", "[]", "\"x\"", "null")) {
      refused(
          token(backend, "{\"alg\":\"EdDSA\",\"exp\":1,\"crit\":" + crit + "}", claims("")),
          "(crit)");
    }
  }

  @Test
  void noCharacterMayChange() {
    String good = token(backend, HEAD, claims(",\"name\":\"Ann\""));
    SplittableRandom random = new SplittableRandom(7);
    String letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.=";
    int last = good.length() - 1; // whose lowest bits mean nothing
    for (int i = 0; i < last; i++) {
      char other = letters.charAt(random.nextInt(letters.length()));
      if (other != good.charAt(i)) {
        String bad = good.substring(0, i) + other + good.substring(i + 1);
        assertThrows(JoinTokens.BadTokenException.class, () -> tokens.check(bad), bad);
      }
    }
    for (int length = 0; length < last; length++) {
      String bad = good.substring(0, length);
      assertThrows(JoinTokens.BadTokenException.class, () -> tokens.check(bad), bad);
    }
  }

  @Test
  void theKeyIsReadFromPem() throws IOException, JoinTokens.BadTokenException {
    Path file = folder.resolve("join.pem");
    String pem =
        "-----BEGIN PUBLIC KEY-----\n"
            + Base64.getMimeEncoder().encodeToString(backend.getPublic().getEncoded())
            + "\n-----END PUBLIC KEY-----\n";
    Files.writeString(file, pem);
    JoinTokens read = JoinTokens.load(file, SERVER, 0, () -> Instant.ofEpochSecond(NOW));
    assertEquals("42", read.check(token(backend, HEAD, claims(""))).account());
    Files.writeString(file, "nothing");
    IOException e =
        assertThrows(IOException.class, () -> JoinTokens.load(file, SERVER, 0, Instant::now));
    assertTrue(e.getMessage().contains("openssl genpkey"), e::getMessage);
    assertThrows(
        IOException.class,
        () -> JoinTokens.load(folder.resolve("none.pem"), SERVER, 0, Instant::now));
  }
}
