package carom.sim.entity;

/** Chooses what a query sees. */
@FunctionalInterface
public interface EntityFilter {
  /**
   * Returns whether a query sees an entity. It may be called several times for the same one, in no
   * particular order, and must change nothing.
   */
  boolean accepts(Entity entity);
}
