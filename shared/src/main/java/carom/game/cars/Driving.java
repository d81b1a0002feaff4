package carom.game.cars;

import static carom.game.cars.CarsFields.BOOSTS;
import static carom.game.cars.CarsFields.GATE;
import static carom.game.cars.CarsFields.HELD;
import static carom.game.cars.CarsFields.HELP;
import static carom.game.cars.CarsFields.LAP;
import static carom.game.cars.CarsFields.NITRO;
import static carom.game.cars.CarsFields.OVER;
import static carom.game.cars.CarsFields.QUARTER;
import static carom.game.cars.CarsFields.RING;
import static carom.game.cars.CarsFields.SKY;
import static carom.game.cars.CarsFields.TURNED;

import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;

/** The driving of cars as their players command; both roles, so a player sees all of it at once. */
final class Driving {
  private static final float SPIN = CarsGame.SPEED / CarsGame.WHEEL; // rad/s
  private static final float BOOST_SPIN = CarsGame.BOOST_SPEED / CarsGame.WHEEL;
  private static final float TORQUE = 14; // N m of each wheel
  private static final float IDLE_TORQUE = 2; // engine brake
  private static final float THRUST = 13; // of nitro, m/s^2
  private static final float NITRO_SECONDS = 2.2f; // of a full tank
  private static final float LEAN = 14; // rad/s^2 in the air
  private static final float GROUND_LEAN = 0.45f; // share of it on the ground
  private static final float STEADY = 2.5f; // 1/s, by which a car in the air stops turning
  private static final float GROUND_STEADY = 1.5f;
  private static final float MAX_TURN = 7; // rad/s
  private static final float FLIP_NITRO = 0.35f;
  private static final float AIR_NITRO = 0.12f; // for each second
  private static final float RING_NITRO = 0.35f;
  private static final float RING_RADIUS = 2;
  private static final float SKY_SECONDS = 20; // longer than any flight
  private static final float HELP_SECONDS = 2.2f;
  private static final float HELD_SECONDS = 1.5f;

  private final Track track;
  private final EntityContactVisitor touch = this::touch;
  private boolean touches; // scratch

  Driving(Track track) {
    this.track = track;
  }

  /** Drives a car for a tick. */
  void input(Simulation s, Player p, Input in) {
    Entity car = p.entity();
    EntityJoint rear = car.joint("rear");
    EntityJoint front = car.joint("front");
    if (rear == null || front == null) {
      return; // a client that doesn't simulate the car
    }
    boolean waits = p.get(HELD) > 0 || MatchClock.phase(s) == MatchPhase.COUNTDOWN;
    boolean grounded = touches(rear.b()) || touches(front.b());
    float throttle = waits ? 0 : in.moveX();
    boolean boosts = !waits && in.held(Input.ACTION) && p.get(NITRO) > 0;
    burn(s, p, car, boosts);
    float spin = -(boosts ? BOOST_SPIN : SPIN) * throttle;
    float torque = waits ? TORQUE : IDLE_TORQUE + (TORQUE - IDLE_TORQUE) * Math.abs(throttle);
    rear.setMotor(spin, torque);
    front.setMotor(spin, torque);
    lean(car, in.moveY(), grounded);
    fly(s, p, car, grounded);
    follow(s, p, car);
    help(s, p, in, throttle);
  }

  private boolean touches(Entity wheel) {
    touches = false;
    wheel.forEachContact(touch);
    return touches;
  }

  private void touch(Entity other, float normalX, float normalY, float impulse) {
    touches |= impulse > 0;
  }

  private void burn(Simulation s, Player p, Entity car, boolean boosts) {
    p.set(BOOSTS, boosts);
    if (!boosts) {
      return;
    }
    p.add(NITRO, -s.tickSeconds() / NITRO_SECONDS);
    float forward = car.velocityX() * car.cos() + car.velocityY() * car.sin();
    if (forward < CarsGame.BOOST_SPEED) {
      float force = THRUST * CarsGame.MASS;
      car.applyForce(force * car.cos(), force * car.sin());
    }
    if (s.tick() % 5 == 0) {
      s.emit(track.nitro).at(car.worldPointX(-1.5f, 0), car.worldPointY(-1.5f, 0)).of(car).by(p);
    }
  }

  /** Turns a car as its player leans; in the air it steadies itself. */
  private static void lean(Entity car, float lean, boolean grounded) {
    float turn = car.angularVelocity();
    float most = LEAN * (grounded ? GROUND_LEAN : 1) * lean;
    float push = turn * lean > MAX_TURN * Math.abs(lean) ? 0 : most;
    float steady = lean != 0 ? 0 : -(grounded ? GROUND_STEADY : STEADY) * turn;
    car.applyTorque(2.5f * car.inertia() * (push + steady)); // the wheels turn along
  }

