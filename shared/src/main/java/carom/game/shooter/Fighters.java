package carom.game.shooter;

import static carom.game.shooter.ShooterFields.AIR_JUMP;
import static carom.game.shooter.ShooterFields.DROPS;
import static carom.game.shooter.ShooterFields.GROUNDED;
import static carom.game.shooter.ShooterFields.JUMPING;
import static carom.game.shooter.ShooterFields.WANTS_JUMP;

import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Ground;
import carom.sim.entity.Input;
import carom.sim.entity.Player;

/** Running, jumping twice, dropping through platforms and being thrown; both roles. */
final class Fighters {
  private static final float GROUND_STEER = 16; // k / mass, 1/s
  private static final float AIR_STEER = 8;
  private static final float AIR_DRAG = 1.5f; // 1/s, without a direction

  /** Steering of a player who is faster than it can run: a blow throws it before it finds hold. */
  private static final float THROWN_STEER = 2;

  private static final float THROWN_SPEED = ShooterGame.SPEED + 1;

  /** Extra gravity while a player rises with the button released, m/s^2. */
  private static final float CUT_GRAVITY = 30;

  private static final float COYOTE_SECONDS = 0.1f;
  private static final float BUFFER_SECONDS = 0.12f;
  private static final float DROP_SECONDS = 0.22f;

  private final Stage stage;

  Fighters(Stage stage) {
    this.stage = stage;
  }

  /** Moves a player as it commands. */
  void move(Simulation s, Player p, Input in) {
    Entity body = p.entity();
    Ground ground = body.ground();
    boolean rises = p.get(JUMPING) && body.velocityY() > ground.velocityY();
    if (rises) {
      p.set(GROUNDED, 0);
    }
    boolean mayJump = !rises && ground.isThereWithin(p, GROUNDED, s.ticks(COYOTE_SECONDS));
    boolean stands = ground.isThere() && !rises;
    if (stands) {
      p.set(AIR_JUMP, true);
    }
    if (in.pressed(Input.JUMP)) {
      p.set(WANTS_JUMP, s.ticks(BUFFER_SECONDS));
    }
    boolean down = in.held(Input.DOWN) || in.moveY() < -0.6f;
    if (down && stands && ground.entity().archetype().oneWay()) {
      p.set(DROPS, s.ticks(DROP_SECONDS));
      p.set(GROUNDED, 0);
    } else if (p.get(WANTS_JUMP) > 0 && (mayJump || (in.pressed(Input.JUMP) && p.get(AIR_JUMP)))) {
      p.set(AIR_JUMP, mayJump);
      p.set(WANTS_JUMP, 0);
      p.set(GROUNDED, 0);
      rises = true;
      body.setVelocity(body.velocityX(), ShooterGame.JUMP_SPEED + Math.max(0, ground.velocityY()));
      s.emit(stage.jump).at(body.x(), body.y() - ShooterGame.PLAYER_HEIGHT / 2).of(body).by(p);
    } else if (rises && !in.held(Input.JUMP)) {
      body.applyForce(0, -CUT_GRAVITY * body.mass());
    }
    p.set(JUMPING, rises);
    run(body, in, ground, stands);
  }

  private static void run(Entity body, Input in, Ground ground, boolean stands) {
    float speed = body.velocityX() - ground.velocityX();
    float goal = in.moveX() * ShooterGame.SPEED;
    float steer = stands ? GROUND_STEER : in.moveX() == 0 ? AIR_DRAG : AIR_STEER;
    if (Math.abs(speed) > THROWN_SPEED) {
      steer = THROWN_STEER;
    }
    body.applyForce(steer * body.mass() * (goal - speed), 0);
    if (body.velocityY() < -ShooterGame.MAX_FALL) {
      body.setVelocity(body.velocityX(), -ShooterGame.MAX_FALL);
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
