package carom.client.desktop.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.Aabb;
import carom.sim.level.Level;
import com.badlogic.gdx.utils.GdxNativesLoader;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Goal: the window shows what a look asks for, and never beyond the level where it can help it. */
final class ViewCameraTest {
  private static final Level.Bounds LARGE = new Level.Bounds(-100, -50, 100, 50);
  private static final float FRAME = 1 / 60f;

  private final ViewCamera camera = new ViewCamera();
  private float least;

  @BeforeAll
  static void load() {
    GdxNativesLoader.load(); // the toolkit multiplies matrices in C
  }

  private void settle(Aabb subject) {
    for (int i = 0; i < 600; i++) {
      camera.update(LARGE, subject, least, 1_600, 900, FRAME);
    }
  }

  private static Aabb point(float x, float y) {
    return new Aabb(x, y, x, y);
  }

  @Test
  void aHeightIsShownAroundThePlayer() {
    settle(point(10, 5));
    assertEquals(16, camera.gdx().viewportHeight, 1e-3f, "the usual");
    least = 24;
    settle(point(10, 5));
    assertEquals(24, camera.gdx().viewportHeight, 1e-3f);
    assertEquals(10, camera.gdx().position.x, 1e-2f);
    least = 200;
    settle(point(10, 5));
    assertTrue(camera.gdx().viewportWidth <= 203, "no more than the level");
  }

  @Test
  void allPlayersAreInThePictureWhereverTheyAre() {
    least = 12;
    camera.zooms(true);
    SplittableRandom random = new SplittableRandom(8);
    for (int i = 0; i < 50; i++) {
      Aabb all = point((float) random.nextDouble(-99, 99), (float) random.nextDouble(-49, 49));
      all.add((float) random.nextDouble(-99, 99), (float) random.nextDouble(-49, 49));
      settle(new Aabb().set(all).grow(4));
      float halfWidth = camera.gdx().viewportWidth / 2;
      float halfHeight = camera.gdx().viewportHeight / 2;
      float x = camera.gdx().position.x;
      float y = camera.gdx().position.y;
      assertTrue(x - halfWidth < all.minX && all.maxX < x + halfWidth, all + " at x=" + x);
      assertTrue(y - halfHeight < all.minY && all.maxY < y + halfHeight, all + " at y=" + y);
      assertTrue(camera.gdx().viewportHeight >= 12 - 1e-3f);
    }
  }

  @Test
  void aRectangleIsShownWholeAndTheWayToItIsSmooth() {
    camera.zooms(true);
    settle(point(10, 5));
    Aabb zone = new Aabb(30, -20, 70, 4);
    float before = camera.gdx().viewportHeight;
    camera.update(LARGE, zone, least, 1_600, 900, FRAME);
    assertTrue(camera.gdx().viewportHeight < before + 1, "the picture jumped");
    settle(zone);
    assertEquals(24, camera.gdx().viewportHeight, 1e-2f);
    assertEquals(50, camera.gdx().position.x, 1e-2f);
    assertEquals(-8, camera.gdx().position.y, 1e-2f);
  }

  @Test
  void aShakeLeavesNoTrace() {
    settle(point(10, 5));
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 1_000; i++) {
      camera.update(LARGE, point(10, 5), least, 1_600, 900, FRAME);
      camera.shake((float) random.nextDouble(-2, 2), (float) random.nextDouble(-2, 2));
    }
    camera.shake(0, 0);
    assertEquals(10, camera.gdx().position.x, 1e-2f);
    assertEquals(5, camera.gdx().position.y, 1e-2f);
  }
}
