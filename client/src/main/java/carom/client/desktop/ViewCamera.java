package carom.client.desktop;

import carom.client.GameClient;
import carom.sim.level.Level;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector3;

/**
 * Which part of the level the window shows: all of it when it fits at a readable size, else a part
 * that follows the player and stops at the level's edges. World units are metres, y up. Render
 * thread only.
 */
final class ViewCamera {
  /** Smallest height shown, in metres, when following. */
  private static final float FOLLOW_HEIGHT_M = 16;

  /** A level up to this height is always shown whole in height. */
  private static final float WHOLE_HEIGHT_M = 30;

  /** Space around a level that is shown whole, in metres. */
  private static final float MARGIN_M = 0.6f;

  /** How fast the camera closes in on the player: share of the distance per second, as a rate. */
  private static final float FOLLOW_PER_SECOND = 6;

  private final OrthographicCamera camera = new OrthographicCamera();
  private final Vector3 scratch = new Vector3();
  private boolean placed;

  OrthographicCamera gdx() {
    return camera;
  }

  /** Whether there ever was somebody to follow; spectators have nobody. */
  boolean hasFollowed() {
    return placed;
  }

  /** Tells the client what is shown. */
  void tell(GameClient client) {
    client.look(camera.position.x, camera.position.y, camera.viewportWidth, camera.viewportHeight);
  }

  /** Pixels per metre. */
  float pixelsPerMetre(int screenHeight) {
    return screenHeight / camera.viewportHeight;
  }

  /**
   * Fits the view to the window and moves it towards the player; with nobody to follow it stays,
   * and before there ever was anybody it shows the whole level.
   */
  void update(
      Level.Bounds bounds,
      boolean followed,
      float x,
      float y,
      int width,
      int height,
      float seconds) {
    float levelWidth = bounds.maxX() - bounds.minX() + 2 * MARGIN_M;
    float levelHeight = bounds.maxY() - bounds.minY() + 2 * MARGIN_M;
    float aspect = width / (float) height;
    float whole = Math.max(levelHeight, levelWidth / aspect);
    boolean follows = placed || followed;
    float shown =
        whole <= WHOLE_HEIGHT_M || !follows ? whole : Math.min(levelHeight, FOLLOW_HEIGHT_M);
    camera.viewportHeight = shown;
    camera.viewportWidth = shown * aspect;

    float centerX = (bounds.minX() + bounds.maxX()) / 2;
    float centerY = (bounds.minY() + bounds.maxY()) / 2;
    float slackX = Math.max(0, (levelWidth - camera.viewportWidth) / 2);
    float slackY = Math.max(0, (levelHeight - camera.viewportHeight) / 2);
    float lookX = followed ? x : placed ? camera.position.x : centerX;
    float lookY = followed ? y : placed ? camera.position.y : centerY;
    float goalX = MathUtils.clamp(lookX, centerX - slackX, centerX + slackX);
    float goalY = MathUtils.clamp(lookY, centerY - slackY, centerY + slackY);
    float step = placed ? 1 - (float) Math.exp(-FOLLOW_PER_SECOND * seconds) : 1;
    camera.position.x = MathUtils.lerp(camera.position.x, goalX, step);
    camera.position.y = MathUtils.lerp(camera.position.y, goalY, step);
    placed |= followed;
    camera.update();
  }

  /** Shows at least a rectangle of metres around a point, whatever the window's shape. */
  void fit(float x, float y, float widthM, float heightM, int screenWidth, int screenHeight) {
    float aspect = screenWidth / (float) screenHeight;
    camera.viewportHeight = Math.max(heightM, widthM / aspect);
    camera.viewportWidth = camera.viewportHeight * aspect;
    camera.position.set(x, y, 0);
    camera.update();
  }

  /** Keeps height and centre when the window changes its shape. */
  void resize(int screenWidth, int screenHeight) {
    camera.viewportWidth = camera.viewportHeight * screenWidth / screenHeight;
    camera.update();
  }

  /** Moves the picture from one pixel to another (origin top left). */
  void pan(float fromX, float fromY, float toX, float toY) {
    Vector3 from = toWorld(fromX, fromY);
    float x = from.x;
    float y = from.y;
    Vector3 to = toWorld(toX, toY);
    camera.position.add(x - to.x, y - to.y, 0);
    camera.update();
  }

  /** Shows {@code factor} times as many metres, with the same point under a pixel. */
  void zoom(float screenX, float screenY, float factor) {
    Vector3 at = toWorld(screenX, screenY);
    float x = at.x;
    float y = at.y;
    float height = MathUtils.clamp(camera.viewportHeight * factor, 0.05f, 1e4f);
    factor = height / camera.viewportHeight;
    camera.viewportHeight = height;
    camera.viewportWidth *= factor;
    camera.position.set(
        x + (camera.position.x - x) * factor, y + (camera.position.y - y) * factor, 0);
    camera.update();
  }

  /** World position under a pixel (origin top left, as devices report it). The result is reused. */
  Vector3 toWorld(float screenX, float screenY) {
    return camera.unproject(scratch.set(screenX, screenY, 0));
  }

  /** Pixel (origin bottom left, as the HUD draws) of a world position. The result is reused. */
  Vector3 toScreen(float x, float y) {
    return camera.project(scratch.set(x, y, 0));
  }
}