  /** Counts turns in the air, and rewards them where the car lands on its wheels. */
  private void fly(Simulation s, Player p, Entity car, boolean grounded) {
    boolean right = car.cos() > car.sin(); // the side of a diagonal
    boolean upper = car.cos() > -car.sin();
    int quarter = upper ? (right ? 0 : 1) : (right ? 3 : 2); // a car on a road is in the first
    int turned = (quarter - p.get(QUARTER) + 4) % 4;
    p.set(QUARTER, quarter);
    if (!grounded) {
      if (p.get(SKY) == 0) {
        p.set(SKY, s.ticks(SKY_SECONDS));
        p.set(TURNED, 0);
      } else if (turned != 0) {
        p.add(TURNED, turned == 3 ? -1 : turned);
      }
      return;
    }
    if (p.get(SKY) == 0) {
      return;
    }
    float seconds = SKY_SECONDS - p.get(SKY) * s.tickSeconds();
    int flips = (Math.abs(p.get(TURNED)) + 1) / 4; // it may land a little short
    p.set(SKY, 0);
    p.set(TURNED, 0);
    if (seconds > 0.4f) {
      p.add(NITRO, AIR_NITRO * seconds);
      s.emit(track.land)
          .at(car.worldPointX(0, -0.9f), car.worldPointY(0, -0.9f))
          .of(car)
          .by(p)
          .strength(20 * seconds);
    }
    if (flips > 0 && car.cos() > 0) {
      p.add(NITRO, FLIP_NITRO * flips);
      s.emit(track.flip).at(car.x(), car.y() + 1.5f).of(car).by(p);
    }
  }

  /** Passes rings, gates, loops and the end of a lap. */
  private void follow(Simulation s, Player p, Entity car) {
    for (int i = p.get(RING); i < track.rings.size(); i++) {
      Entity ring = track.rings.get(i);
      float dx = car.x() - ring.x();
      float dy = car.y() - ring.y();
      if (dx * dx + dy * dy < RING_RADIUS * RING_RADIUS) {
        p.set(RING, i + 1);
        p.add(NITRO, RING_NITRO);
        s.emit(track.ring).at(ring.x(), ring.y()).of(car).by(p).data(i);
      }
    }
    while (p.get(GATE) < track.gates.size() && car.x() > track.gates.get(p.get(GATE)).x()) {
      Entity gate = track.gates.get(p.get(GATE));
      p.add(GATE, 1);
      s.emit(track.gate).at(gate.x(), gate.y() + 2).of(car).by(p);
    }
    if (Track.isIn(track.tops, car)) {
      p.set(OVER, true);
    } else if (Track.isIn(track.sides, car)) {
      p.set(OVER, false);
    }
    if (track.end.contains(car.x(), car.y())) {
      float x = car.x() - track.end.minX() + track.again.x();
      float y = car.y() - track.end.minY() + track.again.y();
      p.add(LAP, 1);
      p.set(GATE, 0);
      p.set(RING, 0);
      car.teleport(x, y, car.angle());
      s.emit(track.lap).at(x, y).of(car).by(p);
    }
  }

  /**
   * Tows a car that is lost, lies on its roof or can't get on to the next gate, where it waits: it
   * is stuck nowhere, and gains nothing. One that asks goes back to its last gate at once.
   */
  private void help(Simulation s, Player p, Input in, float throttle) {
    Entity car = p.entity();
    float speed = Math.abs(car.velocityX()) + Math.abs(car.velocityY());
    boolean fine = speed > 4 || (car.cos() > 0.3f && (speed > 1 || throttle == 0));
    int patience = s.ticks(HELP_SECONDS);
    if (fine && p.get(HELP) < patience * 2 / 3) { // now and then, since each change is sent
      p.set(HELP, patience);
    }
    boolean lost = track.isLost(car);
    if (lost || p.get(HELP) == 0) {
      s.emit(lost ? track.splash : track.back).at(car.x(), car.y()).of(car).by(p);
      int next = Math.min(p.get(GATE), track.gates.size() - 1);
      put(s, p, next);
      p.set(GATE, next + 1);
      p.set(HELD, s.ticks(HELD_SECONDS));
    } else if (in.pressed(Input.SECOND)) {
      s.emit(track.back).at(car.x(), car.y()).of(car).by(p);
      put(s, p, p.get(GATE) - 1);
    }
  }

  /** Puts a car on its wheels, at rest, at a gate, or at the begin of the lap. */
  private void put(Simulation s, Player p, int gate) {
    Entity car = p.entity();
    float x = gate < 0 ? track.again.x() + 1 : track.gates.get(gate).x();
    float y = gate < 0 ? track.again.y() : track.gates.get(gate).y();
    car.teleport(x, y + CarsGame.HEIGHT, 0);
    stop(car);
    stop(car.part("rear"));
    stop(car.part("front"));
    p.set(HELP, s.ticks(HELP_SECONDS));
    p.set(OVER, false);
    p.set(SKY, 0);
    p.set(TURNED, 0);
    p.set(QUARTER, 0);
  }

  private static void stop(Entity body) {
    if (body != null) {
      body.setVelocity(0, 0);
      body.setAngularVelocity(0);
    }
  }
}
