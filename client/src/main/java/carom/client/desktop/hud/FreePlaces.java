package carom.client.desktop.hud;

import java.util.Arrays;

/** The rectangles of the screen that are taken, in points. Render thread only. */
final class FreePlaces {
  private static final int SIDES = 4;

  private float[] taken = new float[16 * SIDES];
  private int count;

  /** Makes everything free again. */
  void clear() {
    count = 0;
  }

  /** Returns whether nothing of a rectangle is taken. */
  boolean isFree(float x, float y, float width, float height) {
    return at(x, y, width, height) < 0;
  }

  /** Returns the number of a taken rectangle that has a part of this one, or -1 for none. */
  int at(float x, float y, float width, float height) {
    for (int i = 0; i < count; i++) {
      int at = i * SIDES;
      if (x < taken[at + 2]
          && taken[at] < x + width
          && y < taken[at + 3]
          && taken[at + 1] < y + height) {
        return i;
      }
    }
    return -1;
  }

  /** Returns the lower edge of a taken rectangle. */
  float bottom(int number) {
    return taken[number * SIDES + 1];
  }

  /** Returns the upper edge of a taken rectangle. */
  float top(int number) {
    return taken[number * SIDES + 3];
  }

  /** Takes a rectangle, whether or not it is free. */
  void take(float x, float y, float width, float height) {
    if ((count + 1) * SIDES > taken.length) {
      taken = Arrays.copyOf(taken, 2 * taken.length);
    }
    int at = count++ * SIDES;
    taken[at] = x;
    taken[at + 1] = y;
    taken[at + 2] = x + width;
    taken[at + 3] = y + height;
  }
}
