package carom.game.rockets;

import static carom.game.rockets.RocketFields.AMMO;
import static carom.game.rockets.RocketFields.FADES;
import static carom.game.rockets.RocketFields.NEXT_ROCK;
import static carom.game.rockets.RocketFields.REPAIRS;
import static carom.game.rockets.RocketFields.STRENGTH;
import static carom.game.rockets.RocketFields.WEAPON;

import carom.physics.math.Trig;
import carom.sim.Match;
import carom.sim.Rules;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Level;
import java.util.function.Predicate;

/**
 * Rocks and what is in them. The server lets them in, breaks them and leaves what they held; {@code
 * rules} hand that out on both sides, so at once.
 */
final class Rocks {
  /** Most large rocks of a level. */
  static final int MOST_LARGE = 12;

  /** Most rocks of all sizes; a rock that breaks beyond leaves nothing. */
  static final int MOST = 32;

  private static final int MOST_PICKUPS = 8;
  private static final int[] STRENGTHS = {90, 45, 12};
  private static final int[] PIECES = {2, 3, 0};
  private static final float[] CONTENTS = {1, 0.25f, 0.1f}; // chance that a rock holds something
  private static final float NEXT_SECONDS = 7;
  private static final float ROOM = 5; // m around a place, in which nobody is
  private static final float DRIFT_SPEED = 1.8f;
  private static final float PIECE_SPEED = 3;
  private static final float SPIN = 1.2f; // rad/s
  private static final float FADE_SECONDS = 20;

  private final Sky sky;
  private final Predicate<Entity> visit = this::visit;
  private final Predicate<Entity> crowds = this::crowds;

  // Scratch: hold nothing between two calls.
  private int content;
  private Player taker;
  private boolean isCrowded;

  Rocks(Sky sky) {
    this.sky = sky;
  }

  /** Lets all rocks in with which a match begins. */
  void begin(Match m) {
    for (Level.Spawn place : sky.rockPlaces) {
      letIn(m, place);
    }
    m.set(NEXT_ROCK, m.ticks(NEXT_SECONDS));
  }

  private void letIn(Match m, Level.Spawn place) {
    float way = m.random().between(-Trig.PI, Trig.PI);
    float vx = DRIFT_SPEED * Trig.cos(way);
    spawn(m, 0, place.x(), place.y(), vx, DRIFT_SPEED * Trig.sin(way));
  }

  private void spawn(Match m, int kind, float x, float y, float vx, float vy) {
    Entity rock = m.spawn(sky.rocks[kind], x, y, m.random().between(-Trig.PI, Trig.PI), null);
    rock.setVelocity(vx, vy);
    rock.setAngularVelocity(m.random().between(-SPIN, SPIN));
    rock.set(STRENGTH, STRENGTHS[kind]);
  }

  /** Lets another rock in when it is time, and takes away what nobody took. */
  void beforeStep(Match m) {
    int large = 0;
    int all = 0;
    for (Entity e : m.entities()) {
      int kind = sky.rock(e);
      large += kind == 0 ? 1 : 0;
      all += kind >= 0 ? 1 : 0;
      if (sky.pickup(e) >= 0 && e.get(FADES) == 0) {
        e.despawn();
      }
    }
    if (m.get(NEXT_ROCK) == 0 && large < sky.rockPlaces.size() && all < MOST) {
      m.set(NEXT_ROCK, m.ticks(NEXT_SECONDS));
      Level.Spawn place = sky.rockPlaces.get(m.random().nextInt(sky.rockPlaces.size()));
      isCrowded = false;
      float x = place.x();
      float y = place.y();
      m.forEachInBox(x - ROOM, y - ROOM, x + ROOM, y + ROOM, crowds);
      if (!isCrowded) {
        letIn(m, place);
      }
    }
  }

  private boolean crowds(Entity e) {
    isCrowded |= e.isOwned() || sky.rock(e) >= 0;
    return !isCrowded;
  }

  /** Damages a rock, which breaks after the tick if it can bear no more. */
  void damage(Entity rock, float damage) {
    rock.add(STRENGTH, -Math.round(damage));
  }

  /** Breaks rocks that can bear no more, after all blasts of a tick. */
  void afterStep(Match m) {
    int all = 0;
    int pickups = 0;
    for (Entity e : m.entities()) {
      all += sky.rock(e) >= 0 ? 1 : 0;
      pickups += sky.pickup(e) >= 0 ? 1 : 0;
    }
    for (Entity e : m.entities()) {
      int kind = sky.rock(e);
      if (kind >= 0 && e.get(STRENGTH) == 0) {
        int pieces = all + PIECES[kind] <= MOST ? PIECES[kind] : 0;
        all += pieces - 1;
        boolean holds = pickups < MOST_PICKUPS && m.random().nextFloat() < CONTENTS[kind];
        pickups += holds ? 1 : 0;
        breakUp(m, e, kind, pieces, holds);
      }
    }
  }

  private void breakUp(Match m, Entity rock, int kind, int pieces, boolean holds) {
    float x = rock.centerX();
    float y = rock.centerY();
    float radius = 0.5f * Sky.radius(kind);
    float first = m.random().between(-Trig.PI, Trig.PI);
    for (int i = 0; i < pieces; i++) {
      float way = first + i * 2 * Trig.PI / pieces;
      float wayX = Trig.cos(way);
      float wayY = Trig.sin(way);
      spawn(
          m,
          kind + 1,
          x + radius * wayX,
          y + radius * wayY,
          rock.velocityX() + PIECE_SPEED * wayX,
          rock.velocityY() + PIECE_SPEED * wayY);
    }
    if (holds) {
      Entity pickup = m.spawn(sky.pickups[m.random().nextInt(sky.pickups.length)], x, y);
      pickup.set(FADES, m.ticks(FADE_SECONDS));
    }
    m.emit(sky.crack).at(x, y).strength(Sky.radius(kind));
    rock.despawn();
  }

  /** Gives players what they touch. */
  void take(Rules r) {
    for (Entity e : r.entities()) {
      content = sky.pickup(e);
      if (content < 0) {
        continue;
      }
      taker = null;
      e.forEachOverlap(visit);
      if (taker == null) {
        continue;
      }
      if (content == 0) {
        taker.set(REPAIRS, true); // health is the server's word
      } else {
        taker.set(WEAPON, weapon());
        taker.set(AMMO, weapon().ammo);
      }
      r.emit(sky.taken).at(e.x(), e.y()).of(taker.entity()).by(taker).data(content);
      e.despawn();
    }
  }

  private Weapon weapon() {
    return Weapon.values()[content];
  }

  /** Finds the first player who may take the content; full hands leave it there. */
  private boolean visit(Entity visitor) {
    Player p = visitor.owner();
    boolean isShip = p != null && p.entity() == visitor;
    boolean isFull =
        isShip && content > 0 && p.get(WEAPON) == weapon() && p.get(AMMO) == weapon().ammo;
    if (isShip && !isFull) {
      taker = p;
    }
    return taker == null;
  }
}
