package carom.physics.broadphase;

/** Receives the boxes that a moving box may meet, and decides where the cast ends. */
@FunctionalInterface
public interface CastVisitor {
  /**
   * Receives a box on the way.
   *
   * @param id the caller's id of the box
   * @param maxFraction where the search ends at present, in units of the way
   * @return where the search ends from now on: {@code maxFraction} to go on as before, less to skip
   *     boxes met later, a negative number to stop
   */
  float visit(int id, float maxFraction);
}
