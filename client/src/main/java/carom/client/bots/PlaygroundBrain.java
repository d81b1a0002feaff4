package carom.client.bots;

import carom.client.field.FieldView;
import carom.client.view.ClientView.Drawn;
import carom.game.playground.PlaygroundFields;
import carom.game.playground.PlaygroundFields.Contest;
import carom.game.playground.PlaygroundGame;
import carom.sim.entity.Input;
import carom.sim.level.Level;

/**
 * Plays {@code playground}: carries the nearest thing into the nearest basket, piles boxes up, and
 * hunts the star or flees with it.
 */
public final class PlaygroundBrain extends GradedBrain {
  private static final float REACH = 4.2f; // from which it grabs, m
  private static final float HOVER = 2.7f; // over a tower, m
  private static final float DOWN = (float) (-Math.PI / 2);
  private static final int PATIENCE_TICKS = 240;
  private static final int STUCK_TICKS = 60;
  private static final int DETOUR_TICKS = 45;
  private static final int DROP_TICKS = 40; // over a basket, after which it lets go
  private static final int IDLE_TICKS = 200; // without a higher tower, after which it carries
  private static final int CARRY_TICKS = 600; // at most, until it builds again
  private static final float THERE = 4; // beside its place at the site, m
  private static final float WIDE = 40; // m within which it looks for things

  private Strength strength;
  private int waitUntil;
  private int grabbedAt;
  private int overSince;
  private int height;
  private int higherAt;
  private int builtAt;
  private int carryUntil;
  private boolean carried;
  private int target = -1;
  private int targetSince;
  private float goalX;
  private float goalY;
  private float miss;
  private float markX;
  private float markY;
  private int markTick;
  private float detour; // radians
  private int detourOf = -1; // the mark for which it was chosen

  /** Creates a bot of a strength that its random numbers choose, for the service loader. */
  public PlaygroundBrain() {
    this(null);
  }

  /** Creates a bot of a strength, null for one by chance. */
  public PlaygroundBrain(Strength strength) {
    super("playground", strength);
  }

  @Override
  void play(Senses s, Strength skill, Input out) {
    strength = skill;
    if (Math.abs(waitUntil - s.tick()) > 300) {
      waitUntil = s.tick(); // another match
    }
    Contest contest = s.view().match().get(PlaygroundFields.CONTEST);
    if (contest == Contest.TOWER) {
      build(s, out);
    } else if (contest == Contest.STAR) {
      hunt(s, out);
    } else {
      carry(s, out);
    }
  }

  private float speed() {
    return strength.of(0.55f, 0.8f, 1);
  }

  /** Returns by how much it aims past things at most, radians. */
  private float error() {
    return strength.of(0.25f, 0.12f, 0.03f);
  }

  /** Returns by how much a box may lie askew, metres. */
  private float slack() {
    return strength.of(0.42f, 0.2f, 0.07f);
  }

  /** Returns how long it waits between two things, ticks. */
  private int rest() {
    return (int) strength.of(75, 45, 24);
  }

  // ---- baskets

  private void carry(Senses s, Input out) {
    if (holds(s)) {
      toBasket(s, out);
      return;
    }
    Drawn thing = s.view().find(target);
    boolean isOld = s.tick() - targetSince > PATIENCE_TICKS || s.tick() < targetSince;
    if (thing == null || isOld || !isLoose(thing)) {
      thing = choose(s);
      target = thing == null ? -1 : thing.id();
      targetSince = s.tick();
    }
    if (thing == null) {
      wander(s, out);
      return;
    }
    fly(s, out, thing.x(), thing.y() + HOVER, 0.2f);
    grab(s, out, thing);
  }

