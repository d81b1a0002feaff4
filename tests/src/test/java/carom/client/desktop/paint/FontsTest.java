package carom.client.desktop.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Goal: text is as readable in a large window as in a small one. */
class FontsTest {
  @Test
  void textGrowsWithTheWindowAndTheChosenSize() {
    assertEquals(1, Fonts.scale(1_280, 720, 1));
    assertEquals(1.5f, Fonts.scale(1_920, 1_080, 1));
    assertEquals(3, Fonts.scale(3_840, 2_160, 1));
    assertEquals(1.25f, Fonts.scale(1_280, 720, 1.25f));
    assertEquals(1, Fonts.scale(1_280, 2_000, 1), "a narrow window isn't filled with text");
  }

  @Test
  void textIsNeverTooSmallToRead() {
    assertEquals(0.75f, Fonts.scale(640, 360, 1));
    assertEquals(4, Fonts.scale(7_680, 4_320, 2));
  }
}
