package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitMeter;
import carom.net.codec.SectionCheck;
import carom.physics.rows.BodyRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The near section: written, measured and read alike. */
class NearCodecTest {
  private final Random random = new Random(74);

  private NearState near(NearState other) {
    NearState near = new NearState();
    if (random.nextInt(8) == 0) {
      return near;
    }
    near.begin(random.nextLong());
    TreeSet<Integer> taken = new TreeSet<>();
    for (int i = 0; i < other.count; i++) {
      int newcomers = random.nextInt(5) == 0 ? random.nextInt(4) : 0;
      for (; newcomers > 0; newcomers--) {
        add(near, taken, key(near));
      }
      if (random.nextInt(6) > 0) {
        add(near, taken, other.key(i));
      }
    }
    for (int n = random.nextInt(6); n > 0; n--) {
      add(near, taken, key(near));
    }
    if (random.nextBoolean()) {
      update(near);
    }
    for (int n = random.nextInt(4); n > 0 && near.count > 0; n--) {
      ruling(near);
    }
    return near;
  }

  private int key(NearState near) {
    boolean close = near.count > 0 && random.nextBoolean();
    int step = 1 + random.nextInt(20);
    return close ? near.key(near.count - 1) + step & 0xffffff : random.nextInt(1 << 24);
  }

  private static void add(NearState near, Set<Integer> taken, int key) {
    if (near.count < NearState.MAX_ENTITIES && taken.add(key)) {
      near.add(key);
    }
  }

  private void update(NearState near) {
    RowCounts counts = new RowCounts();
    counts.set(RowKind.CONTACT, random.nextInt(NearState.MAX_ROWS - 400));
    counts.set(RowKind.FIELDS, random.nextInt(3) * random.nextInt(60));
    near.beginPart(random.nextInt(64), counts, random.nextInt(9));
    for (int i = 0; i < near.count; i++) {
      if (random.nextBoolean()) {
        near.tell(i);
      }
    }
    for (int n = random.nextInt(NearState.MAX_PART + 1); n > 0; n--) {
      near.growRow();
    }
  }

  private void ruling(NearState near) {
    int mask = random.nextInt(1 << BodyRow.CHANGING_INTS);
    near.addRuling(random.nextInt(near.count), random.nextInt(64), random.nextInt(3), mask);
    near.setRulingJoint(random.nextBoolean() ? -1 : random.nextInt(1 << 16));
    for (int word = 0; word < BodyRow.CHANGING_INTS; word++) {
      if ((mask & 1 << word) != 0) {
        near.setRulingWord(word, random.nextInt(2));
      }
    }
  }

  private static String text(NearState near) {
    StringBuilder out = new StringBuilder(near.present + " " + near.hash + " list");
    for (int i = 0; i < near.count; i++) {
      out.append(' ').append(near.key(i));
    }
    out.append(near.updating ? " update " : " none ").append(near.age).append(" told");
    for (int i = 0; i < near.toldCount; i++) {
      out.append(' ').append(near.told[i]);
    }
    out.append(" rows ").append(near.totalRows()).append(' ').append(near.firstRow);
    for (int i = 0; i < near.partRows(); i++) {
      out.append(' ').append(near.kind(i) == RowKind.BODY ? near.rows.get(i, BodyRow.KEY) : 0);
    }
    for (int i = 0; i < near.rulings(); i++) {
      out.append(" ruling ").append(near.rulingPlace(i)).append(' ').append(near.rulingAge(i));
      out.append(' ').append(near.rulingMoment(i)).append(' ').append(near.rulingMask(i));
      out.append(" joint ").append(near.rulingJoint(i));
      for (int word = 0; word < BodyRow.CHANGING_INTS; word++) {
        boolean changed = (near.rulingMask(i) & 1 << word) != 0;
        out.append(' ').append(changed ? near.rulingWord(i, word) : 0);
      }
    }
    return out.toString();
  }

  @Test
  void whatIsWrittenIsMeasuredAndRead() {
    NearState last = new NearState();
    for (int i = 0; i < 200; i++) {
      NearState baseline = last;
      SectionCheck<NearState> check =
          new SectionCheck<>(
              (c, near) -> NearCodec.code(c, baseline, near),
              () -> near(baseline),
              NearCodecTest::text);
      last = near(baseline);
      check.check(last);
      check.hostile(random, 50);
    }
  }

  @Test
  void aListTakesNoMoreThanItSaysBefore() {
    NearState nothing = new NearState();
    for (int i = 0; i < 100; i++) {
      NearState near = near(near(nothing));
      near.endUpdate();
      near.rulings = 0;
      BitMeter meter = new BitMeter();
      NearCodec.code(meter, nothing, near);
      int flagsAndHash = near.present ? 5 + 32 : 1;
      int list = meter.bits() - flagsAndHash;
      if (near.present && near.count > 0) {
        assertTrue(list <= near.listBits(), "bits=" + list + " of " + near.listBits());
      }
    }
  }

  @Test
  void anEntityBetweenTwoThatStayTakesWhatIsSaid() {
    for (int i = 0; i < 300; i++) {
      NearState two = new NearState();
      two.begin(1);
      two.add(key(two));
      two.add(-1 >>> 8);
      NearState three = new NearState();
      three.begin(1);
      three.add(two.key(0));
      int between = key(three);
      three.add(between);
      three.add(two.key(1));
      // A bit each: near, list changed, two entities stay, the list ends, no update, no ruling.
      int expected = 7 + Integer.SIZE + NearCodec.insertBits(two.key(0), between);
      BitMeter meter = new BitMeter();
      NearCodec.code(meter, two, three);
      assertEquals(expected, meter.bits());
    }
  }
}