  /** Returns a thing that nobody made and nobody has, near the robot; a weak bot's is any. */
  private Drawn choose(Senses s) {
    Drawn best = null;
    float least = 1.3f * WIDE;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn e = s.view().entity(i);
      if (isLoose(e)) {
        float cost = s.distance(e) + 6 * rest() * s.random().nextFloat() / 75;
        cost += Math.max(0, s.own().y() - 3 - e.y()) * 0.3f; // those on top lie bare
        cost += cost < least ? 0.4f * way(basket(s, e.x(), e.y()), e.x(), e.y()) : 0;
        if (cost < least) {
          least = cost;
          best = e;
        }
      }
    }
    return best;
  }

  private static boolean isLoose(Drawn e) {
    String kind = e.archetype().name();
    return e.ownerId() < 0
        && (kind.equals("crate") || kind.equals("pebble") || kind.equals("domino"));
  }

  /** Returns the basket nearest to a place, rather a free one. */
  private static Level.Placement basket(Senses s, float x, float y) {
    Level level = s.view().level();
    Level.Placement best = null;
    float least = Float.MAX_VALUE;
    for (Level.Placement p : level.statics()) {
      float way = way(p, x, y);
      boolean isBasket = level.archetypes().get(p.archetype()).name().equals("basket");
      if (isBasket && way < least && isTaken(s, p)) {
        way += 20;
      }
      if (isBasket && way < least) {
        least = way;
        best = p;
      }
    }
    return best;
  }

  /** Returns the way from a place to where things fall into a basket, metres. */
  private static float way(Level.Placement basket, float x, float y) {
    return (float) Math.hypot(basket.x() - x, basket.y() + 3 - y);
  }

  private void toBasket(Senses s, Input out) {
    Level.Placement basket = basket(s, s.own().x(), s.own().y());
    goalX = basket.x();
    goalY = basket.y();
    boolean isOver = Math.abs(goalX - s.own().x()) < 1.2f && s.own().y() > goalY + 2;
    fly(s, out, goalX, goalY + (isOver ? 2.4f : 7), 0.2f);
    overSince = isOver && s.own().y() < goalY + 3 ? Math.min(overSince, s.tick()) : s.tick();
    boolean letsGo = s.tick() - Math.max(overSince, grabbedAt) > DROP_TICKS;
    target = letsGo ? -1 : target;
    out.aim(DOWN).hold(Input.ACTION, !letsGo && s.tick() - grabbedAt < 2 * PATIENCE_TICKS);
  }

  /** Returns whether another robot is over a basket: two would push each other off. */
  private static boolean isTaken(Senses s, Level.Placement basket) {
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn e = s.view().entity(i);
      boolean isOther = e.archetype().name().equals("robot") && e.id() != s.own().id();
      if (isOther && way(basket, e.x(), e.y()) < 4) {
        return true;
      }
    }
    return false;
  }

  // ---- towers

  private void build(Senses s, Input out) {
    Level.Zone site = s.view().level().zones("site").get(0);
    float share = (s.view().playerId() * 7 % 16 + 0.5f) / 16;
    float x = site.minX() + 1 + share * (site.maxX() - site.minX() - 2);
    boolean carries = s.tick() < carryUntil && carryUntil - s.tick() <= CARRY_TICKS;
    boolean isOther = s.player().get(PlaygroundFields.TOWER) != height;
    boolean comes = Math.abs(x - s.own().x()) > THERE || s.tick() - builtAt > 1;
    if (carries || comes || isOther) {
      height = s.player().get(PlaygroundFields.TOWER);
      higherAt = s.tick(); // neither the way there nor what it brings elsewhere is idle
    }
    builtAt = s.tick();
    if (carries) {
      carryUntil = carried && !holds(s) ? s.tick() : carryUntil; // it has brought a thing
      carried = holds(s);
    } else if (s.tick() - higherAt > IDLE_TICKS) {
      carryUntil = s.tick() + CARRY_TICKS; // its tower fell
      carried = false;
    }
    if (carries || s.player().get(PlaygroundFields.THINGS) == PlaygroundGame.MAX_THINGS) {
      carry(s, out);
      return;
    }
    float top = site.minY();
    boolean moves = false;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn e = s.view().entity(i);
      String kind = e.archetype().name();
      if (Math.abs(e.x() - x) < 0.8f && !kind.equals("robot") && !kind.equals("hand")) {
        top = Math.max(top, e.y() + 0.5f);
        moves |= Math.abs(e.velocityY()) > 0.4f;
      }
    }
    float wantX = x + miss;
    fly(s, out, wantX, top + HOVER, slack() / 3);
    out.aim(DOWN);
    boolean isOver =
        Math.abs(s.own().x() - wantX) < slack()
            && Math.abs(s.own().velocityX()) < 1
            && Math.abs(s.own().y() - top - HOVER) < 0.25f;
    if (isOver && !moves && s.tick() > waitUntil) {
      out.hold(PlaygroundGame.MAKE, true);
      waitUntil = s.tick() + 20 + rest();
      miss = s.random().between(-slack(), slack());
    }
  }

  // ---- the star

  private void hunt(Senses s, Input out) {
    Drawn star = s.nearest("star");
    if (star == null) {
      wander(s, out);
      return;
    }
    FieldView keeper = s.view().match().get(PlaygroundFields.KEEPER);
    if (keeper != null && keeper.id() == s.view().playerId()) {
      flee(s, out);
      out.aim(s.direction(star)).hold(Input.ACTION, true);
      return;
    }
    fly(s, out, star.x(), star.y() + 1.5f, 0.2f);
    boolean mayGrab = keeper == null || s.view().match().get(PlaygroundFields.SAFE) == 0;
    if (mayGrab) {
      grab(s, out, star);
    } else {
      out.aim(s.direction(star));
    }
  }

  /** Flies from the nearest other robot, and back from the walls. */
  private void flee(Senses s, Input out) {
    Level.Bounds b = s.view().level().bounds();
    Drawn own = s.own();
    Drawn other = s.nearest("robot");
    float x = 0.05f * ((b.minX() + b.maxX()) / 2 - own.x());
    float y = 0.08f * ((b.minY() + b.maxY()) / 2 + 4 - own.y());
    if (other != null) {
      float away = Math.max(1, s.distance(other));
      x += 8 * (own.x() - other.x()) / (away * away);
      y += 8 * (own.y() - other.y()) / (away * away);
    }
    float length = Math.max(0.1f, (float) Math.hypot(x, y));
    out.move(speed() * x / length, speed() * y / length);
  }

  // ---- hands and wings

  private boolean holds(Senses s) {
    return s.player().get(PlaygroundFields.GRABS) && s.player().get(PlaygroundFields.HELD) != null;
  }

  /** Aims at a thing, and grabs when it is near enough and time. */
  private void grab(Senses s, Input out, Drawn thing) {
    out.aim(s.direction(thing) + miss * error() * 4);
    if (s.distance(thing) < REACH && s.tick() >= waitUntil) {
      out.hold(Input.ACTION, true);
      grabbedAt = s.tick();
      if (s.tick() > waitUntil + 8) { // a key must go up before it goes down again
        waitUntil = s.tick() + 2 + rest() / 2;
        miss = s.random().between(-1, 1);
        out.hold(Input.ACTION, holds(s));
      }
    }
  }

  /** Returns whether it should fly anywhere for a while, as it doesn't get on. */
  private boolean isLost(Senses s, float away) {
    int since = s.tick() - markTick;
    boolean gotOn = Math.hypot(s.own().x() - markX, s.own().y() - markY) > 1;
    if (away < 1.5f
        || since < 0
        || since > STUCK_TICKS + DETOUR_TICKS
        || (gotOn && since <= STUCK_TICKS)) {
      markX = s.own().x();
      markY = s.own().y();
      markTick = s.tick();
      return false;
    }
    if (since > STUCK_TICKS && detourOf != markTick) {
      detourOf = markTick;
      detour = freeWay(s);
    }
    return since > STUCK_TICKS;
  }

  /** Returns a direction in which no wall is near, if three tries find one, radians. */
  private static float freeWay(Senses s) {
    float way = 0;
    boolean isFree = false;
    for (int i = 0; i < 3 && !isFree; i++) {
      way = s.random().between(0, (float) (2 * Math.PI));
      isFree = !s.isWall(3 * (float) Math.cos(way), 3 * (float) Math.sin(way));
    }
    return way;
  }

  private void wander(Senses s, Input out) {
    Level.Bounds b = s.view().level().bounds();
    if (s.tick() >= waitUntil || Math.hypot(goalX - s.own().x(), goalY - s.own().y()) < 2) {
      waitUntil = s.tick() + 180;
      goalX = s.random().between(b.minX() + 3, b.maxX() - 3);
      goalY = s.random().between((b.minY() + b.maxY()) / 2, b.maxY() - 3);
    }
    fly(s, out, goalX, goalY, 1);
  }

  /** Flies to a place, over walls in between. */
  private void fly(Senses s, Input out, float x, float y, float near) {
    float dx = x - s.own().x();
    float dy = y - s.own().y();
    float away = (float) Math.hypot(dx, dy);
    if (isLost(s, away)) {
      out.move((float) Math.cos(detour), (float) Math.sin(detour));
      return;
    }
    float share = away < near ? 0 : speed() * Math.min(1, away / 2) / Math.max(away, 0.01f);
    float look = Math.min(1, 4 / Math.max(away, 0.01f));
    if (away > 1.5f && s.isWall(look * dx, look * dy)) {
      boolean low = s.isWall(0, 3); // something is above: out from under it
      out.move(low ? Math.signum(dx == 0 ? 1 : dx) : 0.3f * Math.signum(dx), low ? 0 : 1);
      return;
    }
    out.move(share * dx, share * dy);
  }
}
