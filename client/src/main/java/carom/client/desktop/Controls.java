package carom.client.desktop;

import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.paint.ViewCamera;
import carom.client.look.Action;
import carom.client.settings.KeyAction;
import carom.sim.entity.Input;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Buttons;
import com.badlogic.gdx.controllers.Controller;
import com.badlogic.gdx.controllers.ControllerMapping;
import com.badlogic.gdx.controllers.Controllers;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector3;

/**
 * Reads keyboard, mouse and controller into the player's input: by the actions that the game's view
 * names, or else by the usual ones. All devices work at once; the one used last decides where the
 * player aims. Render thread only.
 */
final class Controls {
  /** Stick travel that counts as none, 0..1: cheap sticks rest up to here. */
  private static final float DEAD_ZONE = 0.2f;

  private final KeyMap keys;
  private float aimRad;
  private int lastMouseX;
  private int lastMouseY;
  private boolean mouseAims;
  private boolean padUsed;
  private boolean lastPad;

  // What was pressed in a picture since the last tick, and whether that is being looked for.
  private boolean isNoting;
  private int notedButtons;
  private float notedX;
  private float notedY;

  /** Creates controls over the keys that the player has chosen. */
  public Controls(KeyMap keys) {
    this.keys = keys;
  }

  /**
   * Notes what is pressed, for the next tick: a tap may begin and end between two ticks, and on a
   * slow machine between two pictures. Call it once per picture, before {@link #sample}.
   */
  void note() {
    Controller pad = pad();
    isNoting = true;
    float x = moveX(pad);
    float y = moveY(pad);
    notedButtons |= has(Action.Kind.BUTTON) ? buttons(pad) : usualButtons(pad, y);
    isNoting = false;
    notedX = x == 0 ? notedX : x;
    notedY = y == 0 ? notedY : y;
  }

  /** Forgets what was noted: keys had another meaning meanwhile. */
  void forget() {
    notedButtons = 0;
    notedX = 0;
    notedY = 0;
  }

  /**
   * Reads the devices, together with what was noted since the last call.
   *
   * @param out receives the input
   * @param camera to turn the mouse position into a direction
   * @param x the player's drawn position, metres; aiming starts there
   * @param y the player's drawn position, metres
   */
  public void sample(Input out, ViewCamera camera, float x, float y) {
    padUsed = false;
    Controller pad = pad();
    float moveX = moveX(pad);
    float moveY = moveY(pad);
    moveX = moveX == 0 ? notedX : moveX;
    moveY = moveY == 0 ? notedY : moveY;
    watchMouse(moveX, moveY);
    Action place = place();
    if (place != null && mouseAims && !place.mouse().isEmpty()) {
      Vector3 at = camera.toWorld(lastMouseX, lastMouseY);
      moveX = (at.x - x) / place.range();
      moveY = (at.y - y) / place.range();
    }
    float length = (float) Math.sqrt(moveX * moveX + moveY * moveY);
    if (length > 1) {
      moveX /= length;
      moveY /= length;
    }
    aim(camera, x, y, moveX, moveY, pad);
    out.move(moveX, moveY).aim(aimRad);
    int buttons = has(Action.Kind.BUTTON) ? buttons(pad) : usualButtons(pad, moveY);
    out.buttons(buttons | notedButtons);
    forget();
    lastPad = out.buttons() != 0 || length > 0 ? padUsed : lastPad;
  }

  /** Returns whether the gamepad was used last, so that hints name its buttons. */
  boolean isPadUsed() {
    return lastPad;
  }

  private static Controller pad() {
    Controller pad = Controllers.getCurrent();
    return pad != null && pad.isConnected() ? pad : null;
  }

  private float moveX(Controller pad) {
    boolean own = has(Action.Kind.MOVE_X) || place() != null;
    return own ? move(Action.Kind.MOVE_X, pad) : usualX(pad);
  }

