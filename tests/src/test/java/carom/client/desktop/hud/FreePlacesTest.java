package carom.client.desktop.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Goal: nothing is written where something stands. Method: random whole-numbered rectangles against
 * a picture of their pixels.
 */
class FreePlacesTest {
  private static final int SIZE = 40;

  @Test
  void whatIsFreeHasNoPixelThatIsTaken() {
    SplittableRandom random = new SplittableRandom(3);
    FreePlaces places = new FreePlaces();
    for (int round = 0; round < 50; round++) {
      places.clear();
      boolean[] taken = new boolean[SIZE * SIZE];
      for (int i = 0; i < 40; i++) {
        int x = random.nextInt(SIZE - 8);
        int y = random.nextInt(SIZE - 8);
        int width = 1 + random.nextInt(8);
        int height = 1 + random.nextInt(8);
        boolean free = true;
        for (int at = 0; at < width * height; at++) {
          free &= !taken[(y + at / width) * SIZE + x + at % width];
        }
        assertEquals(free, places.isFree(x, y, width, height), "round=" + round + " i=" + i);
        if (free || random.nextInt(4) == 0) {
          places.take(x, y, width, height);
          for (int at = 0; at < width * height; at++) {
            taken[(y + at / width) * SIZE + x + at % width] = true;
          }
        }
      }
    }
  }
}
