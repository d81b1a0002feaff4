package carom.client.look;

import carom.game.JarServices;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the {@linkplain GameView views} of games. A view that can't be loaded is logged and left
 * out, so that it keeps no game from being played. Any thread may use it.
 */
public final class GameViews {
  private static final Logger LOG = LoggerFactory.getLogger(GameViews.class);

  /** Views that the program itself brings; replaced as a whole. */
  private static volatile List<Supplier<GameView>> added = List.of();

  private GameViews() {}

  /**
   * Adds a view that needs no entry in a file of services: that of a program that embeds Carom, or
   * of a test. It comes before those that were added or found for its game.
   *
   * @param view makes a new instance for each window
   */
  public static synchronized void add(Supplier<GameView> view) {
    List<Supplier<GameView>> all = new ArrayList<>(added);
    all.add(0, view);
    added = List.copyOf(all);
  }

  /** Returns a new instance of the view of a game, or null if the game has none. */
  public static GameView create(String game) {
    for (Supplier<GameView> view : added) {
      GameView made = view.get();
      if (made.game().equals(game)) {
        return made;
      }
    }
    List<GameView> found =
        JarServices.all(
            GameView.class,
            e -> LOG.warn("a game's view can't be loaded, so the game has the usual look", e));
    for (GameView view : found) {
      if (view.game().equals(game)) {
        return view;
      }
    }
    return null;
  }
}
