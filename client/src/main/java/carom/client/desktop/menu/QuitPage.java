package carom.client.desktop.menu;

import com.badlogic.gdx.scenes.scene2d.ui.Table;

/** Asks whether to quit, as Esc is pressed by mistake, too. Render thread only. */
final class QuitPage implements Page {
  private final Widgets widgets;
  private final Runnable stay;
  private final Runnable quit;

  QuitPage(Widgets widgets, Runnable stay, Runnable quit) {
    this.widgets = widgets;
    this.stay = stay;
    this.quit = quit;
  }

  @Override
  public void build(Table into) {
    into.defaults().space(8).left().growX();
    into.add(widgets.heading("Quit Carom?")).row();
    into.add(widgets.primary("Stay", stay)).height(Widgets.HEIGHT + 8).row();
    into.add(widgets.button("Quit Carom", quit)).height(Widgets.HEIGHT + 4).row();
  }
}
