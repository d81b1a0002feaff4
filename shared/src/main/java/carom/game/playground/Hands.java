package carom.game.playground;

import static carom.game.playground.PlaygroundFields.AT_X;
import static carom.game.playground.PlaygroundFields.AT_Y;
import static carom.game.playground.PlaygroundFields.DRIVE;
import static carom.game.playground.PlaygroundFields.GRABS;
import static carom.game.playground.PlaygroundFields.HELD;
import static carom.game.playground.PlaygroundFields.HOLDER;
import static carom.game.playground.PlaygroundFields.KEEPER;
import static carom.game.playground.PlaygroundFields.MOTOR;
import static carom.game.playground.PlaygroundFields.REACH;
import static carom.game.playground.PlaygroundFields.SAFE;
import static carom.game.playground.PlaygroundFields.THINGS;

import carom.physics.JointType;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityFilter;
import carom.sim.entity.EntityHit;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import java.util.function.Consumer;

/**
 * The deeds of players and their robots: they fly, grab, turn, throw, make and drive. Both roles,
 * so a player sees all of it at once.
 *
 * <p>The beam is a damped spring from the held point to a point before the robot. It is a force of
 * {@code input}, and no joint: a joint has a number that only the server can give, and solving
 * follows the order of these numbers.
 */
final class Hands {
  private static final float FLY_RATE = 7; // 1/s
  private static final float NEAREST = 1.9f; // at which a thing is held, m
  private static final float FURTHEST = 4.5f;
  private static final float SLIP = 4; // distance between hand and aim at which a thing slips, m
  private static final float STIFFNESS = 480; // 1/s^2
  private static final float DAMPING = 34; // 1/s
  private static final float MAX_FORCE = 450; // N
  private static final float STEADY = 12; // 1/s, by which a held thing stops turning
  private static final float TURN = 4; // rad/s, of a thing that the player turns
  private static final float THROW = 17; // m/s
  private static final float MAX_THROW = 45; // N s
  private static final float PLACE = 2; // where a thing is made, m
  private static final float MOTOR_SPEED = 16; // rad/s

  /** Greatest torque of a motor, N m. */
  static final float TORQUE = 30;

  private static final Circle GRIP = new Circle(0.25f);
  private static final Circle ROOM = new Circle(0.45f);

  private final Yard yard;
  private final EntityHit hit = new EntityHit();
  private final EntityFilter seen;
  private final Consumer<EntityJoint> drive = this::drive;
  private float spin; // scratch

  Hands(Yard yard) {
    this.yard = yard;
    seen = e -> !yard.isRobot(e);
  }

  /** Acts for a tick. */
  void input(Simulation s, Player p, Input in) {
    Entity robot = p.entity();
    robot.seekVelocity(
        in.moveX() * PlaygroundGame.SPEED, in.moveY() * PlaygroundGame.SPEED, FLY_RATE);
    float aimX = Trig.cos(in.aim());
    float aimY = Trig.sin(in.aim());
    if (!in.held(Input.ACTION)) {
      release(p);
    } else if (in.pressed(Input.ACTION)) {
      grab(s, p, aimX, aimY);
    }
    make(s, p, in, aimX, aimY);
    Entity held = p.get(HELD); // null, too, where a client doesn't know it
    if (held != null && in.pressed(Input.SECOND)) {
      float push = Math.min(held.mass() * THROW, MAX_THROW);
      held.applyImpulse(push * aimX, push * aimY);
      s.emit(yard.thrown).at(held.x(), held.y()).of(held).by(p).strength(push);
      release(p);
      held = null;
    }
    float x = robot.x() + aimX;
    float y = robot.y() + aimY;
    if (held != null) {
      float turn = (in.held(Input.UP) ? 1 : 0) - (in.held(Input.DOWN) ? 1 : 0);
      pull(s, p, held, aimX, aimY, turn * TURN);
      x = held.worldPointX(p.get(AT_X), p.get(AT_Y));
      y = held.worldPointY(p.get(AT_X), p.get(AT_Y));
    }
    Entity hand = robot.part("hand");
    if (hand != null) {
      hand.setVelocity((x - hand.x()) * s.tickRate(), (y - hand.y()) * s.tickRate());
    }
    steer(p, in);
  }

  private static void release(Player p) {
    if (p.get(GRABS)) {
      p.set(GRABS, false);
      p.set(HELD, null);
    }
  }

  /** Grabs the first thing along the aim. */
  private void grab(Simulation s, Player p, float aimX, float aimY) {
    Entity robot = p.entity();
    float reach = PlaygroundGame.BEAM;
    if (s.queries()
            .shapeClosest(GRIP, robot.x(), robot.y(), 0, reach * aimX, reach * aimY, seen, hit)
        && yard.isLoose(hit.entity())
        && mayHold(s, p, hit.entity())) {
      Entity e = hit.entity();
      boolean round = yard.isRound(e);
      hold(s, p, e, round ? e.centerX() : hit.x(), round ? e.centerY() : hit.y());
    }
  }

