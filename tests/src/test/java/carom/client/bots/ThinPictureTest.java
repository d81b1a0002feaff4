package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: a bot says only of what it keeps that it has seen it. Method: messages out of order. */
final class ThinPictureTest {
  @Test
  void aSnapshotBeforeTheMatchIsNotSeen() {
    ThinPicture picture = new ThinPicture();
    assertFalse(picture.snapshot(7, 1, -1, 0));
    assertEquals(-1, picture.wholeTick());
    picture.match(3, "");
    assertTrue(picture.snapshot(8, 1, -1, 1));
    picture.body(5, 1, 2, 0, 0, 3);
    assertEquals(8, picture.wholeTick());
    assertEquals(1, picture.shown().bodies().size());
    assertEquals(0, picture.errors());
  }
}
