package carom.server.room;

import carom.net.protocol.SessionState;
import carom.server.match.RoomContext;
import carom.server.session.Session;
import carom.sim.message.MessageKind.Direction;
import carom.sim.outbox.Delivery;
import java.util.function.Consumer;

/**
 * Delivers the messages that the game sends to the sessions they are for. A session without a link
 * gets reliable ones when its client is back. The room's thread.
 */
final class MessageDelivery {
  private final RoomContext room;
  private final RoomSessions sessions;
  private final RoomDirectory directory;
  private final Consumer<Delivery> deliver = this::deliver;

  MessageDelivery(RoomContext room, RoomSessions sessions, RoomDirectory directory) {
    this.room = room;
    this.sessions = sessions;
    this.directory = directory;
  }

  /** Hands the messages of players to the next tick, but for commands. */
  void collect() {
    for (int i = sessions.count() - 1; i >= 0; i--) {
      sessions.get(i).deliverMessages(directory.chatCommands());
    }
  }

  /** Sends what the game has sent since the last call. */
  void send() {
    room.simulation().outbox().drainMessages(deliver);
    for (int i = sessions.count() - 1; i >= 0; i--) {
      sessions.get(i).sendMessages();
    }
  }

  private void deliver(Delivery d) {
    if (d.recipients() == Delivery.Recipients.TEAM) {
      room.match().toldTeam(d.message());
    }
    byte[] bytes = room.simulation().messageKinds().encode(d.message(), Direction.FROM_SERVER);
    for (int i = sessions.count() - 1; i >= 0; i--) {
      Session session = sessions.get(i);
      boolean linked = session.state() == SessionState.PLAYING;
      if (isFor(d, session, linked)) {
        session.messages().send(d.message(), bytes, linked);
      }
    }
  }

  private static boolean isFor(Delivery d, Session session, boolean linked) {
    return switch (d.recipients()) {
      case NOBODY -> false;
      case ALL -> true;
      case ONE -> session.player().id() == d.id();
      case TEAM -> session.player().team() == d.id();
      case NEAR -> linked && session.replication().sees(d.id());
    };
  }
}
