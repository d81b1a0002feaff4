package carom.sim;

import static carom.sim.message.BuiltInKinds.EMOTE;
import static carom.sim.message.BuiltInKinds.EMOTED;
import static carom.sim.message.BuiltInKinds.MAX_CHAT;
import static carom.sim.message.BuiltInKinds.SAID;
import static carom.sim.message.BuiltInKinds.SAY;

import carom.sim.message.Emote;
import carom.sim.message.Message;

/** What every game does with the messages that every game has: chat and emotes. */
final class Talk {
  private Talk() {}

  /** Handles a message of a player: here if its kind is built in, or by the game. */
  static void handle(Simulation s, Player p, Message m) {
    if (m.is(SAY)) {
      say(s, p, m.text("text"), m.flag("team"));
    } else if (m.is(EMOTE)) {
      emote(s, p, m.choice("emote", Emote.class));
    } else {
      s.game().message(s, p, m);
    }
  }

  private static void say(Simulation s, Player p, String text, boolean toTeam) {
    String asked = text.strip();
    String said = asked.isEmpty() ? null : s.game().chat(s, p, asked);
    if (said == null || said.isEmpty()) {
      return;
    }
    Message line = SAID.of(p.id(), toTeam, said.substring(0, Math.min(MAX_CHAT, said.length())));
    if (toTeam) {
      s.send(line).toTeam(p.team());
    } else {
      s.send(line).toAll();
    }
  }

  private static void emote(Simulation s, Player p, Emote emote) {
    if (p.body() != null && s.game().emote(s, p, emote)) {
      s.send(EMOTED.of(p.id(), emote)).toNear(p.body());
    }
  }
}
