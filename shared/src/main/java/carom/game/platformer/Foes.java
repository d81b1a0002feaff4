package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.BACK;
import static carom.game.platformer.PlatformerFields.EARNED;
import static carom.game.platformer.PlatformerFields.FOE;
import static carom.game.platformer.PlatformerFields.FOE_WAIT;
import static carom.game.platformer.PlatformerFields.HAUNT;
import static carom.game.platformer.PlatformerFields.HURT;
import static carom.game.platformer.PlatformerFields.JUMPING;
import static carom.game.platformer.PlatformerFields.MOOD;
import static carom.game.platformer.PlatformerFields.NEXT_MOOD;
import static carom.game.platformer.PlatformerFields.PREY;
import static carom.game.platformer.PlatformerFields.REACTS;

import carom.sim.Match;
import carom.sim.Rules;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.EntityFilter;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Level;

/**
 * Foes that patrol and chase, and what they and players do to each other.
 *
 * <p>Clients don't know all players that a hunter sees. So the server alone looks, and a hunter
 * takes a while to react: clients hear of its decision before it counts. All that follows is on
 * both sides.
 */
final class Foes {
  /** The mood of a foe decides its way. */
  enum Mood {
    PATROLS,
    CHASES_LEFT,
    CHASES_RIGHT
  }

  /** Greatest upward part of the normal to a foe that a player has landed on. */
  private static final float LANDED = -0.5f;

  private static final float STEER = 14; // 1/s
  private static final float WALK_SPEED = 2;
  private static final float CHASE_SPEED = 4.5f;

  /** Distance to a prey below which a hunter doesn't turn, metres. */
  private static final float CLOSE = 0.5f;

  /** Ticks between two looks of hunters. */
  static final int LOOK_TICKS = 4;

  private static final float REACTION_SECONDS = 0.3f;

  /** Distance from its zone at which a prey gets away, metres. */
  private static final float ESCAPE = 1.5f;

  private static final float HURT_SECONDS = 1.6f;
  private static final float STUN_SECONDS = 0.35f;
  private static final float BOUNCE = 9.5f; // m/s
  private static final float THROW_X = 8;
  private static final float THROW_Y = 8;

  private static final float WAIT_SECONDS = 9;
  private static final float FLAT_SECONDS = 0.7f;

  /** Distance to players at which a foe may appear, metres. */
  private static final float ROOM = 5;

  private final Course course;
  private final EntityContactVisitor meeting = this::touch;
  private final EntityContactVisitor bumping = this::bump;
  private final EntityFilter walls = e -> e.isLevel() && !e.archetype().oneWay();

  // Scratch: what a player meets, and whether a foe's way is blocked.
  private Entity below;
  private Entity beside;
  private boolean goesBack;
  private boolean isBlocked;

  Foes(Course course) {
    this.course = course;
  }

  // ---- what foes do

  /** Lets foes turn, and begin to chase. */
  void rules(Rules r) {
    for (Entity e : r.entities()) {
      if (course.isFoe(e)) {
        decide(e);
      }
    }
  }

  private void decide(Entity foe) {
    if (foe.get(MOOD) != foe.get(NEXT_MOOD) && foe.get(REACTS) == 0) {
      foe.set(MOOD, foe.get(NEXT_MOOD));
    }
    Level.Zone haunt = course.haunts.get(foe.get(HAUNT));
    boolean back = foe.get(BACK);
    if (foe.x() < haunt.minX()) {
      back = false;
    } else if (foe.x() > haunt.maxX()) {
      back = true;
    } else if (foe.get(MOOD) != Mood.PATROLS) {
      back = foe.get(MOOD) == Mood.CHASES_LEFT;
    } else {
      goesBack = back;
      isBlocked = false;
      foe.forEachContact(bumping);
      back ^= isBlocked;
    }
    if (back != foe.get(BACK)) {
      foe.set(BACK, back);
    }
  }

  private void bump(Entity other, float normalX, float normalY, float impulse) {
    isBlocked |= !other.isOwned() && (goesBack ? normalX < -0.7f : normalX > 0.7f);
  }

  /** Lets a foe walk. */
  void walk(Entity foe) {
    float speed = foe.get(MOOD) == Mood.PATROLS ? WALK_SPEED : CHASE_SPEED;
    float goal = foe.get(BACK) ? -speed : speed;
    foe.applyForce(STEER * foe.mass() * (goal - foe.velocityX()), 0);
  }

  // ---- what players and foes do to each other

  /** Lets a player beat the foe that it has landed on, or be hurt by one that it has run into. */
  void meet(Simulation s, Player p, Input in) {
    if (p.get(HURT) > 0) {
      return;
    }
    Entity body = p.entity();
    below = null;
    beside = null;
    body.forEachContact(meeting);
    if (below != null) {
      boolean high = in.held(Input.JUMP);
      s.emit(course.stompEvent).at(below.x(), below.y()).of(below).by(p);
      below.become(course.flat);
      body.setVelocity(body.velocityX(), high ? PlatformerGame.JUMP_SPEED : BOUNCE);
      p.set(JUMPING, high);
      p.set(EARNED, PlatformerGame.FOE_POINTS);
    } else if (beside != null) {
      s.emit(course.hurtEvent).at(body.x(), body.y()).of(body).by(p);
      p.set(HURT, s.ticks(HURT_SECONDS));
      body.setVelocity(beside.x() > body.x() ? -THROW_X : THROW_X, THROW_Y);
      p.set(EARNED, -PlatformerGame.HURT_POINTS);
    }
  }

