package carom.physics.rows;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What exact rows hold, and that another world goes on from them alike. */
final class ExactRowsTest {
  private static final float DT = 1 / 60f;
  private static final int BODIES = 6;

  @Test
  void theFieldsOfAKindFillItsRow() throws Exception {
    assertEquals(BodyRow.LOADS + BodyRow.LOAD_INTS + 1, BodyRow.INTS); // and the archetype
    requireFilled(BodyRow.class, BodyRow.INTS, Set.of("ASLEEP"));
    requireFilled(JointRow.class, JointRow.INTS, Set.of("GROUND"));
    requireFilled(JointDefRow.class, JointDefRow.INTS, Set.of());
    requireFilled(ContactRow.class, ContactRow.INTS, Set.of("FLAGS_SHIFT", "POINTS_MASK"));
  }

  /** Each offset below {@code end} has a name, and no name has another offset. */
  private static void requireFilled(Class<?> kind, int end, Set<String> values) throws Exception {
    Set<Integer> offsets = new HashSet<>();
    for (Field field : kind.getFields()) {
      boolean isOffset = !values.contains(field.getName()) && !field.getName().endsWith("INTS");
      if (isOffset && field.getInt(null) < end) {
        offsets.add(field.getInt(null));
      }
    }
    assertEquals(end, offsets.size(), kind + " " + offsets);
  }

  @ParameterizedTest
  @EnumSource(RowKind.class)
  void everyBitOfEveryKindCountsInTheHash(RowKind kind) {
    ExactRows rows = new ExactRows();
    int[] row = new int[kind.ints()];
    rows.add(kind, row, 0);
    rows.add(kind, row, 0);
    Set<Long> hashes = new HashSet<>(List.of(rows.hash()));
    for (int field = 0; field < kind.ints(); field++) {
      for (int bit = 0; bit < Integer.SIZE; bit++) {
        rows.of(kind).set(1, field, 1 << bit);
        assertTrue(hashes.add(rows.hash()), kind + " field " + field + " bit " + bit);
      }
      rows.of(kind).set(1, field, 0);
    }
    assertTrue(hashes.contains(rows.hash()), "nothing is left over");
  }

