package carom.server.fleet;

import carom.text.Json;
import carom.text.JsonException;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Writes and reads the records of a fleet as JSON. */
final class FleetJson {
  private static final JsonFactory JSON = new JsonFactory();

  private FleetJson() {}

  /** Writes the fields of an object. */
  interface Body {
    void write(JsonGenerator json) throws IOException;
  }

  static String write(Body body) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = JSON.createGenerator(text)) {
      json.writeStartObject();
      body.write(json);
      json.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e); // a string takes everything
    }
    return text.toString();
  }

  static Json read(String value) throws IOException {
    try {
      Json json = Json.parseMachineMade(value.getBytes(StandardCharsets.UTF_8));
      if (json.kind == Json.Kind.OBJECT) {
        return json;
      }
    } catch (JsonException e) {
      throw new IOException("no record of a fleet: " + e.getMessage(), e);
    }
    throw new IOException("no record of a fleet: it is no object");
  }

  private static Json field(Json json, String name, Json.Kind kind) throws IOException {
    Json field = json.fields.get(name);
    if (field == null || field.kind != kind) {
      throw new IOException("no record of a fleet: " + name + " is missing, or not " + kind.words);
    }
    return field;
  }

  static String text(Json json, String name) throws IOException {
    return field(json, name, Json.Kind.STRING).text;
  }

  static boolean flag(Json json, String name) throws IOException {
    return field(json, name, Json.Kind.BOOLEAN).truth;
  }

  static int whole(Json json, String name) throws IOException {
    return (int) number(json, name);
  }

  /** Returns a whole number; one of 64 bits keeps them all. */
  static long number(Json json, String name) throws IOException {
    try {
      return Long.parseLong(field(json, name, Json.Kind.NUMBER).text);
    } catch (NumberFormatException e) {
      throw new IOException("no record of a fleet: " + name + " is no whole number", e);
    }
  }
}
