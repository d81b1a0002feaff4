package carom.client.look;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Receives what a {@link GameView} declares, and hands it to what draws. Methods that declare throw
 * {@link IllegalArgumentException} for what can't be meant.
 */
public final class ViewSetup {
  private final List<Action> actions = new ArrayList<>();

  /** Creates the set-up of a view that declares nothing, which is the usual look. */
  public ViewSetup() {}

  /**
   * Adds actions. The buttons of a view take the place of all usual buttons, its movements and its
   * aim that of the usual ones. The player can change the keys, and sees them beside the body in
   * the first minute.
   */
  public void actions(Action... added) {
    actions.addAll(List.of(added));
    Set<String> names = new HashSet<>();
    for (Action action : actions) {
      for (Action.Binding binding : action.bindings()) {
        if (!names.add(binding.name())) {
          throw new IllegalArgumentException(
              "action=\"" + binding.name() + "\" is there already; give each a name of its own");
        }
      }
    }
  }

  /** Returns the actions in the order in which they were declared. Do not change the list. */
  public List<Action> actions() {
    return actions;
  }
}