  private float moveY(Controller pad) {
    boolean own = has(Action.Kind.MOVE_Y) || place() != null;
    return own ? move(Action.Kind.MOVE_Y, pad) : usualY(pad);
  }

  private boolean isDown(KeyAction action) {
    return keys.isDown(action) || (isNoting && keys.isTapped(action));
  }

  private boolean isDown(Action.Binding binding) {
    return keys.isDown(binding) || (isNoting && keys.isTapped(binding));
  }

  private boolean isDown(int mouseButton) {
    return Gdx.input.isButtonPressed(mouseButton)
        || (isNoting && Gdx.input.isButtonJustPressed(mouseButton));
  }

  private boolean has(Action.Kind kind) {
    return first(kind) != null;
  }

  /** Returns the game's action that points at a place, or null. */
  private Action place() {
    return first(Action.Kind.POINT);
  }

  private Action first(Action.Kind kind) {
    for (int i = 0; i < keys.actions().size(); i++) {
      if (keys.actions().get(i).kind() == kind) {
        return keys.actions().get(i);
      }
    }
    return null;
  }

  // ---- the usual keys

  private float usualX(Controller pad) {
    float x = axis(KeyAction.RIGHT) - axis(KeyAction.LEFT);
    return x + (pad == null ? 0 : stickX(pad, "left") + stickX(pad, "d-pad"));
  }

  private float usualY(Controller pad) {
    float y = axis(KeyAction.UP) - axis(KeyAction.DOWN);
    return y + (pad == null ? 0 : stickY(pad, "left") + stickY(pad, "d-pad"));
  }

  private int usualButtons(Controller pad, float moveY) {
    // One key for what a game does most: games use one of the two.
    boolean both =
        isDown(KeyAction.MAIN) || isDown(Buttons.LEFT) || (pad != null && isPressed(pad, "A"));
    boolean jump = both || isDown(KeyAction.JUMP) || isDown(KeyAction.UP);
    boolean action =
        both
            || isDown(KeyAction.ACTION)
            || (pad != null && (isPressed(pad, "X") || isPressed(pad, "R1")));
    boolean second =
        isDown(KeyAction.SECOND) || isDown(Buttons.RIGHT) || (pad != null && isPressed(pad, "B"));
    return (jump ? Input.JUMP : 0)
        | (action ? Input.ACTION : 0)
        | (second ? Input.SECOND : 0)
        | (moveY < -0.5f ? Input.DOWN : 0)
        | (moveY > 0.5f ? Input.UP : 0);
  }

  // ---- the game's own actions

  private float move(Action.Kind kind, Controller pad) {
    float sum = 0;
    for (int i = 0; i < keys.actions().size(); i++) {
      Action action = keys.actions().get(i);
      if (action.kind() == kind) {
        sum += isDown(action.bindings().get(1)) ? 1 : 0;
        sum -= isDown(action.bindings().get(0)) ? 1 : 0;
      }
      if (action.kind() == kind || action.kind() == Action.Kind.POINT) {
        for (int k = 0; pad != null && k < action.sticks().size(); k++) {
          String stick = action.sticks().get(k);
          sum += kind == Action.Kind.MOVE_X ? stickX(pad, stick) : stickY(pad, stick);
        }
      }
    }
    return Math.max(-1, Math.min(1, sum));
  }

  private int buttons(Controller pad) {
    int held = 0;
    for (int i = 0; i < keys.actions().size(); i++) {
      Action action = keys.actions().get(i);
      if (action.kind() == Action.Kind.BUTTON && isHeld(action, pad)) {
        held |= action.button();
      }
    }
    return held;
  }

  /** Returns whether a button of the game is held on any device. */
  private boolean isHeld(Action action, Controller pad) {
    boolean held = isDown(action.bindings().get(0));
    for (int i = 0; i < action.mouse().size(); i++) {
      held |= isDown(mouse(action.mouse().get(i)));
    }
    for (int i = 0; pad != null && i < action.pad().size(); i++) {
      held |= isPressed(pad, action.pad().get(i));
    }
    return held;
  }

