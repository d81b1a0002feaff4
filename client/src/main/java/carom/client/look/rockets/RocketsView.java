package carom.client.look.rockets;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.ViewSetup;
import carom.sim.entity.Input;

/** The look of {@code RocketGame}. */
public final class RocketsView implements GameView {
  /** Creates the view, for the service loader. */
  public RocketsView() {}

  @Override
  public String game() {
    return "rockets";
  }

  @Override
  public void setUp(ViewSetup v) {
    v.actions(
        Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left"),
        Action.moveY("down", "up").keys("S", "W").keys("Down", "Up").stick("left"),
        Action.aim("aim").mouse("pointer").stick("right"),
        Action.button("fire", Input.ACTION)
            .key("Space", "L-Shift", "R-Shift")
            .mouse("left")
            .pad("A")
            .pad("R1"),
        Action.button("set off", Input.SECOND).key("E").mouse("right").pad("B"));
  }
}
