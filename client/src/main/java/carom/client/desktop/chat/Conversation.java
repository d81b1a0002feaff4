package carom.client.desktop.chat;

import carom.client.GameClient;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.input.KeyMap;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.desktop.paint.ViewCamera;
import carom.client.message.MessageListener;
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
public final class Conversation implements MessageListener {
  private static final long SHOWN_NS = 9_000_000_000L;
  private static final long FADES_NS = 1_000_000_000L;
  private static final float PAD = 12;
  private static final float GAP = 5;
  private static final float LINE = 20;
  private static final float BOTTOM = 64;
  private static final float WIDTH = 460;

  private final GameClient client;
  private final KeyMap keys;
  private final Fonts fonts;
  private final ChatLog log = new ChatLog();
  private final EmoteBubbles bubbles = new EmoteBubbles();
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

  /** Draws emotes above bodies, and the lines at the left edge. */
  public void draw(ClientView view, Hud hud, ViewCamera camera, long nowNs) {
    bubbles.draw(view, hud, camera, nowNs);
    float y = BOTTOM;
    if (log.isOpen()) {
      hud.panel(PAD, y - LINE + 2, WIDTH, LINE + 6);
      hud.begin();
      String to = log.isToTeam() ? "Team:" : "All:";
      float x = 2 * PAD;
      hud.left(fonts.small(), to, x, y, Theme.MUTED);
      x += hud.width(fonts.small(), to) + GAP;
      float room = WIDTH + PAD - x - PAD;
      String cursor = nowNs / 500_000_000L % 2 == 0 ? "|" : "";
      hud.left(
          fonts.small(), hud.endOf(fonts.small(), log.draft(), room) + cursor, x, y, Theme.TEXT);
      hud.end();
    }
    hud.begin();
    for (int i = log.lines().size() - 1; i >= 0; i--) {
      y += LINE;
      ChatLog.Line line = log.lines().get(i);
      float left = (SHOWN_NS - (nowNs - line.arrivedNs())) / (float) FADES_NS;
      float alpha = log.isOpen() ? 1 : Math.min(1, left);
      if (alpha > 0) {
        draw(hud, line, y, alpha);
      }
    }
    hud.end();
  }

  private void draw(Hud hud, ChatLog.Line line, float y, float alpha) {
    String who = line.who().isEmpty() ? "" : line.who() + (line.team() ? " (team):" : ":");
    Color tint = line.who().isEmpty() ? Theme.ACCENT : line.team() ? Theme.GOOD : Theme.INFO;
    color.set(tint).a = alpha;
    hud.shadowed(fonts.small(), who, 2 * PAD, y, color);
    color.set(line.who().isEmpty() ? Theme.ACCENT : Theme.TEXT).a = alpha;
    float after = who.isEmpty() ? 0 : hud.width(fonts.small(), who) + GAP;
    hud.shadowed(fonts.small(), line.text(), 2 * PAD + after, y, color);
  }
}
