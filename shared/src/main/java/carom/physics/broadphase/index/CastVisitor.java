package carom.physics.broadphase.index;

/** Receives the boxes that a moving box may meet, and says how far it still has to go. */
@FunctionalInterface
public interface CastVisitor {
  /**
   * Called for a box on the way.
   *
   * @param id the caller's id of the box
   * @param maxFraction where the search ends at present, in units of the way
   * @return where the search shall end from now on: {@code maxFraction} to go on as before, less to
   *     leave out what comes later, a negative number to stop
   */
  float visit(int id, float maxFraction);
}
