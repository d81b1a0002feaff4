package hill;

import carom.client.bots.BotBrain;
import carom.client.bots.Senses;
import carom.client.view.ClientView;
import carom.sim.entity.Input;

/** Plays for bots: goes to the summit, and dashes at what is near. */
public final class HillBrain implements BotBrain {
  @Override
  public String game() {
    return "hill";
  }

  @Override
  public void decide(Senses s, Input out) {
    float x = s.own().x();
    float y = s.own().y();
    float distance = (float) Math.max(1, Math.hypot(x, y));
    out.move(-x / distance, -y / distance);
    ClientView.Drawn other = s.nearest("disc");
    if (other != null && s.distance(other) < 2) {
      out.aim(s.direction(other)).hold(Input.ACTION, true);
    }
  }
}
