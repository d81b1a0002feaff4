package carom.lab.figures;

import carom.lab.measure.JsonLine;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;

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
  /** What counts as reached. */
  enum Goal {
    /** The value, or less. */
    AT_MOST,
    /** The value, or more. */
    AT_LEAST,
    /** Nothing: the value is there to compare with. */
    NONE
  }

  /** Returns a figure that must not be larger. */
  static Figure atMost(double reach, String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.AT_MOST, reach, "");
  }

  /** Returns a figure that must not be smaller. */
  static Figure atLeast(double reach, String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.AT_LEAST, reach, "");
  }

  /** Returns a figure to compare others with. */
  static Figure shown(String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.NONE, Double.NaN, "");
  }

  /** Returns a job that came to nothing: counts as missed. */
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

  /** Returns whether the limit is kept; true where there is none. */
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

  /** Returns the limit for people. */
  String limit() {
    return switch (goal) {
      case AT_MOST -> "<= " + number(reach);
      case AT_LEAST -> ">= " + number(reach);
      case NONE -> "";
    };
  }

  /** Returns a number with three digits that mean something. */
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
    return new JsonLine.Writer()
        .text("job", job)
        .text("what", what)
        .number("value", value)
        .text("unit", unit)
        .text("goal", goal.name())
        .number("reach", reach)
        .truth("reached", reached())
        .text("note", note)
        .end();
  }

  /**
   * Returns what {@link #toJson} wrote.
   *
   * @throws IOException if it is something else
   */
  static Figure ofJson(String json) throws IOException {
    JsonLine line = JsonLine.read(json);
    String goal = line.text("goal");
    if (Arrays.stream(Goal.values()).noneMatch(known -> known.name().equals(goal))) {
      throw new IOException("goal=" + goal + " is unknown");
    }
    return new Figure(
        line.text("job"),
        line.text("what"),
        line.number("value"),
        line.text("unit"),
        Goal.valueOf(goal),
        line.number("reach"),
        line.text("note"));
  }
}
