package carom.client.desktop.menu;

import carom.client.settings.PlayerSettings;

/** The sizes that a window goes through: those that fit on the screen, and then all of it. */
final class WindowSizes {
  private static final int[][] SIZES = {
    {960, 540}, {1_280, 720}, {1_600, 900}, {1_920, 1_080}, {2_560, 1_440}, {3_840, 2_160}
  };

  private WindowSizes() {}

  /**
   * Returns settings with the next larger window; after the largest the whole screen, after that
   * the smallest.
   *
   * @param screen width and height of the screen, px
   */
  static PlayerSettings next(PlayerSettings settings, int[] screen) {
    int least =
        settings.get(PlayerSettings.FULLSCREEN) ? 0 : settings.get(PlayerSettings.WINDOW).width();
    for (int[] size : SIZES) {
      if (size[0] > least && size[0] <= screen[0] && size[1] <= screen[1]) {
        return settings.withWindow(size[0], size[1]).with(PlayerSettings.FULLSCREEN, false);
      }
    }
    return settings.with(PlayerSettings.FULLSCREEN, !settings.get(PlayerSettings.FULLSCREEN));
  }
}
