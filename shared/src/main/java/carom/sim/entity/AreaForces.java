package carom.sim.entity;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.World;
import carom.physics.effects.Effect;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.field.Ratio;
import carom.sim.level.Archetype;
import carom.sim.level.Area;
import java.util.Arrays;
import java.util.List;

/**
 * The areas of one simulation: those of its level, and those that entities carry. In each tick,
 * {@link #begin} notes where the carried ones are; {@link #act} then lets all of them act on one
 * body after another.
 *
 * <p>What they do to a body depends on that body and on the areas alone, never on other bodies. A
 * client that has the body and the carriers near it thus computes what the server does. Areas act
 * in a fixed order, those of the level first, then by the carriers' ids.
 *
 * <p>Holds no state of the simulation but which entities are carriers, which its user tells. One
 * thread; allocates only to grow.
 *
 * @param <T> the world's user type
 */
public final class AreaForces<T> {
  /** Knows how strong areas are. */
  public interface Power<T> {
    /** Returns the value of an entity's field, 0..1. */
    float of(Body<T> carrier, Ratio field);
  }

  /** One area, with the place where it is in this tick. */
  private static final class Place<T> {
    Area area;
    Effect effect;
    int id;
    Body<T> carrier;

    /** The field that says how strong it is; null if it always is. */
    Ratio power;

    float strength = 1;
    final Transform frame = new Transform();
    final Aabb reach = new Aabb();

    Place<T> set(Area newArea, Effect newEffect, int newId, Body<T> newCarrier, Ratio newPower) {
      power = newPower;
      area = newArea;
      effect = newEffect;
      id = newId;
      carrier = newCarrier;
      return this;
    }

    void locate(Aabb out) {
      if (carrier != null) {
        frame.set(carrier.x(), carrier.y(), carrier.cos(), carrier.sin());
      }
      effect.reach(frame, out);
    }
  }

  private final World<T> world;
  private final boolean decides;
  private final Power<T> power;

  /**
   * Places of the level's areas, then those of the areas that are carried, by id; behind them spare
   * ones.
   */
  private Place<T>[] places;

  private final int ofLevel;
  private int count;

  /** By index of an archetype: the effect of the area that its entities carry, or null. */
  private Effect[] effects = {};

  private final Aabb box = new Aabb();
  private Body<T>[] sleepers;
  private int sleeperCount;
  private final BodyVisitor<T> collectSleeper = this::collectSleeper;

  /**
   * Creates the areas of a level.
   *
   * @param world the simulation's world
   * @param areas those of the level, which don't move
   * @param power knows how strong carried areas are
   * @param decides whether an area that comes or goes wakes what sleeps in it. A client doesn't
   *     decide: its bodies have the server's state
   */
  @SuppressWarnings("unchecked")
  public AreaForces(World<T> world, List<Area> areas, Power<T> power, boolean decides) {
    this.power = power;
    this.world = world;
    this.decides = decides;
    ofLevel = areas.size();
    places = (Place<T>[]) new Place<?>[Math.max(4, 2 * ofLevel)];
    sleepers = (Body<T>[]) new Body<?>[16];
    for (Area area : areas) {
      Place<T> place = new Place<T>().set(area, area.effect(world), -1, null, null);
      place.locate(place.reach);
      places[count++] = place;
    }
  }

  /** Adds an entity that comes. What sleeps in its area wakes. */
  public void come(int id, Body<T> body, Archetype archetype) {
    add(id, body, archetype);
    wakeAround(id);
  }

  /** Removes an entity that goes. What sleeps in its area wakes. */
  public void go(int id) {
    wakeAround(id);
    remove(id);
  }

  /**
   * Adds an entity of a state that is restored; it counts if its archetype carries an area.
   *
   * @param id of the entity
   * @param body its body
   * @param archetype its archetype
   */
  public void add(int id, Body<T> body, Archetype archetype) {
    if (archetype.area() == null) {
      return;
    }
    if (count == places.length) {
      places = Arrays.copyOf(places, 2 * count);
    }
    Place<T> place = places[count] == null ? new Place<>() : places[count];
    int at = count++;
    for (; at > ofLevel && places[at - 1].id > id; at--) {
      places[at] = places[at - 1];
    }
    places[at] = place.set(archetype.area(), effect(archetype), id, body, archetype.areaPower());
  }

