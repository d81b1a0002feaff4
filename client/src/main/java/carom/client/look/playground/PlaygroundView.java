package carom.client.look.playground;

import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.HudCanvas;
import carom.client.look.HudItem;
import carom.client.look.Particles;
import carom.client.look.Reaction;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.look.Sprite;
import carom.client.look.ViewSetup;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.game.playground.PlaygroundFields;
import carom.game.playground.PlaygroundFields.Contest;
import carom.game.playground.PlaygroundGame;
import carom.sim.entity.Input;

/** The look of {@code PlaygroundGame}. */
public final class PlaygroundView implements GameView {
  private static final int BEAM = 0x9bf6ff;
  private static final Particles SPARKS =
      Particles.burst(10)
          .speed(1, 5)
          .drag(4)
          .seconds(0.15f, 0.4f)
          .size(0.12f, 0.02f)
          .colour(0xffffff, BEAM)
          .glow();
  private static final Particles PUFF =
      Particles.burst(14)
          .picture("/carom/client/look/rockets/smoke.png")
          .speed(0.5f, 3)
          .drag(4)
          .seconds(0.2f, 0.5f)
          .size(0.2f, 0.6f)
          .colour(0xffffff, 0xc9d4e4)
          .alpha(0.6f);
  private static final Particles CONFETTI =
      Particles.burst(60)
          .picture("bit.png")
          .speed(3, 12)
          .drag(1.5f)
          .seconds(0.6f, 1.3f)
          .size(0.16f, 0.1f)
          .gravity(0.6f)
          .colour(0xffd166, 0xff6b6b);
  private static final Particles GREEN =
      Particles.burst(30)
          .speed(2, 7)
          .drag(2)
          .seconds(0.4f, 0.9f)
          .size(0.15f, 0.03f)
          .colour(0xe8ffd0, 0x5ad18a)
          .glow();
  private static final Particles GOLD =
      Particles.burst(24)
          .speed(2, 8)
          .drag(2)
          .seconds(0.3f, 0.9f)
          .size(0.16f, 0.03f)
          .colour(0xfff3b0, 0xffa62e)
          .glow();
  private static final Particles CHIPS =
      Particles.burst(6)
          .picture("/carom/client/look/cars/splinter.png")
          .speed(1, 4)
          .seconds(0.3f, 0.6f)
          .size(0.1f, 0.05f)
          .gravity(1)
          .colour(0xe6bd86, 0x9a6a36);
  private static final Particles JET =
      Particles.stream(22)
          .speed(0.2f, 1)
          .spread(0.4f)
          .seconds(0.2f, 0.5f)
          .size(0.16f, 0.02f)
          .colour(0xeaffff, BEAM)
          .alpha(0.5f)
          .glow();

  /** Creates the view, for the service loader. */
  public PlaygroundView() {}

  @Override
  public String game() {
    return "playground";
  }

  @Override
  public void setUp(ViewSetup v) {
    int make = PlaygroundGame.MAKE;
    v.actions(
        Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left"),
        Action.moveY("down", "up").keys("S", "W").keys("Down", "Up").stick("left"),
        Action.aim("aim").mouse("pointer").stick("right"),
        Action.button("grab", Input.ACTION).mouse("left").pad("R1"),
        Action.button("throw", Input.SECOND).key("F").mouse("right").pad("L1"),
        Action.button("turn left", Input.UP).key("Q").pad("L3"),
        Action.button("turn right", Input.DOWN).key("E"),
        Action.button("box", make).key("1").pad("A"),
        Action.button("ball", make << 1).key("2"),
        Action.button("plank", make << 2).key("3").pad("X"),
        Action.button("wheel", make << 3).key("4").pad("Y"),
        Action.button("balloon", make << 4).key("5"),
        Action.button("weight", make << 5).key("6"),
        Action.button("weld", PlaygroundGame.WELD).key("Z").pad("Back"),
        Action.button("hinge", PlaygroundGame.HINGE).key("X"),
        Action.button("motor", PlaygroundGame.MOTOR).key("C").pad("B"),
        Action.button("rope", PlaygroundGame.ROPE).key("V"),
        Action.button("cut", PlaygroundGame.CUT).key("G"),
        Action.button("drive motors", Input.JUMP).key("Space", "L-Shift").pad("R3"));
    scenery(v);
    things(v);
    v.sprite("hand", "hand.png").size(0.75f, 0.75f).frames(2).by(PlaygroundFields.GRABS);
    v.sprite("robot", "robot.png").size(1.1f, 1.1f).upright().tint();
    v.sprite("robot", "eye.png").size(1.1f, 1.1f).turn(Sprite.Turn.AIM);
    v.trail("robot", JET);
    v.event("grab", SoundFile.of("grab.wav").volume(0.6f), SPARKS, new Reaction().flash(0xffffff));
    v.event("throw", SoundFile.of("throw.wav").volume(0.8f), PUFF);
    v.event("slip", SoundFile.of("slip.wav").volume(0.6f), SPARKS);
    v.event("make", SoundFile.of("make.wav").volume(0.7f), PUFF, new Reaction().squash(0.25f));
    v.event("gone", SoundFile.of("gone.wav").volume(0.5f), PUFF);
    v.event("blocked", SoundFile.of("blocked.wav").volume(0.6f));
    v.event("join", SoundFile.of("join.wav"), SPARKS);
    v.event("cut", SoundFile.of("cut.wav"), CHIPS);
    v.event("basket", SoundFile.of("basket.wav"), CONFETTI);
    v.event("metre", SoundFile.of("metre.wav").volume(0.8f), GREEN);
    v.event("second", SoundFile.of("second.wav").volume(0.4f), GOLD);
    v.event("taken", SoundFile.of("taken.wav"), GOLD, Shake.by(0.2f));
    v.hud(
        HudItem.number("things of 24", PlaygroundFields.THINGS),
        HudItem.number("baskets", PlaygroundFields.BASKETS).at(HudItem.Place.TOP_LEFT),
        HudItem.number("tower m", PlaygroundFields.TOWER).at(HudItem.Place.TOP_LEFT),
        HudItem.number("star s", PlaygroundFields.STAR_SECONDS).at(HudItem.Place.TOP_LEFT));
    v.minimap(HudItem.Place.BOTTOM_RIGHT);
    v.paint(PlaygroundView::paint);
    v.camera().height(19).lead(0.25f);
  }

