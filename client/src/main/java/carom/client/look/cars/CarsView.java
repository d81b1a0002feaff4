package carom.client.look.cars;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.HudItem;
import carom.client.look.Particles;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.look.ViewSetup;
import carom.game.cars.CarsFields;
import carom.sim.entity.Input;

/** The look of {@code CarsGame}. */
public final class CarsView implements GameView {
  /** Number of colours of cars; each is an archetype. */
  private static final int CARS = 8;

  private static final String SMOKE = "/carom/client/look/rockets/smoke.png";
  private static final Particles DUST =
      Particles.burst(16)
          .picture(SMOKE)
          .speed(1, 5)
          .drag(3)
          .seconds(0.3f, 0.8f)
          .size(0.2f, 0.8f)
          .colour(0xe0b98a, 0xb98a5a)
          .alpha(0.55f);
  private static final Particles SPRAY =
      Particles.stream(26)
          .picture(SMOKE)
          .speed(0.3f, 1.6f)
          .spread(0.9f)
          .drag(2)
          .seconds(0.2f, 0.6f)
          .size(0.1f, 0.45f)
          .colour(0xe0b98a, 0xb98a5a)
          .alpha(0.3f);
  private static final Particles PUFF =
      Particles.burst(5)
          .picture(SMOKE)
          .speed(0.5f, 2)
          .drag(3)
          .seconds(0.2f, 0.5f)
          .size(0.15f, 0.5f)
          .colour(0xe0b98a, 0xb98a5a)
          .alpha(0.35f);
  private static final Particles FIRE =
      Particles.burst(7)
          .speed(1, 4)
          .drag(3)
          .seconds(0.15f, 0.4f)
          .size(0.22f, 0.05f)
          .colour(0xbfeeff, 0x2a6bff)
          .glow();
  private static final Particles STARS =
      Particles.burst(26)
          .speed(2, 9)
          .drag(2.5f)
          .seconds(0.3f, 0.7f)
          .size(0.14f, 0.03f)
          .colour(0xffffff, 0x4cc9f0)
          .glow();
  private static final Particles GOLD =
      Particles.burst(50)
          .speed(3, 12)
          .drag(2)
          .seconds(0.4f, 1)
          .size(0.15f, 0.04f)
          .gravity(0.5f)
          .colour(0xfff3b0, 0xff9a2e)
          .glow();
  private static final Particles SPLINTERS =
      Particles.burst(22)
          .picture("splinter.png")
          .speed(2, 8)
          .seconds(0.5f, 1)
          .size(0.2f, 0.1f)
          .gravity(1)
          .colour(0xd9a066, 0x8a5a33);
  private static final Particles WATER =
      Particles.burst(60)
          .speed(3, 12)
          .seconds(0.4f, 0.9f)
          .size(0.2f, 0.06f)
          .gravity(1)
          .colour(0xe8f6ff, 0x5aa9e0)
          .alpha(0.8f);
  private static final Particles SPARKS =
      Particles.burst(8)
          .speed(3, 9)
          .seconds(0.1f, 0.3f)
          .size(0.06f, 0.02f)
          .gravity(0.6f)
          .colour(0xfff4d0, 0xff9a2e)
          .glow();

  /** Creates the view, for the service loader. */
  public CarsView() {}

  @Override
  public String game() {
    return "cars";
  }

  @Override
  public void setUp(ViewSetup v) {
    v.actions(
        Action.moveX("brake", "drive").keys("A", "D").keys("Left", "Right").stick("left"),
        Action.moveY("lean forwards", "lean back").keys("S", "W").keys("Down", "Up").stick("left"),
        Action.button("nitro", Input.ACTION).key("Space", "L-Shift").mouse("left").pad("A"),
        Action.button("back to the gate", Input.SECOND).key("R").pad("Y"));
    scenery(v);
    for (int i = 0; i < CARS; i++) {
      String car = "car." + i;
      v.sprite(car, "flame.png").size(2, 0.5f).at(-2.45f, -0.17f).frames(2).by(CarsFields.BOOSTS);
      v.sprite(car, "body.png").size(3, 1.5f).tint();
      v.sprite(car, "trim.png").size(3, 1.5f);
      v.blow(car, SPARKS, SoundFile.of("bump1.wav", "bump2.wav").volume(0.5f), Shake.by(0.12f));
    }
    v.sprite("wheel", "wheel.png").size(1, 1);
    v.trail("wheel", SPRAY);
    v.blow("wheel", PUFF);
    v.event("nitro", SoundFile.of("nitro.wav").volume(0.5f), FIRE, Shake.by(0.03f));
    v.event("land", SoundFile.of("land1.wav", "land2.wav").volume(0.6f), DUST, Shake.by(0.12f));
    v.event("flip", SoundFile.of("flip.wav"), GOLD);
    v.event("ring", SoundFile.of("ring.wav").volume(0.7f), STARS);
    v.event("gate", SoundFile.of("gate.wav").volume(0.35f));
    v.event("lap", SoundFile.of("lap.wav"), GOLD);
    v.event("snap", SoundFile.of("snap.wav"), SPLINTERS, Shake.by(0.2f));
    v.event(
        "crash",
        SoundFile.of("/carom/client/look/shooter/crash.wav").volume(0.7f),
        SPLINTERS,
        Shake.by(0.15f));
    v.event("splash", SoundFile.of("splash.wav"), WATER, Shake.by(0.3f));
    v.event("back", SoundFile.of("back.wav").volume(0.6f), DUST);
    v.hud(
        HudItem.bar("nitro", CarsFields.NITRO).colour(0x4cc9f0),
        HudItem.number("lap", CarsFields.LAP).at(HudItem.Place.TOP_LEFT),
        HudItem.number("place", CarsFields.PLACE).at(HudItem.Place.TOP_LEFT),
        HudItem.time("towed: on in", CarsFields.HELD)
            .whileSet(CarsFields.HELD)
            .at(HudItem.Place.TOP));
    v.camera().height(15).lead(0.4f);
  }

  private static void scenery(ViewSetup v) {
    v.background("sky.png").height(70).parallax(0.02f).standsAt(-24);
    v.background("clouds.png").height(9).parallax(0.08f).drifts(0.5f, 0).standsAt(9);
    v.background("far.png").height(13).parallax(0.12f).standsAt(-4);
    v.background("near.png").height(9).parallax(0.3f).standsAt(-4);
    v.sprite("tunnel", "tunnel.png").size(9, 5.2f);
    v.sprite("gate", "gate.png").size(1.25f, 3).at(0.5f, 1.5f);
    v.sprite("ring", "ring.png").size(3.4f, 3.4f);
    v.sprite("plank", "plank.png").size(1.08f, 0.27f);
    v.sprite("post", "plank.png").size(0.3f, 0.3f);
    v.sprite("see-saw", "beam.png").size(19, 0.36f);
    v.sprite("shelf", "beam.png").size(10, 0.36f);
    v.sprite("loop", "loop.png").size(9.2f, 9.2f);
    v.sprite("crate", "crate.png").size(1, 1);
  }
}
