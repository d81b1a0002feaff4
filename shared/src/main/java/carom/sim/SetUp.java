package carom.sim;

import carom.physics.math.Limits;
import carom.physics.mover.MoverDef;
import carom.sim.entity.Assembly;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityMover;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.message.MessageKind;
import carom.sim.outbox.Event;
import carom.sim.pool.ParticleWorld;
import carom.sim.pool.Pool;
import carom.sim.pool.PoolDef;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;

/**
 * The place where {@link Game#setUp} registers what the game is made of, on both sides alike and in
 * the same order.
 */
public final class SetUp {
  private final SimParts parts;

  /** Sorts of things with the names by which views, levels and logs know them. */
  private final Set<String> named = new TreeSet<>();

  SetUp(SimParts parts) {
    this.parts = parts;
  }

  /** Returns the level that will be played. */
  public Level level() {
    return parts.level;
  }

  /** Returns the number of ticks per second. */
  public int tickRate() {
    return parts.tickRate;
  }

  /** Returns the static geometry of the level, in file order; unmodifiable. */
  public List<Entity> statics() {
    return Collections.unmodifiableList(parts.statics);
  }

  /**
   * Registers an archetype: a kind of entity, with its shapes, materials and look.
   *
   * @throws IllegalStateException beyond {@value carom.sim.level.Archetypes#MAX}
   * @throws IllegalArgumentException when the game has registered one of this name
   */
  public Archetype archetype(ArchetypeDef def) {
    Limits.notNull("def", def);
    return register("archetype", def.name(), () -> parts.archetypes.add(def));
  }

  private <T> T register(String sort, String name, Supplier<T> add) {
    String own = sort + "=" + name;
    if (named.contains(own)) {
      throw new IllegalArgumentException(own + " is registered twice; give each a name of its own");
    }
    T thing = add.get();
    named.add(own);
    return thing;
  }

  /**
   * Returns an archetype of the level by its name.
   *
   * @throws IllegalArgumentException if there is none
   */
  public Archetype archetype(String name) {
    return parts.archetype(name);
  }

  /**
   * Registers an assembly: bodies and joints that belong together, such as a car.
   *
   * @throws IllegalArgumentException when the game has registered one of this name
   */
  public Assembly assembly(AssemblyDef def) {
    Limits.notNull("def", def);
    return register("assembly", def.name(), () -> parts.assemblies.add(def));
  }

  /**
   * Registers a silent kind of event, see {@link #event(String, int, float, String, Sound, float)}.
   */
  public EventKind event(String name, int rgb, float radius, String label) {
    return event(name, rgb, radius, label, Sound.NONE, 0);
  }

  /**
   * Registers a kind of event.
   *
   * @param name for logs and tests
   * @param rgb colour of its flash, 0xrrggbb
   * @param radius of its flash, metres, 0..100; 0 for no flash
   * @param label short text that rises from where it happens; empty for none
   * @param sound its sound
   * @param fullStrength {@link Event#strength} from which on the sound is loudest, finite, 0 and
   *     above; 0 if it always is
   * @throws IllegalArgumentException when radius or fullStrength is outside its range, or the game
   *     has registered a kind of this name
   */
  public EventKind event(
      String name, int rgb, float radius, String label, Sound sound, float fullStrength) {
    return register(
        "event", name, () -> parts.eventKinds.add(name, rgb, radius, label, sound, fullStrength));
  }

  /** Registers a kind of message, and returns it. */
  public MessageKind message(MessageKind kind) {
    return parts.messageKinds.add(kind);
  }

  /** Adds water or sand to that of the level, and returns it. */
  public Pool pool(PoolDef def) {
    return parts.pools.add(def);
  }

  /** Returns a pool of the level by its name, or null. */
  public Pool pool(String name) {
    return parts.pools.find(Limits.notNull("name", name));
  }

  /**
   * Shows particles of a world that nobody acts on, at clients.
   *
   * @param copy makes a client's copy of that world; the server never asks for it
   * @throws IllegalStateException if there is one already
   */
  public void showAtClients(Supplier<ParticleWorld> copy) {
    Limits.notNull("copy", copy);
    if (parts.role == Role.PREDICTION) {
      parts.pools.follow(copy.get());
    }
  }

  /** Makes a character that walks, see docs/engine/MOVER.md; keep it. */
  public EntityMover mover(MoverDef<?> def) {
    return new EntityMover(parts.world, def, parts.tickRate);
  }
}
