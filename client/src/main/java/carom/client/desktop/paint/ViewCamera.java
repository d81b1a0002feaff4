package carom.client.desktop.paint;

import carom.physics.math.Aabb;
import carom.sim.level.Level;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector3;

/**
 * The part of the level that the window shows. It is the whole level if that fits at a readable
 * size, or else a part that follows the player and stops at the level's edges. World units are
 * metres, y up. Render thread only.
 */
public final class ViewCamera {
  /** Smallest height shown while following, metres. */
  private static final float FOLLOW_HEIGHT_M = 16;

  /** Height up to which a level is always shown whole in height, metres. */
  private static final float WHOLE_HEIGHT_M = 30;

  /** Space around a level that is shown whole, in metres. */
  private static final float MARGIN_M = 0.6f;

  /** Rate at which the camera approaches the player, 1/s. */
  private static final float FOLLOW_PER_SECOND = 6;

  /** Rate at which the picture widens and narrows for all players, 1/s. */
  private static final float ZOOM_PER_SECOND = 2.5f;

  private final OrthographicCamera camera = new OrthographicCamera();
  private final Vector3 scratch = new Vector3();
  private boolean zooms;
  private boolean placed;
  private float shakeX;
  private float shakeY;

  /** Returns the toolkit's camera; the same object for ever. Change it only through this class. */
  public OrthographicCamera gdx() {
    return camera;
  }

  /** Returns the scale, pixels per metre. */
  public float pixelsPerMetre(int screenHeight) {
    return screenHeight / camera.viewportHeight;
  }

  /** Sets whether the height that is shown changes smoothly while a player is followed. */
  public void zooms(boolean smoothly) {
    zooms = smoothly;
  }

  /**
   * Fits the view to the window and moves it towards the players. Without a player to follow it
   * stays; before the first one it shows the whole level.
   *
   * @param subject what it shows, all of it; null if there is nobody to follow
   * @param least height that it shows then, metres; 0 for the usual
   */
  public void update(
      Level.Bounds bounds, Aabb subject, float least, int width, int height, float seconds) {
    boolean followed = subject != null;
    float levelWidth = bounds.maxX() - bounds.minX() + 2 * MARGIN_M;
    float levelHeight = bounds.maxY() - bounds.minY() + 2 * MARGIN_M;
    float aspect = width / (float) height;
    float whole = Math.max(levelHeight, levelWidth / aspect);
    boolean follows = placed || followed;
    camera.position.sub(shakeX, shakeY, 0);
    float size = followed ? Math.max(subject.height(), subject.width() / aspect) : 0;
    float near = follows ? near(whole, levelHeight, Math.max(least, size)) : whole;
    float zoom = zooms && placed ? 1 - (float) Math.exp(-ZOOM_PER_SECOND * seconds) : 1;
    camera.viewportHeight = MathUtils.lerp(camera.viewportHeight, near, zoom);
    camera.viewportWidth = camera.viewportHeight * aspect;

    float centerX = (bounds.minX() + bounds.maxX()) / 2;
    float centerY = (bounds.minY() + bounds.maxY()) / 2;
    float slackX = Math.max(0, (levelWidth - camera.viewportWidth) / 2);
    float slackY = Math.max(0, (levelHeight - camera.viewportHeight) / 2);
    float lookX =
        followed ? (subject.minX + subject.maxX) / 2 : placed ? camera.position.x : centerX;
    float lookY =
        followed ? (subject.minY + subject.maxY) / 2 : placed ? camera.position.y : centerY;
    float goalX = MathUtils.clamp(lookX, centerX - slackX, centerX + slackX);
    float goalY = MathUtils.clamp(lookY, centerY - slackY, centerY + slackY);
    float step = placed ? 1 - (float) Math.exp(-FOLLOW_PER_SECOND * seconds) : 1;
    camera.position.x = MathUtils.lerp(camera.position.x, goalX, step);
    camera.position.y = MathUtils.lerp(camera.position.y, goalY, step);
    camera.position.add(shakeX, shakeY, 0);
    placed |= followed;
    camera.update();
  }

  /** Returns whether all of a level is in the picture. */
  public boolean shows(Level.Bounds bounds) {
    return bounds.maxX() - bounds.minX() <= camera.viewportWidth
        && bounds.maxY() - bounds.minY() <= camera.viewportHeight;
  }

  /** Returns the height to show while a player is followed, metres. */
  private static float near(float whole, float levelHeight, float wanted) {
    if (wanted > 0) {
      return Math.min(whole, wanted);
    }
    return whole <= WHOLE_HEIGHT_M ? whole : Math.min(levelHeight, FOLLOW_HEIGHT_M);
  }

  /** Moves the picture for a moment, metres; {@link #update} goes on from where it was. */
  public void shake(float x, float y) {
    camera.position.add(x - shakeX, y - shakeY, 0);
    shakeX = x;
    shakeY = y;
    camera.update();
  }

  /** Shows at least a rectangle of metres around a point, in a window of any shape. */
  public void fit(
      float x, float y, float widthM, float heightM, int screenWidth, int screenHeight) {
    float aspect = screenWidth / (float) screenHeight;
    camera.viewportHeight = Math.max(heightM, widthM / aspect);
    camera.viewportWidth = camera.viewportHeight * aspect;
    camera.position.set(x, y, 0);
    camera.update();
  }

  /** Keeps height and centre when the window changes its shape. */
  public void resize(int screenWidth, int screenHeight) {
    camera.viewportWidth = camera.viewportHeight * screenWidth / screenHeight;
    camera.update();
  }

  /** Moves the picture from one pixel to another (origin top left). */
  public void pan(float fromX, float fromY, float toX, float toY) {
    Vector3 from = toWorld(fromX, fromY);
    float x = from.x;
    float y = from.y;
    Vector3 to = toWorld(toX, toY);
    camera.position.add(x - to.x, y - to.y, 0);
    camera.update();
  }

  /** Shows {@code factor} times as many metres, with the same point under a pixel. */
  public void zoom(float screenX, float screenY, float factor) {
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

  /** Returns the world position under a pixel (origin top left). The result is reused. */
  public Vector3 toWorld(float screenX, float screenY) {
    return camera.unproject(scratch.set(screenX, screenY, 0));
  }

  /** Returns the pixel (origin bottom left) of a world position. The result is reused. */
  public Vector3 toScreen(float x, float y) {
    return camera.project(scratch.set(x, y, 0));
  }
}
