package carom.server.level;

import carom.options.PictureSize;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.level.LevelJoint;
import carom.sim.pool.PoolDef;
import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;

/**
 * A picture of a level as it begins, by Java2D, which needs no display. It shows the bounds, zones
 * and areas as tints, sensors as veils, spawn points as rings, joints as lines between bodies, and
 * all bodies in their colours. {@code carom render} draws games by OpenGL, with what their looks
 * add.
 */
final class LevelPicture {
  /** Part of the picture's shorter side that is left free around the level. */
  private static final double MARGIN = 0.04;

  private final Level level;
  private final BufferedImage image;
  private final Graphics2D g;
  private final double pixel; // metres

  LevelPicture(Level level, PictureSize size) {
    this.level = level;
    image = new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
    g = image.createGraphics();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    sky(size);
    Level.Bounds b = level.bounds();
    double free = MARGIN * Math.min(size.width(), size.height());
    double scale =
        Math.min(
            (size.width() - 2 * free) / (b.maxX() - b.minX()),
            (size.height() - 2 * free) / (b.maxY() - b.minY()));
    pixel = 1 / scale;
    g.translate(size.width() / 2.0, size.height() / 2.0);
    g.scale(scale, -scale);
    g.translate(-(b.minX() + b.maxX()) / 2.0, -(b.minY() + b.maxY()) / 2.0);
    grid();
    tints();
    bodies();
    joints();
    marks();
    g.dispose();
  }

  /** Writes the picture as PNG. */
  void save(Path file) throws IOException {
    if (!ImageIO.write(image, "png", file.toFile())) {
      throw new IOException("this JDK can't write PNG");
    }
  }

  private void sky(PictureSize size) {
    Level.Theme theme = level.theme();
    g.setPaint(
        new GradientPaint(
            0, 0, new Color(theme.sky()), 0, size.height(), new Color(theme.background())));
    g.fillRect(0, 0, size.width(), size.height());
  }

  private void grid() {
    Level.Bounds b = level.bounds();
    double step = 1;
    while (step < 12 * pixel) {
      step *= 5;
    }
    line(new Color(level.theme().grid()), 1);
    for (double x = Math.ceil(b.minX() / step) * step; x <= b.maxX(); x += step) {
      g.draw(new Line2D.Double(x, b.minY(), x, b.maxY()));
    }
    for (double y = Math.ceil(b.minY() / step) * step; y <= b.maxY(); y += step) {
      g.draw(new Line2D.Double(b.minX(), y, b.maxX(), y));
    }
    line(new Color(level.theme().accent()).darker(), 1);
    g.draw(box(b.minX(), b.minY(), b.maxX(), b.maxY()));
  }

  private void tints() {
    for (Level.Zone zone : level.zones()) {
      int rgb = zone.rgb() < 0 ? level.theme().accent() : zone.rgb();
      veil(rgb, box(zone.minX(), zone.minY(), zone.maxX(), zone.maxY()));
    }
    for (Area area : level.areas()) {
      int rgb = area.rgb() < 0 ? 0x4da3ff : area.rgb();
      veil(
          rgb,
          area.kind() == Area.Kind.ATTRACTOR
              ? circle(area.x(), area.y(), area.range())
              : box(area.minX(), area.minY(), area.maxX(), area.maxY()));
    }
    for (PoolDef pool : level.pools()) {
      for (PoolDef.Rectangle fill : pool.fills()) {
        veil(pool.rgb(), box(fill.minX(), fill.minY(), fill.maxX(), fill.maxY()));
      }
    }
  }

  private void veil(int rgb, java.awt.Shape shape) {
    g.setComposite(AlphaComposite.SrcOver.derive(0.25f));
    g.setColor(new Color(rgb));
    g.fill(shape);
    g.setComposite(AlphaComposite.SrcOver.derive(0.7f));
    line(new Color(rgb), 1);
    g.draw(shape);
    g.setComposite(AlphaComposite.SrcOver);
  }

  private void bodies() {
    Archetypes archetypes = new Archetypes();
    List<Archetype> all = new ArrayList<>();
    level.archetypes().forEach(def -> all.add(archetypes.add(def)));
    for (List<Level.Placement> bodies : List.of(level.statics(), level.bodies())) {
      for (Level.Placement placed : bodies) {
        AffineTransform before = g.getTransform();
        g.translate(placed.x(), placed.y());
        g.rotate(placed.angle());
        body(all.get(placed.archetype()));
        g.setTransform(before);
      }
    }
  }

  private void body(Archetype archetype) {
    Color fill = new Color(archetype.appearance().rgb());
    Color edge = new Color(archetype.appearance().outlineRgb());
    for (Shape shape : archetype.shapes()) {
      for (Convex part : shape.parts()) {
        java.awt.Shape outline = outline(part);
        if (archetype.sensor()) {
          veil(archetype.appearance().rgb(), outline);
        } else if (part instanceof Segment) {
          line(fill, 3);
          g.draw(outline);
        } else {
          g.setColor(fill);
          g.fill(outline);
          line(edge, 1.5);
          g.draw(outline);
        }
      }
    }
  }

  private static java.awt.Shape outline(Convex part) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < part.vertexCount(); i++) {
      if (i == 0) {
        path.moveTo(part.vertexX(i), part.vertexY(i));
      } else {
        path.lineTo(part.vertexX(i), part.vertexY(i));
      }
    }
    double radius = part.radius();
    if (part instanceof Segment) {
      return path;
    }
    if (part.vertexCount() == 1) {
      return circle(part.vertexX(0), part.vertexY(0), radius);
    }
    if (radius > 0) { // a capsule
      return new BasicStroke((float) (2 * radius), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
          .createStrokedShape(path);
    }
    path.closePath();
    return path;
  }

  private void joints() {
    line(new Color(level.theme().accent()), 1.5);
    for (LevelJoint joint : level.joints()) {
      Level.Placement b = placed(joint.b());
      Level.Placement a = joint.a() == LevelJoint.GROUND ? b : placed(joint.a());
      g.draw(new Line2D.Double(a.x(), a.y(), b.x(), b.y()));
      g.draw(circle(b.x(), b.y(), 3 * pixel));
    }
  }

  private Level.Placement placed(int body) {
    return body < 0 ? level.statics().get(~body) : level.bodies().get(body);
  }

  private void marks() {
    for (Level.Spawn spawn : level.spawns()) {
      line(new Color(level.theme().accent()), 2);
      g.draw(circle(spawn.x(), spawn.y(), 6 * pixel));
      g.draw(circle(spawn.x(), spawn.y(), pixel));
    }
  }

  private void line(Color color, double width) {
    g.setColor(color);
    g.setStroke(
        new BasicStroke((float) (width * pixel), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
  }

  private static java.awt.Shape circle(double x, double y, double radius) {
    return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
  }

  private static java.awt.Shape box(double minX, double minY, double maxX, double maxY) {
    return new Rectangle2D.Double(minX, minY, maxX - minX, maxY - minY);
  }
}
