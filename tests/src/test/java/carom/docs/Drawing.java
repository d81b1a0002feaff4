package carom.docs;

import carom.physics.geometry.Convex;
import carom.physics.math.Transform;
import java.util.Locale;

/**
 * A drawing as SVG: a light card, readable on white and on dark pages. Places are in metres of the
 * present {@linkplain #view view}, y up; texts and strokes are in pixels.
 */
final class Drawing {
  static final String INK = "#1f2933";
  static final String FAINT = "#8a97a6";
  static final String BLUE = "#2b6cb0";
  static final String ORANGE = "#c05621";
  static final String RED = "#c53030";
  static final String GREEN = "#2f855a";
  static final String NOTHING = "none";

  private static final double ARROW = 7;

  private final StringBuilder svg = new StringBuilder();
  private double originX;
  private double originY;
  private double scale = 1;

  /** Begins a card of some pixels; the title is for those who can't see it. */
  Drawing(int width, int height, String title) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1$d\" height=\"%2$d\""
                + " viewBox=\"0 0 %1$d %2$d\" font-family=\"Helvetica, Arial, sans-serif\""
                + " font-size=\"13\" fill=\"none\" stroke-linecap=\"round\""
                + " stroke-linejoin=\"round\">%n<title>%3$s</title>%n"
                + "<rect x=\"0.5\" y=\"0.5\" width=\"%4$d\" height=\"%5$d\" rx=\"8\""
                + " fill=\"#fbfcfd\" stroke=\"#cbd5e0\"/>%n",
            width,
            height,
            title,
            width - 1,
            height - 1));
  }

  /** Draws from now on in metres around a place. */
  void view(double pixelX, double pixelY, double pixelsPerMetre) {
    originX = pixelX;
    originY = pixelY;
    scale = pixelsPerMetre;
  }

  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.1f", value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  private String x(double metres) {
    return number(originX + metres * scale);
  }

  private String y(double metres) {
    return number(originY - metres * scale);
  }

  private void add(String element) {
    svg.append(element).append("/>\n");
  }

  private static String look(String stroke, double width, String fill) {
    return " stroke=\""
        + stroke
        + "\" stroke-width=\""
        + number(width)
        + "\""
        + (fill.equals(NOTHING) ? "" : " fill=\"" + fill + "\" fill-opacity=\"0.18\"");
  }

  /** A line through points, closed if it is filled. */
  void path(String stroke, double width, String fill, double... xy) {
    StringBuilder d = new StringBuilder();
    for (int i = 0; i < xy.length; i += 2) {
      d.append(i == 0 ? "M" : "L").append(x(xy[i])).append(' ').append(y(xy[i + 1]));
    }
    add("<path d=\"" + d + (fill.equals(NOTHING) ? "" : "Z") + "\"" + look(stroke, width, fill));
  }

  /** A dashed line. */
  void dashes(String stroke, double x0, double y0, double x1, double y1) {
    add(
        String.format(
            "<path d=\"M%s %sL%s %s\" stroke-dasharray=\"4 4\"%s",
            x(x0), y(y0), x(x1), y(y1), look(stroke, 1, NOTHING)));
  }

  void circle(String stroke, double width, String fill, double cx, double cy, double radius) {
    add(
        String.format(
            "<circle cx=\"%s\" cy=\"%s\" r=\"%s\"%s",
            x(cx), y(cy), number(radius * scale), look(stroke, width, fill)));
  }

  /** A small disc of some pixels, filled. */
  void dot(String colour, double cx, double cy, double pixels) {
    add(
        String.format(
            "<circle cx=\"%s\" cy=\"%s\" r=\"%s\" fill=\"%s\"",
            x(cx), y(cy), number(pixels), colour));
  }

  /** An arc, counter-clockwise, with an arrow at its end if asked. */
  void arc(
      String stroke, double cx, double cy, double radius, double from, double to, boolean arrow) {
    int steps = Math.max(2, (int) Math.ceil(Math.abs(to - from) / 0.2));
    double[] xy = new double[2 * steps + 2];
    for (int i = 0; i <= steps; i++) {
      double a = from + (to - from) * i / steps;
      xy[2 * i] = cx + radius * StrictMath.cos(a);
      xy[2 * i + 1] = cy + radius * StrictMath.sin(a);
    }
    path(stroke, 1.5, NOTHING, xy);
    if (arrow) {
      int end = 2 * steps;
      head(stroke, xy[end - 2], xy[end - 1], xy[end], xy[end + 1]);
    }
  }

  void arrow(String stroke, double x0, double y0, double x1, double y1) {
    path(stroke, 2, NOTHING, x0, y0, x1, y1);
    head(stroke, x0, y0, x1, y1);
  }

  private void head(String colour, double x0, double y0, double x1, double y1) {
    double length = StrictMath.hypot(x1 - x0, y1 - y0);
    double ux = (x1 - x0) / length * ARROW / scale;
    double uy = (y1 - y0) / length * ARROW / scale;
    add(
        String.format(
            "<path d=\"M%s %sL%s %sL%s %sZ\" fill=\"%s\" stroke=\"%s\"",
            x(x1),
            y(y1),
            x(x1 - ux - uy / 2),
            y(y1 - uy + ux / 2),
            x(x1 - ux + uy / 2),
            y(y1 - uy - ux / 2),
            colour,
            colour));
  }

  /** A convex shape of the engine in a pose; round ones as what they are. */
  void shape(String colour, Convex shape, Transform pose) {
    int n = shape.vertexCount();
    double[] xy = new double[2 * n];
    for (int i = 0; i < n; i++) {
      xy[2 * i] = pose.x + pose.cos * shape.vertexX(i) - pose.sin * shape.vertexY(i);
      xy[2 * i + 1] = pose.y + pose.sin * shape.vertexX(i) + pose.cos * shape.vertexY(i);
    }
    if (shape.radius() == 0) {
      path(colour, 1.5, colour, xy);
    } else if (n == 1) {
      circle(colour, 1.5, colour, xy[0], xy[1], shape.radius());
    } else {
      rounded(colour, xy, shape.radius());
    }
  }

  /** The outline at a distance around corners that go counter-clockwise. */
  private void rounded(String colour, double[] xy, double radius) {
    int n = xy.length / 2;
    StringBuilder d = new StringBuilder();
    String r = number(radius * scale);
    for (int i = 0; i < n; i++) {
      int j = (i + 1) % n;
      double dx = xy[2 * j] - xy[2 * i];
      double dy = xy[2 * j + 1] - xy[2 * i + 1];
      double length = StrictMath.hypot(dx, dy);
      double nx = dy / length * radius;
      double ny = -dx / length * radius;
      String from = x(xy[2 * i] + nx) + ' ' + y(xy[2 * i + 1] + ny);
      d.append(i == 0 ? "M" : "A" + r + ' ' + r + " 0 0 0 ").append(from);
      d.append('L').append(x(xy[2 * j] + nx)).append(' ').append(y(xy[2 * j + 1] + ny));
      if (i == n - 1) {
        double firstX = xy[2] - xy[0];
        double firstY = xy[3] - xy[1];
        double first = StrictMath.hypot(firstX, firstY);
        d.append('A').append(r).append(' ').append(r).append(" 0 0 0 ");
        d.append(x(xy[0] + firstY / first * radius)).append(' ');
        d.append(y(xy[1] - firstX / first * radius)).append('Z');
      }
    }
    add("<path d=\"" + d + "\"" + look(colour, 1.5, colour));
    path(FAINT, 1, NOTHING, xy);
    if (n > 2) {
      path(FAINT, 1, NOTHING, xy[2 * n - 2], xy[2 * n - 1], xy[0], xy[1]);
    }
  }

  /** Ground: a line with strokes below it. */
  void ground(double x0, double x1, double y) {
    path(INK, 1.5, NOTHING, x0, y, x1, y);
    double step = 10 / scale;
    for (double at = x0 + step; at <= x1 + 1e-6; at += step) {
      path(FAINT, 1, NOTHING, at, y, at - step * 0.7, y - step * 0.7);
    }
  }

  /** A spring between two points. */
  void spring(String stroke, double x0, double y0, double x1, double y1) {
    int turns = 6;
    double dx = x1 - x0;
    double dy = y1 - y0;
    double length = StrictMath.hypot(dx, dy);
    double sideX = -dy / length * 5 / scale;
    double sideY = dx / length * 5 / scale;
    double[] xy = new double[4 * turns + 8];
    int at = 0;
    xy[at++] = x0;
    xy[at++] = y0;
    for (int i = 0; i <= 2 * turns; i++) {
      double t = 0.15 + 0.7 * i / (2 * turns);
      double side = i == 0 || i == 2 * turns ? 0 : i % 2 == 0 ? 1 : -1;
      xy[at++] = x0 + dx * t + sideX * side;
      xy[at++] = y0 + dy * t + sideY * side;
    }
    xy[at++] = x1;
    xy[at++] = y1;
    path(stroke, 1.5, NOTHING, java.util.Arrays.copyOf(xy, at));
  }

  /** Text at a place, its anchor start, middle or end. */
  void text(String colour, String anchor, double atX, double atY, String words) {
    text(colour, anchor, atX, atY, "", words);
  }

  void bold(String anchor, double atX, double atY, String words) {
    text(INK, anchor, atX, atY, " font-weight=\"bold\"", words);
  }

  void small(String anchor, double atX, double atY, String words) {
    text("#52606d", anchor, atX, atY, " font-size=\"11\"", words);
  }

  private void text(
      String colour, String anchor, double atX, double atY, String more, String words) {
    svg.append(
        String.format(
            "<text x=\"%s\" y=\"%s\" fill=\"%s\" text-anchor=\"%s\"%s>%s</text>%n",
            x(atX),
            y(atY),
            colour,
            anchor,
            more,
            words.replace("&", "&amp;").replace("<", "&lt;")));
  }

  /** The file's text. */
  String svg() {
    return svg + "</svg>\n";
  }
}
