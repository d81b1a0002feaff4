package carom.client;

import carom.client.link.ServerQuestion;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.LevelOutcome;
import carom.net.seal.PlayerKey;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import java.util.Arrays;

/** Sends a level of the player's to a server, and hears what comes of it. */
public final class LevelSender extends ServerQuestion {
  /** Longest silence of the server, which checks one level after the other. */
  private static final long ANSWER_NS = 600_000_000_000L;

  private static final int AHEAD =
      ProtocolLimits.MAX_PIECES_AHEAD * ProtocolLimits.MAX_LEVEL_PIECE_BYTES;

  private final ClientConfig config;
  private final int size;
  private final byte[] packed;
  private boolean isTaken;
  private int sent;
  private int received = -1;

  /**
   * Creates a sender that begins at the first {@link #update}.
   *
   * @param config has the server, and who sends
   * @param level bytes of the level file
   * @param transport opens the link; stays the caller's
   */
  public LevelSender(ClientConfig config, byte[] level, ClientTransport transport) {
    super(config.get(ClientConfig.SERVER), transport, ANSWER_NS);
    this.config = config;
    size = level.length;
    packed = size <= ProtocolLimits.MAX_OFFERED_BYTES ? PackedLevel.pack(level) : level;
    if (size > ProtocolLimits.MAX_OFFERED_BYTES
        || packed.length > ProtocolLimits.MAX_OFFERED_BYTES) {
      String answer = "A level that is sent has at most %s bytes, this one has %s.";
      end(answer.formatted(ProtocolLimits.MAX_OFFERED_BYTES, size));
    }
  }

  @Override
  protected void ask(Link open) {
    PlayerKey key = config.get(ClientConfig.KEY);
    byte[] binding = open.binding();
    String token = config.get(ClientConfig.TOKEN);
    if (token.isEmpty() && key != null && binding != null) {
      token = key.proof(binding);
    }
    if (!config.get(ClientConfig.PASSWORD).isEmpty()) {
      open.send(new ClientMessage.Password(config.get(ClientConfig.PASSWORD)));
    }
    open.send(
        new ClientMessage.OfferLevel(
            Protocol.VERSION, size, packed.length, config.get(ClientConfig.NAME), token));
  }

  @Override
  protected void goOn(Link open) {
    while (received >= 0 && sent < Math.min(packed.length, received + AHEAD)) {
      int end = Math.min(packed.length, sent + ProtocolLimits.MAX_LEVEL_PIECE_BYTES);
      open.send(new ClientMessage.LevelPiece(sent, Arrays.copyOfRange(packed, sent, end)));
      sent = end;
    }
  }

  @Override
  protected boolean answered(Object message) {
    if (!(message instanceof ServerMessage.LevelAnswer told)) {
      return false;
    }
    heard();
    received = Math.min(told.received(), packed.length);
    if (told.outcome() != LevelOutcome.UNDER_WAY) {
      isTaken = told.outcome() == LevelOutcome.TAKEN;
      end(told.text().isEmpty() ? "The server doesn't say why." : told.text());
    }
    return true;
  }

  /** Returns whether the server has the level now. */
  public boolean isTaken() {
    return isTaken;
  }

  /** Returns how far it is, or what has come of it, in words for the player. */
  public String text() {
    if (isDone()) {
      return outcome().isEmpty() ? "Not sent." : outcome();
    }
    if (received < 0) {
      return "Asking " + address() + " ...";
    }
    return received < packed.length
        ? "Sending " + received / 1_000 + " of " + packed.length / 1_000 + " kB ..."
        : "The server checks it ...";
  }
}
