package carom.server.thin.web;

import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinLink;
import carom.sim.entity.Input;
import carom.text.Json;
import carom.text.JsonException;
import carom.text.Suggestion;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;

/**
 * Reads what thin clients say as JSON, by hand and with bounds. Keys that it doesn't know are
 * ignored, values of another type are refused by name, and so are texts and lists that are too
 * long. One thread.
 */
final class JsonReader {
  /** Most characters of a text. */
  static final int MAX_TEXT = 1_024;

  /** Most values of a message of the game's own. */
  static final int MAX_VALUES = 64;

  private static final int MAX_BUTTONS = 0xffff;
  private static final float MAX_METRES = 1e6f;

  private final Input input = new Input();
  private boolean binary;

  /** Creates a reader. */
  JsonReader() {}

  /** Returns whether the client asked for the binary form when it joined. */
  boolean wantsBinary() {
    return binary;
  }

  /**
   * Reads a message.
   *
   * @param text UTF-8
   * @throws BadMessage if it is none; says why
   */
  ThinClientMessage read(byte[] text) throws BadMessage {
    Json root;
    try {
      root = Json.parseMachineMade(text);
    } catch (JsonException e) {
      String place = e.path().isEmpty() ? "" : e.path();
      throw new BadMessage(place + e.getMessage());
    }
    if (root.kind != Json.Kind.OBJECT || root.fields.size() != 1) {
      throw new BadMessage("a message is an object with one key, such as {\"alive\": {}}");
    }
    Map.Entry<String, Json> only = root.fields.entrySet().iterator().next();
    return read(only.getKey(), only.getValue());
  }

  private ThinClientMessage read(String name, Json body) throws BadMessage {
    if (!ThinClientMessage.NAMES.contains(name)) {
      throw new BadMessage(
          "there is no message "
              + quoted(name)
              + Suggestion.didYouMean(name, ThinClientMessage.NAMES));
    }
    if (body.kind != Json.Kind.OBJECT) {
      throw wrong(body, "an object");
    }
    return switch (name) {
      case "join" -> join(body);
      case "input" -> input(body);
      case "chat" -> new ThinClientMessage.Chat(text(body, "text", true), truth(body, "team"));
      case "emote" -> new ThinClientMessage.Emote(text(body, "emote", true));
      case "choose" -> choose(body);
      case "rate" -> new ThinClientMessage.Rate(integer(required(body, "perSecond")));
      case "view" ->
          new ThinClientMessage.View(
              metres(body, "x"),
              metres(body, "y"),
              metres(body, "halfWidth"),
              metres(body, "halfHeight"));
      case "rooms" -> new ThinClientMessage.ListRooms();
      case "best" -> new ThinClientMessage.ListBest();
      case "custom" -> custom(body);
      case "alive" -> new ThinClientMessage.Alive();
      default -> new ThinClientMessage.Leave();
    };
  }

  private ThinClientMessage join(Json body) throws BadMessage {
    binary = truth(body, "binary");
    String secret = text(body, "secret", false);
    if (!secret.matches("([0-9a-fA-F]{16})?")) {
      throw wrong(body.fields.get("secret"), "the 16 digits of a welcome");
    }
    return new ThinClientMessage.Join(
        integer(body, "version", ThinLink.VERSION),
        text(body, "name", false),
        text(body, "room", false),
        text(body, "game", false),
        text(body, "party", false),
        text(body, "token", false),
        text(body, "password", false),
        secret.isEmpty() ? 0 : HexFormat.fromHexDigitsToLong(secret),
        text(body, "digest", false));
  }

  private ThinClientMessage input(Json body) throws BadMessage {
    int count = integer(required(body, "count"));
    int seen = integer(body, "seen", -1);
    Json list = required(body, "inputs");
    int most = ThinClientMessage.MAX_INPUTS;
    if (list.kind != Json.Kind.ARRAY || list.items.isEmpty() || list.items.size() > most) {
      throw wrong(list, "a list of 1.." + most + " inputs");
    }
    long[] packed = new long[list.items.size()];
    for (int i = 0; i < packed.length; i++) {
      packed[i] = packed(list.items.get(i));
    }
    return new ThinClientMessage.Input(count, seen, packed);
  }

