package carom.client.desktop.look;

import carom.client.look.GameView;
import carom.client.look.GameViews;
import carom.client.look.ViewSetup;
import carom.game.GameFault;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The look of the game that is shown: what its view declares, or nothing for a game without a view
 * or with one that failed. Render thread only.
 */
public final class ShownLook {
  private static final Logger LOG = LoggerFactory.getLogger(ShownLook.class);

  private final Consumer<String> player;
  private String game = "";
  private ViewSetup setup = new ViewSetup();
  private Class<?> home;

  /**
   * Creates the usual look.
   *
   * @param player receives a sentence about a view that failed
   */
  public ShownLook(Consumer<String> player) {
    this.player = player;
  }

  /**
   * Looks for the view of a game, if it is another one than before. A view that throws leaves the
   * usual look; the log and the player are told once.
   *
   * @return whether the game is another one
   */
  public boolean show(String name) {
    if (game.equals(name)) {
      return false;
    }
    game = name;
    setup = new ViewSetup();
    home = null;
    try {
      ViewSetup declared = new ViewSetup();
      GameView view = GameViews.create(name);
      if (view != null) {
        view.setUp(declared);
        setup = declared;
        home = view.getClass();
      }
    } catch (RuntimeException | Error e) { // also an error, such as a class that is missing
      LOG.error("the view of game {} failed: {}", name, GameFault.describe(e), e);
      player.accept("The game's own look failed, so it has the usual one");
    }
    return true;
  }

  /** Returns the class beside which the view's files are; null without a view. */
  public Class<?> home() {
    return home;
  }

  /** Tells the player a sentence about the look. */
  public void tell(String sentence) {
    player.accept(sentence);
  }

  /** Returns what the view declares. */
  public ViewSetup setup() {
    return setup;
  }
}
