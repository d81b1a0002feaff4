package carom.client.desktop.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.settings.Palette;
import com.badlogic.gdx.graphics.Color;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Goal: colours that mean something can be told apart by everybody who asks for it. */
class UiColoursTest {
  @AfterEach
  void back() {
    UiColours.palette(Palette.STANDARD);
  }

  @Test
  void redAndGreenDifferInMoreThanTheirHue() {
    int red = 0xff5d5d;
    int green = 0x5ad18a;
    Color out = new Color();
    assertEquals(red, Color.rgb888(UiColours.shade(red, 1, 1, out)), "as the game chose it");
    UiColours.palette(Palette.COLOUR_BLIND);
    Color a = new Color(UiColours.shade(red, 1, 1, out));
    Color b = new Color(UiColours.shade(green, 1, 1, out));
    assertTrue(Math.abs(a.b - b.b) > 0.3f, "the blue part differs: " + a + " " + b);
    assertTrue(Math.abs(UiColours.GOOD.b - UiColours.BAD.b) > 0.3f);
  }

  @Test
  void greysStayAndBrightnessToo() {
    UiColours.palette(Palette.COLOUR_BLIND);
    Color out = new Color();
    for (int grey : new int[] {0, 0xffffff, 0x808080, 0x10141c}) {
      int shown = Color.rgb888(UiColours.shade(grey, 1, 1, out));
      assertEquals(UiColours.forAll(grey), shown);
    }
    assertEquals(0x808080, UiColours.forAll(0x808080));
    for (int rgb : new int[] {0xff5d5d, 0x4da3ff, 0x123456, 0x9966cc, 0xffe08a}) {
      int shown = UiColours.forAll(rgb);
      assertEquals(brightest(rgb), brightest(shown), 1, Integer.toHexString(rgb));
    }
  }

  private static int brightest(int rgb) {
    return Math.max(rgb >> 16 & 0xff, Math.max(rgb >> 8 & 0xff, rgb & 0xff));
  }
}
