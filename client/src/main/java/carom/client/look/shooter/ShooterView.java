package carom.client.look.shooter;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.HudItem;
import carom.client.look.Particles;
import carom.client.look.Reaction;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.look.Sprite;
import carom.client.look.ViewSetup;
import carom.game.shooter.ShooterFields;
import carom.sim.entity.Input;
import java.util.List;

/** The look of {@code ShooterGame}. */
public final class ShooterView implements GameView {
  /** Number of colours of players; each is an archetype. */
  private static final int PLAYERS = 8;

  private static final String ROCKETS = "/carom/client/look/rockets/";
  private static final Particles DUST =
      Particles.burst(9)
          .picture(ROCKETS + "smoke.png")
          .speed(0.5f, 2.5f)
          .seconds(0.2f, 0.5f)
          .size(0.12f, 0.35f)
          .drag(4)
          .colour(0xe8d8d0, 0x8a7a8a)
          .alpha(0.5f);
  private static final Particles FLASH =
      Particles.burst(9).speed(1, 6).seconds(0.05f, 0.12f).size(0.26f, 0.05f).glow();
  private static final Particles SPARKS =
      Particles.burst(12)
          .speed(3, 10)
          .seconds(0.1f, 0.35f)
          .size(0.07f, 0.02f)
          .gravity(0.5f)
          .colour(0xfff4d0, 0xff9a2e)
          .glow();
  private static final Particles STARS =
      Particles.burst(18)
          .speed(3, 9)
          .seconds(0.15f, 0.4f)
          .size(0.12f, 0.03f)
          .drag(2)
          .colour(0xffffff, 0xff4d6d)
          .glow();
  private static final Particles SPLINTERS =
      Particles.burst(26)
          .speed(2, 8)
          .seconds(0.4f, 0.9f)
          .size(0.13f, 0.05f)
          .gravity(1)
          .colour(0xd9a066, 0x6d4424);
  private static final Particles SMOULDER =
      Particles.burst(22)
          .picture(ROCKETS + "smoke.png")
          .speed(0.4f, 3.5f)
          .drag(2.5f)
          .seconds(0.5f, 1.2f)
          .size(0.5f, 1.4f)
          .colour(0x8a6a5e, 0x2a2035)
          .alpha(0.5f);
  private static final Particles FIRE =
      Particles.burst(34)
          .speed(1, 8)
          .drag(4)
          .seconds(0.2f, 0.5f)
          .size(0.8f, 0.2f)
          .colour(0xffd98a, 0xd83a12)
          .alpha(0.6f)
          .glow();
  private static final Particles CONFETTI =
      Particles.burst(60).speed(4, 15).drag(2).seconds(0.4f, 1.1f).size(0.16f, 0.04f).gravity(0.4f);
  private static final Particles SMOKE =
      Particles.stream(80)
          .picture(ROCKETS + "smoke.png")
          .speed(0.5f, 1.5f)
          .spread(0.3f)
          .seconds(0.3f, 0.8f)
          .size(0.12f, 0.4f)
          .colour(0xffe0c0, 0x5a4a60)
          .alpha(0.5f)
          .drag(2);
  private static final Particles GLINT =
      Particles.stream(60).seconds(0.08f, 0.14f).size(0.07f, 0.01f).colour(0xfff1b8, 0xff9a2e);

  /** Creates the view, for the service loader. */
  public ShooterView() {}

  @Override
  public String game() {
    return "shooter";
  }

