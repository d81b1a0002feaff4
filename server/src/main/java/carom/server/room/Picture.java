package carom.server.room;

import carom.server.match.MatchInfo;
import carom.server.replication.LinkFigures;
import carom.server.session.PlayerInfo;
import java.util.List;
import java.util.Map;
import java.util.Set;

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
    List<Pool> particles,
    int[] playerBodies,
    List<Player> players) {
  /** Values of a pose. */
  public static final int POSE = 3;

  /** Values of a joint. */
  public static final int JOINT = 7;

  /** Values of a node. */
  public static final int CELL = 5;

  /** Values of a contact point. */
  public static final int CONTACT = 5;

  /**
   * A player as people who watch the room see it. Immutable.
   *
   * @param info name, address, state, score and link
   * @param inputsMissing inputs of the session that had not arrived when their tick ran
   */
  public record Player(PlayerInfo info, long inputsMissing) {
    /** Returns what the line and the client's predictions have done since the link began. */
    public LinkFigures link() {
      return info.link();
    }
  }

  /**
   * The particles of a pool at one tick. Nobody changes it, its array included.
   *
   * @param rgb their colour, 0xRRGGBB
   * @param spacing distance between resting neighbours, m
   * @param xy the centres, m: x0, y0, x1, y1, ...
   */
  @SuppressWarnings("ArrayRecordComponent") // Never compared; nobody changes it.
  public record Pool(int rgb, float spacing, float[] xy) {}

  /**
   * The things that a picture should show beside bodies and joints. Immutable.
   *
   * @param players what is known of each player and its line
   * @param cells the nodes of the broadphase's trees
   * @param contacts the contact points of the last step
   * @param priorityOf ids of players; the priority that each body has collected for them. At most
   *     {@link #MAX_PRIORITIES} are answered
   */
  public record Request(boolean players, boolean cells, boolean contacts, Set<Integer> priorityOf) {
    /** Most players whose priorities are in a picture. */
    public static final int MAX_PRIORITIES = 4;

    /** Copies the set. */
    public Request {
      priorityOf = Set.copyOf(priorityOf);
    }
  }
}
