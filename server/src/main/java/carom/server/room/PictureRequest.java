package carom.server.room;

import java.util.Set;

/**
 * The things that a picture should show beside bodies and joints. Immutable.
 *
 * @param players what is known of each player and its line
 * @param cells the nodes of the broadphase's trees
 * @param contacts the contact points of the last step
 * @param priorityOf ids of players; the priority that each body has collected for them. At most
 *     {@link #MAX_PRIORITIES} are answered
 */
public record PictureRequest(
    boolean players, boolean cells, boolean contacts, Set<Integer> priorityOf) {
  /** Most players whose priorities are in a picture. */
  public static final int MAX_PRIORITIES = 4;

  /** Copies the set. */
  public PictureRequest {
    priorityOf = Set.copyOf(priorityOf);
  }
}
