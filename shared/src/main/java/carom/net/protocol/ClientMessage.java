package carom.net.protocol;

/** What a client sends reliably and in order. Encoded by {@link ClientMessageCodec}. */
public sealed interface ClientMessage {

  /**
   * The first message: who is there.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param physicsDigest {@link Protocol#physicsDigest()} of the client
   * @param name the player's name, see {@link PlayerName}
   * @param resumeSecret secret of an earlier session's {@link ServerMessage.Welcome}, or 0
   */
  record Hello(int protocolVersion, long physicsDigest, String name, long resumeSecret)
      implements ClientMessage {}

  /**
   * Asks for a piece of the packed level from an offset on. A client has several requests under
   * way, so that the round trip doesn't set the pace, and goes on where it was when it comes back.
   *
   * @param offset 0..{@link Limits#MAX_LEVEL_BYTES} - 1
   */
  record LevelRequest(int offset) implements ClientMessage {}

  /** The level is loaded: give me a body. */
  record Ready() implements ClientMessage {}

  /**
   * What the client shows, when it changes: the server tells about entities in there. It bounds the
   * size.
   *
   * @param x where it looks while the player has no body, metres
   * @param y where it looks while the player has no body, metres
   * @param halfWidth half of what it shows, metres
   * @param halfHeight half of what it shows, metres
   */
  record Look(float x, float y, float halfWidth, float halfHeight) implements ClientMessage {}

  /** The player goes; no grace period. */
  record Leave() implements ClientMessage {}
}
