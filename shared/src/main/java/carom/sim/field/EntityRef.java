package carom.sim.field;

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
  EntityRef with(Spec changed) {
    return new EntityRef(changed);
  }

  /** Returns the word of an entity. */
  public static int word(int id, int generation) {
    return (generation << 16 | id) + 1;
  }

  @Override
  public String show(int word) {
    return word == 0
        ? "none"
        : "entity " + ((word - 1) & 0xffff) + " generation " + ((word - 1) >>> 16);
  }
}
