package carom.server.session;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.MessageDatagram;
import carom.net.protocol.MessageStream;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageRates;
import java.util.ArrayDeque;

/**
 * The messages of the game between one session and its client. What the client sends is checked
 * against its kind's declaration, bounded in rate, and handed to the simulation before a tick. A
 * reliable message that comes too soon waits; what exceeds the wait is dropped and counted.
 *
 * <p>The room's thread. Allocates for messages only.
 */
public final class SessionMessages {
  /** Most messages of a client that wait for their turn. */
  private static final int MAX_WAITING = 128;

  private final SimulationHost simulation;
  private final HostPlayer player;
  private final Counters counters;
  private final MessageRates rates;
  private final MessageStream stream = new MessageStream();
  private final MessageDatagram incoming = new MessageDatagram();
  private final MessageDatagram outgoing = new MessageDatagram();
  private final ArrayDeque<Message> waiting = new ArrayDeque<>();

  /** Creates the messages of a new session. */
  public SessionMessages(SimulationHost simulation, HostPlayer player, Counters counters) {
    this.simulation = simulation;
    this.player = player;
    this.counters = counters;
    rates = MessageRates.ofServer(simulation.messageKinds());
  }

  /** Begins with a new link, and tells the client what was heard of it. */
  void attach(Link link, int epoch) {
    incoming.begin(epoch);
    outgoing.begin(epoch);
    stream.unlink();
    link.send(new ServerMessage.Heard(stream.lastHeard()));
  }

  /** Notes that the link is gone. What is sent meanwhile waits for the next. */
  void detach() {
    stream.unlink();
    outgoing.clear();
  }

  /** Takes over what the client has heard of the server's messages. */
  void heard(ClientMessage.Heard message) {
    stream.begin(message.number());
  }

  /** Takes a reliable message; returns false when it is none that this client may send. */
  boolean receive(ClientMessage.GameMessage m) {
    Message message = decode(m.bytes());
    if (message == null || !message.kind().isReliable()) {
      return false;
    }
    if (stream.hear(m.number()) < 0) {
      return true; // sent again, although it had arrived
    }
    if (waiting.size() < MAX_WAITING) {
      waiting.add(message);
    } else {
      counters.add(Counter.MESSAGES_DROPPED, 1);
    }
    return true;
  }

  /** Returns whether a datagram carries messages, rather than inputs. */
  boolean isOne(byte[] bytes, int length) {
    return incoming.isOne(bytes, length);
  }

  /** Takes a datagram with unreliable messages. */
  void receive(byte[] bytes, int length) {
    if (!incoming.decode(bytes, length)) {
      return;
    }
    for (byte[] next; (next = incoming.next()) != null; ) {
      Message message = decode(next);
      boolean taken =
          message != null && !message.kind().isReliable() && rates.take(message.kind(), seconds());
      if (!taken || !simulation.receive(player, message)) {
        counters.add(Counter.MESSAGES_DROPPED, 1);
      }
    }
  }

  private Message decode(byte[] bytes) {
    Message message =
        simulation.messageKinds().decode(bytes, 0, bytes.length, Direction.FROM_CLIENT);
    return message == null ? null : message.cleaned();
  }

  /**
   * Hands over what the next tick should handle.
   *
   * @param session whose messages these are
   * @param commands takes lines of chat that are commands
   */
  void deliver(Session session, ChatCommands commands) {
    boolean muted = session.seat().isMuted();
    while (!waiting.isEmpty() && rates.take(waiting.peek().kind(), seconds())) {
      Message message = waiting.remove();
      if (isCommand(message) && commands.take(PlayerInfo.of(session), message.text("text"))) {
        continue;
      }
      if (muted && (message.is(BuiltInKinds.SAY) || message.is(BuiltInKinds.EMOTE))) {
        counters.add(Counter.MESSAGES_MUTED, 1);
      } else if (!simulation.receive(player, message)) {
        counters.add(Counter.MESSAGES_DROPPED, 1);
      }
    }
  }

  private static boolean isCommand(Message message) {
    return message.is(BuiltInKinds.SAY) && message.text("text").startsWith(ChatCommands.BEGIN);
  }

  private double seconds() {
    return simulation.tick() / (double) simulation.tickRate();
  }

  /** Queues a message for the client. */
  public void send(Message message, byte[] bytes, boolean hasLink) {
    boolean taken =
        message.kind().isReliable() ? stream.offer(bytes) : hasLink && outgoing.add(bytes);
    if (!taken) {
      counters.add(Counter.MESSAGES_DROPPED, 1);
    }
  }

  /** Sends what is queued; once per tick with a link. */
  public void flush(Link link) {
    if (stream.waiting() > 0) {
      stream.flush((number, bytes) -> link.send(new ServerMessage.GameMessage(number, bytes)));
    }
    if (!outgoing.isEmpty()) {
      outgoing.complete();
      link.sendDatagram(outgoing.bytes(), 0, outgoing.length());
      outgoing.clear();
    }
  }
}
