package carom.client;

import carom.client.link.ServerAddress;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.LevelOutcome;
import carom.net.seal.PlayerKey;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.Arrays;

/**
 * Sends a level of the player's to a server, over a link of its own, and hears what comes of it. It
 * never waits; call {@link #update} until {@link #isDone}. One thread.
 */
public final class LevelSender implements LinkHandler, AutoCloseable {
  /** Longest time in which a link opens; links have deadlines of their own for each step. */
  private static final long TIMEOUT_NS = 120_000_000_000L;

  /** Longest silence of the server, which checks one level after the other. */
  private static final long ANSWER_NS = 600_000_000_000L;

  private static final int AHEAD =
      ProtocolLimits.MAX_PIECES_AHEAD * ProtocolLimits.MAX_LEVEL_PIECE_BYTES;

  private final ClientConfig config;
  private final ServerAddress address;
  private final ClientTransport transport;
  private final int size;
  private final byte[] packed;
  private Link link;
  private boolean offered;
  private boolean isTaken;
  private String answer = "";
  private int sent;
  private int received = -1;
  private long nowNs;
  private long heardNs;

  /**
   * Creates a sender that begins at the first {@link #update}.
   *
   * @param config has the server, and who sends
   * @param level bytes of the level file
   * @param transport opens the link; stays the caller's
   */
  public LevelSender(ClientConfig config, byte[] level, ClientTransport transport) {
    this.config = config;
    this.transport = transport;
    address = config.get(ClientConfig.SERVER);
    size = level.length;
    packed = size <= ProtocolLimits.MAX_OFFERED_BYTES ? PackedLevel.pack(level) : level;
    if (size > ProtocolLimits.MAX_OFFERED_BYTES
        || packed.length > ProtocolLimits.MAX_OFFERED_BYTES) {
      answer = "A level that is sent has at most %s bytes, this one has %s.";
      answer = answer.formatted(ProtocolLimits.MAX_OFFERED_BYTES, size);
    }
  }

  /** Does what is due. */
  public void update(long timeNs) {
    nowNs = timeNs;
    if (isDone()) {
      return;
    }
    if (link == null) {
      heardNs = nowNs;
      link = transport.connect(address.host(), address.tcpPort(), address.udpPort());
    }
    if (!offered && link.state() == Link.State.OPEN) {
      offer();
    }
    link.poll(this, 64);
    while (!isDone() && received >= 0 && sent < Math.min(packed.length, received + AHEAD)) {
      int end = Math.min(packed.length, sent + ProtocolLimits.MAX_LEVEL_PIECE_BYTES);
      link.send(new ClientMessage.LevelPiece(sent, Arrays.copyOfRange(packed, sent, end)));
      sent = end;
    }
    if (!isDone() && nowNs - heardNs > (offered ? ANSWER_NS : TIMEOUT_NS)) {
      end("No answer from " + address + ". Check the address; is the server running?");
    }
  }

  private void offer() {
    offered = true;
    heardNs = nowNs;
    PlayerKey key = config.get(ClientConfig.KEY);
    byte[] binding = link.binding();
    String token = config.get(ClientConfig.TOKEN);
    if (token.isEmpty() && key != null && binding != null) {
      token = key.proof(binding);
    }
    if (!config.get(ClientConfig.PASSWORD).isEmpty()) {
      link.send(new ClientMessage.Password(config.get(ClientConfig.PASSWORD)));
    }
    link.send(
        new ClientMessage.OfferLevel(
            Protocol.VERSION, size, packed.length, config.get(ClientConfig.NAME), token));
  }

  private void end(String text) {
    answer = text;
    if (link.state() == Link.State.OPEN) {
      link.send(new ClientMessage.Leave());
    }
    link.close("has sent a level");
  }

  @Override
  public void message(Link from, Object message) {
    heardNs = nowNs;
    if (isDone()) {
      return;
    }
    if (message instanceof ServerMessage.LevelAnswer told) {
      received = Math.min(told.received(), packed.length);
      if (told.outcome() != LevelOutcome.UNDER_WAY) {
        isTaken = told.outcome() == LevelOutcome.TAKEN;
        end(told.text().isEmpty() ? "The server doesn't say why." : told.text());
      }
    } else if (message instanceof ServerMessage.Refused refused) {
      end(refused.playerText());
    } else if (message instanceof ServerMessage.Goodbye goodbye) {
      end(goodbye.playerText());
    } else {
      end(address + " answers something else. Is it a Carom server?");
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    // The server sends none before a game is joined.
  }

  @Override
  public void closed(Link from, String reason) {
    if (!isDone()) {
      end((offered ? "The link to " : "Can't reach ") + address + ": " + reason);
    }
  }

  /** Returns whether it is known what has come of the level. */
  public boolean isDone() {
    return !answer.isEmpty();
  }

  /** Returns whether the server has the level now. */
  public boolean isTaken() {
    return isTaken;
  }

  /** Returns how far it is, or what has come of it, in words for the player. */
  public String text() {
    if (isDone()) {
      return answer;
    }
    if (received < 0) {
      return "Asking " + address + " ...";
    }
    return received < packed.length
        ? "Sending " + received / 1_000 + " of " + packed.length / 1_000 + " kB ..."
        : "The server checks it ...";
  }

  @Override
  public void close() {
    if (link != null && !isDone()) {
      end("Not sent.");
    }
  }
}