  private static void things(ViewSetup v) {
    SoundFile wood = SoundFile.of("wood1.wav", "wood2.wav").volume(0.5f);
    SoundFile rubber = SoundFile.of("boing.wav").volume(0.5f);
    v.sprite("box", "box.png").size(1, 1).tint();
    v.sprite("ball", "ball.png").size(1, 1).tint();
    v.sprite("plank", "plank.png").size(3, 0.3f).tint();
    v.sprite("wheel", "tyre.png").size(1.2f, 1.2f);
    v.sprite("wheel", "rim.png").size(1.2f, 1.2f).tint();
    v.sprite("balloon", "balloon.png").size(1.2f, 1.44f).at(0, -0.1f).tint();
    v.sprite("weight", "weight.png").size(0.9f, 0.9f);
    v.sprite("weight", "band.png").size(0.9f, 0.9f).tint();
    v.sprite("star", "star.png").size(2, 2);
    v.sprite("crate", "crate.png").size(0.6f, 0.6f);
    v.sprite("board", "board.png").size(2.6f, 0.3f);
    v.blow("box", wood);
    v.blow("plank", wood);
    v.blow("crate", CHIPS, wood);
    v.blow("board", CHIPS, wood);
    v.blow("brick", wood);
    v.blow("ball", rubber);
    v.blow("wheel", rubber);
    v.blow("pebble", SoundFile.of("boing.wav").volume(0.25f));
    v.blow("balloon", SoundFile.of("squeak.wav").volume(0.4f));
    v.blow("weight", SoundFile.of("iron.wav").volume(0.7f), Shake.by(0.08f));
  }

  private static void scenery(ViewSetup v) {
    v.background("sky.png").height(80).parallax(0.02f).standsAt(-20);
    v.background("/carom/client/look/cars/clouds.png")
        .height(10)
        .parallax(0.06f)
        .drifts(0.5f, 0)
        .standsAt(12);
    v.background("far.png").height(17).parallax(0.12f).standsAt(-9);
    v.background("near.png").height(18).parallax(0.3f).standsAt(-9);
    v.sprite("ground", "ground.png").size(4, 2).tiled();
    v.sprite("wall", "wall.png").size(2, 2).tiled();
    v.sprite("basket", "basket.png").size(4, 2);
  }

  // ---- over the picture

  /** Draws beams, the tower's mark, and what counts now. */
  private static void paint(HudCanvas c, ClientView view) {
    if (!view.knowsFields()) {
      return;
    }
    for (int i = 0; i < view.jointCount(); i++) {
      var joint = view.joint(i);
      Drawn robot = joint.bodyA() < 0 ? null : view.find(joint.bodyA());
      if (robot != null
          && robot.archetype().name().equals("robot")
          && view.player(robot.ownerId()).get(PlaygroundFields.GRABS)) {
        beam(c, joint.ax(), joint.ay(), joint.bx(), joint.by());
      }
    }
    Contest contest = view.match().get(PlaygroundFields.CONTEST);
    String what =
        switch (contest) {
          case FREE -> "";
          case BASKETS -> "BASKETS: loose things into the hoops";
          case TOWER -> "TOWER: your own things up on the site";
          case STAR -> "STAR: grab it and keep it";
        };
    c.text(what, (c.width() - c.textWidth(what)) / 2, c.height() - 64, 0xffffff);
  }

  private static void beam(HudCanvas c, float ax, float ay, float bx, float by) {
    float x1 = c.screenX(ax, ay);
    float y1 = c.screenY(ax, ay);
    float x2 = c.screenX(bx, by);
    float y2 = c.screenY(bx, by);
    c.line(x1, y1, x2, y2, 9, BEAM, 0.25f);
    c.line(x1, y1, x2, y2, 3, 0xffffff, 0.7f);
  }
}
