package carom.game.arena;

import static carom.game.arena.ArenaFields.BALL;
import static carom.game.arena.ArenaFields.BALL_WAIT;
import static carom.game.arena.ArenaFields.MAX_BALLS;
import static carom.game.arena.ArenaFields.PLACE_X;
import static carom.game.arena.ArenaFields.PLACE_Y;
import static carom.game.arena.ArenaFields.TOUCHED;
import static carom.game.arena.ArenaFields.TOUCHED_BEFORE;
import static carom.game.arena.ArenaFields.UNTIL_STUCK;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;

/** The balls: when each is kicked off, who touched it last, and when it leaves the pitch. */
final class Balls {
  /** Radius, m. */
  static final float RADIUS = 0.7f;

  /** Highest speed, m/s. */
  static final float MAX_SPEED = 32;

  private static final float KICK_OFF_SECONDS = 2;
  private static final float STUCK_SECONDS = 4;
  private static final float STUCK_RADIUS = 1.5f;

  private final SimulationHost simulation;
  private final Pitch pitch;
  private final Goals goals;
  private final BodyContactVisitor<HostEntity> touch = this::touched;
  private HostPlayer lastTouch;

  Balls(SimulationHost simulation, Pitch pitch, Goals goals) {
    this.simulation = simulation;
    this.pitch = pitch;
    this.goals = goals;
  }

  /** Kicks off each ball that is missing and whose time has come. */
  void kickOffMissing(SimulationHost s) {
    int wanted = Math.min(MAX_BALLS, 1 + s.playerCount() / ArenaGame.PLAYERS_PER_BALL);
    for (int i = 0; i < wanted; i++) {
      if (s.get(BALL, i) == null && s.get(BALL_WAIT, i) == 0) {
        kickOff(s, i);
      }
    }
  }

  /** Follows each ball: touches, speed, goals, and balls that are stuck or lost. */
  void follow(SimulationHost s) {
    for (int i = 0; i < MAX_BALLS; i++) {
      if (s.get(BALL, i) != null) {
        follow(s, i, s.get(BALL, i));
      }
    }
  }

  /** Lets every ball be kicked off in the next tick. */
  static void clearWaits(SimulationHost s) {
    for (int i = 0; i < MAX_BALLS; i++) {
      s.set(BALL_WAIT, i, 0);
    }
  }

  private void follow(SimulationHost s, int i, HostEntity e) {
    Body<HostEntity> body = e.body();
    lastTouch = null;
    body.forEachContact(touch);
    if (lastTouch != null && lastTouch != e.get(TOUCHED)) {
      e.set(TOUCHED_BEFORE, e.get(TOUCHED));
      e.set(TOUCHED, lastTouch);
    }
    float speed2 = body.velocityX() * body.velocityX() + body.velocityY() * body.velocityY();
    if (speed2 > MAX_SPEED * MAX_SPEED) {
      float scale = MAX_SPEED / (float) Math.sqrt(speed2);
      body.setVelocity(body.velocityX() * scale, body.velocityY() * scale);
    }
    Level.Zone goal = ArenaGame.isOver(s) ? null : pitch.goalAt(body.x(), body.y());
    if (goal != null) {
      int team = Pitch.TEAMS + 1 - goal.team();
      goals.count(s, e, team);
      remove(s, i, e);
      goals.settle(s, team);
    } else if (isStuck(s, i, e) || !s.level().bounds().contains(body.x(), body.y())) {
      remove(s, i, e);
      s.notice("The ball is back in the middle");
    }
  }

  /** Returns whether a ball has stayed around one place for long since it was first played. */
  private boolean isStuck(SimulationHost s, int i, HostEntity e) {
    Body<HostEntity> body = e.body();
    Level.Spawn spot = pitch.kickOffs.get(i % pitch.kickOffs.size());
    float dx = body.x() - e.get(PLACE_X);
    float dy = body.y() - e.get(PLACE_Y);
    boolean moved = dx * dx + dy * dy > STUCK_RADIUS * STUCK_RADIUS;
    boolean waits = body.x() == spot.x() && body.y() == spot.y();
    if (moved || waits) {
      e.set(PLACE_X, body.x());
      e.set(PLACE_Y, body.y());
      e.set(UNTIL_STUCK, s.ticks(STUCK_SECONDS));
    }
    return e.get(UNTIL_STUCK) == 0;
  }

  private void touched(Body<HostEntity> other, float normalX, float normalY, float impulse) {
    HostPlayer owner = simulation.owner(other.user());
    if (owner != null) {
      lastTouch = owner;
    }
  }

  /** Takes all balls off the pitch. */
  static void removeAll(SimulationHost s) {
    for (int i = 0; i < MAX_BALLS; i++) {
      if (s.get(BALL, i) != null) {
        remove(s, i, s.get(BALL, i));
      }
    }
  }

  private void kickOff(SimulationHost s, int i) {
    Level.Spawn spot = pitch.kickOffs.get(i % pitch.kickOffs.size());
    HostEntity e = s.spawn(pitch.ball, spot.x(), spot.y(), 0, null);
    e.set(UNTIL_STUCK, s.ticks(STUCK_SECONDS));
    s.set(BALL, i, e);
  }

  private static void remove(SimulationHost s, int i, HostEntity e) {
    s.despawn(e);
    s.set(BALL_WAIT, i, s.ticks(KICK_OFF_SECONDS));
  }
}
