package carom.client.desktop.menu;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputProcessor;
import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.Group;
import com.badlogic.gdx.scenes.scene2d.InputEvent;
import com.badlogic.gdx.scenes.scene2d.InputListener;
import com.badlogic.gdx.scenes.scene2d.Stage;
import com.badlogic.gdx.scenes.scene2d.ui.ScrollPane;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.viewport.ScreenViewport;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;

/**
 * Shows a menu and moves a focus through it: up, down and Tab go from part to part, Enter presses a
 * button, Esc goes back. The mouse works, too. Render thread only.
 */
final class MenuStage implements Disposable {
  private final ScreenViewport viewport = new ScreenViewport();
  private final Stage stage = new Stage(viewport);
  private final Runnable submit;
  private final Runnable back;
  private final List<Actor> parts = new ArrayList<>();
  private ScrollPane pane;
  private int focus;
  private IntConsumer capture;

  /**
   * Creates an empty one.
   *
   * @param submit runs when the player presses Enter in a field
   * @param back runs when the player presses Esc
   */
  MenuStage(Runnable submit, Runnable back) {
    this.submit = submit;
    this.back = back;
  }

  /** Returns what receives keys and mouse. */
  InputProcessor input() {
    return stage;
  }

  /** Returns the width of the window, points. */
  float width() {
    return viewport.getWorldWidth();
  }

  /** Sets the window's size, px, and the pixels of a point. */
  void resize(int width, int height, float scale) {
    viewport.setUnitsPerPixel(1 / scale);
    viewport.update(width, height, true);
  }

  /**
   * Shows a menu that fills the window. The focus stays with the part of the same name, or without
   * one at its place, and what was scrolled stays so; see {@link #top}.
   */
  void show(Table content) {
    Actor before = stage.getKeyboardFocus();
    String focused = before == null ? null : before.getName();
    stage.clear();
    content.setFillParent(true);
    stage.addActor(content);
    stage.addListener(
        new InputListener() {
          @Override
          public boolean keyDown(InputEvent event, int key) {
            return key(key);
          }
        });
    parts.clear();
    float scrolled = pane == null ? 0 : pane.getScrollY();
    pane = null;
    collect(content);
    if (pane != null) {
      stage.setScrollFocus(pane); // the wheel scrolls it wherever the mouse is
      pane.validate();
      pane.setScrollY(scrolled);
      pane.updateVisualScroll();
    }
    int named = focused == null ? -1 : indexOf(focused);
    boolean stays = before != null;
    focus(named >= 0 ? named : Math.min(focus, parts.size() - 1), !stays);
  }

  /** Scrolls up, because another page begins. */
  void top() {
    if (pane != null) {
      pane.setScrollY(0);
      pane.updateVisualScroll();
    }
  }

  private int indexOf(String name) {
    for (int i = 0; i < parts.size(); i++) {
      if (name.equals(parts.get(i).getName())) {
        return i;
      }
    }
    return -1;
  }

  private void collect(Actor actor) {
    if (actor instanceof TextButton || actor instanceof TextField) {
      parts.add(actor);
    } else if (actor instanceof Group group) {
      pane = actor instanceof ScrollPane found ? found : pane;
      group.getChildren().forEach(this::collect);
    }
  }

  /** Moves the focus to a part, the first being 0, and scrolls so that it is seen. */
  void focus(int part) {
    focus(part, true);
  }

  private void focus(int part, boolean scrolls) {
    focus = Math.max(0, part);
    if (focus < parts.size()) {
      Actor actor = parts.get(focus);
      stage.setKeyboardFocus(actor);
      if (actor instanceof TextField field) {
        field.setCursorPosition(field.getText().length());
      }
      if (scrolls && pane != null && actor.isDescendantOf(pane)) {
        pane.validate();
        Vector2 at = actor.localToAscendantCoordinates(pane.getActor(), new Vector2());
        pane.scrollTo(at.x, at.y, actor.getWidth(), actor.getHeight());
      }
    }
  }

  /** Moves the focus to a part. */
  void focus(Actor actor) {
    focus(parts.indexOf(actor));
  }

  /** Hands the next key to a listener instead of the menu; Esc only ends that, as key 0. */
  void capture(IntConsumer newCapture) {
    capture = newCapture;
  }

  private boolean key(int key) {
    if (capture != null) {
      IntConsumer taker = capture;
      capture = null;
      taker.accept(key == Keys.ESCAPE ? 0 : key);
      return true;
    }
    focus = Math.max(0, parts.indexOf(stage.getKeyboardFocus())); // the mouse may have moved it
    boolean shift =
        Gdx.input.isKeyPressed(Keys.SHIFT_LEFT) || Gdx.input.isKeyPressed(Keys.SHIFT_RIGHT);
    switch (key) {
      case Keys.UP -> step(-1);
      case Keys.DOWN -> step(1);
      case Keys.TAB -> step(shift ? -1 : 1);
      case Keys.ENTER, Keys.NUMPAD_ENTER -> {
        if (stage.getKeyboardFocus() instanceof TextButton button) {
          ((Runnable) button.getUserObject()).run();
        } else {
          submit.run();
        }
      }
      case Keys.ESCAPE -> back.run();
      default -> {
        return false;
      }
    }
    return true;
  }

  private void step(int by) {
    if (!parts.isEmpty()) {
      focus((focus + by + parts.size()) % parts.size());
    }
  }

  /** Draws the menu. */
  void draw(float seconds) {
    viewport.apply();
    stage.act(seconds);
    stage.draw();
  }

  @Override
  public void dispose() {
    stage.dispose();
  }
}