  private static int mouse(String name) {
    return switch (name) {
      case "left" -> Buttons.LEFT;
      case "right" -> Buttons.RIGHT;
      default -> Buttons.MIDDLE;
    };
  }

  // ---- the gamepad

  private boolean isPressed(Controller pad, String name) {
    ControllerMapping map = pad.getMapping();
    int button =
        switch (name) {
          case "A" -> map.buttonA;
          case "B" -> map.buttonB;
          case "X" -> map.buttonX;
          case "Y" -> map.buttonY;
          case "L1" -> map.buttonL1;
          case "R1" -> map.buttonR1;
          case "L3" -> map.buttonLeftStick;
          case "R3" -> map.buttonRightStick;
          case "Back" -> map.buttonBack;
          default -> map.buttonStart;
        };
    return noted(pressed(pad, button)) != 0;
  }

  private float stickX(Controller pad, String name) {
    ControllerMapping map = pad.getMapping();
    return noted(
        switch (name) {
          case "left" -> stick(pad, map.axisLeftX);
          case "right" -> stick(pad, map.axisRightX);
          default -> pressed(pad, map.buttonDpadRight) - pressed(pad, map.buttonDpadLeft);
        });
  }

  private float stickY(Controller pad, String name) {
    ControllerMapping map = pad.getMapping();
    return noted(
        switch (name) {
          case "left" -> -stick(pad, map.axisLeftY);
          case "right" -> -stick(pad, map.axisRightY);
          default -> pressed(pad, map.buttonDpadUp) - pressed(pad, map.buttonDpadDown);
        });
  }

  private float noted(float value) {
    padUsed |= value != 0;
    return value;
  }

  /** Notes where the mouse is. It points from its next move or click on, until a stick does. */
  private void watchMouse(float moveX, float moveY) {
    int mouseX = Gdx.input.getX();
    int mouseY = Gdx.input.getY();
    if (mouseX != lastMouseX || mouseY != lastMouseY || Gdx.input.isButtonPressed(Buttons.LEFT)) {
      mouseAims = true;
      lastMouseX = mouseX;
      lastMouseY = mouseY;
    } else if (place() != null && (moveX != 0 || moveY != 0)) {
      mouseAims = false;
    }
  }

  private void aim(ViewCamera camera, float x, float y, float moveX, float moveY, Controller pad) {
    boolean usual = !has(Action.Kind.AIM);
    boolean pointer = usual;
    float stickX = usual && pad != null ? stickX(pad, "right") : 0;
    float stickY = usual && pad != null ? stickY(pad, "right") : 0;
    for (int i = 0; !usual && i < keys.actions().size(); i++) {
      Action action = keys.actions().get(i);
      if (action.kind() == Action.Kind.AIM) {
        pointer |= !action.mouse().isEmpty();
        for (int k = 0; pad != null && k < action.sticks().size(); k++) {
          stickX += stickX(pad, action.sticks().get(k));
          stickY += stickY(pad, action.sticks().get(k));
        }
      }
    }
    if (stickX != 0 || stickY != 0) {
      aimRad = MathUtils.atan2(stickY, stickX);
      mouseAims = false;
    } else if (mouseAims && pointer) {
      Vector3 at = camera.toWorld(lastMouseX, lastMouseY);
      aimRad = MathUtils.atan2(at.y - y, at.x - x);
    } else if (moveX != 0 || moveY != 0) {
      aimRad = MathUtils.atan2(moveY, moveX);
    }
  }

  private float axis(KeyAction action) {
    return isDown(action) ? 1 : 0;
  }

  private static float pressed(Controller pad, int button) {
    return button != ControllerMapping.UNDEFINED && pad.getButton(button) ? 1 : 0;
  }

  private static float stick(Controller pad, int axis) {
    float value = axis == ControllerMapping.UNDEFINED ? 0 : pad.getAxis(axis);
    return Math.abs(value) < DEAD_ZONE ? 0 : value;
  }
}