  @Override
  public void setUp(ViewSetup v) {
    v.actions(
        Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left"),
        Action.button("jump", Input.JUMP).key("W", "Space", "Up").pad("A"),
        Action.button("drop", Input.DOWN).key("S", "Down").pad("B"),
        Action.aim("aim").mouse("pointer").stick("right"),
        Action.button("fire", Input.ACTION).key("L-Shift", "E").mouse("left").pad("R1"));
    scenery(v);
    for (int i = 0; i < PLAYERS; i++) {
      String player = "player." + i;
      v.sprite(player, "fighter.png")
          .size(1.2f, 1.6f)
          .at(0, 0.06f)
          .frames(4)
          .perMetre(1.7f)
          .upright()
          .flips()
          .tint();
      v.sprite(player, "gun.png")
          .size(1.35f, 0.675f)
          .at(0.28f, -0.12f)
          .frames(4)
          .by(ShooterFields.WEAPON)
          .turn(Sprite.Turn.AIM)
          .flips();
      v.sprite("head." + i, "head.png").size(0.72f, 0.72f).tint();
      v.sprite("torso." + i, "torso.png").size(0.56f, 0.72f).tint();
      v.sprite("arm." + i, "limb.png").size(0.26f, 0.6f).tint();
      v.sprite("leg." + i, "limb.png").size(0.3f, 0.68f).tint();
      v.blow(player, new Reaction().squash(0.3f), SoundFile.of("hit.wav").volume(0.25f));
    }
    v.sprite("bullet", "bullet.png").size(0.9f, 0.28f).at(-0.3f, 0).turn(Sprite.Turn.MOVE);
    v.sprite("rocket", ROCKETS + "rocket.png")
        .size(1, 0.5f)
        .frames(2)
        .perSecond(24)
        .turn(Sprite.Turn.MOVE);
    for (String box : List.of("medkit", "shotgun", "rifle", "launcher")) {
      v.sprite(box, box + ".png").size(1.4f, 1.05f);
    }
    v.trail("rocket", SMOKE);
    v.trail("bullet", GLINT);
    v.event("jump", SoundFile.of("jump.wav").volume(0.35f), DUST);
    v.event("shot", SoundFile.of("gun1.wav", "gun2.wav").volume(0.7f), Shake.by(0.06f), FLASH);
    v.event("spark", SoundFile.of("spark.wav").volume(0.4f), SPARKS);
    v.event(
        "hit",
        SoundFile.of("hit.wav"),
        Shake.by(0.1f),
        STARS,
        new Reaction().flash(0xffffff).hold(0.05f).seconds(0.2f));
    v.event(
        "boom",
        SoundFile.of(ROCKETS + "boom1.wav", ROCKETS + "boom2.wav"),
        Shake.by(0.45f),
        SMOULDER,
        FIRE,
        SPARKS);
    v.event("crash", SoundFile.of("crash.wav"), Shake.by(0.1f), SPLINTERS);
    v.event("taken", SoundFile.of("taken.wav").volume(0.7f), STARS);
    v.event("knock-out", SoundFile.of("out.wav"), Shake.by(0.6f).seconds(0.6f), CONFETTI, FIRE);
    v.hud(
        HudItem.icons("life.png", ShooterFields.LIVES),
        HudItem.bar("damage", ShooterFields.DAMAGE).colour(0xff4d6d),
        HudItem.number("shots", ShooterFields.AMMO).whileSet(ShooterFields.AMMO),
        HudItem.time("back in", ShooterFields.OUT)
            .whileSet(ShooterFields.OUT)
            .at(HudItem.Place.TOP));
    v.camera().height(15).framesAll();
  }

  private static void scenery(ViewSetup v) {
    v.background("sky.png").height(60).parallax(0.02f).standsAt(-26);
    v.background("clouds.png").height(9).parallax(0.1f).drifts(0.5f, 0).standsAt(6);
    v.background("far.png").height(13).parallax(0.2f).standsAt(-12);
    v.background("near.png").height(12).parallax(0.4f).standsAt(-15);
    v.sprite("plank", "plank.png").size(1.5f, 0.3f).tiled();
    v.sprite("floor", "rock.png").size(2, 2).tiled();
    v.sprite("stage", "steel.png").size(2.6f, 0.3f);
    v.sprite("lift", "steel.png").size(2.6f, 0.3f).tint(0x9effc0);
    for (String side : List.of("west", "east")) {
      v.sprite(side + " lift", "steel.png").size(1.8f, 0.3f).tint(0x9effc0);
      v.sprite(side + " edge", "rock.png").size(5.2f, 2);
    }
    v.sprite("crate", "crate.png").size(1.1f, 1.1f).frames(4).by(ShooterFields.COVER);
    v.sprite("lava", "lava.png").size(120, 40);
    v.sprite("lava", "crest.png").size(120, 1.6f).at(0, 20.2f);
  }
}
