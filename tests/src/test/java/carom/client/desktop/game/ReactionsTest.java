package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.Reaction;
import com.badlogic.gdx.math.Affine2;
import com.badlogic.gdx.math.Vector2;
import org.junit.jupiter.api.Test;

/** Goal: a struck body shows its blow and is itself again. Method: time passes by hand. */
final class ReactionsTest {
  private final Reactions.Shown shown = new Reactions.Shown();

  @Test
  void aBodyIsSqueezedByTheBlowsShareSpringsAndIsItself() {
    shown.begin(new Reaction().squash(0.4f).seconds(0.5f), 0, 0, 1, 0, 0.5f);
    assertEquals(0.2f, shown.squash(), 1e-6f);
    float least = 1;
    for (int i = 0; i < 60; i++) {
      shown.age(0.5f / 60);
      least = Math.min(least, shown.squash());
      assertTrue(Math.abs(shown.squash()) <= 0.2f);
    }
    assertTrue(least < -0.01f, "it springs: " + least);
    shown.age(0.01f);
    assertEquals(0, shown.squash());
    assertEquals(0, shown.flash());
  }

  @Test
  void aBodyIsHeldThenCatchesUpAndNeverIsFarFromItsPlace() {
    shown.begin(new Reaction().hold(0.1f), 5, 1, 0, 0, 1);
    shown.age(0.1f);
    assertEquals(5, shownAt(6.5f, 1, 6.5f, 1).x, 1e-6f, "it is where it was struck");
    assertEquals(88, shownAt(90, 1, 90, 1).x, 1e-5f);
    shown.age(0.05f);
    assertEquals(5.75f, shownAt(6.5f, 1, 6.5f, 1).x, 1e-5f, "half way");
    assertTrue(shown.isBent());
    shown.age(0.06f);
    assertEquals(new Vector2(6.5f, 9), shownAt(6.5f, 9, 6.5f, 9));
    assertFalse(shown.isBent());
  }

  @Test
  void aBodyIsShorterAlongTheBlowAndLongerAcrossItAndKeepsItsSize() {
    shown.begin(new Reaction().squash(0.5f), 3, 4, 0.6f, 0.8f, 1);
    assertEquals(3, shownAt(3, 4, 3, 4).x, 1e-6f, "its middle stays");
    Vector2 along = shownAt(3, 4, 3 + 0.6f, 4 + 0.8f).sub(3, 4);
    assertEquals(0, along.dst(0.3f, 0.4f), 1e-5f);
    Vector2 across = shownAt(3, 4, 3 - 0.8f, 4 + 0.6f).sub(3, 4);
    assertEquals(0, across.dst(-1.6f, 1.2f), 1e-5f);
    assertEquals(1, shown.bend(3, 4, new Affine2()).det(), 1e-5f);
    shown.begin(new Reaction().squash(0.5f), 0, 0, 0, 0, 1);
    assertEquals(0.5f, shownAt(0, 0, 0, 1).y, 1e-6f, "without a direction it is from above");
  }

  /** Returns where a point is shown of a body at a place. */
  private Vector2 shownAt(float x, float y, float pointX, float pointY) {
    Vector2 point = new Vector2(pointX, pointY);
    shown.bend(x, y, new Affine2()).applyTo(point);
    return point;
  }

  @Test
  void aBodyIsLitUpInTheColourThatFades() {
    shown.begin(new Reaction().flash(0xff123456).seconds(0.4f), 0, 0, 0, 1, 1);
    assertEquals(1, shown.flash());
    assertEquals(0x123456, shown.flashRgb());
    shown.age(0.3f);
    assertEquals(0.25f, shown.flash(), 1e-6f);
    shown.begin(new Reaction().squash(0.1f), 0, 0, 0, 1, 1);
    assertEquals(0, shown.flash(), "another reaction takes its place");
  }

  @Test
  void whatCanNotBeMeantIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Reaction().squash(0.91f));
    assertThrows(IllegalArgumentException.class, () -> new Reaction().hold(0.31f));
    assertThrows(IllegalArgumentException.class, () -> new Reaction().seconds(Float.NaN));
  }
}
