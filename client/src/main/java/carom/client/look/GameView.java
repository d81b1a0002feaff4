package carom.client.look;

/**
 * The look of a game: keys, pictures, sounds, camera. Put a class with a public constructor without
 * parameters beside the game, and list it in {@code META-INF/services/carom.client.look.GameView}
 * of the game's jar. Only windows load it. A game without one has the usual look.
 *
 * <pre>{@code
 * public final class TagView implements GameView {
 *   public String game() { return "tag"; }
 *   public void setUp(ViewSetup v) {
 *     v.actions(Action.button("sprint", Input.ACTION).key("Space", "L-Shift").pad("A"));
 *   }
 * }
 * }</pre>
 *
 * <p>A view that throws costs a message, and the game has the usual look. Called on the thread that
 * draws.
 */
public interface GameView {
  /** Returns the name of the game. */
  String game();

  /**
   * Declares the look. Called once, before the game's first picture, and again when a later match
   * of another game came in between.
   *
   * @throws RuntimeException leaves the game with its usual look
   */
  void setUp(ViewSetup v);
}
