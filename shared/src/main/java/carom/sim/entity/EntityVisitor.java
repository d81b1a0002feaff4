package carom.sim.entity;

/** Receives what a query finds. */
@FunctionalInterface
public interface EntityVisitor {
  /**
   * Receives an entity; called once for each. It must not spawn or despawn, or make another query.
   *
   * @param hit reused for the next one: copy what you keep
   * @return true to go on with the next one, false to stop
   */
  boolean visit(EntityHit hit);
}
