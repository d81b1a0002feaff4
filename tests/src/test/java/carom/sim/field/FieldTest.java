package carom.sim.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.event.Audience;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Declarations: ranges, names, layout, and how two schemas are told apart. */
final class FieldTest {
  enum Phase {
    WARM_UP,
    PLAY,
    OVER
  }

  private static final Count HEALTH =
      Field.count("health", 0, 100).of(Scope.PLAYER).to(Audience.ALL).startsAt(100);
  private static final Choice<Phase> PHASE =
      Field.choice("phase", Phase.class).of(Scope.MATCH).to(Audience.ALL);
  private static final Flag LAMP = Field.flag("lamp").of(Scope.MATCH).times(5);
  private static final Count SECRET =
      Field.count("secret", -5, 5).of(Scope.MATCH).to(Audience.NOBODY);
  private static final PlayerRef KING = Field.player("king").of(Scope.MATCH).to(Audience.ALL);

  @Test
  void aFieldSaysItsDeclarationInOneLine() {
    assertEquals("player.health count 0..100 to ALL starts 100", HEALTH.toString());
    assertEquals("match.phase choice WARM_UP|PLAY|OVER to ALL", PHASE.toString());
    assertEquals("match.lamp flag x5 to NEAR", LAMP.toString());
    assertEquals(
        "entity.fuel ratio 0..1 in 100 steps to OWNER starts 0.5",
        Field.ratio("fuel", 100).of(Scope.ENTITY).to(Audience.OWNER).startsAt(0.5f).toString());
    assertEquals(
        "player.dashX real to NEAR starts -1.5", Field.real("dashX").startsAt(-1.5f).toString());
    assertEquals("player.dash countdown to NEAR", Field.countdown("dash").toString());
    assertEquals("player.target entity to NEAR", Field.entity("target").toString());
  }

  @Test
  void bitsFollowTheRange() {
    assertEquals(7, HEALTH.bits());
    assertEquals(2, PHASE.bits());
    assertEquals(1, LAMP.bits());
    assertEquals(4, SECRET.bits());
    assertEquals(16, Field.ratio("fuel").bits());
    assertEquals(32, Field.real("x").bits());
    assertEquals(31, Field.countdown("x").bits());
    assertEquals(32, Field.count("x", Integer.MIN_VALUE, Integer.MAX_VALUE).bits());
  }

  @Test
  void changingADeclarationLeavesTheOriginalAsItWas() {
    Count other = HEALTH.to(Audience.OWNER).times(3).startsAt(1);
    assertEquals(Audience.ALL, HEALTH.audience());
    assertEquals(1, HEALTH.times());
    assertEquals(100, HEALTH.start());
    assertEquals("player.health count 0..100 x3 to OWNER starts 1", other.toString());
  }

  @Test
  void aCountStartsAtTheValueNearestToZero() {
    assertEquals(3, Field.count("x", 3, 9).start());
    assertEquals(-2, Field.count("x", -9, -2).start());
    assertEquals(0, Field.count("x", -9, 2).start());
  }

  @Test
  void badDeclarationsAreRefusedByName() {
    refused("field name=\"Health\"", () -> Field.count("Health", 0, 1));
    refused("field name=\"\"", () -> Field.flag(""));
    refused("field name=\"a b\"", () -> Field.real("a b"));
    refused("field name=\"1a\"", () -> Field.real("1a"));
    refused("min=5 of field x must be below max=5", () -> Field.count("x", 5, 5));
    refused("times=0 of field health", () -> HEALTH.times(0));
    refused("times=65537 of field health", () -> HEALTH.times(65_537));
    refused("player.health=101 is outside count 0..100", () -> HEALTH.startsAt(101));
    refused("steps=0 of field x", () -> Field.ratio("x", 0));
    refused("player.x=1.5 is outside ratio 0..1", () -> Field.ratio("x").startsAt(1.5f));
    refused("player.x=NaN", () -> Field.real("x").startsAt(Float.NaN));
  }

  @Test
  void aRatioComesBackAsTheNearestStepAndStopsAtItsLimits() {
    Ratio nitro = Field.ratio("nitro");
    assertEquals(1f, nitro.decode(nitro.encode(1)));
    assertEquals(0f, nitro.decode(nitro.encode(0)));
    for (int step = 0; step <= Ratio.STEPS; step++) {
      assertEquals(step, nitro.encode(nitro.decode(step)));
    }
    assertEquals(0, nitro.add(100, -1));
    assertEquals(Ratio.STEPS, nitro.add(100, Float.POSITIVE_INFINITY));
    assertEquals(100 + 655, nitro.add(100, 0.01f));
    refused("player.nitro=NaN", () -> nitro.add(0, Float.NaN));
  }

