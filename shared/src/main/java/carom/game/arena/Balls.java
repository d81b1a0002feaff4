package carom.game.arena;

import static carom.game.arena.ArenaFields.BALL;
import static carom.game.arena.ArenaFields.BALL_WAIT;
import static carom.game.arena.ArenaFields.MAX_BALLS;
import static carom.game.arena.ArenaFields.PLACE_X;
import static carom.game.arena.ArenaFields.PLACE_Y;
import static carom.game.arena.ArenaFields.TOUCHED;
import static carom.game.arena.ArenaFields.TOUCHED_BEFORE;
import static carom.game.arena.ArenaFields.UNTIL_STUCK;

import carom.sim.Match;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.Player;
import carom.sim.level.Level;

/** The balls: when each is kicked off, who touched it last, and when it leaves the pitch. */
final class Balls {
  /** Radius, m. */
  static final float RADIUS = 0.7f;

  /** Radius of a heavy one, m. */
  static final float HEAVY_RADIUS = 0.95f;

  /** Highest speed, m/s. */
  static final float MAX_SPEED = 32;

  private static final float KICK_OFF_SECONDS = 2;
  private static final float STUCK_SECONDS = 4;
  private static final float STUCK_RADIUS = 1.5f;

  private final Pitch pitch;
  private final Goals goals;
  private final EntityContactVisitor touch = this::touched;
  private Player lastTouch;

  Balls(Pitch pitch, Goals goals) {
    this.pitch = pitch;
    this.goals = goals;
  }

  /** Kicks off each ball that is missing and whose time has come. */
  void kickOffMissing(Match m) {
    int wanted = pitch.heavies + 1 + m.playerCount() / ArenaGame.PLAYERS_PER_BALL;
    for (int i = 0; i < Math.min(MAX_BALLS, wanted); i++) {
      if (m.get(BALL, i) == null && m.get(BALL_WAIT, i) == 0) {
        kickOff(m, i);
      }
    }
  }

  /** Follows each ball: touches, speed, goals, and balls that are stuck or lost. */
  void follow(Match m) {
    for (int i = 0; i < MAX_BALLS; i++) {
      if (m.get(BALL, i) != null) {
        follow(m, i, m.get(BALL, i));
      }
    }
  }

  /** Lets every ball be kicked off in the next tick. */
  static void clearWaits(Match m) {
    for (int i = 0; i < MAX_BALLS; i++) {
      m.set(BALL_WAIT, i, 0);
    }
  }

  private void follow(Match m, int i, Entity e) {
    lastTouch = null;
    e.forEachContact(touch);
    if (lastTouch != null && lastTouch != e.get(TOUCHED)) {
      e.set(TOUCHED_BEFORE, e.get(TOUCHED));
      e.set(TOUCHED, lastTouch);
    }
    float speed2 = e.velocityX() * e.velocityX() + e.velocityY() * e.velocityY();
    if (speed2 > MAX_SPEED * MAX_SPEED) {
      float scale = MAX_SPEED / (float) Math.sqrt(speed2);
      e.setVelocity(e.velocityX() * scale, e.velocityY() * scale);
    }
    Level.Zone goal = ArenaGame.isOver(m) ? null : pitch.goalAt(e.x(), e.y());
    if (goal != null) {
      int team = Pitch.TEAMS + 1 - goal.team();
      goals.count(m, e, team);
      remove(m, i, e);
      goals.settle(m, team);
    } else if (isStuck(m, i, e) || !m.level().bounds().contains(e.x(), e.y())) {
      remove(m, i, e);
      m.notice("The ball is back in the middle");
    }
  }

  /** Returns whether a ball has stayed around one place for long since it was first played. */
  private boolean isStuck(Match m, int i, Entity e) {
    Level.Spawn spot = pitch.kickOff(i);
    float dx = e.x() - e.get(PLACE_X);
    float dy = e.y() - e.get(PLACE_Y);
    boolean moved = dx * dx + dy * dy > STUCK_RADIUS * STUCK_RADIUS;
    boolean waits = e.x() == spot.x() && e.y() == spot.y();
    if (moved || waits) {
      e.set(PLACE_X, e.x());
      e.set(PLACE_Y, e.y());
      e.set(UNTIL_STUCK, m.ticks(STUCK_SECONDS));
    }
    return e.get(UNTIL_STUCK) == 0;
  }

  private void touched(Entity other, float normalX, float normalY, float impulse) {
    Player owner = other.owner();
    if (owner != null) {
      lastTouch = owner;
    }
  }

  /** Takes all balls off the pitch. */
  static void removeAll(Match m) {
    for (int i = 0; i < MAX_BALLS; i++) {
      if (m.get(BALL, i) != null) {
        remove(m, i, m.get(BALL, i));
      }
    }
  }

  private void kickOff(Match m, int i) {
    Level.Spawn spot = pitch.kickOff(i);
    Entity e =
        m.spawn(i < pitch.heavies ? pitch.heavyBall : pitch.ball, spot.x(), spot.y(), 0, null);
    e.set(UNTIL_STUCK, m.ticks(STUCK_SECONDS));
    m.set(BALL, i, e);
  }

  private static void remove(Match m, int i, Entity e) {
    e.despawn();
    m.set(BALL_WAIT, i, m.ticks(KICK_OFF_SECONDS));
  }
}
