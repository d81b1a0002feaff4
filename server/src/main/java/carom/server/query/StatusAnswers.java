package carom.server.query;

import carom.net.protocol.Protocol;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * The answers to A2S queries. Each fits into one datagram of {@value #MAX_BYTES} bytes; players and
 * rules beyond that are left out. An answer is made anew at most once a second, because it asks the
 * rooms. One thread.
 */
final class StatusAnswers {
  /** Largest answer. */
  static final int MAX_BYTES = 1_200;

  private static final int SINGLE = -1;
  private static final byte INFO = 'I';
  private static final byte PLAYERS = 'D';
  private static final byte RULES = 'E';
  private static final byte PROTOCOL = 17;
  private static final int HAS_PORT = 0x80;
  private static final int HAS_KEYWORDS = 0x20;
  private static final int MAX_COUNT = 255;
  private static final int MAX_TEXT = 63;
  private static final long KEEP_NS = 1_000_000_000L;

  private final StatusFacts facts;
  private final Map<Byte, Made> made = new LinkedHashMap<>();

  @SuppressWarnings("ArrayRecordComponent") // Never compared; nobody changes them.
  private record Made(long timeNs, byte[] bytes) {}

  StatusAnswers(StatusFacts facts) {
    this.facts = facts;
  }

  /**
   * Returns the answer to a query.
   *
   * @param query one of {@link StatusQuery}'s
   * @param nowNs monotonic time
   */
  byte[] answer(byte query, long nowNs) {
    Made last = made.get(query);
    if (last == null || nowNs - last.timeNs >= KEEP_NS) {
      byte[] bytes =
          switch (query) {
            case StatusQuery.INFO -> info();
            case StatusQuery.PLAYERS -> players();
            default -> rules();
          };
      last = new Made(nowNs, bytes);
      made.put(query, last);
    }
    return last.bytes;
  }

  private static ByteBuffer begin(byte type) {
    return ByteBuffer.allocate(MAX_BYTES).order(ByteOrder.LITTLE_ENDIAN).putInt(SINGLE).put(type);
  }

  private static byte[] end(ByteBuffer out) {
    byte[] bytes = new byte[out.position()];
    out.flip().get(bytes);
    return bytes;
  }

  /** Returns a text with its end mark; zeros in it, which can't be sent, are left out. */
  private static byte[] text(String text) {
    String shown = text.replace("\0", "");
    int end = Math.min(shown.length(), MAX_TEXT);
    if (end > 0 && end < shown.length() && Character.isHighSurrogate(shown.charAt(end - 1))) {
      end--;
    }
    return (shown.substring(0, end) + "\0").getBytes(StandardCharsets.UTF_8);
  }

  private byte[] info() {
    String level = "";
    String game = "";
    int players = 0;
    int bots = 0;
    int places = 0;
    for (Room room : facts.rooms()) { // a server of a fleet may have none
      level = level.isEmpty() ? room.match().level().level().name() : level;
      game = game.isEmpty() ? room.match().game() : game;
      players += room.seats().takenCount();
      bots += (int) room.counters().get(Counter.BOTS);
      places += room.seats().count();
    }
    String system = System.getProperty("os.name");
    char platform = system.startsWith("Win") ? 'w' : system.startsWith("Mac") ? 'm' : 'l';
    ByteBuffer out = begin(INFO).put(PROTOCOL);
    out.put(text(facts.name()))
        .put(text(level))
        .put(text("carom"))
        .put(text(game))
        .putShort((short) 0) // no number of Steam's
        .put((byte) Math.min(MAX_COUNT, players))
        .put((byte) Math.min(MAX_COUNT, places))
        .put((byte) Math.min(MAX_COUNT, bots)) // of the players
        .put((byte) 'd')
        .put((byte) platform)
        .put((byte) 0) // no password
        .put((byte) 0)
        .put(text(facts.version()))
        .put((byte) (HAS_PORT | HAS_KEYWORDS))
        .putShort((short) facts.tcpPort())
        .put(
            text(
                String.format(
                    Locale.ROOT,
                    "carom,tcp=%d,udp=%d,protocol=%d",
                    facts.tcpPort(),
                    facts.udpPort(),
                    Protocol.VERSION)));
    return end(out);
  }

  private byte[] players() {
    ByteBuffer out = begin(PLAYERS).put((byte) 0);
    int count = 0;
    for (Room room : facts.rooms()) {
      for (PlayerInfo player : room.operator().players()) {
        byte[] name = text(player.name());
        int bytes = 1 + name.length + Integer.BYTES + Float.BYTES;
        if (count < MAX_COUNT && out.remaining() >= bytes) {
          float seconds = player.playedTicks() / (float) room.tickRateHz();
          out.put((byte) count++).put(name).putInt(player.score()).putFloat(seconds);
        }
      }
    }
    out.put(Integer.BYTES + 1, (byte) count);
    return end(out);
  }

  private byte[] rules() {
    Map<String, String> rules = new LinkedHashMap<>();
    rules.put("tcp_port", String.valueOf(facts.tcpPort()));
    rules.put("udp_port", String.valueOf(facts.udpPort()));
    rules.put("protocol", String.valueOf(Protocol.VERSION));
    rules.put("physics", Protocol.PHYSICS_VERSION);
    for (Room room : facts.rooms()) {
      rules.putIfAbsent("tick_rate", String.valueOf(room.tickRateHz()));
    }
    rules.put("rooms", String.valueOf(facts.rooms().size()));
    for (Room room : facts.rooms()) {
      rules.put(
          "room_" + room.name(),
          String.format(
              Locale.ROOT,
              "%s, %s, %d/%d",
              room.match().game(),
              room.match().level().level().name(),
              room.seats().takenCount(),
              room.seats().count()));
    }
    ByteBuffer out = begin(RULES).putShort((short) 0);
    int count = 0;
    for (Map.Entry<String, String> rule : rules.entrySet()) {
      byte[] name = text(rule.getKey());
      byte[] value = text(rule.getValue());
      if (out.remaining() >= name.length + value.length) {
        out.put(name).put(value);
        count++;
      }
    }
    out.putShort(Integer.BYTES + 1, (short) count);
    return end(out);
  }
}
