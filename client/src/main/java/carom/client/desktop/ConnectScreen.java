package carom.client.desktop;

import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.net.protocol.ServerMessage.RoomEntry;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input;
import com.badlogic.gdx.ScreenAdapter;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.NinePatch;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.InputEvent;
import com.badlogic.gdx.scenes.scene2d.InputListener;
import com.badlogic.gdx.scenes.scene2d.Stage;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import com.badlogic.gdx.scenes.scene2d.utils.ChangeListener;
import com.badlogic.gdx.scenes.scene2d.utils.Drawable;
import com.badlogic.gdx.scenes.scene2d.utils.NinePatchDrawable;
import com.badlogic.gdx.utils.Align;
import com.badlogic.gdx.utils.Array;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.ScreenUtils;
import com.badlogic.gdx.utils.viewport.ScreenViewport;

/**
 * Asks for the server and the player's name, shows the rooms of the server to choose from, and why
 * the last attempt failed. Render thread only.
 */
final class ConnectScreen extends ScreenAdapter {
  /** Receives what the player entered, whose form is checked. */
  interface Target {
    /**
     * Plays on a server.
     *
     * @param room name of the room; empty for any
     */
    void connect(ServerAddress server, String name, String room);

    /** Asks a server for its rooms. */
    RoomBrowser browse(ServerAddress server);
  }

  /** Number of rooms for which there is room. */
  private static final int MAX_ROOMS = 6;

  private static final int MAX_NAME_LENGTH = 16;
  private static final float FIELD_WIDTH = 320;
  private static final float FIELD_HEIGHT = 40;
  private static final float PORT_WIDTH = 112;

  private final Stage stage = new Stage(new ScreenViewport());
  private final Array<Disposable> owned = new Array<>();
  private final Fonts fonts;
  private final Target target;
  private final TextField name;
  private final TextField host;
  private final TextField tcpPort;
  private final TextField udpPort;
  private final Label message;
  private final Table rooms = new Table();
  private TextButton.TextButtonStyle plain;
  private RoomBrowser browser;

  ConnectScreen(Fonts fonts, Target target, String host, int tcpPort, int udpPort, String name) {
    this.fonts = fonts;
    this.target = target;
    this.name = field(name, MAX_NAME_LENGTH);
    this.host = field(host, 255);
    this.tcpPort = field(Integer.toString(tcpPort), 5);
    this.udpPort = field(Integer.toString(udpPort), 5);
    this.message = new Label("", new Label.LabelStyle(fonts.text(), Theme.BAD));
    message.setWrap(true);
    message.setAlignment(Align.center);
    lay();
  }

  /** Shows why the player is here again; an empty text shows nothing. */
  void message(String text) {
    message.setText(text);
  }

  private void lay() {
    Label.LabelStyle muted = new Label.LabelStyle(fonts.text(), Theme.MUTED);
    TextButton.TextButtonStyle style = new TextButton.TextButtonStyle();
    style.font = fonts.large();
    style.fontColor = Theme.BACKDROP;
    style.up = panel(Theme.ACCENT, Theme.ACCENT);
    style.over = panel(Theme.rgb(0xffc56b), Theme.rgb(0xffc56b));
    style.down = panel(Theme.rgb(0xd9942c), Theme.rgb(0xd9942c));
    TextButton join = new TextButton("Join", style);
    join.addListener(
        new ChangeListener() {
          @Override
          public void changed(ChangeEvent event, Actor actor) {
            submit("");
          }
        });
    plain = new TextButton.TextButtonStyle();
    plain.font = fonts.text();
    plain.fontColor = Theme.TEXT;
    plain.up = panel(Theme.rgb(0x1b2534), Theme.PANEL_LINE);
    plain.over = panel(Theme.rgb(0x26354b), Theme.ACCENT);
    TextButton show = new TextButton("Show rooms", plain);
    show.addListener(
        new ChangeListener() {
          @Override
          public void changed(ChangeEvent event, Actor actor) {
            browse();
          }
        });

    Table ports = new Table();
    ports.add(tcpPort).width(PORT_WIDTH).height(FIELD_HEIGHT);
    ports.add(new Label("UDP port", muted)).padLeft(16).padRight(12);
    ports.add(udpPort).width(PORT_WIDTH).height(FIELD_HEIGHT);

    Table form = new Table();
    form.setBackground(panel(Theme.PANEL, Theme.PANEL_LINE));
    form.pad(28).defaults().space(12);
    form.add(new Label("Your name", muted)).left();
    form.add(name).width(FIELD_WIDTH).height(FIELD_HEIGHT).row();
    form.add(new Label("Server", muted)).left();
    form.add(host).width(FIELD_WIDTH).height(FIELD_HEIGHT).row();
    form.add(new Label("TCP port", muted)).left();
    form.add(ports).width(FIELD_WIDTH).row();
    form.add(join).colspan(2).height(52).fillX().padTop(10).row();
    form.add(show).colspan(2).height(FIELD_HEIGHT).fillX().row();
    form.add(rooms).colspan(2).fillX().row();
    form.add(message).colspan(2).width(FIELD_WIDTH + 90).minHeight(44);

    Table root = new Table();
    root.setFillParent(true);
    root.add(new Label("CAROM", new Label.LabelStyle(fonts.title(), Theme.TEXT))).row();
    root.add(new Label("multiplayer physics", muted)).padBottom(26).row();
    root.add(form).row();
    root.add(
            new Label(
                "Enter joins    Tab next field    F2 rooms    Esc quits",
                new Label.LabelStyle(fonts.small(), Theme.MUTED)))
        .padTop(18);
    stage.addActor(root);
    stage.addListener(
        new InputListener() {
          @Override
          public boolean keyDown(InputEvent event, int key) {
            if (key == Input.Keys.ENTER || key == Input.Keys.NUMPAD_ENTER) {
              submit("");
            } else if (key == Input.Keys.F2) {
              browse();
            } else if (key == Input.Keys.ESCAPE) {
              Gdx.app.exit();
            }
            return false;
          }
        });
  }