  @Test
  void rowsOfMixedKindsStayApart() {
    Rows rows = Rows.mixed();
    RowCounts counts = new RowCounts();
    counts.set(RowKind.BODY, 20);
    counts.set(RowKind.JOINT, 10);
    counts.set(RowKind.FIELDS, 5);
    List<int[]> added = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      RowKind kind = counts.kind(i);
      int[] row = new int[kind.ints()];
      Arrays.fill(row, i + 1);
      rows.add(kind, row, 0);
      added.add(row);
    }
    Rows copy = Rows.mixed();
    copy.set(rows);
    copy.set(3, rows, 4);
    for (int i = 0; i < added.size(); i++) {
      int[] expected = added.get(i == 3 ? 4 : i);
      int at = copy.at(i);
      int[] found = Arrays.copyOfRange(copy.ints(), at, at + expected.length);
      assertArrayEquals(expected, found, "row " + i);
    }
    assertEquals(RowKind.BODY, counts.kind(19));
    assertEquals(RowKind.JOINT, counts.kind(20));
    assertEquals(RowKind.JOINT, counts.kind(29));
    assertEquals(RowKind.FIELDS, counts.kind(30));
    assertEquals(20, counts.first(RowKind.JOINT));
    assertEquals(35, counts.total());
  }

  @Test
  void aNewRowIsZeroWhateverStoodThere() {
    Rows rows = Rows.of(RowKind.CONTACT);
    int[] ones = new int[ContactRow.INTS];
    Arrays.fill(ones, 1);
    rows.add(RowKind.CONTACT, ones, 0);
    rows.clear();
    int at = rows.add();
    assertEquals(0, Arrays.stream(rows.ints(), at, at + ContactRow.INTS).sum());
  }

  @Test
  void bodiesAreListedByAscendingSlot() {
    ExactRows rows = new ExactRows();
    rows.addBody(3);
    assertThrows(IllegalArgumentException.class, () -> rows.addBody(3));
    ExactRows elsewhere = new ExactRows();
    elsewhere.add(RowKind.BODY, new int[BodyRow.INTS], 0);
    elsewhere.add(RowKind.BODY, new int[BodyRow.INTS], 0);
    assertEquals(-1, elsewhere.slot(1));
    elsewhere.setSlot(0, 7);
    assertThrows(IllegalArgumentException.class, () -> elsewhere.setSlot(1, 6));
    elsewhere.setSlot(1, 8);
    assertEquals(8, elsewhere.slot(1));
  }

  /** A floor, and a tower of boxes that leans. */
  private static World<String> tower(List<Body<String>> boxes) {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().shape(new Box(50, 1), Material.DEFAULT).position(0, -1), "floor");
    for (int i = 0; i < BODIES; i++) {
      BodyDef box = new BodyDef(BodyType.DYNAMIC).shape(new Box(.5f, .5f), Material.DEFAULT);
      boxes.add(w.createBody(box.position(.15f * i, .5f + i), "box"));
    }
    return w;
  }

  private static ExactRows read(World<String> w, List<Body<String>> boxes) {
    ExactRows rows = new ExactRows();
    for (Body<String> box : boxes) {
      rows.addBody(box.index());
    }
    assertEquals(0, w.readRows(rows), "everything that touches is listed");
    return rows;
  }

  @Test
  void anotherWorldGoesOnAlikeToTheBit() {
    List<Body<String>> boxes = new ArrayList<>();
    World<String> w = tower(boxes);
    for (int i = 0; i < 40; i++) {
      w.step(DT);
    }
    boxes.get(2).applyImpulse(3, 1);
    ExactRows rows = read(w, boxes);
    assertTrue(rows.contacts().count() >= 4, "contacts=" + rows.contacts().count());

    List<Body<String>> copies = new ArrayList<>();
    World<String> other = tower(copies);
    ExactRows sent = new ExactRows();
    for (RowKind kind : RowKind.values()) {
      for (int i = 0; i < rows.of(kind).count(); i++) {
        sent.add(kind, rows.of(kind).ints(), rows.of(kind).at(i));
      }
    }
    for (int i = 0; i < BODIES; i++) {
      sent.setSlot(i, copies.get(i).index());
    }
    other.writeRows(sent);
    for (int i = 0; i < 120; i++) {
      assertEquals(read(w, boxes).hash(), read(other, copies).hash(), "step " + i);
      w.step(DT);
      other.step(DT);
    }
  }

  @Test
  void aContactWithABodyThatIsNotListedIsLeftOutAndCounted() {
    List<Body<String>> boxes = new ArrayList<>();
    World<String> w = tower(boxes);
    for (int i = 0; i < 10; i++) {
      w.step(DT);
    }
    ExactRows all = read(w, boxes);
    ExactRows some = new ExactRows();
    some.addBody(boxes.get(0).index());
    int left = w.readRows(some);
    assertEquals(1, left);
    assertEquals(1, some.contacts().count(), "the floor's");
    assertTrue(some.contacts().get(0, ContactRow.END_A) < 0, "a static body has no place");
    assertNotEquals(all.hash(), some.hash());
    assertEquals(all.bodyHash(0), some.bodyHash(0));
  }

  @Test
  void aContactThatACallHasEndedSinceTheStepCountsUntilTheNext() {
    List<Body<String>> boxes = new ArrayList<>();
    World<String> w = tower(boxes);
    w.step(DT);
    w.destroyBody(boxes.remove(boxes.size() - 1));
    ExactRows rows = new ExactRows();
    boxes.forEach(box -> rows.addBody(box.index()));
    assertEquals(1, w.readRows(rows), "the last step may have pushed the one below");
    w.step(DT);
    read(w, boxes);
  }

  @Test
  void theKeyIsLeftToTheProgram() {
    List<Body<String>> boxes = new ArrayList<>();
    World<String> w = tower(boxes);
    ExactRows rows = new ExactRows();
    rows.addBody(boxes.get(0).index());
    rows.bodies().set(0, BodyRow.KEY, 17);
    w.readRows(rows);
    assertEquals(17, rows.bodies().get(0, BodyRow.KEY));
  }
}
