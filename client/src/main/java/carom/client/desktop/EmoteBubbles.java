package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.net.protocol.ProtocolLimits;
import carom.sim.message.Emote;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.Vector3;

/** Words that rise above the bodies of players who show an emote, and fade. Render thread only. */
final class EmoteBubbles {
  private static final long SHOWN_NS = 2_500_000_000L;
  private static final float ABOVE_METRES = 1.9f;
  private static final float RISE_METRES = 0.8f;

  private final Emote[] emotes = new Emote[ProtocolLimits.MAX_PLAYERS];
  private final long[] sinceNs = new long[ProtocolLimits.MAX_PLAYERS];
  private final Color color = new Color();

  /** Shows an emote of a player; its last one goes. */
  void show(int player, Emote emote, long nowNs) {
    if (player >= 0 && player < emotes.length) {
      emotes[player] = emote;
      sinceNs[player] = nowNs;
    }
  }

  /** Draws what is still shown, above the bodies that can be seen. */
  void draw(ClientView view, Hud hud, ViewCamera camera, long nowNs) {
    hud.begin();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      int player = body.ownerId();
      if (player >= 0 && emotes[player] != null) {
        float age = (nowNs - sinceNs[player]) / (float) SHOWN_NS;
        if (age >= 1) {
          emotes[player] = null;
          continue;
        }
        Vector3 at = hud.at(camera, body.x(), body.y() + ABOVE_METRES + RISE_METRES * age);
        color.set(UiColours.ACCENT).a = Math.min(1, 3 * (1 - age));
        hud.floating(emotes[player].text(), at, false, color);
      }
    }
    hud.end();
  }
}
