package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Long lines of ground, in pieces that nobody feels. */
final class ChainDefTest {
  private static final Material ICE = new Material(1, 0, 0);

  /** A line from left to right, its points that far apart. */
  private static float[] flat(int segments, float apart) {
    float[] xy = new float[2 * (segments + 1)];
    for (int i = 0; i <= segments; i++) {
      xy[2 * i] = i * apart;
    }
    return xy;
  }

  private static float[] hills(int segments) {
    float[] xy = flat(segments, .25f);
    for (int i = 0; i <= segments; i++) {
      xy[2 * i + 1] = (float) Math.sin(.05 * i) * 1.5f;
    }
    return xy;
  }

  @Test
  void theLineIsCutWhereTheMaterialChangesAndWhereAChainOrABodyIsFull() {
    ChainDef def =
        ChainDef.open(flat(5_000, 1)).material(ICE).material(40, 60, Material.DEFAULT.withTag(7));
    List<ShapeDef> shapes = def.shapes();
    int segment = 0;
    for (ShapeDef shape : shapes) {
      for (int i = 0; i < shape.shape().parts().size(); i++) {
        assertSame(def.material(segment), shape.material());
        assertEquals(segment + 1, shape.shape().parts().get(i).vertexX(0));
        segment++;
      }
      assertTrue(shape.shape().parts().size() <= Chain.MAX_SEGMENTS);
    }
    assertEquals(5_000, segment);
    assertEquals(40, shapes.get(0).shape().parts().size());
    assertEquals(20, shapes.get(1).shape().parts().size());

    World<String> w = new World<>(new WorldDef());
    List<Body<String>> bodies = w.createChain(def, new BodyDef().position(3, 4), "ground");
    assertEquals(6, bodies.size());
    assertEquals(6, w.bodyCount());
    for (Body<String> body : bodies) {
      assertEquals("ground", body.user());
      assertEquals(3, body.x());
    }
  }

  @Test
  void everyCutIsLinkedAsAJointWithinAChainIs() {
    float[] xy = hills(3_000);
    for (boolean loop : new boolean[] {false, true}) {
      float[] line = loop ? circle(3_000) : xy;
      List<Segment> segments = new ArrayList<>();
      for (Shape piece : Chain.pieces(line, loop, 1, 700, 701, 1_500, 2_400)) {
        piece.parts().forEach(part -> segments.add((Segment) part));
      }
      assertEquals(3_000, segments.size());
      int n = line.length / 2;
      for (int i = 0; i < 3_000; i++) {
        Segment s = segments.get(i);
        boolean first = !loop && i == 0;
        boolean last = !loop && i == 2_999;
        assertEquals(!last, s.isLinked(0), "segment=" + i);
        assertEquals(!first, s.isLinked(1), "segment=" + i);
        if (!last) {
          assertEquals(line[2 * ((i + 2) % n)], s.ghostX(0), "segment=" + i);
        }
        if (!first) {
          assertEquals(line[2 * ((i + n - 1) % n) + 1], s.ghostY(1), "segment=" + i);
        }
      }
    }
  }

  private static float[] circle(int points) {
    float[] xy = new float[2 * points];
    for (int i = 0; i < points; i++) {
      xy[2 * i] = (float) (60 * Math.cos(2 * Math.PI * i / points));
      xy[2 * i + 1] = (float) (60 * Math.sin(2 * Math.PI * i / points));
    }
    return xy;
  }

