package carom.server.room;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Broadcast;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.session.Session;
import carom.server.upload.UploadedLevel;
import carom.server.upload.Uploads;
import carom.sim.outbox.NextMatch;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

/**
 * The levels of players as those who play in the room see them, and which of them they want. A
 * level that more than half want is played. The room's thread.
 */
final class LevelChoices {
  /** The word by which the setting names all rooms. */
  private static final String ALL = "all";

  private final RoomContext room;
  private final String name;
  private final RoomDirectory directory;
  private final RoomSessions sessions;
  private final Announcer announcer;
  private final MatchChange changes;

  /** The level that each session wants. */
  private final IdentityHashMap<Session, UploadedLevel> wanted = new IdentityHashMap<>();

  private int match;

  /**
   * Creates an object of which nobody wants anything.
   *
   * @param name the room's name
   */
  LevelChoices(
      RoomContext room,
      String name,
      RoomDirectory directory,
      RoomSessions sessions,
      Announcer announcer,
      MatchChange changes) {
    this.room = room;
    this.name = name;
    this.directory = directory;
    this.sessions = sessions;
    this.announcer = announcer;
    this.changes = changes;
  }

  private boolean mayChoose() {
    List<String> rooms = room.config().get(ServerConfig.PLAYERS_CHOOSE);
    return rooms.contains(name) || rooms.contains(ALL);
  }

  /** Returns whether a session's player counts: players of programs have no accounts. */
  private static boolean counts(Session session) {
    return session.state() == SessionState.PLAYING
        && !session.seat().account().isEmpty()
        && !session.player().isSpectator();
  }

  /** Takes over what players want since, and begins the level that most of them want. */
  void serve(long nowNs) {
    if (match != room.match().info().number()) {
      match = room.match().info().number();
      wanted.clear();
    }
    for (int i = 0; i < sessions.count(); i++) {
      String choice = sessions.get(i).takeChoice();
      if (choice != null) {
        choose(sessions.get(i), choice, nowNs);
      }
    }
    if (!wanted.isEmpty()) {
      wanted.keySet().removeIf(session -> !counts(session));
    }
  }

  private void choose(Session session, String choice, long nowNs) {
    Uploads uploads = directory.uploads();
    UploadedLevel level = uploads == null || choice.isEmpty() ? null : uploads.find(choice);
    UploadedLevel before = level == null ? wanted.remove(session) : wanted.get(session);
    if (level == null || level.equals(before)) {
      return;
    }
    if (!mayChoose() || !counts(session)) {
      session.send(new ServerMessage.Notice("You don't choose the levels of this room."));
      return;
    }
    wanted.put(session, level);
    int votes = votes(level);
    int needed = needed();
    if (votes >= needed) {
      announcer.notice("Next: \"" + level.name() + "\" of " + level.author() + ".");
      wanted.clear();
      changes.play(new NextMatch("", level.title(), false, false), nowNs);
    } else {
      announcer.notice(
          "%s wants to play \"%s\" of %s (%s of %s): Esc, Levels of players."
              .formatted(session.seat().name(), level.name(), level.author(), votes, needed));
    }
  }

  /** Returns how many are more than half of those who count. */
  private int needed() {
    int players = 0;
    for (int i = 0; i < sessions.count(); i++) {
      players += counts(sessions.get(i)) ? 1 : 0;
    }
    return players / 2 + 1;
  }

  private int votes(UploadedLevel level) {
    return (int) wanted.values().stream().filter(level::equals).count();
  }

  /** Returns the messages that list the levels to a session. */
  List<Broadcast> list(Session session) {
    List<ServerMessage.LevelEntry> entries = new ArrayList<>();
    if (directory.uploads() != null) {
      for (UploadedLevel level : directory.uploads().levels()) {
        boolean chosen = level.equals(wanted.get(session));
        entries.add(
            new ServerMessage.LevelEntry(
                level.name(), level.game(), level.author(), votes(level), chosen));
      }
    }
    List<Broadcast> messages = new ArrayList<>();
    int from = 0;
    do {
      int to = Math.min(entries.size(), from + ProtocolLimits.MAX_LISTED_LEVELS);
      messages.add(
          new Broadcast(
              new ServerMessage.LevelList(
                  entries.size() - to, mayChoose(), entries.subList(from, to))));
      from = to;
    } while (from < entries.size());
    return messages;
  }
}
