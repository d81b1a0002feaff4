package carom.client.desktop.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Goal: names don't cover each other and don't flicker. Method: two or more that walk about. */
class NameRowsTest {
  private static final float WIDTH = 50;

  private final FreePlaces places = new FreePlaces();
  private final NameRows names = new NameRows(places, 8);

  /** The second's row, when the first stands at 0 and it so far to the right. */
  private int secondAt(float x) {
    places.clear();
    assertEquals(100, names.top(0, 0, 100, WIDTH));
    return Math.round((names.top(1, x, 100, WIDTH) - 100) / NameRows.LINE);
  }

  @Test
  void aNameGoesUpWhereItMustAndDownWhereThereIsRoom() {
    assertEquals(0, secondAt(200));
    assertEquals(1, secondAt(30));
    assertEquals(0, secondAt(200));
  }

  @Test
  void twoWhoWalkSideBySideKeepTheirRows() {
    SplittableRandom random = new SplittableRandom(5);
    float touch = WIDTH + 6; // names and the gap between them
    int changes = 0;
    int before = secondAt(touch + 40);
    for (int i = 0; i < 1_000; i++) {
      int row = secondAt(touch - 4 + 8 * (float) random.nextDouble());
      changes += row == before ? 0 : 1;
      before = row;
    }
    assertEquals(1, changes);
  }

  @Test
  void theFourthInOnePlaceIsNotWritten() {
    for (int player = 0; player < NameRows.ROWS; player++) {
      assertEquals(100 + player * NameRows.LINE, names.top(player, 0, 100, WIDTH));
    }
    assertTrue(Float.isNaN(names.top(NameRows.ROWS, 0, 100, WIDTH)));
  }
}
