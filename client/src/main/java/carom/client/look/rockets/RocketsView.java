package carom.client.look.rockets;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.HudItem;
import carom.client.look.Particles;
import carom.client.look.Reaction;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.look.Sprite;
import carom.client.look.ViewSetup;
import carom.game.rockets.RocketGame;
import carom.sim.entity.Input;
import java.util.List;

/** The look of {@code RocketGame}. */
public final class RocketsView implements GameView {
  private static final Particles SMOKE =
      Particles.stream(70)
          .picture("smoke.png")
          .speed(0.5f, 1.5f)
          .spread(0.3f)
          .seconds(0.4f, 0.9f)
          .size(0.12f, 0.4f)
          .colour(0xd8cfc4, 0x4a5260)
          .alpha(0.5f)
          .drag(2);
  private static final Particles FLASH =
      Particles.burst(10).speed(1, 5).seconds(0.06f, 0.16f).size(0.3f, 0.05f).glow();
  private static final Particles SMOULDER =
      Particles.burst(26)
          .picture("smoke.png")
          .speed(0.4f, 3.5f)
          .drag(2.5f)
          .seconds(0.6f, 1.5f)
          .size(0.5f, 1.3f)
          .colour(0x6b5a4e, 0x20242c)
          .alpha(0.55f);
  private static final Particles FIRE =
      Particles.burst(34)
          .speed(1, 7)
          .drag(4)
          .seconds(0.2f, 0.55f)
          .size(0.75f, 0.2f)
          .colour(0xffd98a, 0xd83a12)
          .alpha(0.6f)
          .glow();
  private static final Particles SPARKS =
      Particles.burst(50)
          .speed(6, 17)
          .drag(2)
          .seconds(0.3f, 0.8f)
          .size(0.09f, 0.02f)
          .colour(0xfff4d0, 0xff7a1a)
          .glow();

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
    v.background("nebula.png").height(26).parallax(0.05f).drifts(0.05f, 0.02f);
    v.background("stars.png").height(16).parallax(0.25f);
    v.sprite("player", "hull.png").size(1.3f, 1.3f).tint();
    v.sprite("player", "gun.png").size(1, 0.5f).at(0.2f, 0).turn(Sprite.Turn.AIM);
    v.sprite("rocket", "rocket.png").size(1, 0.5f).frames(2).perSecond(24).turn(Sprite.Turn.MOVE);
    for (String plated : List.of("wall", "side wall", "pillar")) {
      v.sprite(plated, "plate.png").size(1.5f, 1.5f).tiled();
    }
    v.trail("rocket", SMOKE);
    v.event("shot", SoundFile.of("shot1.wav", "shot2.wav").volume(0.7f), Shake.by(0.05f), FLASH);
    v.event(
        "boom", SoundFile.of("boom1.wav", "boom2.wav"), Shake.by(0.35f), SMOULDER, FIRE, SPARKS);
    v.blow(
        "player",
        new Reaction().squash(0.25f).flash(0xffffff),
        SoundFile.of("knock.wav").volume(0.6f));
    v.hud(HudItem.bar("hull", RocketGame.HEALTH));
    v.camera().lead(0.25f);
    v.minimap(HudItem.Place.BOTTOM_RIGHT);
  }
}
