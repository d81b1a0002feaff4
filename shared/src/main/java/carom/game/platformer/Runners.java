package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.CAN_JUMP;
import static carom.game.platformer.PlatformerFields.DROPS;
import static carom.game.platformer.PlatformerFields.JUMPING;
import static carom.game.platformer.PlatformerFields.WANTS_JUMP;

import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Ground;
import carom.sim.entity.Input;
import carom.sim.entity.Player;

/** Running, jumping and dropping through platforms; both roles. */
final class Runners {
  private static final float GROUND_STEER = 16; // k / mass, 1/s
  private static final float AIR_STEER = 6;
  private static final float AIR_DRAG = 2; // 1/s, without a direction

  /** Extra gravity while a player rises with the button released, m/s^2. */
  private static final float CUT_GRAVITY = 30;

  private static final float COYOTE_SECONDS = 0.1f;
  private static final float BUFFER_SECONDS = 0.12f;
  private static final float DROP_SECONDS = 0.2f;

  private final Course course;

  Runners(Course course) {
    this.course = course;
  }

  /** Forgets what a player did with the body that it had before. */
  static void reset(Player p) {
    p.set(CAN_JUMP, 0);
    p.set(WANTS_JUMP, 0);
    p.set(DROPS, 0);
    p.set(JUMPING, false);
  }

  /** Moves a player as it commands. */
  void move(Simulation s, Player p, Input in) {
    Entity body = p.entity();
    Ground ground = body.ground();
    boolean rises = p.get(JUMPING) && body.velocityY() > ground.velocityY();
    boolean grounded = ground.isThere() && !rises;
    jump(s, p, in, ground, grounded, rises);
    run(body, in, ground, grounded);
  }

  private void jump(
      Simulation s, Player p, Input in, Ground ground, boolean grounded, boolean rises) {
    boolean jumping = rises;
    if (grounded) {
      p.set(CAN_JUMP, s.ticks(COYOTE_SECONDS));
    } else {
      p.add(CAN_JUMP, -1);
    }
    if (in.pressed(Input.JUMP)) {
      p.set(WANTS_JUMP, s.ticks(BUFFER_SECONDS));
    }
    boolean down = in.held(Input.DOWN) || in.moveY() < -0.6f;
    if (down && grounded && ground.entity().archetype().oneWay()) {
      p.set(DROPS, s.ticks(DROP_SECONDS));
      p.set(CAN_JUMP, 0);
    }
    Entity body = p.entity();
    if (p.get(WANTS_JUMP) > 0 && p.get(CAN_JUMP) > 0) {
      p.set(WANTS_JUMP, 0);
      p.set(CAN_JUMP, 0);
      jumping = true;
      body.setVelocity(
          body.velocityX(), PlatformerGame.JUMP_SPEED + Math.max(0, ground.velocityY()));
      float feet = body.y() - PlatformerGame.PLAYER_HEIGHT / 2;
      s.emit(course.jumpEvent).at(body.x(), feet).of(p.entity()).by(p);
    } else if (jumping && !in.held(Input.JUMP)) {
      body.applyForce(0, -CUT_GRAVITY * body.mass());
    }
    p.set(JUMPING, jumping);
  }

  private static void run(Entity body, Input in, Ground ground, boolean grounded) {
    float steer = grounded ? GROUND_STEER : in.moveX() == 0 ? AIR_DRAG : AIR_STEER;
    float goal = in.moveX() * PlatformerGame.SPEED + ground.velocityX();
    body.applyForce(steer * body.mass() * (goal - body.velocityX()), 0);
    if (body.velocityY() < -PlatformerGame.MAX_FALL) {
      body.setVelocity(body.velocityX(), -PlatformerGame.MAX_FALL);
    }
  }

  /** Returns whether an entity is a player that drops through a one-way platform now. */
  static boolean drops(Entity rider, Entity platform) {
    if (!platform.archetype().oneWay()) {
      return false;
    }
    Player p = rider.owner();
    return p != null && p.entity() == rider && p.get(DROPS) > 0;
  }
}
