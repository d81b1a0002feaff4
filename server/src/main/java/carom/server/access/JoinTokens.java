package carom.server.access;

import carom.net.protocol.PlayerName;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RoomName;
import carom.net.seal.PlayerKey;
import carom.server.account.PlayerSkill;
import carom.text.Json;
import carom.text.JsonException;
import carom.text.TextFile;
import carom.text.Texts;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.PublicKey;
import java.security.Signature;
import java.security.spec.X509EncodedKeySpec;
import java.time.InstantSource;
import java.util.Base64;
import java.util.Map;

/**
 * Checks join tokens: JSON Web Tokens (RFC 7519) that the operator's own backend signs by Ed25519
 * (algorithm {@code EdDSA}, RFC 8037). The server has the public key only, so a stolen server makes
 * no tokens. Any thread may use it. A check takes about 0.3 ms.
 *
 * <p>Claims: {@code sub} (the account) and {@code exp} (the end, seconds since 1970) must be there.
 * {@code name}, {@code room}, {@code skill}, {@code nbf} (the begin) and {@code server} (the
 * fingerprint of the one server that the token is for) may. Others are ignored. The account
 * identifies the player; the name is only shown, so it is {@linkplain PlayerName#fitted fitted},
 * never a reason to refuse.
 */
public final class JoinTokens {
  /** Tells the player of a token that counts no longer. */
  public static final String USED = "The token has been used. Get another one.";

  private static final int SIGNATURE_BYTES = 64;
  private static final String ALGORITHM = "Ed25519";
  private static final int MAX_PEM_BYTES = 10_000;

  private final PublicKey key;
  private final String fingerprint;
  private final int uses;
  private final InstantSource clock;
  private final SpentTokens spent = new SpentTokens();

  /**
   * Creates a check.
   *
   * @param fingerprint of this server's key
   * @param uses seats that one account may have at a time, 0 = any number
   */
  JoinTokens(PublicKey key, String fingerprint, int uses, InstantSource clock) {
    this.uses = uses;
    this.key = key;
    this.fingerprint = fingerprint;
    this.clock = clock;
  }

  /**
   * Reads the backend's public key from a PEM file.
   *
   * @param fingerprint of this server's key
   * @param uses seats that one account may have at a time, 0 = any number
   * @throws IOException if the file has no such key; the message says how to make one
   */
  public static JoinTokens load(Path file, String fingerprint, int uses, InstantSource clock)
      throws IOException {
    String how =
        "; make a pair with: openssl genpkey -algorithm ed25519 -out backend.pem, and its public"
            + " key with: openssl pkey -in backend.pem -pubout -out join.pem";
    try {
      String text = TextFile.read(file, MAX_PEM_BYTES);
      String base64 = text.replaceAll("-----(BEGIN|END) PUBLIC KEY-----", "").replaceAll("\\s", "");
      X509EncodedKeySpec encoded = new X509EncodedKeySpec(Base64.getDecoder().decode(base64));
      return new JoinTokens(
          KeyFactory.getInstance(ALGORITHM).generatePublic(encoded), fingerprint, uses, clock);
    } catch (NoSuchFileException e) {
      throw new IOException(file + " isn't there" + how, e);
    } catch (IOException e) {
      throw new IOException(file + " can't be read: " + e.getMessage() + how, e);
    } catch (IllegalArgumentException | GeneralSecurityException e) {
      throw new IOException(file + " has no public Ed25519 key in PEM" + how, e);
    }
  }

  /**
   * Returns why an account may have no further seat, or null if it may.
   *
   * @param seats how many it has
   */
  public String refusal(int seats) {
    return uses == 0 || seats < uses
        ? null
        : "Your account plays here already. After a lost connection its place is free in a moment.";
  }

  /** Returns whether an account may have a limited number of seats. */
  public boolean limitsSeats() {
    return uses > 0;
  }

  /**
   * Returns what a token says that others may have read on its way. It never counts again, whether
   * the player gets a place or not.
   *
   * @throws BadTokenException as {@link #check} does
   */
  public Token spend(String token) throws BadTokenException {
    Token result = check(token);
    String[] parts = token.split("\\.", -1);
    if (!spent.add(signed(parts), (long) number(fields(parts[1]), "exp"), now())) {
      throw new BadTokenException("The server has no room for another token. Try again later.");
    }
    return result;
  }

  /** Returns the part of a token that {@link #check} has taken by which it is known again. */
  public static String mark(String token) {
    return token.substring(0, token.lastIndexOf('.'));
  }

  /** Returns how long a token is good that {@link #check} has taken, s. */
  public long secondsLeft(String token) throws BadTokenException {
    return (long) number(fields(token.split("\\.", -1)[1]), "exp") - now();
  }

