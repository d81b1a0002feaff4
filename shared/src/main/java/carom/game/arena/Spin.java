package carom.game.arena;

import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;

/**
 * The spin of discs and balls; both roles, so that clients predict it. A disc that spins turns the
 * ball it touches the other way, as gears do, and pushes it nowhere but ahead. Such a ball curves
 * as the Magnus force bends its way: F = S (w x v), at a right angle to the velocity, so that it
 * makes no ball faster (R. D. Mehta, Aerodynamics of Sports Balls, Annual Review of Fluid Mechanics
 * 17, 1985). Friction at a wall turns a fast spin into speed along the wall; that is the engine's.
 *
 * <p>Here S = m {@value #CURVE} (1 - {@value #ROLL} / |w|): what a ball gets by rolling along walls
 * and discs, at most 17.6 rad/s in six minutes of bots, bends nothing. So only who wants a curve
 * has one. The acceleration is at most {@value #CURVE} ({@value #MOST} - {@value #ROLL}) v.
 */
final class Spin {
  /** Turning speed of a disc that spins, rad/s. Discs that face their way turn by 14 at most. */
  static final float DISC = 30;

  /** Turning speed that a ball takes on from a disc that spins, rad/s. */
  static final float BALL = 50;

  /** Turning speed below which a ball flies straight, rad/s. */
  static final float ROLL = 20;

  private static final float MOST = 60; // rad/s; a faster spin bends no more
  private static final float CURVE = 0.06f; // turns of the way for each turn beyond ROLL

  private final EntityContactVisitor touch = this::touched;
  private float given; // by the disc that the ball touches; scratch

  /** Turns a ball as a disc that it touches spins, and bends the way of a ball that spins. */
  void forces(Entity ball) {
    given = 0;
    ball.forEachContact(touch);
    if (given != 0) {
      ball.setAngularVelocity(given);
    }
    float w = ball.angularVelocity();
    float spare = Math.min(MOST, Math.abs(w)) - ROLL;
    if (spare > 0) {
      float rate = CURVE * ball.mass() * (w > 0 ? spare : -spare);
      ball.applyForce(-rate * ball.velocityY(), rate * ball.velocityX());
    }
  }

  /** Lets a disc that spins push no ball to the side: else that would undo the curve. */
  void collision(Contact c) {
    if (spins(c.self()) || spins(c.other())) {
      c.setFriction(0);
    }
  }

  private static boolean spins(Entity e) {
    return e.isOwned() && Math.abs(e.angularVelocity()) > ROLL;
  }

  private void touched(Entity other, float normalX, float normalY, float impulse) {
    if (impulse > 0 && spins(other)) {
      given = other.angularVelocity() > 0 ? -BALL : BALL;
    }
  }
}
