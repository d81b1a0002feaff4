package carom.server.command;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.options.Sockets;
import carom.server.room.Room;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The command that sends players to another server, and the one that does so and stops this. */
public final class RedirectCommands {
  private static final String SERVER = "SERVER";
  private static final String FLAG = "--redirect";
  private static final int ALL = -1;
  private static final Pattern TARGET =
      Pattern.compile("((?:" + Sockets.HOST + "):(\\d{1,5}))(?:#([-\\w]{43}))?");

  private final List<Room> rooms;
  private final RoomFinder finder;
  private final Consumer<ServerMessage.Redirect> lobby;
  private final Function<ServerMessage.Redirect, String> probe;
  private final Runnable stop;

  private RedirectCommands(
      List<Room> rooms,
      Consumer<ServerMessage.Redirect> lobby,
      Function<ServerMessage.Redirect, String> probe,
      Runnable stop) {
    this.probe = probe;
    this.rooms = rooms;
    this.lobby = lobby;
    finder = new RoomFinder(rooms);
    this.stop = stop;
  }

  /**
   * Adds the commands to a registry.
   *
   * @param rooms all rooms of the server
   * @param lobby sends away all who wait for a place or watch
   * @param probe returns why a server can't take players, or null if it answers
   * @param stop begins to stop the server, and returns at once
   */
  public static void add(
      CommandRegistry registry,
      List<Room> rooms,
      Consumer<ServerMessage.Redirect> lobby,
      Function<ServerMessage.Redirect, String> probe,
      Runnable stop) {
    RedirectCommands all = new RedirectCommands(rooms, lobby, probe, stop);
    registry.add(
        new Command(
                "redirect",
                "[@ROOM] HOST:PORT[#FINGERPRINT] [PLAYER [TOKEN]]",
                "Sends everybody to another server, or a room's players, or one player.",
                all::redirect,
                place -> place == 1 ? all.finder.playerNames() : List.of())
            .logging(2));
    registry.add(
        new Command(
            "stop",
            "[--redirect HOST:PORT[#FINGERPRINT]]",
            "Tells the players and stops the server; may send everybody to another one before.",
            all::stop,
            place -> place == 0 ? List.of(FLAG) : List.of()));
  }

  private String redirect(CommandWords words) throws CommandException {
    words.requireAtMost(3);
    String token = words.has(2) ? words.word(2, "TOKEN") : "";
    if (token.length() > ProtocolLimits.MAX_TOKEN_BYTES) {
      throw new CommandException(
          String.format(
              Locale.ROOT,
              "TOKEN has characters=%d, limit=%d",
              token.length(),
              ProtocolLimits.MAX_TOKEN_BYTES));
    }
    ServerMessage.Redirect redirect = answering(parse(words.word(0, SERVER), token));
    if (!words.has(1) && words.room() == null) {
      return sentEverybody(redirect);
    }
    if (!words.has(1)) {
      return sentAll(finder.all(words), redirect);
    }
    RoomFinder.Found found = finder.player(words, 1);
    int sent = found.room().operator().redirect(found.player().id(), redirect);
    return String.format(Locale.ROOT, "sent players=%d to %s", sent, redirect.server());
  }

  private String sentEverybody(ServerMessage.Redirect redirect) {
    lobby.accept(redirect);
    return sentAll(new ArrayList<>(rooms), redirect);
  }

  private static String sentAll(List<Room> rooms, ServerMessage.Redirect redirect) {
    int sent = 0;
    for (Room room : rooms) {
      sent += room.operator().redirect(ALL, redirect);
    }
    return String.format(Locale.ROOT, "sent players=%d to %s", sent, redirect.server());
  }

  private String stop(CommandWords words) throws CommandException {
    if (!words.has(0)) {
      stop.run();
      return "stopping";
    }
    if (!words.word(0, FLAG).equals(FLAG)) {
      throw new CommandException("\"" + words.word(0, FLAG) + "\" isn't " + FLAG);
    }
    words.requireAtMost(2);
    String sent = sentEverybody(answering(parse(words.word(1, SERVER), "")));
    stop.run();
    return sent + ", stopping";
  }

  /**
   * Returns a redirect whose server answers.
   *
   * @throws CommandException if it doesn't; the message says what was tried, and no player is sent
   *     away
   */
  private ServerMessage.Redirect answering(ServerMessage.Redirect redirect)
      throws CommandException {
    String problem = probe.apply(redirect);
    if (problem != null) {
      throw new CommandException("nobody is sent away: " + problem);
    }
    return redirect;
  }

  private static ServerMessage.Redirect parse(String text, String token) throws CommandException {
    Matcher target = TARGET.matcher(text);
    if (!target.matches()
        || target.group(1).length() > ProtocolLimits.MAX_ADDRESS_BYTES
        || !Sockets.isReachable(target.group(2))) {
      throw new CommandException(
          "SERVER=%s must be HOST:PORT or HOST:PORT#FINGERPRINT, such as play.example.org:54555"
              .formatted(text));
    }
    String fingerprint = target.group(3) == null ? "" : target.group(3);
    return new ServerMessage.Redirect(target.group(1), fingerprint, "", token);
  }
}
