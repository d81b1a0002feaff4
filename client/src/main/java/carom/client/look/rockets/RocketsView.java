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
import carom.game.rockets.RocketFields;
import carom.game.rockets.RocketGame;
import carom.sim.entity.Input;
import java.util.List;

/** The look of {@code RocketFields}. */
public final class RocketsView implements GameView {
  private static final String SHOOTER = "/carom/client/look/shooter/";
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

  private static final Particles GLOW =
      Particles.stream(60)
          .speed(0.2f, 1)
          .spread(0.4f)
          .seconds(0.15f, 0.3f)
          .size(0.3f, 0.05f)
          .colour(0xffd0e0, 0xff2e6d)
          .glow();
  private static final Particles BOLT =
      Particles.stream(40).seconds(0.08f, 0.15f).size(0.09f, 0.01f).colour(0xe8ffb0, 0x5a9e00);
  private static final Particles FIZZ =
      Particles.burst(9)
          .speed(2, 8)
          .seconds(0.1f, 0.3f)
          .size(0.08f, 0.02f)
          .colour(0xf4ffd0, 0x7ac800)
          .glow();
  private static final Particles RIPPLE =
      Particles.burst(24)
          .speed(4, 8)
          .drag(4)
          .seconds(0.2f, 0.4f)
          .size(0.14f, 0.03f)
          .colour(0xe8fbff, 0x3a9ee0)
          .glow();
  private static final Particles GRAVEL =
      Particles.burst(30)
          .picture("scrap.png")
          .speed(1, 7)
          .drag(0.8f)
          .seconds(0.6f, 1.4f)
          .size(0.24f, 0.1f)
          .colour(0xb9adb8, 0x5a5060);
  private static final Particles DUST =
      Particles.burst(16)
          .picture("smoke.png")
          .speed(0.5f, 3)
          .drag(2)
          .seconds(0.5f, 1.2f)
          .size(0.4f, 1.3f)
          .colour(0xa89cab, 0x4a4250)
          .alpha(0.4f);
  private static final Particles STARS =
      Particles.burst(16)
          .speed(2, 7)
          .drag(2)
          .seconds(0.2f, 0.5f)
          .size(0.12f, 0.03f)
          .colour(0xffffff, 0x06d6a0)
          .glow();
  private static final Particles SCRAP =
      Particles.burst(46)
          .picture("scrap.png")
          .speed(3, 15)
          .drag(1.2f)
          .seconds(0.8f, 2)
          .size(0.34f, 0.12f)
          .colour(0xdfe8f2, 0x3a4250);
  private static final Particles FIREBALL =
      Particles.burst(60)
          .speed(1, 10)
          .drag(3)
          .seconds(0.3f, 0.9f)
          .size(1.1f, 0.25f)
          .colour(0xfff0c0, 0xc8321a)
          .alpha(0.65f)
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
            .key("Space", "R-Shift")
            .mouse("left")
            .pad("A")
            .pad("R1"),
        Action.button("shield", RocketGame.SHIELD).key("L-Shift", "Q").mouse("right").pad("L1"),
        Action.button("set off", Input.SECOND).key("E").pad("B"));
    v.background("nebula.png").height(26).parallax(0.05f).drifts(0.05f, 0.02f);
    v.background("stars.png").height(16).parallax(0.25f);
    v.sprite("player", "hull.png").size(1.3f, 1.3f).tint();
    v.sprite("player", "gun.png").size(1, 0.5f).at(0.2f, 0).turn(Sprite.Turn.AIM);
    v.sprite("player", "shield.png").size(2, 2).frames(2).by(RocketFields.SHIELDED).upright();
    v.sprite("rocket", "rocket.png").size(1, 0.5f).frames(2).perSecond(24).turn(Sprite.Turn.MOVE);
    v.sprite("torpedo", "torpedo.png").size(1.5f, 0.75f).turn(Sprite.Turn.MOVE);
    v.sprite("bolt", "bolt.png").size(0.9f, 0.34f).at(-0.25f, 0).turn(Sprite.Turn.MOVE);
    v.sprite("mine", "mine.png").size(1.5f, 1.5f).frames(2).perSecond(3).upright();
    v.sprite("rock.large", "rock-large.png").size(3.54f, 3.54f);
    v.sprite("rock.medium", "rock-medium.png").size(2.18f, 2.18f);
    v.sprite("rock.small", "rock-small.png").size(1.25f, 1.25f);
    v.sprite("planet", "planet.png").size(8.53f, 8.53f);
    v.sprite("crate", "/carom/client/look/cars/crate.png").size(1, 1);
    for (String pickup : List.of("repair", "scatter", "torpedoes", "mines")) {
      v.sprite(pickup, pickup + ".png").size(1.7f, 1.7f).upright();
    }
    for (String plated : List.of("wall", "side wall", "pillar")) {
      v.sprite(plated, "plate.png").size(1.5f, 1.5f).tiled();
    }
    v.trail("rocket", SMOKE);
    v.trail("torpedo", GLOW);
    v.trail("bolt", BOLT);
    v.event("shot", SoundFile.of("shot1.wav", "shot2.wav").volume(0.7f), Shake.by(0.05f), FLASH);
    v.event(
        "boom", SoundFile.of("boom1.wav", "boom2.wav"), Shake.by(0.35f), SMOULDER, FIRE, SPARKS);
    v.event("spark", SoundFile.of(SHOOTER + "spark.wav").volume(0.4f), FIZZ);
    v.event(
        "blocked",
        SoundFile.of(SHOOTER + "spark.wav"),
        RIPPLE,
        new Reaction().flash(0x7cdcff).seconds(0.25f));
    v.event("crack", SoundFile.of(SHOOTER + "crash.wav"), GRAVEL, DUST, Shake.by(0.12f));
    v.event("taken", SoundFile.of(SHOOTER + "taken.wav").volume(0.7f), STARS);
    v.event(
        "wreck",
        SoundFile.of(SHOOTER + "out.wav"),
        Shake.by(0.8f).seconds(0.7f),
        SMOULDER,
        FIREBALL,
        SPARKS,
        SCRAP);
    v.blow(
        "player",
        new Reaction().squash(0.25f).flash(0xffffff),
        SoundFile.of("knock.wav").volume(0.6f));
    v.hud(
        HudItem.bar("hull", RocketFields.HEALTH),
        HudItem.number("shots", RocketFields.AMMO).whileSet(RocketFields.AMMO),
        HudItem.time("back in", RocketFields.OUT).whileSet(RocketFields.OUT).at(HudItem.Place.TOP));
    v.camera().height(22).lead(0.25f);
    v.minimap(HudItem.Place.BOTTOM_RIGHT);
  }
}