  private void touch(Entity other, float normalX, float normalY, float impulse) {
    if (course.isFoe(other)) {
      if (normalY < LANDED) {
        below = other;
      } else {
        beside = other;
      }
    }
  }

  /** Returns whether a player was hurt so lately that it can't steer. */
  static boolean isStunned(Simulation s, Player p) {
    return p.get(HURT) > s.ticks(HURT_SECONDS - STUN_SECONDS);
  }

  /** Keeps foes from harming a player who comes. */
  static void spare(Match m, Player p) {
    p.set(HURT, m.ticks(HURT_SECONDS - STUN_SECONDS));
  }

  /** Returns whether a player passes through a foe, which can't harm it now. */
  boolean passes(Entity body, Entity foe) {
    return course.isFoe(foe) && body.isOwned() && body.owner().get(HURT) > 0;
  }

  // ---- foes that come and go; the server's

  /** Brings foes to where there are none, and nobody is near. */
  void bringBack(Match m) {
    for (int i = 0; i < course.haunts.size(); i++) {
      Level.Zone haunt = course.haunts.get(i);
      float x = (haunt.minX() + haunt.maxX()) / 2;
      float y = haunt.minY() + Course.FOE_HEIGHT / 2;
      if (m.get(FOE, i) == null && m.get(FOE_WAIT, i) == 0 && isLonely(m, x, y)) {
        Entity foe = m.spawn(course.foe(haunt), x, y);
        foe.set(HAUNT, i);
        foe.set(BACK, i % 2 == 0);
        m.set(FOE, i, foe);
      }
    }
  }

  private static boolean isLonely(Match m, float x, float y) {
    for (Player p : m.players()) {
      if (p.isAlive()
          && Math.abs(p.entity().x() - x) < ROOM
          && Math.abs(p.entity().y() - y) < ROOM) {
        return false;
      }
    }
    return true;
  }

  /** Lets hunters see what there is to chase. */
  void look(Match m) {
    for (int i = 0; i < course.haunts.size(); i++) {
      Entity foe = m.get(FOE, i);
      if (foe == null || foe.archetype() != course.hunter) {
        continue;
      }
      Level.Zone haunt = course.haunts.get(i);
      Player prey = foe.get(PREY);
      if (prey == null || !isPrey(haunt, prey, ESCAPE)) {
        prey = find(m, foe, haunt);
        foe.set(PREY, prey);
      }
      Mood mood = prey == null ? Mood.PATROLS : towards(foe, prey.entity());
      if (mood != foe.get(NEXT_MOOD)) {
        foe.set(NEXT_MOOD, mood);
        foe.set(REACTS, m.ticks(REACTION_SECONDS));
      }
    }
  }

  private static Mood towards(Entity foe, Entity prey) {
    float way = prey.x() - foe.x();
    boolean turns = Math.abs(way) > CLOSE || foe.get(NEXT_MOOD) == Mood.PATROLS;
    return !turns ? foe.get(NEXT_MOOD) : way < 0 ? Mood.CHASES_LEFT : Mood.CHASES_RIGHT;
  }

  private Player find(Match m, Entity foe, Level.Zone haunt) {
    for (Player p : m.players()) {
      if (isPrey(haunt, p, 0)) {
        float wayX = p.entity().x() - foe.x();
        float wayY = p.entity().y() - foe.y();
        if (!m.queries().rayAny(foe.x(), foe.y(), wayX, wayY, walls)) {
          return p;
        }
      }
    }
    return null;
  }

  private static boolean isPrey(Level.Zone haunt, Player p, float margin) {
    Entity body = p.entity();
    return body != null
        && p.get(HURT) == 0
        && body.x() > haunt.minX() - margin
        && body.x() < haunt.maxX() + margin
        && body.y() > haunt.minY() - margin
        && body.y() < haunt.maxY() + margin;
  }

  /** Takes foes away that are beaten or have fallen. */
  void clear(Match m) {
    for (int i = 0; i < course.haunts.size(); i++) {
      Entity foe = m.get(FOE, i);
      if (foe == null) {
        continue;
      }
      boolean isBeaten = foe.archetype() == course.flat;
      if (isBeaten && m.get(FOE_WAIT, i) == 0) {
        m.set(FOE_WAIT, i, m.ticks(WAIT_SECONDS));
      } else if (isBeaten && m.get(FOE_WAIT, i) < m.ticks(WAIT_SECONDS - FLAT_SECONDS)) {
        foe.despawn();
      } else if (course.isLost(foe)) {
        m.set(FOE_WAIT, i, m.ticks(WAIT_SECONDS));
        foe.despawn();
      }
    }
  }
}
