package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class FirstTest {
  @Test
  void adds() {
    assertEquals(2, 1 + 1);
  }
}
