package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.settings.MixingRule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** How friction and restitution of two shapes become that of their contact. */
final class MixingTest {
  private static final Material FLOOR = new Material(1, .4f, .2f);
  private static final Material BOX = new Material(1, .9f, .5f);

  private static float expected(MixingRule rule, float a, float b) {
    return switch (rule) {
      case AVERAGE -> (a + b) / 2;
      case GEOMETRIC_MEAN -> (float) Math.sqrt(a * b);
      case MIN -> Math.min(a, b);
      case MULTIPLY -> a * b;
      case MAX -> Math.max(a, b);
    };
  }

  /** The friction and restitution that a listener sees of a box on a floor. */
  private static float[] mixed(WorldDef def, Material floor, Material box) {
    World<String> w = Scenes.floor(floor, def);
    Scenes.box(w, 0, .5f, .5f, .5f, box);
    float[] seen = {-1, -1};
    w.listener(
        new CollisionListener<>() {
          @Override
          public void postSolve(Collision<String> c) {
            seen[0] = c.friction();
            seen[1] = c.restitution();
          }
        });
    w.step(DT);
    return seen;
  }

  @ParameterizedTest
  @EnumSource(MixingRule.class)
  void theRuleOfTheWorldMixes(MixingRule rule) {
    float[] friction = mixed(new WorldDef().withFrictionMixing(rule), FLOOR, BOX);
    assertEquals(expected(rule, .4f, .9f), friction[0]);
    assertEquals(.5f, friction[1], "restitution has a rule of its own");
    float[] restitution = mixed(new WorldDef().withRestitutionMixing(rule), FLOOR, BOX);
    assertEquals(expected(rule, .2f, .5f), restitution[1]);
    assertEquals((float) Math.sqrt(.4f * .9f), restitution[0]);
  }

  @Test
  void theRuleOfAMaterialGoesBeforeTheWorldsAndTheLaterOfTwoCounts() {
    WorldDef def = new WorldDef().withFrictionMixing(MixingRule.AVERAGE);
    for (MixingRule a : MixingRule.values()) {
      Material floor = FLOOR.withFrictionMixing(a).withRestitutionMixing(a);
      float[] one = mixed(def, floor, BOX);
      assertEquals(expected(a, .4f, .9f), one[0], a + " of one");
      assertEquals(expected(a, .2f, .5f), one[1], a + " of one");
      for (MixingRule b : MixingRule.values()) {
        MixingRule later = a.compareTo(b) > 0 ? a : b;
        Material box = BOX.withFrictionMixing(b).withRestitutionMixing(b);
        float[] both = mixed(def, floor, box);
        assertEquals(expected(later, .4f, .9f), both[0], a + " and " + b);
        assertEquals(expected(later, .2f, .5f), both[1], a + " and " + b);
      }
    }
  }

  @Test
  void theMixedFrictionIsWhatActs() {
    // 0.4 and 0.9: the smaller one slides on a slope of 0.5, the larger one doesn't.
    for (MixingRule rule : new MixingRule[] {MixingRule.MIN, MixingRule.MAX}) {
      World<String> w =
          Scenes.floor(FLOOR, new WorldDef().withGravity(5, -10).withFrictionMixing(rule));
      Body<String> box = Scenes.box(w, 0, .5f, .5f, .2f, BOX);
      steps(w, 120);
      float slid = box.x();
      steps(w, 60);
      assertEquals(rule == MixingRule.MIN, box.x() - slid > .5f, rule + " x=" + box.x());
    }
  }

  @Test
  void aRuleSetWhileBodiesTouchActsFromTheNextStepOn() {
    World<String> w = Scenes.floor(FLOOR, new WorldDef().withGravity(5, -10));
    Body<String> box = Scenes.box(w, 0, .5f, .5f, .2f, BOX);
    steps(w, 120);
    float rests = box.x();
    box.setMaterial(0, BOX.withFrictionMixing(MixingRule.MIN));
    steps(w, 60);
    assertNotEquals(rests, box.x(), .2f);
  }

  private static World<String> stack(WorldDef def, Material box) {
    World<String> w = Scenes.floor(FLOOR, def);
    for (int i = 0; i < 5; i++) {
      Scenes.box(w, .1f * i, .6f + 1.2f * i, .5f, .5f, box);
    }
    return w;
  }

  private static byte[] bytes(World<?> w) {
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    return out.toBytes();
  }

  @Test
  void rulesAreHashedAndGoThroughAnArchive() {
    Material own =
        BOX.withFrictionMixing(MixingRule.MULTIPLY).withRestitutionMixing(MixingRule.MIN);
    WorldDef def = new WorldDef().withRestitutionMixing(MixingRule.AVERAGE);
    assertNotEquals(stack(def, BOX).stateHash(), stack(def, own).stateHash());
    for (Material box : new Material[] {BOX, own}) {
      World<String> w = stack(def, box);
      steps(w, 40);
      World<String> copy = new World<>(def);
      copy.restore(copy.read(new ArchiveReader(bytes(w)), slot -> "read"));
      assertEquals(box, copy.body(1).material(0));
      for (int i = 0; i < 60; i++) {
        assertEquals(w.stateHash(), copy.stateHash());
        steps(w, 1);
        steps(copy, 1);
      }
      World<String> others = new World<>(new WorldDef());
      assertThrows(
          ArchiveException.class, () -> others.read(new ArchiveReader(bytes(w)), slot -> "read"));
    }
  }

  @Test
  void rulesOfAMaterialStayWhenItsOtherValuesChange() {
    Material own =
        BOX.withFrictionMixing(MixingRule.MULTIPLY).withRestitutionMixing(MixingRule.MIN);
    Material changed =
        own.withDensity(2)
            .withFriction(.1f)
            .withRestitution(.3f)
            .withRollingResistance(.2f)
            .withTangentSpeed(1)
            .withTag(7);
    assertEquals(
        new Material(2, .1f, .3f, .2f, 1, 7, MixingRule.MULTIPLY, MixingRule.MIN), changed);
    assertEquals(
        new Material(2, .1f, .3f, .2f, 1, 7),
        changed.withFrictionMixing(null).withRestitutionMixing(null));
  }
}
