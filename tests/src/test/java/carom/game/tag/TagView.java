package carom.game.tag;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.ViewSetup;
import carom.sim.entity.Input;

/** The look of tag. */
public final class TagView implements GameView {
  @Override
  public String game() {
    return "tag";
  }

  @Override
  public void setUp(ViewSetup v) {
    v.actions(
        Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left"),
        Action.moveY("down", "up").keys("S", "W").keys("Down", "Up").stick("left"),
        Action.button("sprint", Input.ACTION).key("Space", "L-Shift").mouse("left").pad("A"));
  }
}