  private void remove(int id) {
    for (int i = ofLevel; i < count; i++) {
      if (places[i].id == id) {
        Place<T> spare = places[i];
        System.arraycopy(places, i + 1, places, i, --count - i);
        places[count] = spare;
        return;
      }
    }
  }

  /** Removes all carriers, before those of another state are added. */
  public void clear() {
    count = ofLevel;
  }

  private Effect effect(Archetype archetype) {
    int index = archetype.index();
    if (index >= effects.length) {
      effects = Arrays.copyOf(effects, Math.max(index + 1, 2 * effects.length));
    }
    if (effects[index] == null) {
      effects[index] = archetype.area().effect(world);
    }
    return effects[index];
  }

  /** Returns the number of entities that carry areas. */
  public int carriers() {
    return count - ofLevel;
  }

  /** Returns the id of the entity that carries the area of a number below {@link #carriers}. */
  public int carrierId(int index) {
    return places[ofLevel + index].id;
  }

  /**
   * Tells where a carried area may act now.
   *
   * @param index 0 to {@link #carriers} less 1; they are sorted by their ids
   * @param out receives the box, metres
   */
  public void reach(int index, Aabb out) {
    places[ofLevel + index].locate(out);
  }

  /**
   * Begins a tick: finds the carried areas, and wakes what sleeps within one that moves or that a
   * field switches. Nothing can thus fall asleep in one that may be switched off.
   */
  public void begin() {
    for (int i = ofLevel; i < count; i++) {
      Place<T> place = places[i];
      place.locate(place.reach);
      place.strength = place.power == null ? 1 : power.of(place.carrier, place.power);
      boolean changes = place.power != null || isMoving(place.carrier);
      if (changes && place.strength > 0) {
        wake(place.reach);
      }
    }
  }

  private static boolean isMoving(Body<?> body) {
    return body.type() == BodyType.DYNAMIC
        ? body.awake()
        : body.velocityX() != 0 || body.velocityY() != 0 || body.angularVelocity() != 0;
  }

  /**
   * Lets all areas act on an awake body in the next step. An area doesn't act on its own carrier.
   *
   * @param body the body
   * @param archetype the archetype of its entity
   * @param dtSeconds length of the step, s
   */
  public void act(Body<T> body, Archetype archetype, float dtSeconds) {
    if (count == 0) {
      return;
    }
    float x = body.centerX();
    float y = body.centerY();
    float margin =
        2 * archetype.reach()
            + dtSeconds * (Math.abs(body.velocityX()) + Math.abs(body.velocityY()));
    for (int i = 0; i < count; i++) {
      Place<T> place = places[i];
      Aabb reach = place.reach;
      if (x < reach.minX - margin
          || x > reach.maxX + margin
          || y < reach.minY - margin
          || y > reach.maxY + margin
          || place.carrier == body
          || place.strength == 0
          || (place.area.tag() != Area.ANY_TAG && place.area.tag() != archetype.tag())) {
        continue;
      }
      place.effect.act(world, body, place.frame, place.strength, dtSeconds);
    }
  }

  /** Wakes what sleeps within the area that an entity carries, if it carries one. */
  public void wakeAround(int id) {
    for (int i = ofLevel; decides && i < count; i++) {
      if (places[i].id == id) {
        places[i].locate(box);
        wake(box);
      }
    }
  }

  /** Wakes what sleeps within a box. */
  public void wake(Aabb within) {
    sleeperCount = 0;
    world.queryAabb(within.minX, within.minY, within.maxX, within.maxY, collectSleeper);
    for (int i = 0; i < sleeperCount; i++) {
      sleepers[i].wake();
    }
    Arrays.fill(sleepers, 0, sleeperCount, null);
  }

  private boolean collectSleeper(Body<T> body) {
    if (body.type() == BodyType.DYNAMIC && !body.awake()) {
      if (sleeperCount == sleepers.length) {
        sleepers = Arrays.copyOf(sleepers, 2 * sleeperCount);
      }
      sleepers[sleeperCount++] = body;
    }
    return true;
  }
}
