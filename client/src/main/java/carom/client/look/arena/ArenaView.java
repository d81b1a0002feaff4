package carom.client.look.arena;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.HudItem;
import carom.client.look.Particles;
import carom.client.look.Shake;
import carom.client.look.SlowMotion;
import carom.client.look.SoundFile;
import carom.client.look.ViewSetup;
import carom.game.arena.ArenaFields;
import carom.game.arena.ArenaGame;
import carom.sim.entity.Input;

/**
 * The look of {@code ArenaGame}: its shapes as they are, with a moment for each goal, in which the
 * ball bursts, and for each dash, jolt and blow.
 */
public final class ArenaView implements GameView {
  private static final String SMOKE = "/carom/client/look/rockets/smoke.png";
  private static final Particles FLASH =
      Particles.burst(40)
          .speed(2, 14)
          .drag(4)
          .seconds(0.25f, 0.7f)
          .size(1.2f, 0.2f)
          .colour(0xfff6c8, 0xff9f1c)
          .alpha(0.7f)
          .glow();
  private static final Particles SHREDS =
      Particles.burst(36)
          .picture("/carom/client/look/rockets/scrap.png")
          .speed(5, 19)
          .drag(1.6f)
          .seconds(0.8f, 1.9f)
          .size(0.45f, 0.15f)
          .colour(0xffe08a, 0xc98a1c);
  private static final Particles CONFETTI =
      Particles.burst(110)
          .picture("/carom/client/look/rockets/scrap.png")
          .speed(2, 16)
          .drag(1.3f)
          .seconds(1, 2.6f)
          .size(0.28f, 0.1f)
          .colour(0xff4d6d, 0x4cc9f0);
  private static final Particles WAKE =
      Particles.burst(12)
          .picture(SMOKE)
          .speed(0.5f, 3)
          .drag(3)
          .seconds(0.2f, 0.5f)
          .size(0.2f, 0.7f)
          .colour(0xe8f4ff, 0x9ad1ff)
          .alpha(0.5f);
  private static final Particles ARCS =
      Particles.burst(14)
          .speed(4, 12)
          .drag(2)
          .seconds(0.1f, 0.3f)
          .size(0.1f, 0.02f)
          .colour(0xffffff, 0xfff6c8)
          .glow();
  private static final Particles GRIT =
      Particles.burst(10)
          .speed(2, 8)
          .drag(2)
          .seconds(0.1f, 0.35f)
          .size(0.1f, 0.02f)
          .colour(0xffffff, 0xffe08a)
          .glow();
  private static final Particles STREAK =
      Particles.stream(50)
          .speed(0, 0.3f)
          .seconds(0.15f, 0.35f)
          .size(0.5f, 0.08f)
          .colour(0xffe08a, 0xffb347)
          .alpha(0.3f)
          .glow();

  /** Creates the view, for the service loader. */
  public ArenaView() {}

  @Override
  public String game() {
    return "arena";
  }

  @Override
  public void setUp(ViewSetup v) {
    v.actions(
        Action.button("dash", Input.ACTION).key("Space").mouse("left").pad("A"),
        Action.button("jolt", Input.SECOND).key("E").mouse("right").pad("B"),
        Action.button("boost", ArenaGame.BOOSTS).key("L-Shift", "R-Shift").pad("R1"),
        Action.button("bend left", ArenaGame.SPINS_LEFT).key("Q").pad("X"),
        Action.button("bend right", ArenaGame.SPINS_RIGHT).key("R").pad("Y"));
    v.hud(HudItem.bar("boost", ArenaFields.BOOST).colour(0x4cc9f0));
    v.event(
        "goal",
        SoundFile.of("/carom/client/look/cars/lap.wav", "/carom/client/look/cars/flip.wav"),
        Shake.by(0.7f).seconds(0.8f),
        SlowMotion.last(1).speed(0.4f),
        FLASH,
        SHREDS,
        CONFETTI);
    v.event("dash", WAKE);
    v.event("jolt", ARCS);
    v.event("jolt hit", ARCS, GRIT, Shake.by(0.1f));
    v.blow("ball", GRIT);
    v.event("boost", WAKE);
    v.trail("ball", STREAK);
    v.trail("heavy ball", STREAK);
    v.blow("heavy ball", GRIT, SoundFile.of("/carom/client/look/cars/land2.wav").volume(0.4f));
  }
}
