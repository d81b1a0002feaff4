package carom.values;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

public class RecordsTest {
  /** A record that refuses something. */
  public record Size(String name, int width, double height) {
    /** Refuses what is less than nothing. */
    public Size {
      if (width < 0) {
        throw new IllegalArgumentException("width=" + width + " is negative");
      }
    }
  }

  record Hidden(int value) {}

  private final Size size = new Size("a", 1, 2);

  @Test
  void aCopyHasTheChangesAndEverythingElse() {
    assertEquals(new Size("a", 1, 7), Records.with(size, "height", 7.0));
    assertEquals(new Size("b", 3, 2), Records.with(size, "width", 3, "name", "b"));
    assertEquals(size, Records.with(size));
    assertEquals(new Size("a", 1, 2), size, "the original stays as it is");
  }

  @Test
  void theConstructorChecksCopiesToo() {
    Exception e =
        assertThrows(IllegalArgumentException.class, () -> Records.with(size, "width", -1));
    assertEquals("width=-1 is negative", e.getMessage());
  }

  @Test
  void namesThatAreNoComponentAreRefused() {
    Exception e =
        assertThrows(IllegalArgumentException.class, () -> Records.with(size, "depth", 1));
    assertEquals("name=depth is no component of the record", e.getMessage());
  }

  @Test
  void recordsThatCannotBeMadeFromHereAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> Records.with(new Hidden(1), "value", 2));
  }
}
