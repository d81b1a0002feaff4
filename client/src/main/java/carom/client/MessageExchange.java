package carom.client;

import carom.client.link.Connection;
import carom.client.stats.NetStatsRecorder;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.MessageDatagram;
import carom.net.protocol.MessageStream;
import carom.net.protocol.ServerMessage;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import carom.sim.message.MessageRates;
import java.util.ArrayDeque;
import java.util.List;

/**
 * The messages of the game between this client and the server, over all links of a session. One
 * thread; allocates for messages only.
 */
final class MessageExchange {
  private final Connection connection;
  private final NetStatsRecorder stats;
  private final MessageDatagram incoming = new MessageDatagram();
  private final MessageDatagram outgoing = new MessageDatagram();

  /** The last reliable messages, to name those that never got through; at most as the stream. */
  private final ArrayDeque<Message> offered = new ArrayDeque<>();

  private MessageStream stream = new MessageStream();
  private MessageListener listener = MessageListener.NONE;
  private MessageKinds kinds;
  private MessageRates rates;
  private long session;
  private String room = "";
  private int match;
  private int incarnation;
  private long nowNs;

  /** Creates an exchange without a session. */
  public MessageExchange(Connection connection, NetStatsRecorder stats) {
    this.connection = connection;
    this.stats = stats;
  }

  /** Sets who hears messages. */
  public void listener(MessageListener newListener) {
    listener = newListener;
  }

  /**
   * Begins with a link or a match. A session that goes on in the same match keeps what waits; else,
   * and if the room was resumed from a checkpoint, the listener is told what is no longer sent.
   *
   * @param welcome the server's
   * @param gameKinds of the game that is played
   */
  public void begin(ServerMessage.Welcome welcome, MessageKinds gameKinds) {
    List<Message> unsent = List.of();
    if (welcome.sessionSecret() != session
        || !welcome.room().equals(room)
        || welcome.match() != match
        || welcome.incarnation() != incarnation) {
      int waiting = stream.waiting();
      unsent = List.copyOf(offered).subList(offered.size() - waiting, offered.size());
      session = welcome.sessionSecret();
      room = welcome.room();
      match = welcome.match();
      incarnation = welcome.incarnation();
      stream = new MessageStream();
      offered.clear();
    }
    stream.unlink();
    kinds = gameKinds;
    rates = MessageRates.ofClient(gameKinds);
    incoming.begin(welcome.epoch());
    outgoing.begin(welcome.epoch());
    unsent.forEach(listener::unsent);
  }

  /** Notes that the link is gone; reliable messages wait for the next one. */
  public void stop() {
    stream.unlink();
    outgoing.clear();
  }

  /**
   * Sends a message.
   *
   * @return false when it isn't sent: no game is played yet, the kind's rate is exceeded, too much
   *     waits for a link, or the message is unreliable and there is no link
   * @throws IllegalArgumentException when the kind isn't registered, or only the server sends it
   */
  public boolean send(Message message) {
    if (kinds == null) {
      return false;
    }
    byte[] bytes = kinds.encode(message, Direction.FROM_CLIENT);
    boolean reliable = message.kind().isReliable();
    if (reliable ? stream.waiting() >= MessageStream.KEPT : !connection.isPlaying()) {
      return false;
    }
    if (!rates.take(message.kind(), nowNs * 1e-9)) {
      return false;
    }
    if (!reliable) {
      return outgoing.add(bytes);
    }
    if (offered.size() == MessageStream.KEPT) {
      offered.remove();
    }
    offered.add(message);
    return stream.offer(bytes);
  }

  /** Sends what waits; once per update. */
  public void update(long now) {
    nowNs = now;
    if (stream.waiting() > 0) {
      stream.flush(
          (number, bytes) -> connection.send(new ClientMessage.GameMessage(number, bytes)));
    }
    if (!outgoing.isEmpty()) {
      outgoing.complete();
      connection.sendDatagram(outgoing.bytes(), outgoing.length());
      outgoing.clear();
    }
  }

  /** Takes over what the server has heard, and answers with what this client has. */
  public void heard(ServerMessage.Heard message) {
    stream.begin(message.number());
    connection.send(new ClientMessage.Heard(stream.lastHeard()));
  }

  /** Takes a reliable message. */
  public void receive(ServerMessage.GameMessage m) {
    int lost = stream.hear(m.number());
    if (lost > 0) {
      listener.missed(lost);
    }
    if (lost >= 0) {
      hear(m.bytes());
    }
  }

  /** Takes a datagram; returns false when it carries no messages. */
  public boolean receive(byte[] bytes, int length) {
    if (!incoming.isOne(bytes, length)) {
      return false;
    }
    if (incoming.decode(bytes, length)) {
      for (byte[] next; (next = incoming.next()) != null; ) {
        hear(next);
      }
    }
    return true;
  }

  private void hear(byte[] bytes) {
    Message raw = kinds.decode(bytes, 0, bytes.length, Direction.FROM_SERVER);
    Message m = raw == null ? null : raw.cleaned();
    if (m == null) {
      stats.malformed();
    } else if (m.is(BuiltInKinds.SAID)) {
      listener.said(m.count("player"), m.flag("team"), m.text("text"));
    } else if (m.is(BuiltInKinds.EMOTED)) {
      listener.emoted(m.count("player"), m.choice("emote", Emote.class));
    } else {
      listener.heard(m);
    }
  }
}
