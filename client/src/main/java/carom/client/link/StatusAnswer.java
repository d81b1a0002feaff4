package carom.client.link;

import carom.text.Texts;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A Carom server's description of itself in the answer to an A2S_INFO query. Texts are clean and
 * short enough to be shown. Immutable.
 *
 * @param name the server's name
 * @param level name of the level in its first room
 * @param game name of the game in its first room
 * @param players number of players in all rooms
 * @param places number of players that all rooms have places for
 * @param tcpPort port by which players join, 1..65,535
 * @param protocol version of Carom's protocol
 */
public record StatusAnswer(
    String name, String level, String game, int players, int places, int tcpPort, int protocol) {
  /** Longest text that is kept, in characters. */
  static final int MAX_TEXT = 40;

  /** Most bytes of an answer that are looked at. */
  static final int MAX_BYTES = 1_400;

  private static final int SINGLE = -1;
  private static final byte INFO = 'I';
  private static final byte A2S_PROTOCOL = 17;
  private static final int FLAG_PORT = 0x80;
  private static final int FLAG_STEAM_ID = 0x10;
  private static final int FLAG_SPECTATORS = 0x40;
  private static final int FLAG_KEYWORDS = 0x20;

  /** Returns the answer in a datagram, or null if it isn't one of a Carom server. */
  static StatusAnswer parse(ByteBuffer datagram) {
    ByteBuffer in = datagram.order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < 6
        || in.getInt() != SINGLE
        || in.get() != INFO
        || in.get() != A2S_PROTOCOL) {
      return null;
    }
    String name = text(in);
    String level = text(in);
    String folder = text(in);
    String game = text(in);
    boolean isCarom = name != null && level != null && "carom".equals(folder) && game != null;
    if (!isCarom || in.remaining() < 9) {
      return null;
    }
    in.getShort(); // a number of Steam's
    int players = Byte.toUnsignedInt(in.get());
    int places = Byte.toUnsignedInt(in.get());
    in.position(in.position() + 5); // bots, kind, system, password, cheats
    String version = text(in);
    String keywords = version == null ? null : keywords(in);
    if (keywords == null) {
      return null;
    }
    int tcpPort = number(keywords, "tcp");
    int protocol = number(keywords, "protocol");
    return tcpPort < 1 || tcpPort > 65_535 || protocol < 1
        ? null
        : new StatusAnswer(
            shown(name), shown(level), shown(game), players, places, tcpPort, protocol);
  }

  /** Returns the keywords behind the optional fields, or null if there are none. */
  private static String keywords(ByteBuffer in) {
    int flags = in.hasRemaining() ? in.get() : 0;
    skip(in, (flags & FLAG_PORT) != 0 ? Short.BYTES : 0);
    skip(in, (flags & FLAG_STEAM_ID) != 0 ? Long.BYTES : 0);
    if ((flags & FLAG_SPECTATORS) != 0) {
      skip(in, Short.BYTES);
      text(in);
    }
    return (flags & FLAG_KEYWORDS) == 0 ? null : text(in);
  }

  private static void skip(ByteBuffer in, int bytes) {
    in.position(Math.min(in.limit(), in.position() + bytes));
  }

  /** Returns the text up to its zero, or null if there is no zero or the text is no UTF-8. */
  private static String text(ByteBuffer in) {
    int start = in.position();
    while (in.hasRemaining()) {
      if (in.get() == 0) {
        return Texts.ofUtf8(in.duplicate().limit(in.position() - 1).position(start));
      }
    }
    return null;
  }

  /** Returns the number of {@code key=number}, or 0 if there is none. */
  private static int number(String keywords, String key) {
    for (String word : keywords.split(",", -1)) {
      if (word.startsWith(key + "=")) {
        String digits = word.substring(key.length() + 1);
        return digits.matches("[0-9]{1,6}") ? Integer.parseInt(digits) : 0;
      }
    }
    return 0;
  }

  private static String shown(String text) {
    String clean = Texts.clean(text).strip();
    if (clean.codePointCount(0, clean.length()) <= MAX_TEXT) {
      return clean;
    }
    return clean.substring(0, clean.offsetByCodePoints(0, MAX_TEXT - 1)) + "…";
  }
}
