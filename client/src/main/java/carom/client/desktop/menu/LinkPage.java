package carom.client.desktop.menu;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.scenes.scene2d.ui.Image;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.utils.Align;
import io.nayuki.qrcodegen.QrCode;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.Collections;
import java.util.List;

/**
 * Shows the link by which a friend plays in a browser: as a code for a phone's camera, and to copy.
 * Render thread only.
 */
final class LinkPage implements Page {
  private static final int QUIET = 4; // modules of white around the code, by the standard
  private static final float SIDE = 232;
  private static final String LOOPBACK = "//(localhost|127\\.[0-9.]+|\\[::1]):";

  private final Widgets widgets;
  private final String link;
  private final Runnable changed;
  private Texture code;
  private boolean copied;

  /**
   * Creates the page.
   *
   * @param link as {@code ClientView.playLink} has it
   * @param changed is run when the page must be built anew
   */
  LinkPage(Widgets widgets, String link, Runnable changed) {
    this.widgets = widgets;
    this.changed = changed;
    this.link = fromOutside(link);
  }

  @Override
  public void build(Table into) {
    close();
    code = draw(QrCode.encodeText(link, QrCode.Ecc.LOW));
    into.defaults().space(10).center();
    into.add(widgets.heading("Play in a browser")).row();
    into.add(new Image(code)).size(SIDE).row();
    Label text = widgets.muted(link);
    text.setWrap(true);
    text.setAlignment(Align.center);
    into.add(text).growX().row();
    into.add(widgets.button(copied ? "Copied" : "Copy the link", this::copy))
        .height(Widgets.HEIGHT)
        .growX();
  }

  private void copy() {
    Gdx.app.getClipboard().setContents(link);
    copied = true;
    changed.run();
  }

  private static Texture draw(QrCode code) {
    int side = code.size + 2 * QUIET;
    Pixmap pixels = new Pixmap(side, side, Pixmap.Format.RGB888);
    pixels.setColor(Color.WHITE);
    pixels.fill();
    pixels.setColor(Color.BLACK);
    for (int y = 0; y < code.size; y++) {
      for (int x = 0; x < code.size; x++) {
        if (code.getModule(x, y)) {
          pixels.drawPixel(x + QUIET, y + QUIET);
        }
      }
    }
    Texture texture = new Texture(pixels);
    texture.setFilter(Texture.TextureFilter.Nearest, Texture.TextureFilter.Nearest);
    pixels.dispose();
    return texture;
  }

  /** Returns a link to this machine with an address that others in its network reach. */
  private static String fromOutside(String link) {
    try {
      List<NetworkInterface> networks = Collections.list(NetworkInterface.getNetworkInterfaces());
      for (NetworkInterface network : networks) {
        for (InetAddress address : Collections.list(network.getInetAddresses())) {
          if (address.isSiteLocalAddress() && network.isUp()) {
            return link.replaceFirst(LOOPBACK, "//" + address.getHostAddress() + ":");
          }
        }
      }
    } catch (SocketException e) {
      return link; // it still works on this machine
    }
    return link;
  }

  @Override
  public void close() {
    if (code != null) {
      code.dispose();
      code = null;
    }
  }
}
