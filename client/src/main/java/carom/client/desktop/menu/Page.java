package carom.client.desktop.menu;

import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.ui.Table;

/** A page of a menu. Render thread only. */
interface Page {
  /** Fills a table with the page, anew after each change of the window or of the page. */
  void build(Table into);

  /** Returns the part that has the focus when the page opens; null for the first one. */
  default Actor entrance() {
    return null;
  }

  /** Does what the page is there for, when the player presses Enter in a field. */
  default void submit() {}

  /**
   * Does what is due.
   *
   * @return whether the page must be built anew
   */
  default boolean update(long nowNs) {
    return false;
  }

  /** Lets go of what the page holds; it may be built again. */
  default void close() {}
}
