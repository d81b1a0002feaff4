package carom.game.platformer;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.sim.entity.HostEntity;

/** The body that a player stands on; of several, the one that bears most. Scratch, no state. */
final class Ground {
  /**
   * Largest upward part of the normal from the player to a contact that counts as ground: slopes up
   * to 53 degrees. The player's bevelled edge (50 degrees) counts, or a player wedged between
   * crates could not jump.
   */
  private static final float MAX_NORMAL = -0.6f;

  private final BodyContactVisitor<HostEntity> visitor = this::visit;
  private float impulse;
  private float velocityX;
  private float velocityY;
  private boolean oneWay;

  /** Looks below a body. */
  void find(Body<HostEntity> body) {
    impulse = 0;
    velocityX = 0;
    velocityY = 0;
    oneWay = false;
    body.forEachContact(visitor);
  }

  private void visit(Body<HostEntity> other, float normalX, float normalY, float pressure) {
    if (normalY < MAX_NORMAL && pressure > impulse) {
      impulse = pressure;
      velocityX = other.velocityX();
      velocityY = other.velocityY();
      oneWay = other.user().archetype().oneWay();
    }
  }

  /** Returns whether there is any. */
  boolean bears() {
    return impulse > 0;
  }

  /** Returns whether it is a one-way platform. */
  boolean isOneWay() {
    return oneWay;
  }

  /** Returns how fast it moves to the right, m/s; 0 without ground. */
  float velocityX() {
    return velocityX;
  }

  /** Returns how fast it moves upwards, m/s; 0 without ground. */
  float velocityY() {
    return velocityY;
  }
}
