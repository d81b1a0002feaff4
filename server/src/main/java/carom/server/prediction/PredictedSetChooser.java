package carom.server.prediction;

import carom.net.snapshot.exact.NearState;
import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.Joint;
import carom.physics.math.Aabb;
import carom.sim.SimulationHost;
import carom.sim.entity.AreaForces;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.EntityRef;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * Chooses which entities are near a player's body:
 *
 * <ol>
 *   <li>the body itself, and all that it touches, directly or through others;
 *   <li>what the player's input has spawned, wherever it is, with all that it touches;
 *   <li>what is close to the body or soon will be, the closest first, each with all that it
 *       touches; then what is close to the {@value #FOLLOWED} newest spawned ones; while the list
 *       is shorter than {@value #MOST_CLOSE}. An awake heap farther away that doesn't fit into less
 *       than half of the list isn't chosen: a part of it would fall at the client at once;
 *   <li>all that joints hold together with one of these, directly or through others: bodies that
 *       joints hold together are chosen as a whole or not at all. Only what no set could hold is
 *       cut if the own body touches it, and the client holds the bodies at the cut;
 *   <li>what fields of players, told to all near, mean: with the body of the player, and that with
 *       it;
 *   <li>what carries an {@linkplain carom.sim.level.Area area} that acts on one of these, or soon
 *       may;
 *   <li>what {@linkplain carom.sim.Rules#move rules may move}, as far as the player sees.
 * </ol>
 *
 * <p>An entity that was chosen before stays until it is {@value #LEAVE} times as far away. But for
 * the own body, sensors without an area are never chosen (but where there are rules), nor are
 * statics of the level, nor is what the game hides from the player.
 *
 * <p>The room's thread; allocates only to grow.
 */
final class PredictedSetChooser {
  /** An entity enters within this distance of the body's origin, metres: what it may touch. */
  private static final float NEAR_METRES = 3;

  /**
   * Distance as {@link #NEAR_METRES} for a client that takes as many entities as there is room for,
   * metres.
   */
  private static final float ALL_METRES = 15;

  /** An entity whose area ends this far away enters, metres: bodies move while it is told. */
  private static final float CARRIER_METRES = 4;

  /**
   * Distance of the origins within which what rules may move enters, metres: it moves at once on
   * the screen of the player who sets it off.
   */
  private static final float MOVABLE_METRES = 30;

  /** An entity leaves at this many times the distance at which it enters. */
  private static final float LEAVE = 1.4f;

  /** An entity that approaches enters this early, seconds before it is there. */
  private static final float LEAD_SECONDS = 0.3f;

  /** Number of spawned entities around which others are chosen, too: the newest. */
  private static final int FOLLOWED = 8;

  /** Entities that don't touch the body are added while there are fewer than these. */
  private static final int MOST_CLOSE = 63;

  private final SimulationHost simulation;
  private final EntityMarks marks;
  private final Predicate<HostEntity> mayKnow;
  private final EntityList chosen = new EntityList();
  private final Candidates candidates = new Candidates(4 * MOST_CLOSE);
  private final Aabb box = new Aabb();
  private final BodyVisitor<HostEntity> considerVisitor = this::consider;
  private final BodyContactVisitor<HostEntity> addVisitor =
      (other, normalX, normalY, impulse) -> addIfFit(other.user());

  private final Consumer<Joint<HostEntity>> jointVisitor = this::follow;

  /** Words of players that mean entities and are told to all near. */
  private final int[] references;

  /** True while the own body is being chosen, with all that joints tie to it. */
  private boolean choosesOwn;

  /** True while what touches the own body is being chosen, directly or through others. */
  private boolean spreadsOwn;

  /** True if all that joints tie to an entity could be chosen so far. */
  private boolean fits;

  /** True if joints tie more to an entity than any set holds. */
  private boolean isTooLarge;

  private boolean reachedFromOutside;
  private int limit;

  /** True if there was no room for all that a candidate touches. */
  private boolean lacksRoom;

  /** The body around which candidates are gathered, and how close they must be, metres. */
  private Body<HostEntity> centre;

  private float enterMetres;

  PredictedSetChooser(SimulationHost simulation, EntityMarks marks, Predicate<HostEntity> mayKnow) {
    this.simulation = simulation;
    this.marks = marks;
    this.mayKnow = mayKnow;
    Schema schema = simulation.schema();
    references =
        IntStream.range(0, schema.words(Scope.PLAYER))
            .filter(word -> schema.field(Scope.PLAYER, word) instanceof EntityRef)
            .filter(word -> schema.isShared(Scope.PLAYER, word))
            .toArray();
  }

  /** Returns the entities chosen last, in the order of the world. */
  EntityList chosen() {
    return chosen;
  }

  /**
   * Chooses anew.
   *
   * @param player has a body
   * @param all whether to reach as far as possible, or only as far as the body may touch soon
   * @param before what was chosen before
   * @param most the most entities to choose
   */
  void choose(HostPlayer player, boolean all, KeyList before, int most) {
    marks.clear(simulation.entityCapacity());
    for (int i = 0; i < before.count(); i++) {
      HostEntity e = EntityList.find(simulation, before.get(i));
      if (e != null) {
        marks.member(e.id());
      }
    }
    chosen.clear();
    limit = most;
    choosesOwn = true;
    addIfFit(player.entity());
    choosesOwn = false;
    spreadsOwn = true;
    spreadContacts(0);
    spreadsOwn = false;
    for (int i = player.spawnedCount() - 1; i >= 0; i--) {
      addWithContacts(player.spawned(i));
    }
    limit = Math.min(most, Math.max(chosen.count(), MOST_CLOSE));
    addClose(player.entity().body(), all ? ALL_METRES : NEAR_METRES);
    int oldest = Math.max(0, player.spawnedCount() - FOLLOWED);
    for (int i = player.spawnedCount() - 1; i >= oldest; i--) {
      addClose(player.spawned(i).body(), NEAR_METRES);
    }
    limit = most;
    addMeant();
    addCarriers();
    addMovable(player.entity());
    chosen.sort(simulation);
    reachedFromOutside = isReached();
  }

  /**
   * Adds what chosen players' fields mean, if all near are told them, and the bodies of players
   * whose fields mean what is chosen: an input may push the one and look at it.
   */
  private void addMeant() {
    for (int id = 0; references.length > 0 && id < simulation.playerCapacity(); id++) {
      HostPlayer p = simulation.player(id);
      for (int i = 0; i < references.length && p != null && p.isAlive(); i++) {
        HostEntity meant = meant(p, references[i]);
        if (meant != null && marks.isListed(p.entity().id())) {
          addWithContacts(meant);
        } else if (meant != null && marks.isListed(meant.id())) {
          addWithContacts(p.entity());
        }
      }
    }
  }

  /** Returns whether a field of a player that all near are told means an entity. */
  boolean means(HostPlayer p) {
    boolean means = false;
    for (int i = 0; i < references.length && !means; i++) {
      means = meant(p, references[i]) != null;
    }
    return means;
  }

  private HostEntity meant(HostPlayer p, int word) {
    Schema schema = simulation.schema();
    EntityRef field = (EntityRef) schema.field(Scope.PLAYER, word);
    return (HostEntity) p.get(field, schema.index(Scope.PLAYER, word));
  }

  /** Returns whether something that isn't chosen acts on what is, or is what its input looks at. */
  private boolean isReached() {
    boolean reached = false;
    for (int i = 0; i < simulation.areas().carriers() && !reached; i++) {
      simulation.areas().reach(i, box);
      box.grow(CARRIER_METRES);
      reached = !marks.isListed(simulation.areas().carrierId(i)) && isOneWithin(box);
    }
    for (int id = 0; references.length > 0 && id < simulation.playerCapacity(); id++) {
      HostPlayer p = simulation.player(id);
      for (int i = 0; i < references.length && p != null && p.isAlive() && !reached; i++) {
        HostEntity meant = meant(p, references[i]);
        reached = meant != null && marks.isListed(meant.id()) != marks.isListed(p.entity().id());
      }
    }
    return reached;
  }

  /** Adds the bodies that rules may move, without what these touch: that doesn't move them. */
  private void addMovable(HostEntity own) {
    for (int i = 0; i < simulation.movableCount(); i++) {
      HostEntity e = simulation.movable(i);
      if (e != null) {
        float reach = MOVABLE_METRES * (marks.isMember(e.id()) ? LEAVE : 1);
        if (length(e.x() - own.x(), e.y() - own.y()) <= reach) {
          addIfFit(e);
        }
      }
    }
  }

  /** Adds the entities whose areas act on a chosen one, or soon may. */
  private void addCarriers() {
    AreaForces<HostEntity> areas = simulation.areas();
    for (int i = 0; i < areas.carriers(); i++) {
      HostEntity carrier = simulation.entity(areas.carrierId(i));
      areas.reach(i, box);
      box.grow(CARRIER_METRES * (marks.isMember(carrier.id()) ? LEAVE : 1));
      if (!marks.isListed(carrier.id()) && isOneWithin(box)) {
        addWithContacts(carrier);
      }
    }
  }

  private boolean isOneWithin(Aabb area) {
    for (int i = 0; i < chosen.count(); i++) {
      Body<HostEntity> body = chosen.get(i).body();
      if (area.contains(body.centerX(), body.centerY())) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether an entity was chosen. Valid until another session chooses. */
  boolean isChosen(int id) {
    return marks.isListed(id);
  }

  /**
   * Returns whether an area or an input may act on a chosen entity whose carrier or player isn't
   * among them, because there was no room, the game hides it, or it began since they were chosen.
   */
  boolean isReachedFromOutside() {
    return reachedFromOutside;
  }

  /**
   * Chooses what was chosen before.
   *
   * @return false when one of them is gone, or is hidden from the player by now
   */
  boolean chooseAgain(KeyList before) {
    chosen.clear();
    marks.clear(simulation.entityCapacity());
    for (int i = 0; i < before.count(); i++) {
      HostEntity e = EntityList.find(simulation, before.get(i));
      if (e == null || !mayKnow.test(e)) {
        return false;
      }
      marks.list(e.id());
      chosen.add(e);
    }
    reachedFromOutside = isReached();
    return true;
  }

  /** Adds an entity and all that it touches, directly or through others, while there is room. */
  private void addWithContacts(HostEntity from) {
    int first = chosen.count();
    addIfFit(from);
    spreadContacts(first);
  }

  /** Adds all that the chosen entities from a place on touch, directly or through others. */
  private void spreadContacts(int first) {
    for (int next = first; next < chosen.count(); next++) {
      chosen.get(next).body().forEachContact(addVisitor);
    }
  }

  private void addIfFit(HostEntity e) {
    if (!(choosesOwn || affectsOthers(e)) || marks.isListed(e.id()) || !mayKnow.test(e)) {
      return;
    }
    if (chosen.count() >= limit) {
      lacksRoom = true;
      return;
    }
    marks.list(e.id());
    int first = chosen.count();
    chosen.add(e);
    addJointed(first);
    if (choosesOwn || (fits && chosen.count() <= limit)) {
      return; // the own body is never left out, whatever hangs on it
    }
    // What no set could hold is cut where there is no more room, if the own island touches it.
    lacksRoom = true;
    int keep = isTooLarge && spreadsOwn ? limit : first;
    while (chosen.count() > keep) {
      marks.unlist(chosen.removeLast().id());
    }
  }

  /**
   * Adds all that joints tie to a chosen entity, through dynamic bodies, the nearest along joints
   * first. Notes whether the game hides some, and whether it is more than any set holds.
   *
   * @param first place of the entity, the last one
   */
  private void addJointed(int first) {
    fits = true;
    isTooLarge = false;
    for (int i = first; i < chosen.count() && fits; i++) {
      Body<HostEntity> body = chosen.get(i).body();
      if (body.type() == BodyType.DYNAMIC) {
        body.forEachJoint(jointVisitor);
      }
    }
  }

  private void follow(Joint<HostEntity> joint) {
    addTied(joint.bodyA());
    addTied(joint.bodyB());
  }

  private void addTied(Body<HostEntity> body) {
    HostEntity e = body == null ? null : body.user();
    if (e == null || e.isLevel() || marks.isListed(e.id())) {
      return;
    }
    isTooLarge |= chosen.count() == NearState.MAX_ENTITIES;
    if (isTooLarge || !mayKnow.test(e)) {
      fits = false;
      return;
    }
    marks.list(e.id());
    chosen.add(e);
  }

  private boolean affectsOthers(HostEntity e) {
    return !e.isLevel() && Neighbourhood.affectsOthers(simulation, e.archetype());
  }

  /** Adds what is close to a body or soon will be, the closest first. */
  private void addClose(Body<HostEntity> body, float metres) {
    centre = body;
    enterMetres = metres;
    gatherCandidates();
    for (int i = 0; i < candidates.count(); i++) {
      HostEntity e = candidates.get(i);
      int first = chosen.count();
      lacksRoom = marks.isLeftOut(e.id());
      if (!lacksRoom) {
        addWithContacts(e);
      }
      boolean isFar = candidates.distance(i) > NEAR_METRES;
      if (lacksRoom && isFar && e.body().awake() && 2 * (limit - first) < limit) {
        while (chosen.count() > first) {
          marks.leaveOut(chosen.removeLast().id());
        }
      }
    }
    candidates.clear();
  }

  private void gatherCandidates() {
    centre.aabb(box);
    float speed = length(centre.velocityX(), centre.velocityY());
    float range = enterMetres * LEAVE + 2 * speed * LEAD_SECONDS;
    simulation
        .world()
        .queryAabb(
            box.minX - range,
            box.minY - range,
            box.maxX + range,
            box.maxY + range,
            considerVisitor);
  }

  /** Makes a body a candidate if it is close enough, or soon will be. */
  private boolean consider(Body<HostEntity> body) {
    HostEntity e = body.user();
    if (!affectsOthers(e) || body == centre || !mayKnow.test(e)) {
      return true;
    }
    body.aabb(box);
    float dx = Math.max(0, Math.max(box.minX - centre.x(), centre.x() - box.maxX));
    float dy = Math.max(0, Math.max(box.minY - centre.y(), centre.y() - box.maxY));
    float away = length(dx, dy);
    float closing =
        away == 0
            ? 0
            : ((centre.velocityX() - body.velocityX()) * (body.x() - centre.x())
                    + (centre.velocityY() - body.velocityY()) * (body.y() - centre.y()))
                / Math.max(1e-3f, length(body.x() - centre.x(), body.y() - centre.y()));
    float soon = away - Math.max(0, closing) * LEAD_SECONDS;
    boolean member = marks.isMember(e.id());
    if (soon <= enterMetres * (member ? LEAVE : 1)) {
      candidates.insert(e, member ? soon / LEAVE : soon);
    }
    return true;
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }

  /** Entities sorted by distance. */
  private static final class Candidates {
    private final int most;
    private HostEntity[] entities = new HostEntity[16];
    private float[] distances = new float[16];
    private int count;

    Candidates(int most) {
      this.most = most;
    }

    int count() {
      return count;
    }

    HostEntity get(int index) {
      return entities[index];
    }

    float distance(int index) {
      return distances[index];
    }

    void clear() {
      Arrays.fill(entities, 0, count, null);
      count = 0;
    }

    void insert(HostEntity e, float distance) {
      if (count == entities.length) {
        if (count >= most) {
          return; // a crowd: the order of the query decides
        }
        entities = Arrays.copyOf(entities, 2 * count);
        distances = Arrays.copyOf(distances, 2 * count);
      }
      int at = count++;
      for (; at > 0 && distances[at - 1] > distance; at--) {
        entities[at] = entities[at - 1];
        distances[at] = distances[at - 1];
      }
      entities[at] = e;
      distances[at] = distance;
    }
  }
}
