package carom.server;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * The GameServer in whose pod this server runs, as Agones shows it. Immutable.
 *
 * @param state such as {@code Ready} or {@code Allocated}; empty if unknown
 * @param address of the node, by which players come; empty before the pod has one
 * @param ports open at that address, by name
 * @param labels of the GameServer
 * @param healthPeriodS time within which it must be told that the server is healthy, s; 0 if
 *     unknown
 */
record GameServer(
    String state,
    String address,
    Map<String, Integer> ports,
    Map<String, String> labels,
    int healthPeriodS) {
  /** Name of the port for reliable messages. */
  public static final String TCP = "tcp";

  /** Name of the port for datagrams. */
  public static final String UDP = "udp";

  /** Name of the port for other servers of the fleet. */
  public static final String FLEET = "fleet";

  private static final JsonFactory JSON = new JsonFactory();

  /** Copies the maps. */
  public GameServer {
    ports = Map.copyOf(ports);
    labels = Map.copyOf(labels);
  }

  /**
   * Returns the address for players as {@code --advertise} takes it.
   *
   * @throws IOException if the GameServer lacks a port for it; the message says which
   */
  public String advertise() throws IOException {
    return host() + ":" + required(TCP) + ":" + required(UDP);
  }

  /**
   * Returns the address for the other servers of the fleet.
   *
   * @throws IOException as above
   */
  public String peer() throws IOException {
    return host() + ":" + required(FLEET);
  }

  private String host() {
    return address.contains(":") ? "[" + address + "]" : address;
  }

  /**
   * Returns the port of a name, or 0; one for TCP and UDP has two ports, whose names end so.
   *
   * @param name {@link #TCP}, {@link #UDP} or {@link #FLEET}
   */
  public int port(String name) {
    for (Map.Entry<String, Integer> port : ports.entrySet()) {
      if (port.getKey().equals(name) || port.getKey().endsWith("-" + name)) {
        return port.getValue();
      }
    }
    return 0;
  }

  private int required(String name) throws IOException {
    int port = port(name);
    if (port == 0) {
      throw new IOException(
          "the GameServer has no port named \"" + name + "\"; it has " + ports.keySet());
    }
    return port;
  }

  /**
   * Reads a GameServer; fields that aren't needed are skipped.
   *
   * @param json an answer of {@code /gameserver}, or a line of {@code /watch/gameserver}
   * @throws IOException if it is neither
   */
  static GameServer parse(byte[] json) throws IOException {
    Reader reader = new Reader();
    try (JsonParser parser = JSON.createParser(json)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new IOException("a GameServer begins with a brace");
      }
      reader.object(parser, "");
      if (!reader.whole) {
        throw new IOException("a GameServer has object_meta or status");
      }
    }
    return new GameServer(
        reader.state, reader.address, reader.ports, reader.labels, reader.periodS);
  }

  /** Collects fields by their paths. Agones writes names with underscores or without. */
  private static final class Reader {
    private String state = "";
    private String address = "";
    private final Map<String, Integer> ports = new LinkedHashMap<>();
    private final Map<String, String> labels = new HashMap<>();
    private int periodS;
    private boolean whole;

    void object(JsonParser parser, String path) throws IOException {
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        String name = parser.currentName();
        JsonToken value = parser.nextToken();
        String field = path + "/" + name.replace("_", "").toLowerCase(Locale.ROOT);
        switch (field) {
          case "/result", "/spec", "/spec/health" -> inner(parser, value, path(field));
          case "/error" -> throw new IOException("the sidecar ends the watch");
          case "/objectmeta", "/status" -> {
            whole = true;
            inner(parser, value, field);
          }
          case "/objectmeta/labels" -> labels(parser, value);
          case "/status/ports" -> ports(parser, value);
          case "/status/state" -> state = parser.getValueAsString("");
          case "/status/address" -> address = parser.getValueAsString("");
          case "/spec/health/periodseconds" -> periodS = parser.getValueAsInt(0);
          default -> parser.skipChildren();
        }
      }
    }

    private static String path(String field) {
      return field.equals("/result") ? "" : field;
    }

    private void inner(JsonParser parser, JsonToken value, String path) throws IOException {
      if (value == JsonToken.START_OBJECT) {
        object(parser, path);
      } else {
        parser.skipChildren();
      }
    }

    private void labels(JsonParser parser, JsonToken value) throws IOException {
      if (value != JsonToken.START_OBJECT) {
        parser.skipChildren();
        return;
      }
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        String name = parser.currentName();
        parser.nextToken();
        labels.put(name, parser.getValueAsString(""));
        parser.skipChildren();
      }
    }

    private void ports(JsonParser parser, JsonToken value) throws IOException {
      if (value != JsonToken.START_ARRAY) {
        parser.skipChildren();
        return;
      }
      while (parser.nextToken() == JsonToken.START_OBJECT) {
        String name = "";
        int port = 0;
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
          String field = parser.currentName();
          parser.nextToken();
          if (field.equals("name")) {
            name = parser.getValueAsString("");
          } else if (field.equals("port")) {
            port = parser.getValueAsInt(0);
          }
          parser.skipChildren();
        }
        ports.put(name, port);
      }
    }
  }
}
