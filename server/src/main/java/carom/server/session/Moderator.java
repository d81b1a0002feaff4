package carom.server.session;

import carom.sim.Player;
import carom.sim.Simulation;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.PlayerRole;
import carom.text.Texts;

/**
 * What an operator does to the people in a room: speaks to all, mutes one, makes one a spectator.
 * Each method answers in one line. The room's thread.
 */
public final class Moderator {
  private Moderator() {}

  /** Says a line to everybody in the room, as chat of the server. */
  public static String say(Simulation s, String text) {
    String line = text == null ? "" : Texts.clean(text).strip();
    if (line.isEmpty() || line.length() > BuiltInKinds.MAX_CHAT) {
      return "text has length=" + line.length() + ", allowed are 1.." + BuiltInKinds.MAX_CHAT;
    }
    s.send(BuiltInKinds.SAID.of(BuiltInKinds.SERVER, false, line)).toAll();
    return "said \"" + line + "\"";
  }

  /**
   * Drops chat and emotes of a player for the rest of its stay, or ends that.
   *
   * @param sessions by seat, null where there is none
   */
  public static String mute(Session[] sessions, String name, boolean on) {
    Session session = named(sessions, name);
    if (session == null) {
      return nobody(name);
    }
    session.messages().mute(on);
    return (on ? "muted " : "unmuted ") + session.seat().name();
  }

  /**
   * Makes a player a spectator, whatever the game says. The player may ask to play again.
   *
   * @param sessions by seat, null where there is none
   */
  public static String spectate(Simulation s, Session[] sessions, String name) {
    Session session = named(sessions, name);
    if (session == null) {
      return nobody(name);
    }
    Player player = session.player();
    if (player.isSpectator()) {
      return player.name() + " watches already";
    }
    s.role(player, PlayerRole.SPECTATOR);
    return player.name() + " watches";
  }

  /** Returns the session of a name, without regard to case, or null. */
  private static Session named(Session[] sessions, String name) {
    String wanted = name == null ? "" : name.strip();
    for (Session session : sessions) {
      if (session != null && session.seat().name().equalsIgnoreCase(wanted)) {
        return session;
      }
    }
    return null;
  }

  private static String nobody(String name) {
    return "name=\"" + name + "\" doesn't play here; the log names those who joined";
  }
}
