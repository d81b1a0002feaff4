package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.physics.particles.ParticleDef;
import carom.physics.particles.Particles;
import carom.sim.pool.Pools;
import carom.sim.pool.ShownParticles;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;

/**
 * Draws water and sand: a dark rim around the whole, and the particles on it, the faster the
 * lighter, like foam. Render thread only; about 0.3 us a particle.
 */
final class PoolPainter {
  /** Size of a particle's rim and of the particle, in spacings. */
  private static final float RIM = 1.9f;

  private static final float SIZE = 1.6f;

  /** Size in pixels below which a square does for a disc. */
  private static final float SMALL_PX = 5;

  /** Speed, m/s, at which water is all foam. */
  private static final float FOAM_M_S = 9;

  private static final float MOST_FOAM = 0.75f;

  private final Canvas canvas;
  private final Color color = new Color();
  private float left;
  private float right;
  private float low;
  private float high;
  private float pixelsPerMetre;

  PoolPainter(Canvas canvas) {
    this.canvas = canvas;
  }

  /** Draws what the camera sees of all pools. */
  void draw(Pools pools, OrthographicCamera camera, float newPixelsPerMetre) {
    pixelsPerMetre = newPixelsPerMetre;
    float halfWidth = 0.5f * camera.viewportWidth * camera.zoom;
    float halfHeight = 0.5f * camera.viewportHeight * camera.zoom;
    left = camera.position.x - halfWidth;
    right = camera.position.x + halfWidth;
    low = camera.position.y - halfHeight;
    high = camera.position.y + halfHeight;
    for (int i = 0; i < pools.shown().size(); i++) {
      ShownParticles some = pools.shown().get(i);
      paint(some, RIM, 0.62f, false);
      paint(some, SIZE, 1, true);
    }
  }

  private void paint(ShownParticles some, float spacings, float brightness, boolean foams) {
    Particles all = some.particles();
    boolean water = all.kind() == ParticleDef.Kind.WATER;
    float size = spacings * all.spacing();
    boolean small = size * pixelsPerMetre < SMALL_PX;
    for (int i = 0; i < all.count(); i++) {
      float x = all.x(i);
      float y = all.y(i);
      if (x < left - size || x > right + size || y < low - size || y > high + size) {
        continue;
      }
      UiColours.shade(some.rgb(), brightness, 1, color);
      if (foams && water) {
        float speed = Math.abs(all.velocityX(i)) + Math.abs(all.velocityY(i));
        color.lerp(1, 1, 1, 1, Math.min(MOST_FOAM, speed / FOAM_M_S));
      } else if (foams && all.id(i) % 3 == 0) {
        UiColours.shade(some.rgb(), 0.88f, 1, color); // grains
      }
      if (small) {
        canvas.rect(x - size / 2, y - size / 2, size, size, color);
      } else {
        canvas.disc(x, y, size / 2, color);
      }
    }
  }
}
