package carom.client.look;

import carom.game.rockets.RocketFields;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A look that a seed draws: all that a view can declare, in any number and order, with files that
 * are there, that are missing and that are no pictures.
 */
public final class RandomView implements GameView {
  private static final String FILES = "/carom/client/look/rockets/";
  private static final List<String> THINGS =
      List.of("player", "rocket", "wall", "side wall", "pillar", "?");
  private static final List<String> EVENTS = List.of("shot", "boom", "?");
  private static final List<String> PICTURES =
      List.of("hull.png", "gun.png", "smoke.png", "stars.png", "rocket.png", "plate.png");

  private final SplittableRandom random;
  private final boolean faulty;

  /**
   * Creates a view.
   *
   * @param faulty whether some of its files are missing or no pictures
   */
  public RandomView(long seed, boolean faulty) {
    random = new SplittableRandom(seed);
    this.faulty = faulty;
  }

  @Override
  public String game() {
    return "rockets";
  }

  private float in(double least, double most) {
    return (float) random.nextDouble(least, most);
  }

  private <T> T one(List<T> of) {
    return of.get(random.nextInt(of.size()));
  }

  private String picture() {
    if (faulty && random.nextInt(4) == 0) {
      return one(List.of("missing.png", FILES + "boom1.wav", FILES + "RocketsView.class"));
    }
    return FILES + one(PICTURES);
  }

  private Particles particles(Particles p) {
    p.speed(in(0, 3), in(3, 30)).seconds(in(0.02, 1), in(1, 3)).size(in(0, 2), in(0, 2));
    p.colour(random.nextInt(), random.nextInt()).alpha(in(0, 1)).gravity(in(-2, 2));
    p.drag(in(0, 9)).spread(in(0, 3.1));
    if (random.nextBoolean()) {
      p.glow();
    }
    return random.nextBoolean() ? p.picture(picture()) : p;
  }

  private Effect effect() {
    return switch (random.nextInt(4)) {
      case 3 ->
          new Reaction()
              .squash(in(0, 0.9))
              .flash(random.nextInt())
              .hold(in(0, 0.3))
              .seconds(in(0.05, 3));
      case 0 -> Shake.by(in(0.01, 2)).seconds(in(0.05, 3));
      case 1 -> SoundFile.of(FILES + "boom1.wav", "missing.ogg").volume(in(0, 1));
      default -> particles(Particles.burst(1 + random.nextInt(Particles.MAX)));
    };
  }

  private HudItem line() {
    HudItem line =
        switch (random.nextInt(4)) {
          case 0 -> HudItem.bar("goals", RocketFields.HEALTH);
          case 1 -> HudItem.icons(picture(), RocketFields.HEALTH);
          case 2 ->
              HudItem.number("health", RocketFields.HEALTH)
                  .scale(in(-9, 9))
                  .decimals(random.nextInt(HudItem.MAX_DECIMALS + 1));
          default -> HudItem.time("wait", RocketFields.HEALTH).whileSet(RocketFields.HEALTH);
        };
    return line.at(one(List.of(HudItem.Place.values()))).colour(random.nextInt());
  }

  private void sprite(Sprite s) {
    if (random.nextBoolean()) {
      s.size(in(0.01, 9), in(0.01, 9));
    }
    s.at(in(-3, 3), in(-3, 3))
        .frames(1 + random.nextInt(256))
        .turn(one(List.of(Sprite.Turn.values())));
    s.perSecond(in(-99, 99)).perMetre(in(-99, 99)).tint(random.nextInt());
    if (random.nextInt(3) == 0) {
      s.by(RocketFields.HEALTH);
    }
    if (random.nextBoolean()) {
      s.flips();
    }
    if (random.nextBoolean()) {
      s.tint();
    }
    if (random.nextBoolean() && s.width() > 0) {
      s.tiled();
    }
  }

  @Override
  public void setUp(ViewSetup v) {
    int count = 1 + random.nextInt(30);
    for (int i = 0; i < count; i++) {
      switch (random.nextInt(6)) {
        case 0 ->
            v.background(picture())
                .height(in(0.1, 99))
                .parallax(in(-2, 2))
                .drifts(in(-9, 9), in(-9, 9))
                .alpha(in(0, 1));
        case 1 -> v.background(picture()).height(in(0.1, 99)).standsAt(in(-50, 50));
        case 2 -> v.event(one(EVENTS), effect(), effect());
        case 3 -> v.blow(one(THINGS), effect());
        case 4 -> v.trail(one(THINGS), particles(Particles.stream(1 + random.nextInt(500))));
        default -> sprite(v.sprite(one(THINGS), picture()));
      }
    }
    if (random.nextBoolean()) {
      String file = picture();
      float at = in(-50, 900);
      v.paint(
          (canvas, view) -> {
            canvas.rect(at, at, 40, 20, 0x334455, 0.5f);
            canvas.text(view.game(), at, canvas.height() - at, 0xffffff);
            canvas.line(0, 0, canvas.screenX(at, 3), canvas.screenY(at, 3), 2, 0xff0000, 1);
            canvas.picture(file, canvas.width() - at, at, 64, 32);
            canvas.title("" + view.tick(), at, at, 0x00ff00);
            canvas.disc(at, at, canvas.titleWidth("12") + canvas.textWidth("x"), 0xff, 0.3f);
          });
    }
    if (random.nextBoolean()) {
      v.minimap(one(List.of(HudItem.Place.values())), one(THINGS), one(THINGS));
    }
    for (int i = random.nextInt(9); i > 0; i--) {
      v.hud(line());
    }
    v.camera().height(in(4, 200)).lead(in(0, 2));
    if (random.nextBoolean()) {
      v.camera().framesAll();
    }
    if (random.nextBoolean()) {
      v.camera().zone(one(List.of("goal", "nowhere"))).whileSet(RocketFields.HEALTH, in(4, 200));
    }
  }
}
