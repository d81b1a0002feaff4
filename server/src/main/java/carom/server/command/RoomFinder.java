package carom.server.command;

import carom.net.protocol.PlayerName;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Finds the rooms and players that a line names. */
public final class RoomFinder {
  private static final Pattern ID = Pattern.compile("#\\d{1,4}");

  private final List<Room> rooms;

  /**
   * A player and its room.
   *
   * @param room the room
   * @param player the player as it was when it was found
   */
  public record Found(Room room, PlayerInfo player) {}

  /** Creates a finder in some rooms. */
  public RoomFinder(List<Room> rooms) {
    this.rooms = rooms;
  }

  /** Returns the room that a line names, or all. */
  List<Room> all(CommandWords words) throws CommandException {
    return words.room() == null ? rooms : List.of(named(words.room()));
  }

  /** Returns the room that a line names, or the only one. */
  Room one(CommandWords words) throws CommandException {
    if (words.room() != null) {
      return named(words.room());
    }
    if (rooms.size() > 1) {
      throw new CommandException("which room? name one of " + String.join(", ", names()));
    }
    if (rooms.isEmpty()) {
      throw new CommandException("this server has no rooms now; the fleet's are at other servers");
    }
    return rooms.get(0);
  }

  private Room named(String name) throws CommandException {
    for (Room room : rooms) {
      if (room.name().equalsIgnoreCase(name)) {
        return room;
      }
    }
    throw new CommandException(
        "no room=%s; rooms are %s%s"
            .formatted(
                name, String.join(", ", names()), Suggestion.didYouMean("@" + name, names())));
  }

  /** Returns the names of the rooms as they are written in a line. */
  List<String> names() {
    return rooms.stream().map(room -> "@" + room.name()).toList();
  }

  /** Returns whether a word can only be an id, such as {@code #3}, and never a player's name. */
  public static boolean isId(String word) {
    return ID.matcher(word).matches();
  }

  /**
   * Returns the player with a name or id, in the room that the line names or in any. A name goes
   * before an id, unless the id is written as {@code #3}.
   *
   * @throws CommandException when there is none, or more than one
   */
  public Found player(CommandWords words, int place) throws CommandException {
    String wanted = words.word(place, "PLAYER");
    String folded = PlayerName.folded(wanted);
    List<Found> named = new ArrayList<>();
    List<Found> numbered = new ArrayList<>();
    List<String> names = new ArrayList<>();
    for (Room room : all(words)) {
      for (PlayerInfo player : room.operator().players()) {
        names.add(player.name());
        if (isId(wanted) ? wanted.equals("#" + player.id()) : isNamed(player, folded)) {
          named.add(new Found(room, player));
        } else if (wanted.equals(String.valueOf(player.id()))) {
          numbered.add(new Found(room, player));
        }
      }
    }
    List<Found> found = named.isEmpty() ? numbered : named;
    if (found.isEmpty()) {
      throw new CommandException(
          "no player=" + wanted + " plays here" + Suggestion.didYouMean(wanted, names));
    }
    if (found.size() > 1) {
      throw new CommandException(
          found.size()
              + " rooms have a player="
              + wanted
              + "; name the room, such as "
              + names().get(0));
    }
    return found.get(0);
  }

  private static boolean isNamed(PlayerInfo player, String folded) {
    return PlayerName.folded(player.name()).equals(folded);
  }

  /** Returns the names of all players, for completion. */
  List<String> playerNames() {
    List<String> names = new ArrayList<>();
    for (Room room : rooms) {
      room.operator().players().forEach(player -> names.add(player.name()));
    }
    return names;
  }
}