  /** Joins a room, or any if its name is empty. */
  private void submit(String room) {
    String player = name.getText().strip();
    ServerAddress server = server();
    if (player.isEmpty()) {
      message("Enter a name of 1 to " + MAX_NAME_LENGTH + " letters.");
    } else if (server != null) {
      message("");
      target.connect(server, player, room);
    }
  }

  /** Asks the server for its rooms; they show when they arrive. */
  private void browse() {
    ServerAddress server = server();
    if (server != null && browser == null) {
      message("Asking " + server + " ...");
      browser = target.browse(server);
    }
  }

  private void showRooms() {
    rooms.clearChildren();
    for (RoomEntry room : browser.rooms().subList(0, Math.min(MAX_ROOMS, browser.rooms().size()))) {
      String text =
          "%s     %s, %s     %d/%d     %s"
              .formatted(
                  room.name(),
                  room.game(),
                  room.level(),
                  room.players(),
                  room.places(),
                  room.phase());
      TextButton button = new TextButton(text.stripTrailing(), plain);
      button.addListener(
          new ChangeListener() {
            @Override
            public void changed(ChangeEvent event, Actor actor) {
              submit(room.name());
            }
          });
      rooms.add(button).height(34).growX().padTop(4).row();
    }
    int more = browser.rooms().size() - MAX_ROOMS;
    message(more > 0 ? more + " more; carom-client --list shows all" : browser.problem());
  }

  /** Returns the server that the player entered, or null after saying what is wrong with it. */
  private ServerAddress server() {
    String server = host.getText().strip();
    int tcp = port(tcpPort.getText());
    int udp = port(udpPort.getText());
    if (server.isEmpty()) {
      message("Enter the server's name or address, for instance localhost.");
    } else if (tcp == 0 || udp == 0) {
      message(
          "A port is a number from 1 to 65535. The usual ones are 54555 (TCP) and 54777 (UDP).");
    } else {
      return new ServerAddress(server, tcp, udp);
    }
    return null;
  }

  /** Returns the port that a text names, or 0. */
  private static int port(String text) {
    try {
      int port = Integer.parseInt(text.strip());
      return port >= 1 && port <= 65_535 ? port : 0;
    } catch (NumberFormatException notANumber) {
      return 0;
    }
  }

  private TextField field(String text, int maxLength) {
    TextField.TextFieldStyle style = new TextField.TextFieldStyle();
    style.font = fonts.text();
    style.fontColor = Theme.TEXT;
    style.background = panel(Theme.rgb(0x141b27), Theme.PANEL_LINE);
    style.focusedBackground = panel(Theme.rgb(0x182234), Theme.ACCENT);
    style.cursor = panel(Theme.ACCENT, Theme.ACCENT);
    style.cursor.setMinWidth(2);
    style.selection = panel(Theme.rgb(0x2f4d78), Theme.rgb(0x2f4d78));
    TextField field = new TextField(text, style);
    field.setMaxLength(maxLength);
    return field;
  }

  private Drawable panel(Color fill, Color line) {
    Pixmap pixels = new Pixmap(9, 9, Pixmap.Format.RGBA8888);
    pixels.setBlending(Pixmap.Blending.None);
    pixels.setColor(line);
    pixels.fill();
    pixels.setColor(fill);
    pixels.fillRectangle(1, 1, 7, 7);
    for (int corner = 0; corner < 4; corner++) {
      pixels.drawPixel(corner % 2 * 8, corner / 2 * 8, 0);
    }
    Texture texture = new Texture(pixels);
    pixels.dispose();
    owned.add(texture);
    NinePatchDrawable drawable = new NinePatchDrawable(new NinePatch(texture, 3, 3, 3, 3));
    drawable.setLeftWidth(10);
    drawable.setRightWidth(10);
    return drawable;
  }

  @Override
  public void show() {
    Gdx.input.setInputProcessor(stage);
    stage.setKeyboardFocus(name);
    name.setCursorPosition(name.getText().length());
  }

  @Override
  public void render(float deltaSeconds) {
    ScreenUtils.clear(Theme.BACKDROP);
    if (browser != null) {
      browser.update(System.nanoTime());
      if (browser.isDone()) {
        showRooms();
        browser = null;
      }
    }
    stage.act(deltaSeconds);
    stage.draw();
  }

  @Override
  public void resize(int width, int height) {
    stage.getViewport().update(width, height, true);
  }

  @Override
  public void dispose() {
    if (browser != null) {
      browser.close();
    }
    stage.dispose();
    owned.forEach(Disposable::dispose);
  }
}
