package carom.client.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.entity.Input;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: an action says what it sets and by which keys, and refuses names that there aren't. */
final class ActionTest {
  private static void refuses(String part, Runnable wrong) {
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, wrong::run);
    assertTrue(e.getMessage().contains(part), e.getMessage());
  }

  @Test
  void aButtonHasItsKeysFromAllDevices() {
    Action jump = Action.button("jump", Input.JUMP).key("W", "Space").mouse("left").pad("A");
    assertEquals(Input.JUMP, jump.button());
    assertEquals(List.of("W", "Space"), jump.bindings().get(0).keys());
    assertEquals(List.of("left"), jump.mouse());
    assertEquals(List.of("A"), jump.pad());
  }

  @Test
  void aMovementHasABindingForEachWay() {
    Action steer = Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left");
    assertEquals(List.of("A", "Left"), steer.bindings().get(0).keys());
    assertEquals(List.of("D", "Right"), steer.bindings().get(1).keys());
    assertEquals("right", steer.bindings().get(1).name());
  }

  @Test
  void anActionIsNeverChangedInPlace() {
    Action jump = Action.button("jump", Input.JUMP);
    jump.key("W").pad("A");
    assertEquals(List.of(), jump.bindings().get(0).keys());
    assertEquals(List.of(), jump.pad());
  }

  @Test
  void whatCannotBeMeantIsRefusedByName() {
    refuses("button=3 is not one", () -> Action.button("both", Input.JUMP | Input.ACTION));
    refuses("1 << 0..15", () -> Action.button("far", 1 << 16));
    refuses("is no name", () -> Action.button("a|b", Input.JUMP));
    refuses("is no name", () -> Action.button("", Input.JUMP));
    refuses("known are [A, B", () -> Action.button("jump", Input.JUMP).pad("Q"));
    refuses("known are [left, right, middle]", () -> Action.button("j", 1).mouse("pointer"));
    refuses("is the window's", () -> Action.button("jump", Input.JUMP).key("Escape"));
    refuses("a movement has keys", () -> Action.moveX("a", "b").key("A"));
    refuses("others have stick", () -> Action.aim("aim").pad("A"));
    ViewSetup v = new ViewSetup();
    v.actions(Action.button("jump", Input.JUMP));
    refuses("is there already", () -> v.actions(Action.moveX("duck", "jump")));
    refuses("range=0.0", () -> Action.point("at", 0));
    refuses("others have stick", () -> Action.point("at", 9).pad("A"));
    refuses("point() takes its place", () -> Action.moveX("l", "r").mouse("pointer"));
    Action place = Action.point("at", 9).mouse("pointer");
    Action other = Action.moveY("down", "up");
    refuses("declare no other", () -> v.actions(place, other));
    refuses("declare no other", () -> v.actions(place, Action.point("there", 9)));
    v.actions(other);
    refuses("declare no other", () -> v.actions(place));
  }
}
