package carom.server.thin.plain;

import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinSnapshot;
import carom.sim.entity.Input;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Writes what is in messages as the program Echo of the tests' resources does. */
final class Dump {
  /** Names that differ from those of the classes of carom.plain. */
  private static final Map<String, String> NAMES = Map.of("Participant", "Player");

  private Dump() {}

  /** Returns a message of the server as the client reads it, if it isn't cut. */
  static String of(Object value) {
    if (value == null || value instanceof Boolean || value instanceof Integer) {
      return String.valueOf(value);
    } else if (value instanceof Long) {
      return String.valueOf(value);
    } else if (value instanceof Float f) {
      return "f" + Integer.toHexString(Float.floatToIntBits(f));
    } else if (value instanceof String text) {
      return text(text);
    } else if (value instanceof List<?> list) {
      return "[" + String.join(",", list.stream().map(Dump::of).toList()) + "]";
    } else if (value instanceof Map<?, ?> map) {
      List<String> all = new ArrayList<>();
      map.forEach((name, v) -> all.add("Value{name=" + of(name) + ";value=" + of(v) + ";}"));
      return "[" + String.join(",", all) + "]";
    }
    Map<String, Object> fields = new TreeMap<>();
    try {
      for (RecordComponent component : value.getClass().getRecordComponents()) {
        fields.put(component.getName(), component.getAccessor().invoke(value));
      }
    } catch (ReflectiveOperationException e) {
      throw new LinkageError(e.getMessage(), e);
    }
    if (value instanceof ThinServerMessage.Match) {
      fields.put("more", 0);
      fields.put("number", 1); // an encoder for each
    } else if (value instanceof ThinServerMessage.Joints) {
      fields.put("part", 0);
      fields.put("parts", 1);
    }
    String name = value.getClass().getSimpleName();
    return object(NAMES.getOrDefault(name, name), fields);
  }

  /** Returns a message that the server has read, with the fields that the client wrote. */
  static String read(ThinClientMessage message) {
    if (!(message instanceof ThinClientMessage.Input input)) {
      return of(message);
    }
    List<String> controls = new ArrayList<>();
    for (long packed : input.inputs()) {
      Input unpacked = new Input();
      unpacked.unpack(packed);
      controls.add(
          String.format(
              Locale.ROOT,
              "Controls{aim=%d;buttons=%d;moveX=%d;moveY=%d;}",
              packed >>> 32 & 0xffff,
              unpacked.buttons(),
              Math.round(unpacked.moveX() * 127),
              Math.round(unpacked.moveY() * 127)));
    }
    return "Input{count="
        + input.count()
        + ";inputs=["
        + String.join(",", controls)
        + "];seen="
        + input.seenTick()
        + ";}";
  }

  /** Returns a part of a snapshot as the client reads it. */
  static String part(
      ThinSnapshot s, int match, int part, int parts, int from, int to, int goneFrom, int goneTo) {
    List<String> bodies = new ArrayList<>();
    for (int i = from; i < to; i++) {
      bodies.add(
          "Body{angle="
              + of(s.angle[i] * (float) (2 * Math.PI / ThinSnapshot.STEPS_PER_TURN))
              + ";archetype="
              + s.archetype[i]
              + ";id="
              + s.id[i]
              + ";owner="
              + s.owner[i]
              + ";x="
              + of(s.x[i] / (float) ThinSnapshot.STEPS_PER_METRE)
              + ";y="
              + of(s.y[i] / (float) ThinSnapshot.STEPS_PER_METRE)
              + ";}");
    }
    List<String> gone = new ArrayList<>();
    for (int i = goneFrom; i < goneTo; i++) {
      gone.add(String.valueOf(s.gone[i]));
    }
    return "Snapshot{bodies=["
        + String.join(",", bodies)
        + "];gone=["
        + String.join(",", gone)
        + "];input="
        + s.input
        + ";match="
        + match
        + ";part="
        + part
        + ";parts="
        + parts
        + ";tick="
        + s.tick
        + ";}";
  }

  private static String object(String name, Map<String, Object> fields) {
    StringBuilder out = new StringBuilder(name).append('{');
    fields.forEach((field, value) -> out.append(field).append('=').append(of(value)).append(';'));
    return out.append('}').toString();
  }

  private static String text(String value) {
    StringBuilder out = new StringBuilder("\"");
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      out.append(
          c > ' ' && c < 0x7f && c != '"' ? "" + c : String.format(Locale.ROOT, "\\%04x", (int) c));
    }
    return out.append('"').toString();
  }
}
