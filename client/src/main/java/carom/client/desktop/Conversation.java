package carom.client.desktop;

import carom.client.GameClient;
import carom.client.MessageListener;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.settings.KeyAction;
import carom.client.view.ClientView;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Emote;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.graphics.Color;

/**
 * Chat and emotes in the window. A key begins a line to all, another one or Shift and the first one
 * a line to the team; Enter sends it, Escape gives it up. Keys 1 to 8 show emotes. Lines fade after
 * some seconds. Render thread only.
 */
final class Conversation implements MessageListener {
  private static final long SHOWN_NS = 9_000_000_000L;
  private static final long FADES_NS = 1_000_000_000L;
  private static final float PAD = 12;
  private static final float GAP = 5;
  private static final float LINE = 20;
  private static final float FIELD = 30;
  private static final float WIDTH = 460;

  private final GameClient client;
  private final KeyMap keys;
  private final Fonts fonts;
  private final ChatLog log = new ChatLog();
  private final EmoteBubbles bubbles = new EmoteBubbles();
  private final Panel panel = new Panel(Spot.BOTTOM_LEFT, Spot.BOTTOM_RIGHT, Spot.TOP_LEFT);
  private final Color color = new Color();
  private boolean swallowsTyped;

  /** Creates a conversation over a client, whose messages it hears. */
  public Conversation(GameClient client, KeyMap keys, Fonts fonts) {
    this.client = client;
    this.keys = keys;
    this.fonts = fonts;
    client.messages(this);
  }

  @Override
  public void said(int player, boolean team, String text) {
    String who = player == BuiltInKinds.SERVER ? "" : client.view().playerName(player);
    log.add(new ChatLog.Line(who, team, text, System.nanoTime()));
  }

  @Override
  public void emoted(int player, Emote emote) {
    bubbles.show(player, emote, System.nanoTime());
  }

  /** Shows a line of the program itself. */
  public void announce(String text) {
    log.add(new ChatLog.Line("", false, text, System.nanoTime()));
  }

  /** Returns whether a line is being written, so that keys are letters. */
  public boolean isWriting() {
    return log.isOpen();
  }

  /**
   * Handles a key that was pressed.
   *
   * @param shift whether a shift key is held
   * @return false if it means nothing here
   */
  public boolean key(int key, boolean shift) {
    if (log.isOpen()) {
      edit(key);
      return true;
    }
    int emote = key - Keys.NUM_1;
    if (keys.does(key, KeyAction.CHAT)) {
      log.open(shift);
      swallowsTyped = key != Keys.ENTER; // a letter follows
    } else if (keys.does(key, KeyAction.TEAM_CHAT)) {
      log.open(true);
      swallowsTyped = true;
    } else if (emote >= 0 && emote < Emote.values().length) {
      client.emote(Emote.values()[emote]);
    } else {
      return false;
    }
    return true;
  }

  private void edit(int key) {
    swallowsTyped = false;
    switch (key) {
      case Keys.ESCAPE -> log.close();
      case Keys.BACKSPACE -> log.erase();
      case Keys.ENTER, Keys.NUMPAD_ENTER -> {
        send();
        log.close();
      }
      default -> {}
    }
  }

  private void send() {
    String line = log.draft();
    boolean sent = log.isToTeam() ? client.teamChat(line) : client.chat(line);
    if (!sent && !line.isBlank()) {
      log.add(new ChatLog.Line("", false, "Not sent: too fast", System.nanoTime()));
    }
  }

  /** Handles a character that was typed. */
  public void typed(char character) {
    if (swallowsTyped) {
      swallowsTyped = false;
    } else {
      log.type(character);
    }
  }

  /** Draws emotes above bodies. */
  public void drawEmotes(ClientView view, Hud hud, ViewCamera camera, long nowNs) {
    bubbles.draw(view, hud, camera, nowNs);
  }

  /** Draws the lines, the newest below, and under them the one that is written, in a corner. */
  public void draw(Hud hud, long nowNs) {
    float w = Math.min(WIDTH, hud.windowWidth() - 2 * PAD);
    int shown = 0;
    for (int i = log.lines().size() - 1; i >= 0 && alpha(i, nowNs) > 0; i--) {
      shown++;
    }
    float field = log.isOpen() ? FIELD : 0;
    if (shown + field == 0 || !place(hud, w, shown, field)) {
      return;
    }
    if (log.isOpen()) {
      drawDraft(hud, w, nowNs);
    }
    hud.begin();
    float y = panel.y() + field;
    for (int row = 0; row < shown; row++) {
      y += LINE;
      int i = log.lines().size() - 1 - row;
      draw(hud, log.lines().get(i), y - 3, w, alpha(i, nowNs));
    }
    hud.end();
  }

  private boolean place(Hud hud, float w, int lines, float field) {
    float h = lines * LINE + field;
    return log.isOpen() ? hud.layout().placeAnyhow(panel, w, h) : hud.layout().place(panel, w, h);
  }

  private float alpha(int line, long nowNs) {
    float left = (SHOWN_NS - (nowNs - log.lines().get(line).arrivedNs())) / (float) FADES_NS;
    return log.isOpen() ? 1 : Math.min(1, left);
  }

  private void drawDraft(Hud hud, float w, long nowNs) {
    hud.panel(panel.x(), panel.y(), w, FIELD - 4, UiColours.DIALOG);
    hud.begin();
    String to = log.isToTeam() ? "Team:" : "All:";
    float x = panel.x() + PAD;
    float y = panel.y() + FIELD - 11;
    hud.left(fonts.small(), to, x, y, UiColours.MUTED);
    x += hud.width(fonts.small(), to) + GAP;
    float room = panel.x() + w - x - 2 * PAD;
    String cursor = nowNs / 500_000_000L % 2 == 0 ? "|" : "";
    hud.left(
        fonts.small(), hud.endOf(fonts.small(), log.draft(), room) + cursor, x, y, UiColours.TEXT);
    hud.end();
  }

  private void draw(Hud hud, ChatLog.Line line, float y, float w, float alpha) {
    String who = line.who().isEmpty() ? "" : line.who() + (line.team() ? " (team):" : ":");
    Color tint =
        line.who().isEmpty() ? UiColours.ACCENT : line.team() ? UiColours.GOOD : UiColours.INFO;
    color.set(tint).a = alpha;
    float x = panel.x() + PAD;
    hud.shadowed(fonts.small(), who, x, y, color);
    color.set(line.who().isEmpty() ? UiColours.ACCENT : UiColours.TEXT).a = alpha;
    float after = who.isEmpty() ? 0 : hud.width(fonts.small(), who) + GAP;
    String text = hud.cut(fonts.small(), line.text(), w - 2 * PAD - after);
    hud.shadowed(fonts.small(), text, x + after, y, color);
  }
}
