package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.paint.ViewCamera;
import carom.client.look.Action;
import carom.client.settings.PlayerSettings;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import com.badlogic.gdx.Application;
import com.badlogic.gdx.Application.ApplicationType;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Graphics;
import com.badlogic.gdx.Input.Buttons;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.utils.GdxNativesLoader;
import java.lang.reflect.Proxy;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: what a player presses reaches a tick, however short and however slow the pictures. Method:
 * keys of a display that the test holds.
 */
class ControlsTest {
  private final Set<Integer> down = new HashSet<>();
  private final Set<Integer> tapped = new HashSet<>();
  private final Set<Integer> buttons = new HashSet<>();
  private final KeyMap keys = new KeyMap(PlayerSettings.defaults());
  private final Controls controls = new Controls(keys);
  private final Input input = new Input();
  private int mouseX;
  private Application app;
  private com.badlogic.gdx.Input devices;
  private Graphics graphics;

  @BeforeEach
  void open() {
    GdxNativesLoader.load(); // the camera's mathematics
    app = Gdx.app;
    devices = Gdx.input;
    graphics = Gdx.graphics;
    Gdx.graphics = proxy(Graphics.class, (name, code) -> name.equals("getWidth") ? 800 : 400);
    Gdx.app =
        proxy(
            Application.class,
            (name, code) -> name.equals("getType") ? ApplicationType.HeadlessDesktop : null);
    Gdx.input =
        proxy(
            com.badlogic.gdx.Input.class,
            (name, code) ->
                switch (name) {
                  case "isKeyPressed" -> down.contains(code);
                  case "isKeyJustPressed" -> tapped.contains(code);
                  case "getX" -> mouseX;
                  case "isButtonPressed" -> false;
                  case "isButtonJustPressed" -> buttons.contains(code);
                  default -> 0;
                });
  }

  @AfterEach
  void close() {
    Gdx.app = app;
    Gdx.input = devices;
    Gdx.graphics = graphics;
  }

  private interface Answer {
    Object of(String method, Object argument);
  }

  private static <T> T proxy(Class<T> type, Answer answer) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            (self, method, arguments) ->
                method.getName().equals("hashCode")
                    ? 1
                    : method.getName().equals("equals")
                        ? self == arguments[0]
                        : answer.of(method.getName(), arguments == null ? null : arguments[0])));
  }

  private int tick() {
    input.clear();
    controls.sample(input, new ViewCamera(), 0, 0);
    return input.buttons();
  }

  @Test
  void aTapWithinAPictureIsInOneTick() {
    tapped.add(Keys.SPACE); // and up again, before the picture began
    controls.note();
    assertEquals(Input.JUMP | Input.ACTION, tick());
    assertEquals(0, tick(), "the second tick of a slow picture");
    tapped.clear();
    controls.note();
    assertEquals(0, tick());
  }

  @Test
  void aTapBetweenTwoTicksIsInTheNextOne() {
    down.add(Keys.E);
    controls.note(); // a picture without a tick
    down.clear();
    controls.note();
    assertEquals(Input.SECOND, tick());
    assertEquals(0, tick());
  }

  @Test
  void aTappedClickOfAnActionAndATappedMovementCount() {
    keys.game(
        "tag",
        List.of(
            Action.moveX("left", "right").keys("A", "D"),
            Action.button("hook", 1 << 5).mouse("right")));
    tapped.add(Keys.D);
    buttons.add(Buttons.RIGHT);
    controls.note();
    assertEquals(1 << 5, tick());
    assertEquals(1, input.moveX());
    assertEquals(0, tick());
    assertEquals(0, input.moveX());
  }

  @Test
  void whatWasPressedForAMenuIsForgotten() {
    tapped.add(Keys.SPACE);
    controls.note();
    controls.forget();
    assertEquals(0, tick());
  }

  @Test
  void aPlaceIsTheWayToThePointerInSharesOfItsRange() {
    ViewCamera camera = new ViewCamera();
    camera.update(new Level.Bounds(-20, -10, 20, 10), null, 0, 800, 400, 0);
    keys.game("yard", List.of(Action.point("build at", 20).mouse("pointer").stick("left")));
    down.add(Keys.D); // moves nobody now
    controls.sample(input, camera, 0, 0);
    assertEquals(0, input.moveX(), "the mouse hasn't moved");
    mouseX = 3;
    Vector3 at = camera.toWorld(mouseX, 0).cpy();
    controls.sample(input, camera, at.x - 5, at.y + 10);
    assertEquals(0.25f, input.moveX(), 1 / 127f);
    assertEquals(-0.5f, input.moveY(), 1 / 127f);
    controls.sample(input, camera, at.x + 30, at.y);
    assertEquals(-1, input.moveX(), "beyond the range it lies at the range");
  }
}