  private boolean mayHold(Simulation s, Player p, Entity e) {
    return e.archetype() != yard.star
        || s.get(SAFE) == 0
        || s.get(KEEPER) == null
        || s.get(KEEPER) == p;
  }

  private void hold(Simulation s, Player p, Entity e, float x, float y) {
    float dx = x - p.entity().x();
    float dy = y - p.entity().y();
    p.set(HELD, e);
    p.set(GRABS, true);
    p.set(AT_X, e.localPointX(x, y));
    p.set(AT_Y, e.localPointY(x, y));
    p.set(REACH, Math.max(NEAREST, Math.min(FURTHEST, (float) Math.sqrt(dx * dx + dy * dy))));
    e.set(HOLDER, p);
    s.emit(yard.grab).at(x, y).of(e).by(p);
  }

  /** Draws the held point to its place before the robot, and bears the thing's weight. */
  private void pull(Simulation s, Player p, Entity e, float aimX, float aimY, float turn) {
    float x = e.worldPointX(p.get(AT_X), p.get(AT_Y));
    float y = e.worldPointY(p.get(AT_X), p.get(AT_Y));
    float dx = p.entity().x() + p.get(REACH) * aimX - x;
    float dy = p.entity().y() + p.get(REACH) * aimY - y;
    float away = dx * dx + dy * dy;
    if (away > SLIP * SLIP) {
      s.emit(yard.slip).at(x, y).of(e).by(p);
      release(p);
      return;
    }
    float armX = x - e.centerX();
    float armY = y - e.centerY();
    float mass = e.mass();
    float inertia = e.inertia();
    float lever = inertia > 0 ? mass * (armX * armX + armY * armY) / inertia : 0;
    float moved = mass / (1 + lever) / (1 + DAMPING * s.tickSeconds());
    float speedX = e.velocityAtX(x, y) - p.entity().velocityX();
    float speedY = e.velocityAtY(x, y) - p.entity().velocityY();
    float fx = moved * (STIFFNESS * dx - DAMPING * speedX);
    float fy = moved * (STIFFNESS * dy - DAMPING * speedY);
    float force = (float) Math.sqrt(fx * fx + fy * fy);
    float share = force > MAX_FORCE ? MAX_FORCE / force : 1;
    e.applyForce(share * fx, share * fy, x, y);
    e.applyForce(0, -yard.weight(e));
    e.applyTorque(STEADY * inertia * (turn - e.angularVelocity()));
  }

  /** Makes the things whose keys went down; the oldest one gives way to one too many. */
  private void make(Simulation s, Player p, Input in, float aimX, float aimY) {
    for (int i = 0; i < yard.things.length; i++) {
      if (!in.pressed(PlaygroundGame.MAKE << i)) {
        continue;
      }
      float x = p.entity().x() + PLACE * aimX;
      float y = p.entity().y() + PLACE * aimY;
      if (!s.queries().isFree(ROOM, x, y, 0, null)) {
        s.emit(yard.blocked).at(x, y).by(p);
        continue;
      }
      if (p.spawnedCount() >= PlaygroundGame.MAX_THINGS) {
        Entity oldest = p.spawned(0);
        s.emit(yard.gone).at(oldest.x(), oldest.y()).by(p);
        oldest.despawn();
      }
      Entity e = p.spawn(yard.things[i], x, y, 0);
      s.emit(yard.made).at(x, y).of(e).by(p);
      if (in.held(Input.ACTION) && !p.get(GRABS)) {
        hold(s, p, e, x, y);
      }
    }
    if (p.get(THINGS) != p.spawnedCount()) {
      p.set(THINGS, Math.min(THINGS.max(), p.spawnedCount()));
    }
  }

  /** Lets the motors of a player turn while the key is held, the way that the player flies. */
  private void steer(Player p, Input in) {
    int way = in.held(Input.JUMP) ? (in.moveX() < 0 ? -1 : 1) : 0;
    if (way != p.get(DRIVE)) {
      p.set(DRIVE, way);
      spin = -way * MOTOR_SPEED;
      for (int i = 0; i < PlaygroundFields.MAX_MOTORS; i++) {
        if (p.get(MOTOR, i) != null) {
          p.get(MOTOR, i).forEachJoint(drive);
        }
      }
    }
  }

  private void drive(EntityJoint joint) {
    if (joint.type() == JointType.REVOLUTE && joint.isDriven()) {
      joint.setMotor(spin, TORQUE);
    }
  }
}
