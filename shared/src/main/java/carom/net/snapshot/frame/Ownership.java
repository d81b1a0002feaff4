package carom.net.snapshot.frame;

import carom.net.codec.BitCoder;
import carom.net.protocol.PlayerId;

/**
 * The owner of an entity as an int: -1 for nobody, else a player's id, with {@link #NOT_BODY} if
 * the entity belongs to that player without being the player's body.
 */
public final class Ownership {
  /** Added to the id of a player whose body the entity isn't. */
  public static final int NOT_BODY = 1 << 10;

  /** Largest value. */
  public static final int MAX = NOT_BODY | PlayerId.MAX;

  /** Largest id in the short form. */
  private static final int SHORT = 127;

  private Ownership() {}

  /** Returns the player's id, or -1. */
  public static int player(int ownership) {
    return ownership < 0 ? -1 : ownership & PlayerId.MAX;
  }

  /** Returns whether the entity is a player's body. */
  public static boolean isBody(int ownership) {
    return ownership >= 0 && (ownership & NOT_BODY) == 0;
  }

  /**
   * Codes an ownership: 1 bit "somebody's", then a {@link PlayerId}. Ids up to 127 in the long
   * form, which is otherwise for larger ones only, mean that it isn't the body; after larger ones,
   * 1 bit says so.
   */
  public static int code(BitCoder c, int value) {
    if (!c.flag(value >= 0)) {
      return -1;
    }
    int player = player(value);
    boolean isBody = isBody(value);
    if (!c.flag(player > SHORT || !isBody)) {
      return c.plain(player, 7);
    }
    player = c.plain(player, 10);
    boolean other = player <= SHORT || c.flag(!isBody);
    return other ? player | NOT_BODY : player;
  }
}
