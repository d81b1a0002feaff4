package carom.client.desktop;

import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.paint.ViewCamera;
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
 * Reads keyboard, mouse and controller into the player's input. All devices work at once; the one
 * used last decides where the player aims. Render thread only.
 */
final class Controls {
  /** Stick travel that counts as none, 0..1: cheap sticks rest up to here. */
  private static final float DEAD_ZONE = 0.2f;

  private final KeyMap keys;
  private float aimRad;
  private int lastMouseX;
  private int lastMouseY;
  private boolean mouseAims;

  /** Creates controls over the keys that the player has chosen. */
  public Controls(KeyMap keys) {
    this.keys = keys;
  }

  /**
   * Reads the devices.
   *
   * @param out receives the input
   * @param camera to turn the mouse position into a direction
   * @param x the player's drawn position, metres; aiming starts there
   * @param y the player's drawn position, metres
   */
  public void sample(Input out, ViewCamera camera, float x, float y) {
    float moveX = axis(KeyAction.RIGHT) - axis(KeyAction.LEFT);
    float moveY = axis(KeyAction.UP) - axis(KeyAction.DOWN);
    // One key for whatever a game does most: games use one of the two.
    boolean both = keys.isDown(KeyAction.MAIN) || Gdx.input.isButtonPressed(Buttons.LEFT);
    boolean jump = both || keys.isDown(KeyAction.JUMP) || keys.isDown(KeyAction.UP);
    boolean action = both || keys.isDown(KeyAction.ACTION);
    boolean second = keys.isDown(KeyAction.SECOND) || Gdx.input.isButtonPressed(Buttons.RIGHT);
    float stickAimX = 0;
    float stickAimY = 0;

    Controller pad = Controllers.getCurrent();
    if (pad != null && pad.isConnected()) {
      ControllerMapping map = pad.getMapping();
      moveX +=
          stick(pad, map.axisLeftX)
              + pressed(pad, map.buttonDpadRight)
              - pressed(pad, map.buttonDpadLeft);
      moveY +=
          -stick(pad, map.axisLeftY)
              + pressed(pad, map.buttonDpadUp)
              - pressed(pad, map.buttonDpadDown);
      stickAimX = stick(pad, map.axisRightX);
      stickAimY = -stick(pad, map.axisRightY);
      jump |= pad.getButton(map.buttonA);
      action |=
          pad.getButton(map.buttonA) || pad.getButton(map.buttonX) || pad.getButton(map.buttonR1);
      second |= pad.getButton(map.buttonB);
    }
    float length = (float) Math.sqrt(moveX * moveX + moveY * moveY);
    if (length > 1) {
      moveX /= length;
      moveY /= length;
    }
    aim(camera, x, y, moveX, moveY, stickAimX, stickAimY);
    out.move(moveX, moveY)
        .aim(aimRad)
        .hold(Input.JUMP, jump)
        .hold(Input.ACTION, action)
        .hold(Input.SECOND, second)
        .hold(Input.DOWN, moveY < -0.5f)
        .hold(Input.UP, moveY > 0.5f);
  }

  private void aim(
      ViewCamera camera, float x, float y, float moveX, float moveY, float stickX, float stickY) {
    int mouseX = Gdx.input.getX();
    int mouseY = Gdx.input.getY();
    if (mouseX != lastMouseX || mouseY != lastMouseY || Gdx.input.isButtonPressed(Buttons.LEFT)) {
      mouseAims = true;
      lastMouseX = mouseX;
      lastMouseY = mouseY;
    }
    if (stickX != 0 || stickY != 0) {
      aimRad = MathUtils.atan2(stickY, stickX);
      mouseAims = false;
    } else if (mouseAims) {
      Vector3 at = camera.toWorld(mouseX, mouseY);
      aimRad = MathUtils.atan2(at.y - y, at.x - x);
    } else if (moveX != 0 || moveY != 0) {
      aimRad = MathUtils.atan2(moveY, moveX);
    }
  }

  private float axis(KeyAction action) {
    return keys.isDown(action) ? 1 : 0;
  }

  private static float pressed(Controller pad, int button) {
    return button != ControllerMapping.UNDEFINED && pad.getButton(button) ? 1 : 0;
  }

  private static float stick(Controller pad, int axis) {
    float value = axis == ControllerMapping.UNDEFINED ? 0 : pad.getAxis(axis);
    return Math.abs(value) < DEAD_ZONE ? 0 : value;
  }
}
