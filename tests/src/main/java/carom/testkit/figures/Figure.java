package carom.testkit.figures;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * One line of the table.
 *
 * @param job that measured it
 * @param what was measured
 * @param value what came out; NaN if nothing did
 * @param unit of value and reach
 * @param goal how the two compare
 * @param reach the limit; NaN where there is none
 * @param note what else must be known, or empty
 */
record Figure(
    String job, String what, double value, String unit, Goal goal, double reach, String note) {
  private static final JsonFactory JSON = new JsonFactory();

  /** What counts as reached. */
  enum Goal {
    /** The value, or less. */
    AT_MOST,
    /** The value, or more. */
    AT_LEAST,
    /** Nothing: the value is there to compare with. */
    NONE
  }

  /** A figure that must not be larger. */
  static Figure atMost(double reach, String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.AT_MOST, reach, "");
  }

  /** A figure that must not be smaller. */
  static Figure atLeast(double reach, String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.AT_LEAST, reach, "");
  }

  /** A figure to compare others with. */
  static Figure shown(String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.NONE, Double.NaN, "");
  }

  /** A job that came to nothing: counts as missed. */
  static Figure failed(String job, String why) {
    return new Figure(job, job, Double.NaN, "", Goal.AT_LEAST, Double.NaN, why);
  }

  Figure withNote(String format, Object... arguments) {
    return new Figure(
        job, what, value, unit, goal, reach, String.format(Locale.ROOT, format, arguments));
  }

  Figure of(String newJob) {
    return new Figure(newJob, what, value, unit, goal, reach, note);
  }

  /** Whether the limit is kept; true where there is none. */
  boolean reached() {
    return switch (goal) {
      case AT_MOST -> value <= reach;
      case AT_LEAST -> value >= reach;
      case NONE -> true;
    };
  }

  /** "reached", "missed", or nothing. */
  String verdict() {
    return goal == Goal.NONE ? "" : reached() ? "reached" : "missed";
  }

  /** The limit for people. */
  String limit() {
    return switch (goal) {
      case AT_MOST -> "<= " + number(reach);
      case AT_LEAST -> ">= " + number(reach);
      case NONE -> "";
    };
  }

  /** A number with three digits that mean something. */
  static String number(double value) {
    if (!Double.isFinite(value)) {
      return "";
    }
    if (value == Math.rint(value) && Math.abs(value) < 1e9) {
      return String.valueOf((long) value);
    }
    double size = Math.abs(value);
    int places = size >= 99.95 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : 3;
    return String.format(Locale.ROOT, "%." + places + "f", value);
  }

  /** One object in one line; what isn't a number is null. */
  String toJson() {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = JSON.createGenerator(text)) {
      out.writeStartObject();
      out.writeStringField("job", job);
      out.writeStringField("what", what);
      number(out, "value", value);
      out.writeStringField("unit", unit);
      out.writeStringField("goal", goal.name());
      number(out, "reach", reach);
      out.writeBooleanField("reached", reached());
      out.writeStringField("note", note);
      out.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e); // a StringWriter never fails
    }
    return text.toString();
  }

  private static void number(JsonGenerator out, String name, double value) throws IOException {
    if (Double.isFinite(value)) {
      out.writeNumberField(name, value);
    } else {
      out.writeNullField(name); // JSON has no NaN
    }
  }

  /**
   * What {@link #toJson} wrote.
   *
   * @throws IOException if it is something else
   */
  static Figure ofJson(String json) throws IOException {
    Map<String, String> fields = new HashMap<>();
    try (JsonParser in = JSON.createParser(json)) {
      in.nextToken();
      while (in.nextToken() == JsonToken.FIELD_NAME) {
        String name = in.currentName();
        in.nextToken();
        fields.put(name, in.getText());
      }
    }
    try {
      return new Figure(
          text(fields, "job"),
          text(fields, "what"),
          number(text(fields, "value")),
          text(fields, "unit"),
          Goal.valueOf(text(fields, "goal")),
          number(text(fields, "reach")),
          text(fields, "note"));
    } catch (IllegalArgumentException e) {
      throw new IOException("not a figure: " + json, e);
    }
  }

  private static String text(Map<String, String> fields, String name) throws IOException {
    String value = fields.get(name);
    if (value == null) {
      throw new IOException("figure without field=" + name);
    }
    return value;
  }

  private static double number(String text) {
    return text.equals("null") ? Double.NaN : Double.parseDouble(text);
  }
}
