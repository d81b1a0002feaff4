package carom.physics;

/**
 * Receives the collisions of a world during {@link World#step}.
 *
 * <p>Two shapes begin to touch when they overlap or will meet within the step, and touch until they
 * are farther apart than {@link WorldDef#speculativeDistance} or pass each other. Within a step,
 * {@code end}, {@code begin} and {@code preSolve} are called before anything is solved. {@code
 * preSolve} is also asked about shapes that are close but don't touch, because a blow within the
 * step may push them together; {@code begin} is then called after the solver. {@code postSolve} is
 * called when the bodies have moved, followed by {@code hit} of the same contact if it was an
 * impact. Calls of each kind come in the canonical order of contacts: by the indices of the two
 * bodies, then of their shapes. But {@code preSolve} comes before its turn, and before {@code
 * begin}, where it decides whether other shapes touch or a body wakes.
 *
 * <p>When a shape enters a sensor or leaves it, {@code begin} and {@code end} are called, with
 * {@link Collision#isSensor} true. Nothing else is called, as there is no response. Sensors notice
 * real overlap only, not shapes that are merely close. A fast shape may cross a sensor within one
 * step (unless {@link WorldDef#continuous} is off): {@code begin} is then called at the end of that
 * step, after {@code hit}, and {@code end} in the next one.
 *
 * <p>Contacts of sleeping bodies are not reported. They stay as they were when the bodies fell
 * asleep, and waking doesn't begin them anew. If {@code preSolve} would return another value
 * because something else changed, {@linkplain Body#wake wake} the body.
 *
 * <p>A callback may set velocities, apply forces and impulses, teleport bodies and create bodies
 * (these collide from the next step on); bodies wake or fall asleep at the end of the step. {@link
 * World#destroyBody} takes effect at the end of the step; until then the body stays valid.
 * Stepping, saving or restoring the world throws IllegalStateException. Results must depend on the
 * world's state alone, or runs will differ.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public interface CollisionListener<T> {
  /**
   * Receives a contact whose shapes began to touch. Called before {@link #preSolve} of the same
   * contact; at the end of the step for a sensor that was crossed within it, and for shapes that a
   * blow within it pushed together.
   *
   * @param collision valid during the call only; no impulses yet
   */
  default void begin(Collision<T> collision) {}

  /**
   * Receives a contact whose shapes no longer touch, or of which a body is being destroyed.
   *
   * @param collision valid during the call only; no points
   */
  default void end(Collision<T> collision) {}

  /**
   * Decides whether touching shapes are pushed apart in this step, and how: it may set the
   * collision's {@linkplain Collision#setFriction friction}, {@linkplain Collision#setRestitution
   * restitution} and {@linkplain Collision#setTangentSpeed tangent speed}. Both the answer and the
   * settings hold for this step only; the next one asks again.
   *
   * <p>It is also asked, after the solver, about shapes at which continuous collision would stop a
   * fast body, if they had no contact when the step began: {@link Collision#isSwept} is true then.
   *
   * @param collision valid during the call only; the impulses are those of the step before
   * @return false to let them pass through each other in this step
   */
  default boolean preSolve(Collision<T> collision) {
    return true;
  }

  /**
   * Receives a contact that was solved in this step: its shapes touched and {@link #preSolve}
   * returned true.
   *
   * @param collision valid during the call only; with the impulses of this step. Points and normal
   *     are those the step began with, the bodies have moved already
   */
  default void postSolve(Collision<T> collision) {}

  /**
   * Receives an impact: two shapes approached faster than {@link WorldDef#hitSpeed} when the step
   * began, were pushed apart in it, and were not in the step before. An impact is therefore
   * reported once, however long it lasts. Called after {@link #postSolve} of the same contact. A
   * body that hits with several shapes, or hits several bodies, is reported for each contact.
   *
   * @param collision valid during the call only; as in postSolve, with {@link Collision#hitSpeed}
   *     and {@link Collision#hitX}
   */
  default void hit(Collision<T> collision) {}
}
