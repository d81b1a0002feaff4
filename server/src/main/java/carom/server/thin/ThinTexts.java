package carom.server.thin;

import carom.net.protocol.ServerMessage;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.PlayerColour;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;

/** Turns the messages of own clients into those of thin ones. */
final class ThinTexts {
  private ThinTexts() {}

  static ThinServerMessage.Rooms rooms(ServerMessage.RoomList list) {
    List<ThinServerMessage.Room> rooms = new ArrayList<>();
    for (ServerMessage.RoomEntry r : list.rooms()) {
      rooms.add(
          new ThinServerMessage.Room(
              r.name(), r.game(), r.level(), r.phase(), r.players(), r.places(), r.metadata()));
    }
    return new ThinServerMessage.Rooms(rooms, list.left());
  }

  static ThinServerMessage best(ServerMessage.BestLists best) {
    List<ThinServerMessage.BestList> lists = new ArrayList<>();
    for (ServerMessage.BestList list : best.lists()) {
      List<ThinServerMessage.BestEntry> entries = new ArrayList<>();
      list.entries()
          .forEach(e -> entries.add(new ThinServerMessage.BestEntry(e.name(), e.value())));
      lists.add(new ThinServerMessage.BestList(list.field(), list.own(), entries));
    }
    return new ThinServerMessage.Best(lists);
  }

  static ThinServerMessage of(Message message) {
    if (message.is(BuiltInKinds.SAID)) {
      return new ThinServerMessage.Chat(
          message.count("player"), message.text("text"), message.flag("team"));
    }
    if (message.is(BuiltInKinds.EMOTED)) {
      return new ThinServerMessage.Emote(
          message.count("player"), message.choice("emote", Emote.class).name());
    }
    return new ThinServerMessage.Custom(message.kind().name(), message.values());
  }

  /** Tells of players that changed: in full, or where that is all, by score and ping. */
  static void tellRoster(
      ServerMessage.Roster changes,
      SortedMap<Integer, ServerMessage.RosterEntry> known,
      boolean ownColours,
      ThinLink link) {
    List<ThinServerMessage.Participant> players = new ArrayList<>();
    List<Integer> gone = new ArrayList<>();
    List<Integer> scores = new ArrayList<>();
    for (ServerMessage.RosterEntry e : changes.entries()) {
      ServerMessage.RosterEntry before =
          e.hasGone() ? known.remove(e.playerId()) : known.put(e.playerId(), e);
      if (e.hasGone()) {
        gone.add(e.playerId());
      } else if (before != null && differsInScore(before, e)) {
        scores.add(e.playerId());
        scores.add(e.score());
        scores.add(e.pingMs());
      } else {
        players.add(participant(e, ownColours));
      }
    }
    if (!players.isEmpty() || !gone.isEmpty()) {
      link.tell(new ThinServerMessage.Roster(players, gone));
    }
    if (!scores.isEmpty()) {
      link.tell(new ThinServerMessage.Scores(scores));
    }
  }

  private static boolean differsInScore(ServerMessage.RosterEntry a, ServerMessage.RosterEntry b) {
    return a.equals(
        new ServerMessage.RosterEntry(
            b.playerId(),
            b.name(),
            b.team(),
            a.score(),
            b.spectator(),
            b.ready(),
            b.alive(),
            a.pingMs(),
            b.colour()));
  }

  private static ThinServerMessage.Participant participant(
      ServerMessage.RosterEntry e, boolean ownColours) {
    PlayerColour colour = PlayerColour.of(e.colour());
    if (colour == PlayerColour.OF_THE_GAME && ownColours) {
      colour = PlayerColour.of(1 + e.playerId() % (PlayerColour.values().length - 1));
    }
    return new ThinServerMessage.Participant(
        e.playerId(),
        e.name(),
        e.team(),
        e.score(),
        e.spectator(),
        e.ready(),
        e.alive(),
        e.pingMs(),
        colour.rgb());
  }
}