  /** Where a body is after sliding over ground for so long. */
  private static double[] slide(ChainDef def, Shape shape, float speed, int ticks) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    w.createChain(def, new BodyDef(), "ground");
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(shape, ICE).position(2, .51f).velocity(speed, 0),
            "slider");
    steps(w, ticks);
    return new double[] {b.x(), b.y(), b.velocityX()};
  }

  @Test
  void bodiesKeepTheirSpeedOverAllCuts() {
    for (Shape shape : new Shape[] {new Circle(.5f), new Box(.5f, .5f)}) {
      for (float speed : new float[] {3, 20, 60}) {
        ChainDef cuts = ChainDef.open(flat(4_000, .1f));
        for (int i = 0; i < 4_000; i++) {
          cuts.material(i, ICE.withTag(i / 7));
        }
        double[] at = slide(cuts, shape, speed, (int) (390 / speed * 60) - 20);
        String what = shape + " speed=" + speed + " x=" + at[0] + " y=" + at[1];
        assertEquals(speed, at[2], .001 * speed, what);
        assertEquals(.5, at[1], .02, what);
      }
    }
  }

  @Test
  void theMaterialOfEachSegmentActs() {
    ChainDef def =
        ChainDef.open(flat(3_000, .1f)).material(ICE).material(1_500, 3_000, Material.DEFAULT);
    World<String> w = new World<>(new WorldDef());
    w.createChain(def, new BodyDef(), "ground");
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(.5f, .5f), Material.DEFAULT)
                .position(100, .51f)
                .velocity(10, 0),
            "slider");
    steps(w, 240);
    assertEquals(10, b.velocityX(), .02, "ice up to 150 m");
    steps(w, 400);
    // Stops after v^2 / 2 mu g on the rough half.
    assertEquals(150 + 100 / (2 * .6 * 10), b.x(), 1);
    assertEquals(0, b.velocityX(), 1e-3);
  }

  @Test
  void hillsInPiecesAreTheHillsOfOneChain() {
    float[] xy = hills(1_000);
    double[] one = slide(ChainDef.open(xy), new Circle(.5f), 4, 600);
    ChainDef tagged = ChainDef.open(xy);
    for (int i = 0; i < 1_000; i++) {
      tagged.material(i, Material.DEFAULT.withTag(i % 3));
    }
    double[] pieces = slide(tagged, new Circle(.5f), 4, 600);
    assertTrue(one[0] > 10, "x=" + one[0]);
    for (int i = 0; i < 3; i++) {
      assertEquals(one[i], pieces[i], "to the bit");
    }
  }

  @Test
  void whatAQueryCostsDoesNotDependOnTheLength() {
    int[] seen = new int[2];
    for (int k = 0; k < 2; k++) {
      World<String> w = new World<>(new WorldDef());
      w.createChain(ChainDef.open(flat(k == 0 ? 500 : 50_000, 1)), new BodyDef(), "ground");
      int n = k;
      w.queries()
          .rayAll(
              250.5f,
              3,
              0,
              -6,
              (body, shape) -> {
                seen[n]++;
                return true;
              },
              hit -> true);
    }
    assertTrue(seen[0] > 0 && seen[1] <= 2 * seen[0] + 2, seen[0] + " then " + seen[1]);
  }

  @Test
  void piecesGoThroughAnArchive() {
    World<String> w = new World<>(new WorldDef());
    w.createChain(ChainDef.loop(circle(2_500)).material(3, ICE), new BodyDef(), "ground");
    Scenes.disc(w, 59, 0, .5f, Material.DEFAULT);
    steps(w, 30);
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    World<String> copy = new World<>(new WorldDef());
    copy.restore(copy.read(new ArchiveReader(out.toBytes()), slot -> "read"));
    for (int i = 0; i < 120; i++) {
      assertEquals(w.stateHash(), copy.stateHash());
      w.step(DT);
      copy.step(DT);
    }
  }

  @Test
  void movedPiecesStayLinked() {
    Chain piece = Chain.pieces(hills(30), false, 10, 20).get(1);
    Segment first = (Segment) piece.moved(5, 6).parts().get(0);
    Segment original = (Segment) piece.parts().get(0);
    assertTrue(first.isLinked(1));
    assertEquals(original.ghostX(1) + 5, first.ghostX(1));
    assertEquals(original.ghostY(1) + 6, first.ghostY(1));
  }

  @Test
  void badLinesAreRefusedByName() {
    refused("chain coordinates=3 must be even", () -> ChainDef.open(1, 2, 3));
    refused("chain segments=0 must be in 1..200000", () -> ChainDef.open(1, 2));
    refused("chain segments=2 must be in 3..200000", () -> ChainDef.loop(1, 2, 3, 4));
    refused("chain segments=200001", () -> ChainDef.open(new float[2 * 200_002]));
    ChainDef def = ChainDef.open(flat(9, 1));
    assertThrows(IndexOutOfBoundsException.class, () -> def.material(9, ICE));
    refused("material=null", () -> def.material(null));
    refused("filter=null", () -> def.filter(null));
    float[] crossing = flat(1_200, 1);
    crossing[2 * 600] = 600;
    crossing[2 * 601] = 598.5f;
    crossing[2 * 601 + 1] = 1;
    crossing[2 * 602] = 598.5f;
    crossing[2 * 602 + 1] = -1;
    refused("chain segment=598 crosses segment=601", () -> ChainDef.open(crossing).shapes());
    refused("chain piece=1 from segment 5 to 5", () -> Chain.pieces(flat(9, 1), false, 5, 5));
    refused(
        "chain piece=0 from segment 0 to 1100", () -> Chain.pieces(flat(1_200, 1), false, 1_100));
    World<String> w = new World<>(new WorldDef());
    refused("type=DYNAMIC shapes=0", () -> w.createChain(def, new BodyDef(BodyType.DYNAMIC), "no"));
    BodyDef filled = new BodyDef().shape(new Circle(1));
    refused("type=STATIC shapes=1", () -> w.createChain(def, filled, "no"));
    assertEquals(0, w.bodyCount());
  }

  private static void refused(String start, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.startsWith(start), message);
  }
}
