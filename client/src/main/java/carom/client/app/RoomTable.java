package carom.client.app;

import carom.net.protocol.ServerMessage.RoomEntry;
import java.util.ArrayList;
import java.util.List;

/** Writes a server's rooms as a table for a terminal. */
final class RoomTable {
  private static final int COLUMNS = 6;

  private RoomTable() {}

  /** Returns a line of headings and a line for each room, in columns. */
  static String of(List<RoomEntry> rooms) {
    List<String[]> lines = new ArrayList<>();
    lines.add(new String[] {"ROOM", "GAME", "LEVEL", "PLAYERS", "PHASE", "SPECTATORS", ""});
    for (RoomEntry room : rooms) {
      List<String> about = new ArrayList<>();
      room.metadata().forEach((key, value) -> about.add(key + "=" + value));
      lines.add(
          new String[] {
            room.name(),
            room.game(),
            room.level(),
            room.players() + "/" + room.places(),
            room.phase().isEmpty() ? "-" : room.phase(),
            String.valueOf(room.spectators()),
            String.join(" ", about)
          });
    }
    StringBuilder text = new StringBuilder();
    for (String[] line : lines) {
      StringBuilder row = new StringBuilder();
      for (int column = 0; column < COLUMNS; column++) {
        row.append(line[column]);
        row.append(" ".repeat(2 + width(lines, column) - line[column].length()));
      }
      text.append(text.length() == 0 ? "" : System.lineSeparator());
      text.append(row.append(line[COLUMNS]).toString().stripTrailing());
    }
    return text.toString();
  }

  private static int width(List<String[]> lines, int column) {
    return lines.stream().mapToInt(line -> line[column].length()).max().orElse(0);
  }
}
