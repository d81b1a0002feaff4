package carom.server.bench;

import carom.sim.scene.SceneReport;
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
 * One line of results.
 *
 * @param scene name of the job
 * @param entrant who did it
 * @param bodies dynamic bodies and particles, or boxes
 * @param joints number of joints
 * @param awake bodies that are awake at the end
 * @param times what a step cost
 * @param hash of the last state, 16 hexadecimal digits; equal hashes mean equal bits
 * @param kineticEnergy of the last state, J; this and what follows is NaN where it has no meaning
 * @param maxPenetration deepest overlap in the last state, m
 * @param deepPairs overlaps deeper than 2 cm
 * @param jointGap worst distance between the anchors of a hinge, m
 * @param stages ms per step by name of the stage, empty if nobody looked
 * @param ratios of other engines' times to this one, by who they are; above 1 this one is faster.
 *     Only Carom's rows have them
 * @param fault why the run doesn't count, or empty
 */
record BenchRow(
    String scene,
    Entrant entrant,
    int bodies,
    int joints,
    int awake,
    Times times,
    String hash,
    double kineticEnergy,
    double maxPenetration,
    double deepPairs,
    double jointGap,
    Map<String, Double> stages,
    Map<String, Double> ratios,
    String fault) {
  private static final JsonFactory JSON = new JsonFactory();

  /** A row about so many bodies without a world to look at. */
  static BenchRow of(String scene, Entrant entrant, int bodies, Times times) {
    return new BenchRow(
        scene,
        entrant,
        bodies,
        0,
        0,
        times,
        "",
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Map.of(),
        Map.of(),
        "");
  }

  /** A run that gave no figures. */
  static BenchRow failed(String scene, Entrant entrant, String fault) {
    return of(scene, entrant, 0, Times.NONE).withFault(fault);
  }

  /** The same with what the end state looks like. */
  BenchRow withEnd(int jointCount, int awakeCount, SceneReport end) {
    return new BenchRow(
        scene,
        entrant,
        bodies,
        jointCount,
        awakeCount,
        times,
        hash,
        end.kineticEnergy(),
        end.maxDepth(),
        end.deepOverlaps(),
        end.worstJointGap(),
        stages,
        ratios,
        fault);
  }

  BenchRow withHash(long newHash) {
    return with("%016x".formatted(newHash), stages, ratios, fault);
  }

  BenchRow withStages(Map<String, Double> newStages) {
    return with(hash, newStages, ratios, fault);
  }

  BenchRow withRatios(Map<String, Double> newRatios) {
    return with(hash, stages, newRatios, fault);
  }

  BenchRow withFault(String newFault) {
    return with(hash, stages, ratios, newFault);
  }

  private BenchRow with(
      String newHash,
      Map<String, Double> newStages,
      Map<String, Double> newRatios,
      String newFault) {
    return new BenchRow(
        scene,
        entrant,
        bodies,
        joints,
        awake,
        times,
        newHash,
        kineticEnergy,
        maxPenetration,
        deepPairs,
        jointGap,
        newStages,
        newRatios,
        newFault);
  }

  /** Whether there are figures at all, good or bad. */
  boolean isMeasured() {
    return times.steps() > 0;
  }

  /** Whether its figures are results. */
  boolean counts() {
    return isMeasured() && fault.isEmpty();
  }

  double medianMs() {
    return times.medianMs();
  }

  /** One object in one line; what wasn't measured is null. */
  String toJson() {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = JSON.createGenerator(text)) {
      out.writeStartObject();
      out.writeStringField("scene", scene);
      out.writeStringField("engine", entrant.engine());
      out.writeStringField("kernels", entrant.kernels());
      out.writeNumberField("threads", entrant.threads());
      out.writeNumberField("bodies", bodies);
      out.writeNumberField("joints", joints);
      out.writeNumberField("awake", awake);
      out.writeNumberField("steps", times.steps());
      number(out, "medianMs", times.medianMs());
      number(out, "p99Ms", times.p99Ms());
      number(out, "wallMs", times.wallMs());
      number(out, "allocatedBytesPerStep", times.allocatedBytes());
      out.writeStringField("hash", hash);
      number(out, "kineticEnergy", kineticEnergy);
      number(out, "maxPenetration", maxPenetration);
      if (Double.isNaN(deepPairs)) {
        out.writeNullField("deepPairs");
      } else {
        out.writeNumberField("deepPairs", (int) deepPairs);
      }
      number(out, "jointGap", jointGap);
      numbers(out, "stages", stages);
      numbers(out, "ratios", ratios);
      out.writeBooleanField("valid", counts());
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

  private static void numbers(JsonGenerator out, String name, Map<String, Double> values)
      throws IOException {
    out.writeObjectFieldStart(name);
    for (Map.Entry<String, Double> value : values.entrySet()) {
      number(out, value.getKey(), value.getValue());
    }
    out.writeEndObject();
  }

  /**
   * What {@link #toJson} wrote.
   *
   * @throws IOException if it is something else
   */
  static BenchRow ofJson(String json) throws IOException {
    Map<String, String> fields = new LinkedHashMap<>();
    Map<String, Map<String, Double>> maps = new LinkedHashMap<>();
    try (JsonParser in = JSON.createParser(json)) {
      in.nextToken();
      while (in.nextToken() == JsonToken.FIELD_NAME) {
        String name = in.currentName();
        if (in.nextToken() != JsonToken.START_OBJECT) {
          fields.put(name, in.getText());
          continue;
        }
        Map<String, Double> values = new LinkedHashMap<>();
        while (in.nextToken() == JsonToken.FIELD_NAME) {
          in.nextToken();
          values.put(in.currentName(), in.getDoubleValue());
        }
        maps.put(name, values);
      }
    }
    try {
      return new BenchRow(
          text(fields, "scene"),
          new Entrant(
              text(fields, "engine"),
              text(fields, "kernels"),
              Integer.parseInt(text(fields, "threads"))),
          Integer.parseInt(text(fields, "bodies")),
          Integer.parseInt(text(fields, "joints")),
          Integer.parseInt(text(fields, "awake")),
          new Times(
              Integer.parseInt(text(fields, "steps")),
              number(fields, "medianMs"),
              number(fields, "p99Ms"),
              number(fields, "wallMs"),
              number(fields, "allocatedBytesPerStep")),
          text(fields, "hash"),
          number(fields, "kineticEnergy"),
          number(fields, "maxPenetration"),
          number(fields, "deepPairs"),
          number(fields, "jointGap"),
          maps.getOrDefault("stages", Map.of()),
          maps.getOrDefault("ratios", Map.of()),
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
