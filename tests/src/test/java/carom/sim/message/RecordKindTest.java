package carom.sim.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.entity.EntityTable;
import carom.sim.entity.PlayerTable;
import carom.sim.message.MessageKind.Direction;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: a record declares a kind of message as the builder does. Method: the same declarations both
 * ways, and values drawn at random that go through the wire.
 */
final class RecordKindTest {
  private enum Hand {
    LEFT,
    RIGHT
  }

  private record Throw(
      @Bounds(min = 0, max = 31) int item,
      @Bounds(min = -2, max = 9) float power,
      boolean far,
      Hand hand,
      @Longest(60) String note,
      @IdOfPlayer int to,
      @IdOfEntity int ball) {}

  private record Unbounded(int item) {}

  private record Halved(@Bounds(min = 0.5, max = 3) int item) {}

  private record Huge(@Bounds(min = 0, max = 1e12) int item) {}

  private record Endless(String text) {}

  private record Odd(long number) {}

  private record Other(boolean flag) {}

  private static final MessageKind THROW = MessageKind.of(Throw.class).fromClient().atMost(5);

  @Test
  void declaresTheSameAsTheBuilder() {
    MessageKind built =
        MessageKind.named("throw")
            .fromClient()
            .count("item", 0, 31)
            .real("power", -2, 9)
            .flag("far")
            .choice("hand", Hand.class)
            .text("note", 60)
            .player("to")
            .entity("ball");
    assertEquals(built.toString(), THROW.toString());
    assertEquals(5, THROW.perSecond());
  }

  @Test
  void valuesGoThroughTheWireAsOne() {
    MessageKinds kinds = new MessageKinds();
    kinds.add(THROW);
    long seed = System.nanoTime();
    Random random = new Random(seed);
    for (int i = 0; i < 1_000; i++) {
      Throw thrown =
          new Throw(
              random.nextInt(32),
              random.nextFloat() * 11 - 2,
              random.nextBoolean(),
              Hand.values()[random.nextInt(2)],
              "x".repeat(random.nextInt(61)),
              random.nextInt(PlayerTable.MAX_PLAYERS + 1) - 1,
              random.nextInt(EntityTable.MAX_ENTITIES + 1) - 1);
      byte[] bytes = kinds.encode(THROW.of(thrown), Direction.FROM_CLIENT);
      Message message = kinds.decode(bytes, 0, bytes.length, Direction.FROM_CLIENT);
      assertEquals(thrown, message.as(Throw.class), "seed=" + seed);
      assertEquals(thrown.to(), message.player("to"));
      assertEquals(thrown.ball(), message.entity("ball"));
      assertEquals(thrown, THROW.parse(message.values()).as(Throw.class), "by name");
    }
  }

  @Test
  void whatDoesntFitIsRefusedByName() {
    assertRefused("item", () -> MessageKind.of(Unbounded.class));
    assertRefused("0.5", () -> MessageKind.of(Halved.class));
    assertRefused("1.0E12", () -> MessageKind.of(Huge.class));
    assertRefused("@Longest", () -> MessageKind.of(Endless.class));
    assertRefused("long number", () -> MessageKind.of(Odd.class));
    assertRefused("item=32", () -> THROW.of(new Throw(32, 0, true, Hand.LEFT, "", 0, 0)));
    assertRefused(
        "to=1024",
        () -> THROW.of(new Throw(1, 0, true, Hand.LEFT, "", PlayerTable.MAX_PLAYERS, 0)));
    assertRefused(
        "ball=65535",
        () -> THROW.of(new Throw(1, 0, true, Hand.LEFT, "", -1, EntityTable.MAX_ENTITIES)));
    assertRefused("Other", () -> THROW.of(new Other(true)));
    assertRefused("Other", () -> THROW.of(0, 0f, true, Hand.LEFT, "", -1, -1).as(Other.class));
    assertEquals(null, THROW.parse(Map.of("item", 3)));
  }

  private static void assertRefused(String word, Runnable declares) {
    String text = assertThrows(IllegalArgumentException.class, declares::run).getMessage();
    assertTrue(text.contains(word), text);
  }
}
