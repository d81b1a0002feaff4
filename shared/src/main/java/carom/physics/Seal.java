package carom.physics;

/**
 * Decides which calls may still change a {@linkplain World#seal sealed} world. Programs seal worlds
 * that others compute, too, from the same definitions and without hearing of such calls.
 *
 * <p>These are asked about: all that changes what bodies are made of, creates or destroys bodies,
 * moves static ones, sets filters and listeners, steps the world or gives it another state. What
 * moves or pushes other bodies, and all calls of joints, are always possible.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface Seal<T> {
  /**
   * Returns why a call is refused.
   *
   * @param call the name of the method of {@link World} or {@link Body}
   * @param body the body it would change, null if it isn't about one
   * @return the reason and what to do instead, for the error's text; null if the call is possible
   */
  String refusal(String call, Body<T> body);

  /**
   * Receives that a caller of {@link Body#forEachOverlap} got a body. It may advise, and must
   * change nothing.
   *
   * @param asked the body that was asked about
   * @param other the one that overlaps it
   */
  default void overlapRead(Body<T> asked, Body<T> other) {}
}