  /**
   * Returns what a token says.
   *
   * @throws BadTokenException if it is none, is not signed by the backend, isn't for this server
   *     and this time, or was {@linkplain #spend spent}
   */
  public Token check(String token) throws BadTokenException {
    if (token.isEmpty()) {
      throw new BadTokenException("Join through the game's own site or launcher.");
    }
    String[] parts = token.split("\\.", -1);
    if (parts.length != 3) {
      throw new BadTokenException("The token isn't one.");
    }
    // Only one algorithm is right: a header that names another one must not choose the check.
    Map<String, Json> head = fields(parts[0]);
    if (!text(head, "alg").equals("EdDSA")) {
      throw new BadTokenException("The token isn't signed by EdDSA.");
    }
    if (head.containsKey("crit")) { // RFC 7515: what it lists must be understood
      throw new BadTokenException("The token demands what this server doesn't know (crit).");
    }
    if (!isSigned(parts)) {
      throw new BadTokenException("The token isn't from this game's operator, or was changed.");
    }
    Map<String, Json> claims = fields(parts[1]);
    long now = now();
    if (!claims.containsKey("exp") || !(number(claims, "exp") > now)) {
      throw new BadTokenException("The token has expired. Get another one.");
    }
    if (claims.containsKey("nbf") && !(number(claims, "nbf") <= now)) {
      throw new BadTokenException("The token isn't valid yet.");
    }
    String server = text(claims, "server");
    if (!server.isEmpty() && !server.equals(fingerprint)) {
      throw new BadTokenException("The token is for another server.");
    }
    Token result =
        new Token(
            text(claims, "sub"),
            PlayerName.fitted(text(claims, "name")),
            text(claims, "room"),
            skill(claims));
    requireUsable(result);
    if (spent.has(signed(parts))) {
      throw new BadTokenException(USED);
    }
    return result;
  }

  private static int skill(Map<String, Json> claims) throws BadTokenException {
    if (!claims.containsKey("skill")) {
      return PlayerSkill.NO_CLAIM;
    }
    double skill = number(claims, "skill");
    if (!(skill >= 0 && skill <= PlayerSkill.MAX_CLAIM) || skill != Math.rint(skill)) {
      throw new BadTokenException(
          "The token's skill is no whole number of 0 to " + PlayerSkill.MAX_CLAIM + ".");
    }
    return (int) skill;
  }

  private long now() {
    return clock.instant().getEpochSecond();
  }

  /** Returns what the signature is of, so that no other spelling of a token counts. */
  private static byte[] signed(String[] parts) {
    return (parts[0] + "." + parts[1]).getBytes(StandardCharsets.US_ASCII);
  }

  private static void requireUsable(Token token) throws BadTokenException {
    String account = token.account();
    if (account.isBlank()
        || !account.equals(Texts.clean(account))
        || account.length() > ProtocolLimits.MAX_ACCOUNT_CHARACTERS) {
      throw new BadTokenException("The token has no account of 1 to 64 visible characters (sub).");
    }
    if (account.startsWith(PlayerKey.ACCOUNT)) {
      throw new BadTokenException(
          "The token's account (sub) begins with "
              + PlayerKey.ACCOUNT
              + ", which players' own keys alone prove.");
    }
    String problem = token.room().isEmpty() ? null : RoomName.problem(token.room());
    if (problem != null) {
      throw new BadTokenException("The token can't be used: " + problem + ".");
    }
  }

  private boolean isSigned(String[] parts) throws BadTokenException {
    try {
      Signature signature = Signature.getInstance(ALGORITHM);
      signature.initVerify(key);
      signature.update(signed(parts));
      byte[] signed = bytes(parts[2]);
      return signed.length == SIGNATURE_BYTES && signature.verify(signed); // Java takes longer ones
    } catch (GeneralSecurityException e) {
      return false;
    }
  }

  private static byte[] bytes(String part) throws BadTokenException {
    try {
      return Base64.getUrlDecoder().decode(part);
    } catch (IllegalArgumentException e) {
      throw new BadTokenException("The token isn't one.");
    }
  }

  private static Map<String, Json> fields(String part) throws BadTokenException {
    try {
      return Json.parseMachineMade(bytes(part)).fields;
    } catch (JsonException e) {
      throw new BadTokenException("The token isn't one.");
    }
  }

  private static String text(Map<String, Json> fields, String name) throws BadTokenException {
    Json field = fields.get(name);
    if (field != null && field.kind != Json.Kind.STRING) {
      throw new BadTokenException("The token's " + name + " is no text.");
    }
    return field == null ? "" : field.text;
  }

  private static double number(Map<String, Json> fields, String name) throws BadTokenException {
    Json field = fields.get(name);
    if (field.kind != Json.Kind.NUMBER) {
      throw new BadTokenException("The token's " + name + " is no number.");
    }
    return field.number;
  }

  /**
   * The facts about a player that the operator's own backend has signed in a token.
   *
   * @param account the backend's name of the player's account, never empty
   * @param name the name to play under, or empty for the one that the player asks for
   * @param room the room to play in, or empty for the one that the player asks for
   * @param skill of the player, or {@link PlayerSkill#NO_CLAIM}
   */
  public record Token(String account, String name, String room, int skill) {}

  /** Thrown for a join token that isn't valid. The message is for the player. */
  public static final class BadTokenException extends Exception {
    private static final long serialVersionUID = 1;

    BadTokenException(String message) {
      super(message, null, false, false);
    }
  }
}
