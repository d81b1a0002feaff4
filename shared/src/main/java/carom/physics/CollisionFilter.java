package carom.physics;

/**
 * Decides which shapes never meet, for rules that {@link Filter} can't express: {@link
 * World#collisionFilter} sets it. It is asked before the narrow phase, and only about pairs that
 * filters, types and joints let meet. So a refused pair costs no contact, and the {@link
 * CollisionListener} never hears of it. Sensors and continuous collision obey it, too; queries
 * don't.
 *
 * <p><b>When.</b> A pair is asked about when its fat boxes begin to overlap, and again as often as
 * the engine likes; a pair whose shapes touch is not. When that is depends on the broadphase and
 * shows in no result, as long as the answer is constant. An answer may depend on what the bodies
 * are ({@link Body#user()}, their shapes), not on where they are. For what changes from step to
 * step there is {@link CollisionListener#preSolve}.
 *
 * <p><b>If the answer changes</b>, call {@link Body#refilter}. The next step then asks about all
 * pairs of the body: contacts that are refused end, and those that are allowed begin.
 *
 * <p>Where several machines compute the same world, each must set an equal filter, and answers must
 * never change: a game sets it in its set-up on server and clients, and its world refuses {@link
 * Body#refilter}. What changes belongs to the game's {@code collision}, which both sides ask.
 *
 * <p>A {@link WorldRecorder} records the answers by pair of shapes. Its replay needs no filter.
 *
 * <p>It is called on the thread that steps the world, whatever {@linkplain World#workers workers}
 * there are. It must change nothing and make no query. It is no part of the world's state: worlds
 * behave alike if their filters answer alike.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface CollisionFilter<T> {
  /**
   * Returns whether two shapes meet.
   *
   * @param self the body with the smaller {@link Body#index()}
   * @param selfShape number of its shape, see {@link Body#shape}
   * @param other the body with the larger index
   * @param otherShape number of its shape
   * @return false to let them pass through each other
   */
  boolean shouldCollide(Body<T> self, int selfShape, Body<T> other, int otherShape);
}
