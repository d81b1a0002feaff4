package carom.physics.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.math.Trig;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

final class ShapeTest {
  @Test
  void aBoxBySizesIsTheBoxOfHalfSizes() {
    assertEquals(new Box(0.55f, 0.4f).toString(), Box.of(1.1f, 0.8f).toString());
    assertEquals(0.88f, Box.of(1.1f, 0.8f).area(), 1e-6f);
  }

  @Test
  void massesFollowTheClosedForms() {
    assertMass(new Circle(2, 3, 4).mass(5), 5 * Math.PI * 4, 3, 4, 5 * Math.PI * 4 * 2);
    assertMass(new Box(1.5f, 0.5f, 1, 2).mass(2), 6, 1, 2, 6 * (9 + 1) / 12.0);
    assertMass(Polygon.of(0, 0, 3, 0, 3, 1, 0, 1).mass(2), 6, 1.5, 0.5, 6 * (9 + 1) / 12.0);
    // Right triangle with legs b, h: I = m (b^2 + h^2) / 18.
    assertMass(Polygon.of(0, 0, 3, 0, 0, 6).mass(1), 9, 1, 2, 9 * 45 / 18.0);
    // Regular n-gon of circumradius R: I = m R^2 / 2 (1 - 2/3 sin^2(pi/n)).
    double area = 0.5 * 6 * 4 * Math.sin(Math.PI / 3);
    assertMass(Polygon.regular(6, 2).mass(1), area, 0, 0, area * 2 * (1 - 2.0 / 3 * 0.25));
    assertMass(
        Compound.of(new Box(1, 1, -1, 0), new Box(1, 1, 1, 0)).mass(1), 8, 0, 0, 8 * 20 / 12.0);
    assertMass(new Box(1, 1, 7, 8).mass(0), 0, 7, 8, 0);
    assertMass(Compound.of(new Box(1, 1, 7, 8)).mass(0), 0, 7, 8, 0);
  }

  private static void assertMass(MassData m, double mass, double x, double y, double inertia) {
    assertEquals(mass, m.mass(), 1e-5 * mass + 1e-9);
    assertEquals(x, m.centerX(), 1e-5);
    assertEquals(y, m.centerY(), 1e-5);
    assertEquals(inertia, m.inertia(), 1e-5 * inertia + 1e-9);
  }

  @Test
  void massesOfRandomHullsAgreeWithNumericalIntegration() {
    for (long seed = 1; seed <= 12; seed++) {
      Polygon p = randomHull(new SplittableRandom(seed));
      double mass = 0;
      double mx = 0;
      double my = 0;
      double second = 0;
      double h = 0.005;
      for (double x = -1 + h / 2; x < 1; x += h) {
        for (double y = -1 + h / 2; y < 1; y += h) {
          if (p.containsPoint((float) x, (float) y)) {
            mass += h * h;
            mx += x * h * h;
            my += y * h * h;
            second += (x * x + y * y) * h * h;
          }
        }
      }
      MassData m = p.mass(1);
      String message = "seed=" + seed;
      assertEquals(mass, m.mass(), 0.01 * mass, message);
      assertEquals(mx / mass, m.centerX(), 0.005, message);
      assertEquals(my / mass, m.centerY(), 0.005, message);
      assertEquals(second - (mx * mx + my * my) / mass, m.inertia(), 0.02 * m.inertia(), message);
      assertEquals(m.mass(), p.area(), 1e-6, message);
    }
  }

  @Test
  void hullsAreConvexCounterClockwiseAndHoldTheirPoints() {
    for (long seed = 1; seed <= 200; seed++) {
      Polygon p = randomHull(new SplittableRandom(seed));
      for (int i = 0; i < p.vertexCount(); i++) {
        int k = (i + 1) % p.vertexCount();
        float ex = p.vertexX(k) - p.vertexX(i);
        float ey = p.vertexY(k) - p.vertexY(i);
        String message = "seed=" + seed + " edge=" + i;
        assertEquals(1, Math.hypot(p.normalX(i), p.normalY(i)), 1e-6, message);
        assertEquals(0, ex * p.normalX(i) + ey * p.normalY(i), 1e-6, message);
        assertTrue(ex * p.normalY(i) - ey * p.normalX(i) < 0, message);
        for (int j = 0; j < p.vertexCount(); j++) {
          float d =
              p.normalX(i) * (p.vertexX(j) - p.vertexX(i))
                  + p.normalY(i) * (p.vertexY(j) - p.vertexY(i));
          assertTrue(d <= 1e-6, message + " vertex=" + j + " d=" + d);
        }
      }
    }
  }

