package carom.client.desktop.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a part that throws costs itself, and people hear of each thing that is wrong with it. */
class PicturePartsTest {
  private final List<String> told = new ArrayList<>();
  private final PictureParts parts = new PictureParts(() -> {}, told::add);
  private int runs;

  private void run(String mistake) {
    parts.run(
        "map",
        () -> {
          runs++;
          if (mistake != null) {
            throw new IllegalStateException(mistake);
          }
        });
  }

  @Test
  void aPartThatThrowsIsLeftOutUntilAllAreTriedAgain() {
    run("one");
    run(null);
    assertTrue(parts.isBroken("map"));
    assertEquals(1, runs);
    parts.renew();
    run(null);
    assertFalse(parts.isBroken("map"));
    assertEquals(2, runs);
  }

  @Test
  void eachFailureIsToldOnce() {
    for (String mistake : List.of("one", "one", "two", "one")) {
      run(mistake);
      parts.renew();
    }
    assertEquals(4, runs);
    assertEquals(2, told.size(), told::toString);
  }
}
