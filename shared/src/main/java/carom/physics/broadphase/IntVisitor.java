package carom.physics.broadphase;

/** Receives ids one by one, and may stop the search. */
@FunctionalInterface
public interface IntVisitor {
  /**
   * Receives an id. Each id found is passed once.
   *
   * @param id the caller's id of a box
   * @return true to go on, false to stop the search
   */
  boolean visit(int id);
}
