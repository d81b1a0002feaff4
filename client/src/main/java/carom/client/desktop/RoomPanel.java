package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RoomEntry;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.TextureRegion;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The server's rooms over the picture, one of which the player can go to. Opened by a key, steered
 * by arrows and Enter. It asks for the list anew while it is open. Render thread only.
 */
final class RoomPanel {
  private static final float LINE = 24;
  private static final float PAD = 16;
  private static final float WIDTH = 640;
  private static final int MAX_LINES = 14;
  private static final float ASK_SECONDS = 2;
  private static final float PICTURE_WIDTH = 288;
  private static final float PICTURE_HEIGHT = 162;

  private final Hud hud;
  private final Fonts fonts;
  private final Runnable ask;
  private final Consumer<String> go;
  private final Function<RoomEntry, TextureRegion> pictures;
  private boolean open;
  private float untilAsking;
  private int selected;
  private List<RoomEntry> rooms = List.of();

  /**
   * Creates a panel that is closed.
   *
   * @param ask asks the server for its rooms
   * @param go asks the server to go to the room of this name
   * @param pictures returns that of a room's level, or null if the level isn't known here
   */
  public RoomPanel(
      Hud hud,
      Fonts fonts,
      Runnable ask,
      Consumer<String> go,
      Function<RoomEntry, TextureRegion> pictures) {
    this.hud = hud;
    this.fonts = fonts;
    this.ask = ask;
    this.go = go;
    this.pictures = pictures;
  }

  /** Opens the panel, or closes it. */
  public void toggle() {
    open = !open;
    untilAsking = 0;
    selected = 0;
  }

  /** Returns whether the panel is open and takes keys. */
  public boolean isOpen() {
    return open;
  }

  /** Handles a key while the panel is open. */
  public void key(int key) {
    int count = Math.max(1, rooms.size());
    switch (key) {
      case Keys.UP, Keys.W -> selected = (selected + count - 1) % count;
      case Keys.DOWN, Keys.S -> selected = (selected + 1) % count;
      case Keys.ENTER, Keys.NUMPAD_ENTER -> {
        if (selected < rooms.size()) {
          go.accept(rooms.get(selected).name());
        }
        open = false;
      }
      case Keys.ESCAPE, Keys.F2 -> open = false;
      default -> {}
    }
  }

  /**
   * Draws the rooms if the panel is open.
   *
   * @param seconds since the last picture
   */
  public void draw(ClientView view, float seconds) {
    if (!open) {
      return;
    }
    untilAsking -= seconds;
    if (untilAsking <= 0) {
      ask.run();
      untilAsking = ASK_SECONDS;
    }
    rooms = view.rooms();
    int first = Math.max(0, Math.min(selected - MAX_LINES / 2, rooms.size() - MAX_LINES));
    int lines = Math.min(MAX_LINES, rooms.size() - first);
    float width = Math.min(WIDTH, hud.windowWidth() - 2 * PAD);
    TextureRegion picture = selected < rooms.size() ? pictures.apply(rooms.get(selected)) : null;
    boolean fits = hud.height() >= (lines + 2) * LINE + 6 * PAD + PICTURE_HEIGHT;
    float shown = picture == null || !fits ? 0 : PICTURE_HEIGHT + PAD;
    float height = (lines + 2) * LINE + 3 * PAD + shown;
    float x = (hud.windowWidth() - width) / 2;
    float top = (hud.height() + height) / 2;
    hud.panel(x, top - height, width, height, UiColours.DIALOG);
    hud.begin();
    hud.left(
        fonts.large(), rooms.isEmpty() ? "Rooms ..." : "Rooms", x + PAD, top - PAD, UiColours.TEXT);
    for (int i = 0; i < lines; i++) {
      RoomEntry room = rooms.get(first + i);
      float y = top - 2 * PAD - (i + 1) * LINE;
      boolean own = room.name().equals(view.room());
      boolean full = room.players() >= room.places();
      Color tint =
          first + i == selected
              ? UiColours.ACCENT
              : full && !own ? UiColours.MUTED : UiColours.TEXT;
      hud.left(fonts.text(), (own ? "> " : "") + room.name(), x + PAD, y, tint);
      hud.left(fonts.text(), room.game() + ", " + room.level(), x + 0.30f * width, y, tint);
      hud.left(fonts.text(), room.phase(), x + 0.68f * width, y, tint);
      hud.left(fonts.text(), room.players() + "/" + room.places(), x + 0.86f * width, y, tint);
    }
    if (shown > 0) {
      float y = top - height + 2 * PAD + 10;
      hud.picture(picture, x + (width - PICTURE_WIDTH) / 2, y, PICTURE_WIDTH, PICTURE_HEIGHT);
    }
    hud.left(
        fonts.small(),
        "up, down: choose     Enter: go     F2: close",
        x + PAD,
        top - height + PAD + 10,
        UiColours.MUTED);
    hud.end();
  }
}
