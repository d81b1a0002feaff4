package carom.net.field;

import carom.net.protocol.ProtocolLimits;
import carom.sim.field.Schema;
import carom.sim.message.MessageKinds;
import java.util.ArrayList;
import java.util.List;

/**
 * The declarations that server and client of a game must share: fields, and kinds of messages. The
 * server tells digest and declarations, and a client whose game has others leaves with a text that
 * names the first difference. Immutable; any thread.
 */
public final class Declarations {
  private static final char LAST_ASCII = 0x7e;
  private static final String MESSAGE = "message.";

  private final long digest;
  private final List<String> lines;

  private Declarations(long digest, List<String> lines) {
    this.digest = digest;
    this.lines = lines;
  }

  /** Returns the declarations of a game that has been set up. */
  public static Declarations of(Schema schema, MessageKinds kinds) {
    List<String> lines = new ArrayList<>(schema.lines());
    for (String line : kinds.lines()) {
      lines.add(MESSAGE + line);
    }
    List<String> told =
        lines.stream().limit(ProtocolLimits.MAX_DECLARATIONS).map(Declarations::cut).toList();
    return new Declarations(31 * schema.digest() + kinds.digest(), told);
  }

  private static String cut(String line) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < Math.min(line.length(), ProtocolLimits.MAX_DECLARATION_BYTES); i++) {
      text.append(line.charAt(i) <= LAST_ASCII ? line.charAt(i) : '?');
    }
    return text.toString();
  }

  /** Returns a hash of all declarations in their order. */
  public long digest() {
    return digest;
  }

  /**
   * Returns the declarations as they are told: the first {@value ProtocolLimits#MAX_DECLARATIONS},
   * each cut to {@value ProtocolLimits#MAX_DECLARATION_BYTES} ASCII characters.
   */
  public List<String> lines() {
    return lines;
  }

  /**
   * Returns how these declarations, the client's, differ from the server's.
   *
   * @param game the game's name
   * @param serverDigest the server's {@link #digest}
   * @param told the server's {@link #lines}
   * @return a sentence for the player, or null if they are the same
   */
  public String difference(String game, long serverDigest, List<String> told) {
    if (serverDigest == digest) {
      return null;
    }
    return describe(lines, told) + "; use the same build of game " + game;
  }

  private static String describe(List<String> mine, List<String> told) {
    for (int i = 0; i < Math.max(mine.size(), told.size()); i++) {
      String here = i < mine.size() ? mine.get(i) : "";
      String there = i < told.size() ? told.get(i) : "";
      if (!here.equals(there)) {
        boolean same = path(here).equals(path(there));
        String path = same || there.isEmpty() ? path(here) : path(there);
        String what =
            path.startsWith(MESSAGE)
                ? "message " + path.substring(MESSAGE.length())
                : "field " + path;
        return "%s differs: server %s, client %s"
            .formatted(what, show(there, same), show(here, same));
      }
    }
    return "fields or messages differ beyond what the server tells of them";
  }

  /** Returns a declaration in quotes, without its name if both sides have the same. */
  private static String show(String line, boolean named) {
    if (line.isEmpty()) {
      return "none";
    }
    return "\"" + (named ? line.substring(path(line).length()).trim() : line) + "\"";
  }

  private static String path(String line) {
    int end = line.indexOf(' ');
    return end < 0 ? line : line.substring(0, end);
  }
}
