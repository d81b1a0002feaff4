package carom.client.desktop.game;

import carom.client.look.GameView;
import carom.client.look.GameViews;
import carom.client.look.ViewSetup;
import carom.game.GameFault;
import carom.game.GameJars;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;

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

  /** The jars that the view was looked for in. */
  private ClassLoader jars;

  /**
   * Creates the usual look.
   *
   * @param player receives a sentence about a view that failed
   */
  public ShownLook(Consumer<String> player) {
    this.player = player;
  }

  /**
   * Looks for the view of a game, if it is another one than before, or if the jars are new. A view
   * that throws leaves the usual look, or the one before if that is of the same game; the log and
   * the player are told once.
   *
   * @return whether the game or the look is another one
   */
  public boolean show(String name) {
    boolean isNew = !game.equals(name);
    if (!isNew && jars == GameJars.loader()) {
      return false;
    }
    game = name;
    jars = GameJars.loader();
    if (isNew) {
      setup = new ViewSetup();
      home = null;
    }
    return take(name) || isNew;
  }

  /** Takes the look that the view of a game declares, and returns whether there is one. */
  private boolean take(String name) {
    String stays = home == null ? "the usual one" : "the one before";
    try {
      ViewSetup declared = new ViewSetup();
      GameView view = GameViews.create(name);
      if (view != null) {
        view.setUp(declared);
        setup = declared;
        home = view.getClass();
        return true;
      }
      if (home != null) {
        player.accept("The game's own look is gone or can't be loaded, so it has " + stays);
      }
    } catch (RuntimeException | Error e) { // also an error, such as a class that is missing
      String reason = GameFault.describe(e);
      LOG.error("the view of game {} failed: {}", name, reason, e);
      player.accept("The game's own look failed, so it has " + stays + ": " + reason);
    }
    return false;
  }

  /**
   * Logs what the view declares for things that there aren't. A mistyped name is a warning: one
   * near to that of a thing for which the view declares nothing. Any other may be of another level,
   * and is told at debug only. Events are the game's, so each that is missing is a warning.
   *
   * @param things names of the game's archetypes and of the level's pieces
   * @param events names of the game's kinds of events
   * @param zones names of the level's zones
   * @return the number of warnings
   */
  public int check(Collection<String> things, Collection<String> events, Collection<String> zones) {
    int warnings =
        mistyped(
            setup.things(), things, "neither an archetype of the game nor a piece of this level");
    warnings += mistyped(setup.camera().zones(), zones, "no zone of this level");
    for (String name : setup.events()) {
      if (!events.contains(name)) {
        warnings++;
        String near = Suggestion.didYouMean(name, events);
        LOG.warn("the view of game {} names \"{}\", which is no event of it{}", game, name, near);
      }
    }
    return warnings;
  }

  private int mistyped(Collection<String> named, Collection<String> all, String what) {
    int warnings = 0;
    List<String> unnamed = new ArrayList<>(all);
    unnamed.removeAll(named);
    for (String name : named) {
      String near = Suggestion.didYouMean(name, unnamed);
      if (!all.contains(name)) {
        warnings += near.isEmpty() ? 0 : 1;
        LOG.atLevel(near.isEmpty() ? Level.DEBUG : Level.WARN)
            .log("the view of game {} names \"{}\", which is {}{}", game, name, what, near);
      }
    }
    return warnings;
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
