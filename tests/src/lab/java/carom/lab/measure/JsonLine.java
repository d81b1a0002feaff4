package carom.lab.measure;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A result as one JSON object in one line: texts, numbers, booleans and maps of numbers. JSON has
 * no NaN, so a number that isn't finite is written as null, and null is read as NaN. Not
 * thread-safe.
 */
public final class JsonLine {
  private static final JsonFactory JSON = new JsonFactory();

  private final Map<String, String> fields = new LinkedHashMap<>();
  private final Map<String, Map<String, Double>> maps = new LinkedHashMap<>();

  private JsonLine() {}

  /** Writes a line. The fields are in the order of the calls. */
  public static final class Writer {
    private final StringWriter text = new StringWriter();
    private final JsonGenerator out;

    /** Begins an object. */
    public Writer() {
      try {
        out = JSON.createGenerator(text);
        out.writeStartObject();
      } catch (IOException e) {
        throw new UncheckedIOException(e); // a StringWriter never fails
      }
    }

    /** A call of the generator. It can't fail, because the target is a StringWriter. */
    @FunctionalInterface
    private interface Write {
      void run() throws IOException;
    }

    private Writer write(Write write) {
      try {
        write.run();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return this;
    }

    /**
     * Adds a text.
     *
     * @param name of the field
     * @param value any
     * @return this
     */
    public Writer text(String name, String value) {
      return write(() -> out.writeStringField(name, value));
    }

    /**
     * Adds a whole number.
     *
     * @param name of the field
     * @param value any
     * @return this
     */
    public Writer whole(String name, int value) {
      return write(() -> out.writeNumberField(name, value));
    }

    /**
     * Adds a number.
     *
     * @param name of the field
     * @param value null is written if it isn't finite
     * @return this
     */
    public Writer number(String name, double value) {
      return write(
          () -> {
            if (Double.isFinite(value)) {
              out.writeNumberField(name, value);
            } else {
              out.writeNullField(name);
            }
          });
    }

    /**
     * Adds a boolean.
     *
     * @param name of the field
     * @param value any
     * @return this
     */
    public Writer truth(String name, boolean value) {
      return write(() -> out.writeBooleanField(name, value));
    }

    /**
     * Adds an object of numbers.
     *
     * @param name of the field
     * @param values by the names of their fields
     * @return this
     */
    public Writer numbers(String name, Map<String, Double> values) {
      write(() -> out.writeObjectFieldStart(name));
      values.forEach(this::number);
      return write(out::writeEndObject);
    }

    /**
     * Ends the object.
     *
     * @return the line, without an end of line
     */
    public String end() {
      write(out::writeEndObject);
      write(out::close);
      return text.toString();
    }
  }

  /**
   * Parses a line that a {@link Writer} wrote.
   *
   * @param json the line
   * @return its fields
   * @throws IOException if it is no JSON
   */
  public static JsonLine read(String json) throws IOException {
    JsonLine line = new JsonLine();
    try (JsonParser in = JSON.createParser(json)) {
      in.nextToken();
      while (in.nextToken() == JsonToken.FIELD_NAME) {
        String name = in.currentName();
        if (in.nextToken() != JsonToken.START_OBJECT) {
          line.fields.put(name, in.getText());
          continue;
        }
        Map<String, Double> values = new LinkedHashMap<>();
        while (in.nextToken() == JsonToken.FIELD_NAME) {
          in.nextToken();
          values.put(in.currentName(), in.getDoubleValue());
        }
        line.maps.put(name, values);
      }
    }
    return line;
  }

  /**
   * Returns a field's text. Numbers, booleans and null are in JSON's spelling.
   *
   * @param name of the field
   * @return the text
   * @throws IOException if there is no such field
   */
  public String text(String name) throws IOException {
    String value = fields.get(name);
    if (value == null) {
      throw new IOException("result without field=" + name);
    }
    return value;
  }

  /**
   * Returns a number.
   *
   * @param name of the field
   * @return NaN for null
   * @throws IOException if there is no such field, or no number in it
   */
  public double number(String name) throws IOException {
    String value = text(name);
    try {
      return value.equals("null") ? Double.NaN : Double.parseDouble(value);
    } catch (NumberFormatException e) {
      throw new IOException(name + "=" + value + " is no number", e);
    }
  }

  /**
   * Returns a number that may be absent.
   *
   * @param name of the field
   * @return NaN for null, and if there is no such field
   * @throws IOException if there is no number in it
   */
  public double optional(String name) throws IOException {
    return fields.containsKey(name) ? number(name) : Double.NaN;
  }

  /**
   * Returns a whole number.
   *
   * @param name of the field
   * @return the number
   * @throws IOException if there is no such field, or no whole number in it
   */
  public int whole(String name) throws IOException {
    String value = text(name);
    try {
      return Integer.parseInt(value);
    } catch (NumberFormatException e) {
      throw new IOException(name + "=" + value + " is no whole number", e);
    }
  }

  /**
   * Returns an object of numbers.
   *
   * @param name of the field
   * @return by the names of their fields, in their order; empty if there is none
   */
  public Map<String, Double> numbers(String name) {
    return maps.getOrDefault(name, Map.of());
  }
}