  @Test
  void roundedMassesFollowTheClosedFormsAndNumericalIntegration() {
    // A capsule along x: rectangle L x 2r and two half discs, whose centroids are 4 r / (3 pi) out.
    double l = 3;
    double r = 0.5;
    double rectangle = l * 2 * r;
    double discs = Math.PI * r * r;
    double caps = r * r / 2 + l * l / 4 + l * 4 * r / (3 * Math.PI);
    double inertia = rectangle * (l * l + 4 * r * r) / 12 + discs * caps;
    assertMass(new Capsule(1, 2, 4, 2, 0.5f).mass(2), 2 * (rectangle + discs), 2.5, 2, 2 * inertia);
    assertEquals(rectangle + discs, new Capsule(0, 0, 0, 3, 0.5f).area(), 1e-5);
    assertEquals(2, Capsule.upright(2, 0.3f).length() + 0.6f, 1e-6);
    assertMass(new Segment(1, 2, 3, 6).mass(5), 0, 2, 4, 0);
    assertMass(Chain.open(0, 0, 2, 0, 4, 3).mass(5), 0, 2, 1, 0);
    assertMass(Compound.of(new Segment(0, 0, 2, 0), new Segment(4, 0, 6, 0)).mass(1), 0, 3, 0, 0);
    Polygon p = Polygon.rounded(0.3f, 0, 0, 1, 0, 0.2f, 0.6f);
    double h = 0.004;
    double mass = 0;
    double mx = 0;
    double my = 0;
    double second = 0;
    for (double x = -0.4; x < 1.4; x += h) {
      for (double y = -0.4; y < 1; y += h) {
        if (p.containsPoint((float) x, (float) y)) {
          mass += h * h;
          mx += x * h * h;
          my += y * h * h;
          second += (x * x + y * y) * h * h;
        }
      }
    }
    MassData m = p.mass(1);
    assertEquals(mass, m.mass(), 0.002 * mass);
    assertEquals(p.area(), m.mass(), 1e-6);
    assertEquals(mx / mass, m.centerX(), 0.002);
    assertEquals(my / mass, m.centerY(), 0.002);
    assertEquals(second - (mx * mx + my * my) / mass, m.inertia(), 0.005 * m.inertia());
    assertEquals("0.3 true", p.moved(3, 4).radius() + " " + p.moved(3, 4).containsPoint(3, 3.75f));
  }

  @Test
  void chainsHaveTheirFrontOnTheLeftAndKnowTheirNeighbours() {
    Chain ground = Chain.open(0, 0, 1, 0, 2, 1);
    Segment first = (Segment) ground.parts().get(0);
    assertEquals("0.0 1.0", first.normalX(0) + " " + first.normalY(0), "up");
    assertTrue(first.isOneSided() && first.isLinked(0) && !first.isLinked(1));
    assertEquals("2.0 1.0", first.ghostX(0) + " " + first.ghostY(0));
    Segment moved = (Segment) ground.moved(5, 6).parts().get(0);
    assertEquals("7.0 7.0", moved.ghostX(0) + " " + moved.ghostY(0));
    Chain arena = Chain.loop(0, 0, 4, 0, 4, 3, 0, 3);
    assertEquals(4, arena.parts().size());
    Segment last = (Segment) arena.parts().get(3);
    assertTrue(last.isLinked(0) && last.isLinked(1));
    assertEquals("1.0 0.0", last.normalX(0) + " " + last.normalY(0), "inwards");
    Aabb box = new Aabb();
    arena.aabb(new Transform(1, 1, 0), box);
    assertEquals("Aabb(1.0, 1.0 .. 5.0, 4.0)", box.toString());
    assertEquals(5, arena.reach(), 1e-6);
  }

  private static Polygon randomHull(SplittableRandom random) {
    float[] xy = new float[2 * random.nextInt(4, 40)];
    for (int i = 0; i < xy.length; i++) {
      xy[i] = (float) random.nextDouble(-0.9, 0.9);
    }
    return Polygon.hull(xy);
  }

  @Test
  void windingDuplicatesAndStraightCornersDoNotMatter() {
    Polygon square = Polygon.of(0, 0, 1, 0, 1, 1, 0, 1);
    assertEquals(square.toString(), Polygon.of(0, 1, 1, 1, 1, 0, 0, 0).toString());
    assertEquals(
        square.toString(),
        Polygon.hull(0, 0, 0.5f, 0, 1, 0, 1, 0.00001f, 1, 1, 0.5f, 0.5f, 0, 1, -0f, 1).toString());
    assertEquals(64, Polygon.regular(64, 0.01f).vertexCount());
    assertEquals(64, Polygon.regular(64, 1000).vertexCount());
  }

