package carom.sim.entity;

/** Receives the contacts of an entity, see {@link Entity#forEachContact}. */
@FunctionalInterface
public interface EntityContactVisitor {
  /**
   * Receives a contact; called once per pair of touching shapes.
   *
   * @param other the other entity
   * @param normalX x of the unit normal from the visited entity towards the other
   * @param normalY y of the unit normal; below -0.7 the visited entity stands on the other one
   * @param impulse total impulse along the normal in the last step, N s, not negative; 0 if the
   *     shapes were merely close, or vetoed
   */
  void contact(Entity other, float normalX, float normalY, float impulse);
}
