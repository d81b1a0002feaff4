package carom.client.desktop;

import carom.client.desktop.game.EventSounds;
import carom.client.desktop.game.GamePicture;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.replay.ReplayClient;
import carom.net.protocol.ServerMessage.RosterEntry;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputAdapter;
import com.badlogic.gdx.ScreenAdapter;
import java.io.IOException;
import java.util.Locale;
import java.util.function.Supplier;

/** Shows a recorded game, with the keys of a video player. Render thread only. */
final class ReplayScreen extends ScreenAdapter {
  private static final float PAD = 12;
  private static final int JUMP_SECONDS = 5;
  private static final String KEYS =
      "Space: pause     .: one step     Left, Right: 5 s     - +: slow motion, faster     Home, End"
          + "     Tab, 1-9: follow a player     0: nobody     M: sound     F4: debug     Esc:"
          + " leave";

  private final GamePicture picture;
  private final Fonts fonts;
  private final ReplayClient client;
  private final TimeBar bar;
  private final Panel title = new Panel(Spot.TOP_LEFT, Spot.TOP_RIGHT, Spot.BOTTOM_LEFT);
  private final String heading;
  private final Supplier<String> end;
  private final Runnable exit;

  /**
   * Creates a screen.
   *
   * @param client closed with this screen
   * @param heading names what is shown, in a word
   * @param end tells why the recording grows no more, in words for the player; empty while it may
   */
  ReplayScreen(
      Canvas canvas,
      Fonts fonts,
      EventSounds sounds,
      ReplayClient client,
      String heading,
      Supplier<String> end,
      Runnable exit) {
    this.fonts = fonts;
    this.client = client;
    this.heading = heading;
    this.end = end;
    this.exit = exit;
    picture = new GamePicture(canvas, fonts, sounds);
    bar = new TimeBar(picture.hud(), canvas);
    picture.hud().layout().floor(TimeBar.ROOM);
    client.events(picture.events(client.view()));
  }

  /** Shows or hides the debug layers. */
  void debug(boolean shown) {
    picture.debug(shown);
  }

  /** Returns whether the recording's end is shown. */
  boolean atEnd() {
    return client.ended() && !client.seeking();
  }

  /** Returns the texts and panels of the picture. */
  Hud hud() {
    return picture.hud();
  }

  @Override
  public void show() {
    Gdx.input.setInputProcessor(
        new InputAdapter() {
          private boolean seeks;

          @Override
          public boolean keyDown(int key) {
            return key(key);
          }

          @Override
          public boolean touchDown(int x, int y, int pointer, int button) {
            seeks = bar.isAt(x, y);
            return touchDragged(x, y, pointer);
          }

          @Override
          public boolean touchDragged(int x, int y, int pointer) {
            if (seeks) {
              client.seek(bar.tick(x, client.lastTick()));
            }
            return seeks;
          }
        });
  }

  private boolean key(int key) {
    int jump = JUMP_SECONDS * client.view().tickRate();
    switch (key) {
      case Keys.SPACE -> client.pause(!client.paused());
      case Keys.PERIOD -> client.single();
      case Keys.LEFT -> client.seek(client.tick() - jump);
      case Keys.RIGHT -> client.seek(client.tick() + jump);
      case Keys.HOME -> client.seek(0);
      case Keys.END -> client.seek(Integer.MAX_VALUE);
      case Keys.MINUS, Keys.NUMPAD_SUBTRACT -> client.speedUp(-1);
      case Keys.EQUALS, Keys.PLUS, Keys.NUMPAD_ADD -> client.speedUp(1);
      case Keys.TAB -> client.followNext();
      case Keys.M -> picture.toggleSound();
      case Keys.ESCAPE -> exit.run();
      default -> {
        int player = key - Keys.NUM_1;
        if (player < -1 || player > 8) {
          return picture.key(key);
        }
        follow(player);
      }
    }
    return true;
  }

  /** Follows the player at a place of the list of those who have a body; nobody for another. */
  private void follow(int place) {
    int id = -1;
    int playing = 0;
    for (RosterEntry entry : client.view().players()) {
      if (!entry.spectator() && entry.alive() && playing++ == place) {
        id = entry.playerId();
      }
    }
    client.follow(id);
  }

  @Override
  public void render(float deltaSeconds) {
    long nowNs = System.nanoTime();
    client.update(nowNs);
    picture.draw(client.view(), false, nowNs, deltaSeconds);
    title(picture.hud());
  }

  private void title(Hud hud) {
    int rate = client.view().tickRate();
    StringBuilder text = new StringBuilder(heading).append("   ");
    text.append(time(client.tick(), rate)).append(" / ");
    text.append(time(client.lastTick(), rate)).append("   tick ").append(client.tick());
    text.append(client.paused() ? "   paused" : "");
    text.append(client.seeking() ? "   seeking" : "");
    text.append(client.ended() ? "   end" : "");
    text.append(client.waiting() && end.get().isEmpty() ? "   waiting for more" : "");
    text.append(client.speed() == 1 ? "" : "   speed " + client.speed());
    text.append(client.followed().isEmpty() ? "" : "   follows " + client.followed());
    String trouble = client.problem();
    if (trouble.isEmpty() && client.divergence() != null) {
      trouble = "diverged from the recording at tick " + client.divergence().tick();
    }
    if (trouble.isEmpty()) {
      trouble = end.get();
    }
    hud.panel(-2, -2, hud.windowWidth() + 4, TimeBar.ROOM, UiColours.DIALOG);
    bar.draw(client.tick(), client.lastTick());
    float w = hud.width(fonts.text(), text.toString());
    w = Math.max(w, hud.width(fonts.text(), trouble)) + 2 * PAD;
    float h = trouble.isEmpty() ? 34 : 58;
    if (hud.layout().placeAnyhow(title, Math.min(w, hud.windowWidth() - 2 * PAD), h)) {
      hud.panel(title.x(), title.y(), w, h);
      hud.begin();
      float top = title.y() + h - 11;
      hud.left(fonts.text(), text.toString(), title.x() + PAD, top, UiColours.TEXT);
      hud.left(fonts.text(), trouble, title.x() + PAD, top - 24, UiColours.ACCENT);
      hud.end();
    }
    hud.begin();
    float height = hud.wrap(fonts.small(), KEYS, hud.windowWidth() - 2 * PAD, UiColours.MUTED);
    hud.wrapped(PAD, Math.min(height + 8, TimeBar.ROOM - 28));
    hud.end();
  }

  private static String time(int tick, int rate) {
    int second = tick / rate;
    return String.format(Locale.ROOT, "%d:%02d", second / 60, second % 60);
  }

  @Override
  public void dispose() {
    try {
      client.close();
    } catch (IOException e) {
      System.err.println("carom-client: " + e);
    }
    picture.dispose();
  }
}
