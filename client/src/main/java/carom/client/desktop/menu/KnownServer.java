package carom.client.desktop.menu;

import carom.client.link.LanServer;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.client.link.StatusAnswer;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage.RoomEntry;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** A server of the player's lists and what it told of itself. Render thread only. */
final class KnownServer implements AutoCloseable {
  private static final double NS_PER_MS = 1e6;

  private final String text;
  private ServerAddress address;
  private RoomBrowser browser;
  private String about = "...";

  /**
   * Creates one and asks the server.
   *
   * @param text its address, as the player entered it
   */
  KnownServer(String text, Function<ServerAddress, RoomBrowser> browse) {
    this.text = text;
    try {
      address = ServerAddress.parse(text);
      browser = browse.apply(address);
    } catch (IllegalArgumentException e) {
      about = "is no address";
    }
  }

  /** Returns its address, as the player entered it. */
  String text() {
    return text;
  }

  /** Returns its address, or null when the text is none. */
  ServerAddress address() {
    return address;
  }

  /** Returns what it told, in a line. */
  String about() {
    return about;
  }

  /** Takes in its answer; returns whether there is something new to show. */
  boolean update(long nowNs) {
    if (browser == null) {
      return false;
    }
    browser.update(nowNs);
    if (!browser.isDone()) {
      return false;
    }
    about =
        browser.problem().isEmpty()
            ? describe(browser.rooms(), browser.roundTripNs() / NS_PER_MS)
            : "no answer";
    browser = null;
    return true;
  }

  /** Returns a line about a server's rooms. */
  static String describe(List<RoomEntry> rooms, double pingMs) {
    int players = rooms.stream().mapToInt(RoomEntry::players).sum();
    int places = rooms.stream().mapToInt(RoomEntry::places).sum();
    String game =
        rooms.isEmpty()
            ? "no room"
            : rooms.size() == 1
                ? rooms.get(0).game() + ", " + rooms.get(0).level()
                : rooms.size() + " rooms";
    return describe(game, players, places, pingMs);
  }

  /** Returns a line about a server of this network. */
  static String describe(LanServer server) {
    StatusAnswer told = server.status();
    return told.protocol() == Protocol.VERSION
        ? describe(
            told.game() + ", " + told.level(), told.players(), told.places(), server.pingMs())
        : "another version of Carom";
  }

  private static String describe(String game, int players, int places, double pingMs) {
    return String.format(Locale.ROOT, "%s    %d/%d    %.0f ms", game, players, places, pingMs);
  }

  @Override
  public void close() {
    if (browser != null) {
      browser.close();
      browser = null;
    }
  }
}