  @Test
  void boundsHoldWhatTheyShouldAndNoMore() {
    Shape[] shapes = {
      new Circle(0.5f, 1, 2), new Box(1, 2, 0.5f, -1), Polygon.of(0, 0, 2, 0, 1, 3)
    };
    Aabb box = new Aabb();
    for (Shape shape : shapes) {
      for (float angle = 0; angle < 7; angle += 0.1f) {
        Transform t = new Transform(10, 20, angle);
        shape.aabb(t, box);
        Convex c = shape.parts().get(0);
        Aabb points = new Aabb().setEmpty();
        for (int i = 0; i < c.vertexCount(); i++) {
          float x = c.vertexX(i);
          float y = c.vertexY(i);
          points.add(t.worldX(x, y), t.worldY(x, y));
        }
        points.grow(c.radius());
        assertEquals(points.minX, box.minX, 1e-5);
        assertEquals(points.minY, box.minY, 1e-5);
        assertEquals(points.maxX, box.maxX, 1e-5);
        assertEquals(points.maxY, box.maxY, 1e-5);
      }
    }
  }

  @Test
  void boundsOfACompoundHoldAllParts() {
    Aabb box = new Aabb();
    Compound.of(new Box(1, 1), new Circle(0.5f, 3, 0)).aabb(new Transform(10, 0, 0), box);
    assertEquals("Aabb(9.0, -1.0 .. 13.5, 1.0)", box.toString());
  }

  @Test
  void movingKeepsTheFormAndTheFeatureOrder() {
    Polygon p = Polygon.regular(7, 1);
    Polygon q = p.moved(3, 4);
    for (int i = 0; i < 7; i++) {
      assertEquals(p.vertexX(i) + 3, q.vertexX(i));
      assertEquals(p.normalX(i), q.normalX(i));
    }
    assertTrue(q.containsPoint(3, 4));
    assertTrue(new Box(1, 1).moved(5, 5).containsPoint(6, 6));
    assertEquals(5f + 1, new Circle(1).moved(3, 4).reach(), 1e-6f);
    assertTrue(
        Compound.of(new Circle(1), p)
            .moved(1, 1)
            .containsPoint(new Transform(0, 0, Trig.PI), -1, -1));
  }

  @Test
  void badShapesAreRefusedWithValueAndLimit() {
    refuses("circle radius=NaN must be in 0.001..100000.0", () -> new Circle(Float.NaN));
    refuses("circle radius=-1.0", () -> new Circle(-1));
    refuses("circle centerX=Infinity", () -> new Circle(1, Float.POSITIVE_INFINITY, 0));
    refuses("box halfHeight=1.0E-5", () -> new Box(1, 1e-5f));
    refuses("box halfWidth=1000000.0", () -> new Box(1e6f, 1));
    refuses("box edge0=0.0 m at 90000.0, ", () -> new Box(0.002f, 1, 90000, 0));
    refuses("too small for a place", () -> Polygon.regular(8, 0.002f).moved(90000, 90000));
    refuses("polygon vertices=2 must be in 3..", () -> Polygon.of(0, 0, 1, 1));
    refuses("polygon coordinates=5 must be even", () -> Polygon.of(0, 0, 1, 1, 2));
    refuses("polygon y1=NaN", () -> Polygon.of(0, 0, 1, Float.NaN, 2, 3));
    refuses("polygon area=0", () -> Polygon.of(0, 0, 1, 1, 2, 2));
    refuses("polygon area=0", () -> Polygon.of(1, 1, 1, 1, 1, 1));
    refuses("polygon width=", () -> Polygon.of(0, 0, 1, 0, 1, 0.0005f));
    refuses("compound parts=0", Compound::of);
    refuses("capsule length=0.0", () -> new Capsule(1, 1, 1, 1, 1));
    refuses("capsule radius=NaN", () -> new Capsule(0, 0, 1, 1, Float.NaN));
    refuses("capsule x1=Infinity", () -> new Capsule(0, 0, Float.POSITIVE_INFINITY, 1, 1));
    refuses("segment length=0.0", () -> new Segment(1, 1, 1, 1));
    refuses("polygon radius=-1.0", () -> Polygon.rounded(-1, 0, 0, 1, 0, 0, 1));
    refuses("chain points=1 must be in 2..", () -> Chain.open(1, 1));
    refuses("chain points=2 must be in 3..", () -> Chain.loop(1, 1, 2, 2));
    refuses("chain coordinates=3", () -> Chain.open(1, 1, 2));
    refuses("segment y0=NaN", () -> Chain.open(1, 1, 2, Float.NaN));
    refuses("density=-1.0", () -> new Circle(1).mass(-1));
    refuses("density=NaN", () -> Polygon.regular(3, 1).mass(Float.NaN));
    float[] many = new float[400];
    for (int i = 0; i < 200; i++) {
      many[2 * i] = Trig.cos(i * Trig.PI / 100);
      many[2 * i + 1] = Trig.sin(i * Trig.PI / 100);
    }
    refuses("polygon hull vertices=200 must be <= 64", () -> Polygon.of(many));
  }

  private static void refuses(String message, Runnable maker) {
    String actual = assertThrows(IllegalArgumentException.class, maker::run).getMessage();
    assertTrue(actual.contains(message), () -> Stream.of(message, actual).toList().toString());
  }
}
