package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: each event is heard once over all links, also when the room has gone back a little. */
class RepeatedEventFilterTest {
  private final RepeatedEventFilter filter = new RepeatedEventFilter();

  private int heard(int... ticks) {
    int heard = 0;
    for (int tick : ticks) {
      heard += filter.accept(tick, 0) ? 1 : 0;
    }
    return heard;
  }

  @Test
  void anotherLinkOfTheSameRunRepeatsWhatWasHeard() {
    filter.beginLink("cup", 1, 7, 0);
    assertEquals(3, heard(10, 12, 12));
    filter.beginLink("cup", 1, 7, 40);
    assertEquals(2, heard(10, 12, 12, 12, 13), "the third of tick 12, and tick 13");
  }

  @Test
  void aResumedRoomsTicksAfterTheCourseTickAreNew() {
    filter.beginLink("cup", 1, 7, 0);
    assertEquals(4, heard(10, 12, 20, 25));
    filter.beginLink("cup", 1, 8, 12);
    assertFalse(filter.accept(10, 0), "heard over the old course");
    assertFalse(filter.accept(12, 0), "the course tick belongs to both");
    assertFalse(filter.accept(12, 0));
    assertTrue(filter.accept(13, 0), "a rewound tick");
    assertTrue(filter.accept(20, 0), "it happens again, otherwise");
    filter.beginLink("cup", 1, 8, 12);
    assertEquals(1, heard(10, 12, 13, 20, 21), "the same run once more");
  }

  @Test
  void aResumedRoomThatHasGoneBackToALaterTickRepeatsAsBefore() {
    filter.beginLink("cup", 1, 7, 0);
    assertEquals(2, heard(10, 12));
    filter.beginLink("cup", 1, 8, 30);
    assertEquals(2, heard(10, 12, 12, 31), "what the lost link didn't bring, and what is new");
  }

  @Test
  void anotherMatchOrRoomBeginsAnew() {
    filter.beginLink("cup", 1, 7, 0);
    assertEquals(1, heard(100));
    filter.beginLink("cup", 2, 7, 5);
    assertEquals(1, heard(6));
    filter.beginLink("jump", 2, 7, 5);
    assertEquals(1, heard(6));
  }
}