  private long packed(Json one) throws BadMessage {
    if (one.kind != Json.Kind.ARRAY || one.items.size() != 4) {
      throw wrong(one, "[buttons, moveX, moveY, aim]");
    }
    int buttons = integer(one.items.get(0));
    if (buttons < 0 || buttons > MAX_BUTTONS) {
      throw wrong(one.items.get(0), "0.." + MAX_BUTTONS);
    }
    input.buttons(buttons);
    input.move(number(one.items.get(1)), number(one.items.get(2)));
    return input.aim(number(one.items.get(3))).pack();
  }

  private static ThinClientMessage choose(Json body) throws BadMessage {
    Json team = body.fields.get("team");
    Json ready = body.fields.get("ready");
    if (ready != null && ready.kind != Json.Kind.BOOLEAN && ready.kind != Json.Kind.NULL) {
      throw wrong(ready, "true or false");
    }
    return new ThinClientMessage.Choose(
        isGiven(team) ? (Integer) integer(team) : null,
        textOrNull(body, "role"),
        isGiven(ready) ? (Boolean) ready.truth : null,
        textOrNull(body, "colour"),
        textOrNull(body, "room"));
  }

  private static ThinClientMessage custom(Json body) throws BadMessage {
    String kind = text(body, "kind", true);
    Json given = body.fields.get("values");
    Map<String, Object> values = new HashMap<>();
    if (isGiven(given)) {
      if (given.kind != Json.Kind.OBJECT || given.fields.size() > MAX_VALUES) {
        throw wrong(given, "an object of at most " + MAX_VALUES + " values");
      }
      for (Map.Entry<String, Json> entry : given.fields.entrySet()) {
        values.put(entry.getKey(), value(entry.getValue()));
      }
    }
    return new ThinClientMessage.Custom(kind, values);
  }

  private static Object value(Json node) throws BadMessage {
    return switch (node.kind) {
      case STRING -> bounded(node);
      case BOOLEAN -> node.truth;
      case NUMBER -> {
        boolean whole = node.number == (int) node.number;
        yield whole ? (Object) (int) node.number : (Object) number(node);
      }
      default -> throw wrong(node, "a number, a text, true or false");
    };
  }

  private static boolean isGiven(Json node) {
    return node != null && node.kind != Json.Kind.NULL;
  }

  private static Json required(Json body, String key) throws BadMessage {
    Json node = body.fields.get(key);
    if (!isGiven(node)) {
      throw new BadMessage(body.path() + "." + key + " is missing");
    }
    return node;
  }

  private static String text(Json body, String key, boolean isRequired) throws BadMessage {
    Json node = isRequired ? required(body, key) : body.fields.get(key);
    return isGiven(node) ? bounded(node) : "";
  }

  private static String textOrNull(Json body, String key) throws BadMessage {
    Json node = body.fields.get(key);
    return isGiven(node) ? bounded(node) : null;
  }

  private static String bounded(Json node) throws BadMessage {
    if (node.kind != Json.Kind.STRING) {
      throw wrong(node, "a text");
    }
    if (node.text.length() > MAX_TEXT) {
      throw wrong(node, "a text of at most " + MAX_TEXT + " characters");
    }
    return node.text;
  }

  private static boolean truth(Json body, String key) throws BadMessage {
    Json node = body.fields.get(key);
    if (isGiven(node) && node.kind != Json.Kind.BOOLEAN) {
      throw wrong(node, "true or false");
    }
    return isGiven(node) && node.truth;
  }

  private static int integer(Json body, String key, int otherwise) throws BadMessage {
    Json node = body.fields.get(key);
    return isGiven(node) ? integer(node) : otherwise;
  }

  private static int integer(Json node) throws BadMessage {
    if (node.kind != Json.Kind.NUMBER || node.number != (int) node.number) {
      throw wrong(node, "a whole number");
    }
    return (int) node.number;
  }

  private static float number(Json node) throws BadMessage {
    if (node.kind != Json.Kind.NUMBER) {
      throw wrong(node, "a number");
    }
    return (float) node.number;
  }

  private static float metres(Json body, String key) throws BadMessage {
    float value = number(required(body, key));
    if (!(Math.abs(value) <= MAX_METRES)) {
      throw wrong(body.fields.get(key), "metres, at most 1000000 from the origin");
    }
    return value;
  }

  private static BadMessage wrong(Json node, String must) {
    return new BadMessage(node.path() + "=" + node.shown() + " must be " + must);
  }

  private static String quoted(String name) {
    return '"' + (name.length() > 40 ? name.substring(0, 40) + "..." : name) + '"';
  }
}
