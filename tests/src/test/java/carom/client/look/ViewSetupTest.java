package carom.client.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.event.Audience;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Goal: a view can declare what can be meant; all else is refused with its name and value. */
final class ViewSetupTest {
  private final ViewSetup setup = new ViewSetup();

  private static void refused(String part, Runnable declared) {
    String message = assertThrows(IllegalArgumentException.class, declared::run).getMessage();
    assertTrue(message.contains(part), message);
  }

  @Test
  void whatCannotBeMeantIsRefused() {
    refused("size=0.0", () -> setup.sprite("a", "a.png").size(0, 1));
    refused("size=NaN", () -> setup.sprite("a", "a.png").size(Float.NaN, 1));
    refused("frames=0", () -> setup.sprite("a", "a.png").frames(0));
    refused("frames=257", () -> setup.sprite("a", "a.png").frames(257));
    refused("height=-1.0", () -> setup.background("a.png").height(-1));
    refused("particles=0", () -> Particles.burst(0));
    refused("particles=501", () -> Particles.stream(501));
    refused("metres=3.0", () -> Shake.by(3));
    refused("seconds=9.0", () -> Shake.by(1).seconds(9));
    refused("sound=\"a.mp3\"", () -> SoundFile.of("b.ogg", "a.mp3"));
    refused("pitch=2.0, 1.0", () -> SoundFile.of("b.ogg").pitch(2, 1));
    refused("sound=\"a.flac\"", () -> setup.music("a.flac"));
    refused("height=1.0", () -> setup.camera().height(1));
    refused("lead=NaN", () -> setup.camera().lead(Float.NaN));
  }

  @Test
  void linesShowWhatPlayersAreTold() {
    Field<?> hidden = Field.count("hidden", 0, 9).of(Scope.PLAYER).to(Audience.NOBODY);
    refused("hidden", () -> HudItem.number("hidden", hidden));
    Countdown out = Field.countdown("out");
    refused("out, which has no greatest value", () -> HudItem.bar("back in", out));
    setup.hud(HudItem.time("back in", out).whileSet(out).at(HudItem.Place.TOP));
    assertEquals("back in", setup.hud().get(0).label());
    assertEquals(HudItem.Place.TOP, setup.hud().get(0).place());
  }

  @Test
  void declarationsAreLimited() {
    for (int i = 0; i < ViewSetup.MAX; i++) {
      setup.sprite("a", "a.png");
    }
    refused("Sprite: more than 500", () -> setup.sprite("a", "a.png"));
  }

  @Test
  void effectsOfAnEventAddUpInTheirOrder() {
    Shake shake = Shake.by(0.1f);
    Particles burst = Particles.burst(3);
    setup.event("boom", shake);
    setup.event("boom", burst);
    assertEquals(List.of(shake, burst), setup.event("boom"));
    assertEquals(null, setup.event("other"));
  }

  @Test
  void framesAreWithinThePicture() {
    SplittableRandom random = new SplittableRandom(4);
    for (int i = 0; i < 2_000; i++) {
      int frames = 1 + random.nextInt(256);
      Sprite sprite =
          setup.sprites().isEmpty() ? setup.sprite("a", "a.png") : setup.sprites().get(0);
      sprite.frames(frames);
      sprite.perSecond((float) random.nextDouble(-1e4, 1e4));
      sprite.perMetre((float) random.nextDouble(-1e4, 1e4));
      int frame = sprite.frame(0, random.nextDouble(0, 1e7), random.nextDouble(0, 1e7));
      assertTrue(frame >= 0 && frame < frames, "frame=" + frame + " of " + frames);
    }
  }
}
