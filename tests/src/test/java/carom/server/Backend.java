package carom.server;

import carom.server.access.EntryRule;
import carom.server.access.JoinTokens;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.time.Instant;
import java.util.Base64;

/** An operator's backend, which signs join tokens for accounts. */
public final class Backend {
  private static final KeyPair KEYS = pair();

  private Backend() {}

  private static KeyPair pair() {
    try {
      return KeyPairGenerator.getInstance("Ed25519").generateKeyPair();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  /**
   * Returns a rule that lets in players with tokens of this backend.
   *
   * @param scratch gets the backend's key
   */
  public static EntryRule rule(Path scratch) throws Exception {
    return rule(scratch, 0);
  }

  /**
   * Returns a rule as {@link #rule(Path)} does.
   *
   * @param uses seats that an account may have at a time, 0 = any number
   */
  public static EntryRule rule(Path scratch, int uses) throws Exception {
    Path key = scratch.resolve("join.pem");
    Files.writeString(
        key,
        "-----BEGIN PUBLIC KEY-----\n"
            + Base64.getEncoder().encodeToString(KEYS.getPublic().getEncoded())
            + "\n-----END PUBLIC KEY-----\n");
    JoinTokens tokens = JoinTokens.load(key, "us", uses, () -> Instant.ofEpochSecond(1_000));
    return new EntryRule() {
      @Override
      public Refusal refusal(String name, String account, String remote) {
        return null;
      }

      @Override
      public JoinTokens tokens() {
        return tokens;
      }
    };
  }

  private static String base64(byte[] bytes) {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  /** Returns a token for an account. */
  public static String token(String account) throws Exception {
    return token(account, "", 2_000);
  }

  /** Returns a token for an account that claims how good its player is. */
  public static String token(String account, int skill, long expires) throws Exception {
    return token(account, ",\"skill\":" + skill, expires);
  }

  private static String token(String account, String more, long expires) throws Exception {
    String text =
        base64("{\"alg\":\"EdDSA\"}".getBytes(StandardCharsets.UTF_8))
            + "."
            + base64(
                ("{\"sub\":\"" + account + "\",\"exp\":" + expires + more + "}")
                    .getBytes(StandardCharsets.UTF_8));
    Signature signature = Signature.getInstance("Ed25519");
    signature.initSign(KEYS.getPrivate());
    signature.update(text.getBytes(StandardCharsets.US_ASCII));
    return text + "." + base64(signature.sign());
  }
}
