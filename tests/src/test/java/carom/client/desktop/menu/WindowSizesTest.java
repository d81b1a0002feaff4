package carom.client.desktop.menu;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.client.settings.PlayerSettings;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a button reaches each size that fits. Method: presses, and what they set. */
final class WindowSizesTest {
  @Test
  void aWindowGrowsToTheWholeScreenAndBeginsAnew() {
    assertEquals(
        List.of("1600x900", "1920x1080", "whole", "960x540", "1280x720", "1600x900"),
        sizes(PlayerSettings.defaults(), new int[] {1_920, 1_080}, 6));
  }

  @Test
  void aSizeThatThePlayerDrewIsFollowedByTheNextLargerOne() {
    PlayerSettings drawn = PlayerSettings.defaults().withWindow(1_001, 700);
    assertEquals(List.of("1280x720"), sizes(drawn, new int[] {1_920, 1_080}, 1));
  }

  @Test
  void aSmallScreenHasTheWholeOfItAndItsWindow() {
    assertEquals(
        List.of("whole", "1280x720", "whole"),
        sizes(PlayerSettings.defaults(), new int[] {800, 480}, 3));
  }

  private static List<String> sizes(PlayerSettings settings, int[] screen, int presses) {
    List<String> seen = new ArrayList<>();
    for (int i = 0; i < presses; i++) {
      settings = WindowSizes.next(settings, screen);
      String window =
          settings.get(PlayerSettings.WINDOW).width()
              + "x"
              + settings.get(PlayerSettings.WINDOW).height();
      seen.add(settings.get(PlayerSettings.FULLSCREEN) ? "whole" : window);
    }
    return seen;
  }
}
