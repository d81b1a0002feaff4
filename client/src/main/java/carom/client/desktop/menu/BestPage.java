package carom.client.desktop.menu;

import carom.net.protocol.ServerMessage.BestEntry;
import carom.net.protocol.ServerMessage.BestList;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/** The best of what accounts keep in the game, with the player's own place. Render thread only. */
final class BestPage implements Page {
  private static final long ASK_NS = TimeUnit.SECONDS.toNanos(1);
  private static final float PLACE_WIDTH = 32;

  /** Answers before an empty one counts: the server asks its store when the first one asks. */
  private static final int TRUSTED = 2;

  private final Widgets widgets;
  private final Runnable ask;
  private final Supplier<List<BestList>> known;
  private List<BestList> shown;
  private long askedNs;
  private int asked;

  /**
   * Creates a page.
   *
   * @param ask asks the server for the lists
   * @param known returns them as they were told last; null before
   */
  BestPage(Widgets widgets, Runnable ask, Supplier<List<BestList>> known) {
    this.widgets = widgets;
    this.ask = ask;
    this.known = known;
  }

  @Override
  public void build(Table into) {
    shown = known.get();
    into.defaults().space(4).left();
    into.add(widgets.heading("The best")).colspan(3).padBottom(8).row();
    if (shown == null || shown.isEmpty()) {
      String why =
          asked <= TRUSTED
              ? "Asking the server ..."
              : "Nobody is listed: this game keeps nothing that lasts, or nobody has gained it"
                  + " yet.";
      into.add(widgets.note(why)).colspan(3).growX().row();
      return;
    }
    for (BestList list : shown) {
      into.add(widgets.muted(list.field())).colspan(3).padTop(10).row();
      for (int i = 0; i < list.entries().size(); i++) {
        BestEntry entry = list.entries().get(i);
        boolean own = i == list.own();
        into.add(widgets.mark(i + 1 + ".", own)).width(PLACE_WIDTH);
        into.add(widgets.mark(own ? entry.name() + "  (you)" : entry.name(), own)).growX();
        into.add(widgets.mark(entry.value(), own)).right().row();
      }
    }
  }

  @Override
  public boolean update(long nowNs) {
    boolean due = asked == 0 || nowNs - askedNs > ASK_NS;
    if (due) {
      asked++;
      askedNs = nowNs;
      ask.run();
    }
    return due && asked == TRUSTED + 1 || !Objects.equals(known.get(), shown);
  }

  @Override
  public void close() {
    asked = 0;
  }
}
