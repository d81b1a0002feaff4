package carom.server.bench;

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
 * One line of results. Times are CPU times of the stepping thread.
 *
 * @param scene what was stepped
 * @param engine by which engine
 * @param kernels {@code vector} or {@code scalar} for Carom, else empty
 * @param bodies dynamic bodies, or boxes
 * @param joints number of joints
 * @param steps how many were timed
 * @param medianMs time of a step, ms
 * @param p99Ms 99 of 100 steps took no longer, ms
 * @param allocatedBytesPerStep garbage of the stepping thread
 * @param hash of the last state; equal hashes mean equal bits
 * @param kineticEnergy of the last state, J
 * @param maxPenetration deepest overlap in the last state, m
 * @param deepPairs overlaps deeper than 2 cm
 * @param jointGap worst distance between the anchors of a hinge, m
 * @param fault why the run doesn't count, or empty
 */
record BenchRow(
    String scene,
    String engine,
    String kernels,
    int bodies,
    int joints,
    int steps,
    double medianMs,
    double p99Ms,
    double allocatedBytesPerStep,
    String hash,
    double kineticEnergy,
    double maxPenetration,
    int deepPairs,
    double jointGap,
    String fault) {
  private static final JsonFactory JSON = new JsonFactory();

  /** A run that gave no figures. */
  static BenchRow failed(String scene, String engine, String kernels, String fault) {
    return new BenchRow(
        scene, engine, kernels, 0, 0, 0, Double.NaN, Double.NaN, 0, "", 0, 0, 0, 0, fault);
  }

  /** Whether there are figures at all, good or bad. */
  boolean isMeasured() {
    return steps > 0;
  }

  /** Engine and kernels, as tables have it. */
  String who() {
    return kernels.isEmpty() ? engine : engine + " " + kernels;
  }

  /** One object in one line; what wasn't measured is null. */
  String toJson() {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = JSON.createGenerator(text)) {
      out.writeStartObject();
      out.writeStringField("scene", scene);
      out.writeStringField("engine", engine);
      out.writeStringField("kernels", kernels);
      out.writeNumberField("bodies", bodies);
      out.writeNumberField("joints", joints);
      out.writeNumberField("steps", steps);
      number(out, "medianMs", medianMs);
      number(out, "p99Ms", p99Ms);
      number(out, "allocatedBytesPerStep", allocatedBytesPerStep);
      out.writeStringField("hash", hash);
      number(out, "kineticEnergy", kineticEnergy);
      number(out, "maxPenetration", maxPenetration);
      out.writeNumberField("deepPairs", deepPairs);
      number(out, "jointGap", jointGap);
      out.writeStringField("fault", fault);
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
  static BenchRow ofJson(String json) throws IOException {
    Map<String, String> fields = new LinkedHashMap<>();
    try (JsonParser in = JSON.createParser(json)) {
      in.nextToken();
      while (in.nextToken() == JsonToken.FIELD_NAME) {
        String name = in.currentName();
        in.nextToken();
        fields.put(name, in.getText());
      }
    }
    try {
      return new BenchRow(
          text(fields, "scene"),
          text(fields, "engine"),
          text(fields, "kernels"),
          Integer.parseInt(text(fields, "bodies")),
          Integer.parseInt(text(fields, "joints")),
          Integer.parseInt(text(fields, "steps")),
          number(fields, "medianMs"),
          number(fields, "p99Ms"),
          number(fields, "allocatedBytesPerStep"),
          text(fields, "hash"),
          number(fields, "kineticEnergy"),
          number(fields, "maxPenetration"),
          Integer.parseInt(text(fields, "deepPairs")),
          number(fields, "jointGap"),
          text(fields, "fault"));
    } catch (NumberFormatException e) {
      throw new IOException("not a row: " + json, e);
    }
  }

  private static String text(Map<String, String> fields, String name) throws IOException {
    String value = fields.get(name);
    if (value == null) {
      throw new IOException("row without field=" + name);
    }
    return value;
  }

  private static double number(Map<String, String> fields, String name) throws IOException {
    String value = text(fields, name);
    return value.equals("null") ? Double.NaN : Double.parseDouble(value);
  }
}
