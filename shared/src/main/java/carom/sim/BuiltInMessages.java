package carom.sim;

import static carom.sim.message.BuiltInKinds.COLOUR;
import static carom.sim.message.BuiltInKinds.EMOTE;
import static carom.sim.message.BuiltInKinds.EMOTED;
import static carom.sim.message.BuiltInKinds.MAX_CHAT;
import static carom.sim.message.BuiltInKinds.READY;
import static carom.sim.message.BuiltInKinds.ROLE;
import static carom.sim.message.BuiltInKinds.SAID;
import static carom.sim.message.BuiltInKinds.SAY;
import static carom.sim.message.BuiltInKinds.SERVER;
import static carom.sim.message.BuiltInKinds.TEAM;

import carom.sim.entity.HostPlayer;
import carom.sim.entity.Player;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import java.util.List;

/**
 * Handles the messages that every game has: chat, emotes, and what a participant asks of the
 * roster. A request that isn't granted is answered in words, to the player who asked.
 */
final class BuiltInMessages {
  private BuiltInMessages() {}

  /** Handles a message of a participant: here if its kind is built in, or by the game. */
  static void handle(SimulationHost s, HostPlayer p, Message m) {
    if (m.is(SAY)) {
      say(s, p, m.text("text"), m.flag("team"));
    } else if (m.is(EMOTE)) {
      emote(s, p, m.choice("emote", Emote.class));
    } else if (m.is(ROLE)) {
      role(s, p, m.choice("role", PlayerRole.class));
    } else if (m.is(TEAM)) {
      team(s, p, m.count("team"));
    } else if (m.is(READY)) {
      p.ready(m.flag("ready"));
    } else if (m.is(COLOUR)) {
      boolean lets = s.game().ownColours();
      p.colour(lets ? m.choice("colour", PlayerColour.class) : PlayerColour.OF_THE_GAME);
    } else if (!p.isSpectator()) {
      s.game().message(s, p, m);
    }
  }

  /** Says a line of the server to one participant. */
  static void tell(SimulationHost s, HostPlayer p, String text) {
    s.send(SAID.of(SERVER, false, cut(text))).to(p);
  }

  private static String cut(String text) {
    return text.substring(0, Math.min(MAX_CHAT, text.length()));
  }

  private static void say(SimulationHost s, HostPlayer p, String text, boolean toTeam) {
    String asked = text.strip();
    String said = asked.isEmpty() ? null : s.game().chat(s, p, asked);
    if (said == null || said.isEmpty()) {
      return;
    }
    Message line = SAID.of(p.id(), toTeam, cut(said));
    if (toTeam) {
      s.send(line).toTeam(p.team());
    } else {
      s.send(line).toAll();
    }
  }

  private static void emote(SimulationHost s, HostPlayer p, Emote emote) {
    if (p.entity() != null && s.game().emote(s, p, emote)) {
      s.send(EMOTED.of(p.id(), emote)).toNear(p.entity());
    }
  }

  private static void role(SimulationHost s, HostPlayer p, PlayerRole role) {
    if (p.role() == role) {
      return;
    }
    boolean full = role == PlayerRole.PLAYER && s.playerCount() >= s.game().maxPlayers();
    String refusal = full ? refusalWhenFull(s) : s.game().refuseRole(s, p, role);
    if (refusal == null) {
      s.role(p, role);
    } else {
      tell(s, p, refusal);
    }
  }

  /** Returns what a participant is told who can't play because others do. */
  static String refusalWhenFull(SimulationHost s) {
    return "All " + s.game().maxPlayers() + " places are taken: you watch";
  }

  private static void team(SimulationHost s, HostPlayer p, int team) {
    if (!p.isSpectator() && p.team() == team) {
      return;
    }
    String refusal = refusal(s, p, team);
    if (refusal == null) {
      p.team(team);
      s.game().teamChanged(s, p);
    } else {
      tell(s, p, refusal);
    }
  }

  private static String refusal(SimulationHost s, HostPlayer p, int team) {
    List<String> teams = s.game().teams();
    if (p.isSpectator()) {
      return "Spectators have no team: ask to play first";
    } else if (teams.isEmpty()) {
      return "This game has no teams to choose";
    } else if (team < 1 || team > teams.size()) {
      return "There is no team " + team + ", only 1 to " + teams.size();
    }
    return s.game().refuseTeam(s, p, team);
  }

  /** Returns why a change to a team would make the teams unequal, or null if it doesn't. */
  static String imbalance(Match m, Player p, int team, List<String> teams) {
    for (int other = 1; other <= teams.size(); other++) {
      int others = m.teamSize(other) - (m.team(p) == other ? 1 : 0);
      if (m.teamSize(team) > others) {
        return teams.get(team - 1) + " has more players than " + teams.get(other - 1);
      }
    }
    return null;
  }
}
