package carom.server.room;

import carom.server.session.Session;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.message.PlayerRole;

/**
 * Carries out what an operator does to a player in a room: mutes it, makes it a spectator. Each
 * method answers in one line. The room's thread.
 */
final class Moderator {
  private Moderator() {}

  /**
   * Drops chat and emotes of a player until it leaves the server, or ends that.
   *
   * @param sessions by seat, null where there is none
   */
  public static String mute(Session[] sessions, String name, boolean on) {
    Session session = named(sessions, name);
    if (session == null) {
      return nobody(name);
    }
    session.seat().mute(on);
    return (on ? "muted " : "unmuted ") + session.seat().name();
  }

  /**
   * Makes a player a spectator without asking the game. The player may ask to play again.
   *
   * @param sessions by seat, null where there is none
   */
  public static String spectate(SimulationHost s, Session[] sessions, String name) {
    Session session = named(sessions, name);
    if (session == null) {
      return nobody(name);
    }
    HostPlayer player = session.player();
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