  @Test
  void wordsThatPlayersMayBeToldComeFirst() {
    Schema schema = Schema.of(List.of(SECRET, PHASE, LAMP, HEALTH));
    assertEquals(7, schema.words(Scope.MATCH));
    assertEquals(6, schema.toldWords(Scope.MATCH));
    assertEquals(1, schema.words(Scope.PLAYER));
    assertEquals(0, schema.words(Scope.ENTITY));
    assertEquals("match.phase", schema.name(Scope.MATCH, 0));
    assertEquals("match.lamp[4]", schema.name(Scope.MATCH, 5));
    assertEquals("match.secret", schema.name(Scope.MATCH, 6));
    assertEquals(6, schema.word(SECRET, Scope.MATCH));
    assertEquals(3, schema.word(LAMP, Scope.MATCH, 2));
  }

  @Test
  void misuseIsRefusedByTheFieldsName() {
    Schema schema = Schema.of(List.of(PHASE, LAMP, HEALTH));
    refused("field match.secret isn't declared", () -> schema.word(SECRET, Scope.MATCH));
    refused("player.health belongs to scope PLAYER", () -> schema.word(HEALTH, Scope.MATCH));
    refused("match.lamp has values=5", () -> schema.word(LAMP, Scope.MATCH));
    String message =
        assertThrows(IndexOutOfBoundsException.class, () -> schema.word(LAMP, Scope.MATCH, 5))
            .getMessage();
    assertTrue(message.contains("index=5 of field match.lamp is outside 0..4"), message);
    refused("match.king isn't declared", () -> Schema.EMPTY.word(KING, Scope.MATCH));
  }

  @Test
  void aNameIsDeclaredOnceInItsScope() {
    refused(
        "match.phase is declared twice",
        () -> Schema.of(List.of(PHASE, Field.flag("phase").of(Scope.MATCH))));
    refused("player.health is declared twice", () -> Schema.of(List.of(HEALTH, HEALTH)));
    Schema.of(List.of(HEALTH, HEALTH.of(Scope.ENTITY)));
  }

  @Test
  void aScopeHasALimit() {
    refused(
        "field entity.bag makes words=65 of scope ENTITY, above the limit of 64",
        () -> Schema.of(List.of(Field.flag("bag").of(Scope.ENTITY).times(65))));
  }

  @Test
  void theFirstDifferenceOfTwoSchemasHasAName() {
    Schema mine = Schema.of(List.of(HEALTH, PHASE));
    assertNull(mine.difference(Schema.of(List.of(HEALTH, PHASE)).lines()));
    assertEquals(
        "field player.health is \"player.health count 0..100 to ALL starts 100\" here and"
            + " \"player.health count 0..100 to OWNER starts 100\" there",
        mine.difference(Schema.of(List.of(HEALTH.to(Audience.OWNER), PHASE)).lines()));
    assertEquals(
        "field match.lamp is declared there only",
        mine.difference(Schema.of(List.of(HEALTH, LAMP, PHASE)).lines()));
    assertEquals(
        "field match.lamp is declared there only",
        mine.difference(Schema.of(List.of(HEALTH, PHASE, LAMP)).lines()));
    assertEquals(
        "field player.health is declared here only",
        mine.difference(Schema.of(List.of(PHASE)).lines()));
    assertEquals(
        "field player.health is declared here where match.phase is there",
        mine.difference(Schema.of(List.of(PHASE, HEALTH)).lines()));
    assertEquals(
        "field match.phase is declared here only", mine.difference(List.of(HEALTH.toString())));
  }

  @Test
  void theDigestSeesEveryDeclaration() {
    long digest = Schema.of(List.of(HEALTH, PHASE)).digest();
    assertEquals(digest, Schema.of(List.of(HEALTH, PHASE)).digest());
    assertNotEquals(digest, Schema.of(List.of(PHASE, HEALTH)).digest());
    assertNotEquals(digest, Schema.of(List.of(HEALTH)).digest());
    assertNotEquals(digest, Schema.of(List.of(HEALTH.startsAt(99), PHASE)).digest());
    assertFalse(digest == Schema.EMPTY.digest());
  }

  private static void refused(String part, Runnable act) {
    String message = assertThrows(IllegalArgumentException.class, act::run).getMessage();
    assertTrue(message.contains(part), message);
  }
}
