package carom.lab.measure;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;

/**
 * A figure: one line of the table.
 *
 * @param job name of the job that measured it
 * @param what description of the quantity
 * @param value the measured value; NaN without one
 * @param unit unit of value and reach
 * @param goal how the value must compare with the reach
 * @param reach the limit; NaN without one
 * @param note conditions and further values, or empty
 */
public record Figure(
    String job, String what, double value, String unit, Goal goal, double reach, String note) {
  /** The comparison of a value with its limit. */
  public enum Goal {
    /** The value must not be larger than the limit. */
    AT_MOST,
    /** The value must not be smaller than the limit. */
    AT_LEAST,
    /** The value has no limit; other figures are compared with it. */
    NONE
  }

  /** Returns a figure that must not be larger than a limit. */
  public static Figure atMost(double reach, String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.AT_MOST, reach, "");
  }

  /** Returns a figure that must not be smaller than a limit. */
  public static Figure atLeast(double reach, String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.AT_LEAST, reach, "");
  }

  /** Returns a figure without a limit. */
  public static Figure shown(String what, double value, String unit) {
    return new Figure("", what, value, unit, Goal.NONE, Double.NaN, "");
  }

  /** Returns the figure of a job that failed. It counts as missed. */
  public static Figure failed(String job, String why) {
    return new Figure(job, job, Double.NaN, "", Goal.AT_LEAST, Double.NaN, why);
  }

  /** Returns a copy with a note, formatted as {@link String#format} does. */
  public Figure withNote(String format, Object... arguments) {
    return new Figure(
        job, what, value, unit, goal, reach, String.format(Locale.ROOT, format, arguments));
  }

  /** Returns a copy that belongs to a job. */
  public Figure of(String newJob) {
    return new Figure(newJob, what, value, unit, goal, reach, note);
  }

  /** Returns whether the limit is kept; true where there is none. */
  public boolean reached() {
    return switch (goal) {
      case AT_MOST -> value <= reach;
      case AT_LEAST -> value >= reach;
      case NONE -> true;
    };
  }

  /** Returns "reached", "missed", or an empty text without a limit. */
  public String verdict() {
    return goal == Goal.NONE ? "" : reached() ? "reached" : "missed";
  }

  /** Returns the limit as a text for people. */
  public String limit() {
    return switch (goal) {
      case AT_MOST -> "<= " + number(reach);
      case AT_LEAST -> ">= " + number(reach);
      case NONE -> "";
    };
  }

  /** Returns a number as a text with three significant digits. */
  public static String number(double value) {
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

  /** Returns the figure as one JSON object in one line. NaN is null. */
  public String toJson() {
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
   * Returns the figure that {@link #toJson} wrote.
   *
   * @throws IOException if it is something else
   */
  public static Figure ofJson(String json) throws IOException {
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
