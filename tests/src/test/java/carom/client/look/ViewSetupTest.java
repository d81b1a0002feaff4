package carom.client.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.event.Audience;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
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
    refused("width=0.0", () -> setup.sprite("a", "a.png").size(0, 1));
    refused("width=NaN", () -> setup.sprite("a", "a.png").size(Float.NaN, 1));
    refused("frames=0", () -> setup.sprite("a", "a.png").frames(0));
    refused("frames=257", () -> setup.sprite("a", "a.png").frames(257));
    refused("height=-1.0", () -> setup.background("a.png").height(-1));
    refused("particles=0", () -> Particles.burst(0));
    refused("particles=501", () -> Particles.stream(501));
    refused("metres=3.0", () -> Shake.by(3));
    refused("seconds=9.0", () -> Shake.by(1).seconds(9));
    refused("sound=\"a.mp3\"", () -> SoundFile.of("b.ogg", "a.mp3"));
    refused("most pitch=1.0 is outside 2.0..2.0", () -> SoundFile.of("b.ogg").pitch(2, 1));
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

  /** All that takes a number, with the range that its doc comment says. */
  @Test
  void eachNumberHasItsRange() {
    Background b = setup.background("a.png");
    Sprite s = setup.sprite("a", "a.png");
    Particles p = Particles.burst(1);
    ranged(0.1f, 10_000, b::height);
    ranged(-10, 10, b::parallax);
    ranged(-32_768, 32_768, b::standsAt);
    ranged(-100, 100, v -> b.drifts(0, v));
    ranged(0, 1, b::alpha);
    ranged(0.01f, 2_000, v -> s.size(1, v));
    ranged(-2_000, 2_000, v -> s.at(v, 0));
    ranged(-1_000, 1_000, s::perSecond);
    ranged(-1_000, 1_000, s::perMetre);
    ranged(0, 1_000, v -> p.speed(v, v));
    ranged(0.02f, 10, v -> p.seconds(v, v));
    ranged(0, 100, v -> p.size(0, v));
    ranged(0, 1, p::alpha);
    ranged(-100, 100, p::gravity);
    ranged(0, 1_000, p::drag);
    ranged(0, (float) Math.PI, p::spread);
    ranged(0, 2, Shake::by);
    ranged(0.05f, 3, v -> Shake.by(1).seconds(v));
    ranged(0.2f, 3, SlowMotion::last);
    ranged(0.1f, 1, v -> SlowMotion.last(1).speed(v));
    ranged(0, 1, v -> SoundFile.of("a.ogg").volume(v));
    ranged(0.5f, 2, v -> SoundFile.of("a.ogg").pitch(v, v));
    ranged(4, 200, v -> setup.camera().height(v));
    ranged(0, 2, v -> setup.camera().lead(v));
    ranged(4, 200, v -> setup.camera().whileSet(Field.flag("scope"), v));
  }

  private static void ranged(float least, float most, Consumer<Float> declared) {
    declared.accept(least);
    declared.accept(most);
    for (float out : new float[] {Math.nextDown(least), Math.nextUp(most), 1e30f, Float.NaN}) {
      refused("=" + out + " is outside", () -> declared.accept(out));
    }
  }

  @Test
  void onlyNumbersAndTimesHaveDecimals() {
    HudItem number = HudItem.number("speed", Field.count("speed"));
    assertEquals(3.6f, number.scale(3.6f).decimals(6).scale());
    refused("digits=7 is outside 0..6", () -> number.decimals(7));
    refused("digits=-1 is outside 0..6", () -> number.decimals(-1));
    ranged(-HudItem.MAX_SCALE, HudItem.MAX_SCALE, number::scale);
    HudItem bar = HudItem.bar("health", Field.ratio("health"));
    refused("a bar has no decimals; a number or time has", () -> bar.decimals(1));
    refused("a bar has no scale; a number or time has", () -> bar.scale(2));
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
  void onlyAnEventHasASlowMotion() {
    assertFalse(setup.hasSlowMotion());
    refused("declare it for an event", () -> setup.blow("ball", SlowMotion.last(1)));
    setup.event("goal", Shake.by(1), SlowMotion.last(1));
    assertTrue(setup.hasSlowMotion());
  }

  @Test
  void framesAreWithinThePicture() {
    SplittableRandom random = new SplittableRandom(4);
    for (int i = 0; i < 2_000; i++) {
      int frames = 1 + random.nextInt(256);
      Sprite sprite =
          setup.sprites().isEmpty() ? setup.sprite("a", "a.png") : setup.sprites().get(0);
      sprite.frames(frames);
      sprite.perSecond((float) random.nextDouble(-1e3, 1e3));
      sprite.perMetre((float) random.nextDouble(-1e3, 1e3));
      int frame = sprite.frame(0, random.nextDouble(0, 1e7), random.nextDouble(0, 1e7));
      assertTrue(frame >= 0 && frame < frames, "frame=" + frame + " of " + frames);
    }
  }
}
