package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SpatialCollectionTest {
  private static final class Thing {
    final String name;
    float x;

    Thing(String name, float x) {
      this.name = name;
      this.x = x;
    }

    void write(AabbArray boxes, int id) {
      boxes.set(id, x, 0, x + 1, 1);
    }
  }

  private static String around(SpatialCollection<Thing> things, float from, float to) {
    List<Thing> found = new ArrayList<>();
    things.retrieve(from, 0, to, 1, found);
    StringBuilder names = new StringBuilder();
    found.forEach(thing -> names.append(thing.name));
    return names.toString();
  }

  @ParameterizedTest
  @MethodSource("carom.physics.broadphase.SpatialIndexTest#indexes")
  void behavesLikeACollectionThatKnowsPlaces(SpatialIndex index) {
    SpatialCollection<Thing> things = new SpatialCollection<>(index, Thing::write);
    assertEquals("", around(things, -100, 100), "empty");
    Thing a = new Thing("a", 0);
    Thing b = new Thing("b", 5);
    Thing c = new Thing("c", 5.5f);
    things.addAll(List.of(a, b, c));
    assertEquals("abc", around(things, -100, 100));
    assertEquals("bc", around(things, 6, 6));
    a.x = 6;
    assertEquals("bc", around(things, 6, 6), "moved, but not rebuilt");
    things.rebuild();
    assertEquals("abc", around(things, 6, 6));
    List<String> pairs = new ArrayList<>();
    things.forEachPair((p, q) -> pairs.add(p.name + q.name));
    pairs.sort(null);
    assertEquals(List.of("ab", "ac", "bc"), pairs);
    assertTrue(things.remove(b));
    assertFalse(things.remove(b));
    assertEquals("ac", around(things, 6, 6));
    things.removeIf(thing -> thing.x > 5.8f);
    assertEquals("c", around(things, 6, 6));
    things.clear();
    assertTrue(things.isEmpty());
    assertEquals("", around(things, -100, 100));
  }

  @Test
  void elementWithAnInvalidBoxIsRefusedAndCanBeMended() {
    SpatialCollection<Thing> things = new SpatialCollection<>(Thing::write);
    Thing good = new Thing("g", 1);
    things.add(good);
    things.rebuild();
    good.x = Float.NaN;
    assertThrows(IllegalArgumentException.class, things::rebuild);
    good.x = 2;
    assertEquals("g", around(things, 2, 2) + (things.contains(good) ? "" : "lost"));
    assertThrows(NullPointerException.class, () -> things.add(null));
  }
}
