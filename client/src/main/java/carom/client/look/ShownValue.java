package carom.client.look;

import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.physics.math.Limits;
import carom.sim.event.Audience;
import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.FloatField;
import carom.sim.field.IntField;
import carom.sim.field.PlayerRef;
import java.util.Locale;

/**
 * Reads a field of a game as a number, for what a view shows by it: a count or the ticks of a
 * countdown, 0 or 1 of a flag, the number of a choice's constant, 1 while a field means a player or
 * an entity; or as a word, if it is a choice or a player. Immutable.
 */
public final class ShownValue {
  private final Field<?> field;

  private ShownValue(Field<?> field) {
    this.field = field;
  }

  /**
   * Returns what reads a field.
   *
   * @throws IllegalArgumentException for a field that no player is told, or that has several values
   */
  public static ShownValue of(Field<?> field) {
    if (Limits.notNull("field", field).audience() == Audience.NOBODY) {
      throw new IllegalArgumentException(
          "a view can't show " + field.path() + ": no player is told it");
    }
    if (field.times() > 1) {
      throw new IllegalArgumentException(
          "a view can't show "
              + field.path()
              + ", which has "
              + field.times()
              + " values; declare a field for the one to show, or paint it");
    }
    return new ShownValue(field);
  }

  /** Returns the field. */
  public Field<?> field() {
    return field;
  }

  /**
   * Returns the value; that of a player or entity which isn't there is 0.
   *
   * @param player whose value it is, for a field of players; -1 for nobody
   * @param body whose value it is, for a field of entities; null for none
   */
  public float number(ClientView view, int player, Drawn body) {
    FieldView holder = view.knowsFields() ? holder(view, player, body) : null;
    return holder == null ? 0 : number(holder);
  }

  private FieldView holder(ClientView view, int player, Drawn body) {
    return switch (field.scope()) {
      case MATCH -> view.match();
      case PLAYER, ACCOUNT -> player < 0 ? null : view.player(player);
      case ENTITY -> body == null ? null : view.fields(body);
    };
  }

  private float number(FieldView holder) {
    if (field instanceof IntField<?> whole) {
      return holder.get(whole);
    }
    if (field instanceof FloatField<?> real) {
      return holder.get(real);
    }
    if (field instanceof Flag flag) {
      return holder.get(flag) ? 1 : 0;
    }
    if (field instanceof Choice<?> choice) {
      return holder.get(choice).ordinal();
    }
    boolean isSet =
        field instanceof PlayerRef player
            ? holder.get(player) != null
            : holder.get((EntityRef) field) != null;
    return isSet ? 1 : 0;
  }

  /** Returns whether the value is a word: a choice's constant, or a player's name. */
  public boolean isWord() {
    return field instanceof Choice<?> || field instanceof PlayerRef;
  }

  /**
   * Returns a choice's constant in lower case, or the name of the player that a field means; empty
   * for what isn't there.
   */
  public String word(ClientView view, int player, Drawn body) {
    FieldView holder = view.knowsFields() ? holder(view, player, body) : null;
    if (holder == null) {
      return "";
    }
    if (field instanceof Choice<?> choice) {
      return holder.get(choice).name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
    FieldView meant = holder.get((PlayerRef) field);
    return meant == null ? "" : view.playerName(meant.id());
  }

  /**
   * Returns how full a bar of this value is, 0..1; counts go from their least to their greatest.
   */
  public float share(ClientView view, int player, Drawn body) {
    float value = number(view, player, body);
    if (field instanceof Count count) {
      value = (value - count.min()) / ((float) count.max() - count.min());
    }
    return Math.max(0, Math.min(1, value));
  }
}
