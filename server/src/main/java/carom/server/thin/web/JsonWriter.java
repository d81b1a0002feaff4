package carom.server.thin.web;

import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinSnapshot;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Writes what thin clients are told as JSON: an object with one key, the message's name, whose
 * value has a key for each of its components. Any thread.
 */
final class JsonWriter {
  private static final JsonFactory FACTORY = new JsonFactory();

  /** Length of a whole turn in thousandths of a radian, divided by the steps of a snapshot. */
  private static final double RAD_PER_STEP = 2 * Math.PI / ThinSnapshot.STEPS_PER_TURN;

  /** Four decimals: a tenth of a millimetre. */
  private static final double DECIMALS = 1e4;

  /** Numbers below this aren't rounded. */
  private static final float LEAST_ROUNDED = 0.01f;

  private static final Map<Class<?>, RecordComponent[]> COMPONENTS = new ConcurrentHashMap<>();

  private JsonWriter() {}

  /** Returns a message as UTF-8; of an event only the value, as they go in lists. */
  static byte[] write(ThinServerMessage message) {
    ByteArrayOutputStream out = new ByteArrayOutputStream(256);
    try (JsonGenerator json = FACTORY.createGenerator(out)) {
      if (message instanceof ThinServerMessage.Event) {
        write(json, message);
        json.flush();
        return out.toByteArray();
      }
      json.writeStartObject();
      json.writeFieldName(name(message));
      if (message instanceof ThinServerMessage.Fields fields) {
        writeFields(json, fields);
      } else {
        write(json, message);
      }
      json.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e); // can't happen in memory
    }
    return out.toByteArray();
  }

  /** Returns the name of a message, such as {@code welcome}. */
  static String name(ThinServerMessage message) {
    return message.getClass().getSimpleName().toLowerCase(Locale.ROOT);
  }

  /** Writes fields as objects in objects, because that takes half the bytes: scope, id, name. */
  private static void writeFields(JsonGenerator json, ThinServerMessage.Fields fields)
      throws IOException {
    Map<String, Map<Integer, Map<String, Object>>> scopes = new LinkedHashMap<>();
    for (ThinServerMessage.FieldValue field : fields.values()) {
      scopes
          .computeIfAbsent(field.scope(), scope -> new LinkedHashMap<>())
          .computeIfAbsent(field.id(), id -> new LinkedHashMap<>())
          .put(field.name(), field.value());
    }
    write(json, scopes);
  }

  private static void write(JsonGenerator json, Object value) throws IOException {
    if (value == null) {
      json.writeNull();
    } else if (value instanceof String text) {
      json.writeString(whole(text));
    } else if (value instanceof Boolean truth) {
      json.writeBoolean(truth);
    } else if (value instanceof Integer number) {
      json.writeNumber(number);
    } else if (value instanceof Long secret) {
      json.writeString(HexFormat.of().toHexDigits(secret)); // JavaScript's numbers have 53 bits
    } else if (value instanceof Float number) {
      writeFloat(json, number);
    } else if (value instanceof List<?> list) {
      json.writeStartArray();
      for (Object item : list) {
        write(json, item);
      }
      json.writeEndArray();
    } else if (value instanceof Map<?, ?> map) {
      json.writeStartObject();
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        json.writeFieldName(whole(entry.getKey().toString()));
        write(json, entry.getValue());
      }
      json.writeEndObject();
    } else if (value instanceof Record object) {
      json.writeStartObject();
      for (RecordComponent component : components(object.getClass())) {
        json.writeFieldName(component.getName());
        write(json, read(component, object));
      }
      json.writeEndObject();
    } else if (value instanceof Number number) {
      json.writeNumber(number.intValue());
    } else {
      json.writeString(whole(value.toString()));
    }
  }

  private static void writeFloat(JsonGenerator json, float number) throws IOException {
    if (!Float.isFinite(number)) {
      json.writeNull(); // JSON has no such number
    } else if (number == Math.rint(number) && Math.abs(number) < 1e7f) {
      json.writeNumber((int) number);
    } else if (Math.abs(number) > LEAST_ROUNDED) {
      json.writeNumber(Math.round(number * DECIMALS) / DECIMALS);
    } else {
      json.writeNumber(number);
    }
  }

  private static RecordComponent[] components(Class<?> type) {
    return COMPONENTS.computeIfAbsent(type, Class::getRecordComponents);
  }

  private static Object read(RecordComponent component, Record of) {
    try {
      return component.getAccessor().invoke(of);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e); // the accessors of messages are public
    }
  }

  /** Returns a text in which each half of a surrogate pair has its other half. */
  private static String whole(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (Character.isSurrogate(text.charAt(i))) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8); // half a pair becomes a question mark
        return new String(bytes, StandardCharsets.UTF_8);
      }
    }
    return text;
  }

  /** Writes a snapshot. */
  static void write(ThinSnapshot snapshot, Bytes out) {
    out.ascii("{\"snapshot\":{\"tick\":").number(snapshot.tick);
    out.ascii(",\"input\":").number(snapshot.input).ascii(",\"bodies\":[");
    for (int i = 0; i < snapshot.count; i++) {
      out.ascii(i == 0 ? "[" : ",[").number(snapshot.id[i]);
      out.ascii(",").thousandths(thousandths(snapshot.x[i]));
      out.ascii(",").thousandths(thousandths(snapshot.y[i]));
      out.ascii(",").thousandths(Math.round(snapshot.angle[i] * RAD_PER_STEP * 1_000));
      if (snapshot.archetype[i] >= 0) {
        out.ascii(",").number(snapshot.archetype[i]).ascii(",").number(snapshot.owner[i]);
      }
      out.ascii("]");
    }
    out.ascii("],\"gone\":[");
    for (int i = 0; i < snapshot.goneCount; i++) {
      out.ascii(i == 0 ? "" : ",").number(snapshot.gone[i]);
    }
    out.ascii("]}}");
  }

  private static long thousandths(int steps) {
    return Math.round(steps * (1_000.0 / ThinSnapshot.STEPS_PER_METRE));
  }
}
