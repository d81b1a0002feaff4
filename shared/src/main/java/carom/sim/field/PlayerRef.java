package carom.sim.field;

/**
 * A field for a player, see {@link Field#player}. When a player leaves, all fields that mean the
 * player are set to null, so none ever means the next player with that id.
 */
public final class PlayerRef extends Field<PlayerRef> {
  /** Largest word: 1 above the largest id. */
  static final int MOST = 1_024;

  PlayerRef(Spec spec) {
    super(spec);
  }

  @Override
  boolean lasts() {
    return false;
  }

  @Override
  PlayerRef with(Spec changed) {
    return new PlayerRef(changed);
  }

  /** Returns the word of a player. */
  public static int word(int id) {
    return id + 1;
  }

  @Override
  public Object value(int word) {
    return word - 1;
  }

  @Override
  public String show(int word) {
    return word == 0 ? "nobody" : "player " + (word - 1);
  }
}
