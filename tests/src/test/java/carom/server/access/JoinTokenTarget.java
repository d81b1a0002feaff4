package carom.server.access;

import carom.fuzz.FuzzTarget;
import carom.fuzz.Pieces;
import carom.net.protocol.ProtocolLimits;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.time.Instant;
import java.util.Base64;
import java.util.List;

/**
 * Join tokens: a piece of kind 0 is a whole token as a client sends it, one of kind 1 sets the head
 * of the tokens that follow, and others are claims, signed as a careless backend would. A token is
 * refused with a reason, or is within its limits; none without the backend's signature is good.
 */
public final class JoinTokenTarget implements FuzzTarget {
  private static final long NOW = 1_800_000_000L;
  private static final byte[] HEAD = bytes("{\"alg\":\"EdDSA\",\"typ\":\"JWT\"}");
  private static final int MOST_PIECES = 8;

  private final KeyPair backend;
  private final JoinTokens tokens;

  /** Makes a backend's key, another one in each run. */
  public JoinTokenTarget() {
    try {
      backend = KeyPairGenerator.getInstance("Ed25519").generateKeyPair();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK has Ed25519", e);
    }
    tokens = new JoinTokens(backend.getPublic(), "the-server", 0, () -> Instant.ofEpochSecond(NOW));
  }

  @Override
  public void take(byte[] data) throws GeneralSecurityException {
    Pieces pieces = new Pieces(data);
    byte[] head = HEAD;
    byte[] piece = pieces.next();
    for (int count = 0; piece != null && count < MOST_PIECES; piece = pieces.next(), count++) {
      switch (pieces.kind() % 3) {
        case 0 -> {
          if (isGood(new String(piece, StandardCharsets.UTF_8))) {
            throw new AssertionError("a token without the backend's signature is good");
          }
        }
        case 1 -> head = piece;
        default -> isGood(signed(head, piece));
      }
    }
  }

  private boolean isGood(String token) {
    try {
      JoinTokens.Token read = tokens.check(token);
      int account = read.account().length();
      if (account < 1 || account > ProtocolLimits.MAX_ACCOUNT_CHARACTERS) {
        throw new AssertionError("an account of " + account + " characters");
      }
      FuzzTarget.requirePrintable(read.account() + read.name() + read.room());
      return true;
    } catch (JoinTokens.BadTokenException e) {
      FuzzTarget.requirePrintable(e.getMessage());
      return false;
    }
  }

  private String signed(byte[] head, byte[] claims) throws GeneralSecurityException {
    Base64.Encoder base64 = Base64.getUrlEncoder().withoutPadding();
    String text = base64.encodeToString(head) + "." + base64.encodeToString(claims);
    Signature signature = Signature.getInstance("Ed25519");
    signature.initSign(backend.getPrivate());
    signature.update(bytes(text));
    return text + "." + base64.encodeToString(signature.sign());
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  @Override
  public List<byte[]> seeds() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Pieces.add(out, 2, bytes("{\"sub\":\"42\",\"exp\":1800000060}"));
    Pieces.add(
        out,
        2,
        bytes(
            "{\"sub\":\"42\",\"exp\":1800000060,\"nbf\":1799999999,\"name\":\"Zo\u00eb\","
                + "\"room\":\"cup\",\"server\":\"the-server\"}"));
    Pieces.add(out, 1, bytes("{\"alg\":\"none\"}"));
    Pieces.add(out, 2, bytes("{\"sub\":[],\"exp\":\"soon\"}"));
    Pieces.add(out, 0, bytes("eyJhbGciOiJFZERTQSJ9.eyJzdWIiOiI0MiJ9." + "A".repeat(86)));
    return List.of(out.toByteArray());
  }
}
