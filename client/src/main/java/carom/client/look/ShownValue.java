package carom.client.look;

import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.physics.math.Limits;
import carom.sim.event.Audience;
import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.FloatField;
import carom.sim.field.IntField;

/**
 * Reads a field of a game as a number, for what a view shows by it: a count or the ticks of a
 * countdown, 0 or 1 of a flag, the number of a choice's constant. Immutable.
 */
public final class ShownValue {
  private final Field<?> field;

  private ShownValue(Field<?> field) {
    this.field = field;
  }

  /**
   * Returns what reads a field.
   *
   * @throws IllegalArgumentException for a field that no player is told, or that is no number
   */
  public static ShownValue of(Field<?> field) {
    boolean isNumber =
        Limits.notNull("field", field) instanceof IntField<?>
            || field instanceof FloatField<?>
            || field instanceof Flag
            || field instanceof Choice<?>;
    if (!isNumber || field.audience() == Audience.NOBODY) {
      throw new IllegalArgumentException(
          "a view can't show " + field.path() + (isNumber ? ": no player is told it" : ""));
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
    if (!view.knowsFields()) {
      return 0;
    }
    return switch (field.scope()) {
      case MATCH -> number(view.match());
      case PLAYER, ACCOUNT -> player < 0 ? 0 : number(view.player(player));
      case ENTITY -> body == null ? 0 : number(view.fields(body));
    };
  }

  private float number(FieldView holder) {
    if (field instanceof IntField<?> whole) {
      return holder.get(whole);
    }
    if (field instanceof FloatField<?> real) {
      return holder.get(real);
    }
    return field instanceof Flag flag ? (holder.get(flag) ? 1 : 0) : ordinal(holder, field);
  }

  private static <E extends Enum<E>> int ordinal(FieldView holder, Field<?> field) {
    @SuppressWarnings("unchecked") // of() lets no other kind through
    Choice<E> choice = (Choice<E>) field;
    return holder.get(choice).ordinal();
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
