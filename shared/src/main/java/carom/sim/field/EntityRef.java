package carom.sim.field;

import carom.sim.spawn.Origin;

/**
 * A field for an entity, see {@link Field#entity}. It knows the entity's id and generation, so it
 * never means another entity that was given the id later.
 */
public final class EntityRef extends Field<EntityRef> {
  /** Largest word: 1 above the largest id with the largest generation. */
  static final int MOST = 0xff_ffff + 1;

  EntityRef(Spec spec) {
    super(spec);
  }

  @Override
  boolean lasts() {
    return false;
  }

  @Override
  EntityRef with(Spec changed) {
    return new EntityRef(changed);
  }

  /** Returns the word of an entity. */
  public static int word(int id, int generation) {
    return (generation << 16 | id) + 1;
  }

  /** Returns the id in a word less 1. What a client's input spawned has its origin for an id. */
  static int id(int key) {
    return Origin.isProvisional(key) ? key : key & 0xffff;
  }

  /** Returns the generation in a word less 1. */
  static int generation(int key) {
    return Origin.isProvisional(key) ? 0 : key >>> 16;
  }

  @Override
  public Object value(int word) {
    return word == 0 ? -1 : id(word - 1);
  }

  @Override
  public String show(int word) {
    return word == 0 ? "none" : "entity " + id(word - 1) + " generation " + generation(word - 1);
  }
}
