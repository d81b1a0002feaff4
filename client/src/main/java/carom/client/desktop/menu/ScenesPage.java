package carom.client.desktop.menu;

import carom.sim.scene.Scene;
import carom.sim.scene.Scenes;
import com.badlogic.gdx.scenes.scene2d.ui.Table;

/** Chooses a scene of the library, which needs no server. Render thread only. */
final class ScenesPage implements Page {
  private final Widgets widgets;
  private final StartTarget target;

  ScenesPage(Widgets widgets, StartTarget target) {
    this.widgets = widgets;
    this.target = target;
  }

  @Override
  public void build(Table into) {
    into.defaults().space(6).left().growX();
    into.add(widgets.heading("Scenes")).row();
    for (Scene scene : Scenes.all()) {
      String text = scene.name().replace('_', ' ') + "     " + scene.description();
      into.add(widgets.row(text, () -> target.scene(scene)))
          .height(Widgets.HEIGHT)
          .minWidth(0)
          .row();
    }
  }
}
