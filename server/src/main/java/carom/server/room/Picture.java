package carom.server.room;

import carom.server.match.MatchInfo;
import java.util.List;
import java.util.Map;

/**
 * A room at one tick. Nobody changes it, its arrays included.
 *
 * @param match what the room plays; another object once it plays another match
 * @param tick tick of the match
 * @param bodies the bodies, by ascending slot
 * @param poses x (m), y (m) and angle (rad) of each body, {@value #POSE} values each
 * @param awake whether each body is awake
 * @param joints type, both bodies' slots and both anchors (m), {@value #JOINT} values each
 * @param cells edges (m) and depth of the nodes of the broadphase's trees, {@value #CELL} values
 *     each; empty if no viewer asked
 * @param contacts place (m), normal and impulse (N s) of contact points, {@value #CONTACT} values
 *     each; empty if no viewer asked
 * @param priorities by player, the priority that each body's entity has collected since it was sent
 * @param particles the water and sand, a pool each, without empty ones
 * @param playerBodies ids of the players that have a body, and its slot, in pairs
 * @param players the players, or null if no viewer asked
 */
@SuppressWarnings("ArrayRecordComponent") // Never compared; nobody changes them.
public record Picture(
    MatchInfo match,
    int tick,
    List<BodyLook> bodies,
    float[] poses,
    boolean[] awake,
    float[] joints,
    float[] cells,
    float[] contacts,
    Map<Integer, float[]> priorities,
    List<PoolPicture> particles,
    int[] playerBodies,
    List<PlayerPicture> players) {
  /** Values of a pose. */
  public static final int POSE = 3;

  /** Values of a joint. */
  public static final int JOINT = 7;

  /** Values of a node. */
  public static final int CELL = 5;

  /** Values of a contact point. */
  public static final int CONTACT = 5;
}
