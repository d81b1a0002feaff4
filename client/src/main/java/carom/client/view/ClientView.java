package carom.client.view;

import carom.client.field.FieldView;
import carom.client.field.ShownFields;
import carom.client.interpolation.Pose;
import carom.client.link.ConnectionPhase;
import carom.client.stats.NetStats;
import carom.net.protocol.ServerMessage.BestList;
import carom.net.protocol.ServerMessage.LevelList;
import carom.net.protocol.ServerMessage.PlayPage;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.protocol.ServerMessage.Roster;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.physics.Queries;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.pool.Pools;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A read-only picture of the game for a player, at the moment of the client's last update. One
 * object for the client's life; its content changes only during an update. Read it on the client's
 * thread.
 *
 * <p>Static geometry is not among the entities: draw it from {@link #level}.
 */
public final class ClientView {
  /**
   * A line for the player's screen.
   *
   * @param text the line
   * @param arrivedNs when it arrived, by the clock of the client's updates
   */
  public record Notice(String text, long arrivedNs) {}

  /** One visible entity. The object is reused from frame to frame: don't keep it. */
  public static final class Drawn {
    int id;
    int generation;
    Archetype archetype;
    int ownerId;
    float alpha;
    float predicted;
    final Pose pose = new Pose();

    Drawn() {}

    /** Copies another one. */
    void set(Drawn other) {
      id = other.id;
      generation = other.generation;
      archetype = other.archetype;
      ownerId = other.ownerId;
      alpha = other.alpha;
      predicted = other.predicted;
      pose.set(other.pose);
    }

    /** Returns its slot; of what the own input spawned and the server hasn't told, its origin. */
    public int id() {
      return id;
    }

    /** Returns its generation, which tells it from an earlier entity in the same slot. */
    public int generation() {
      return generation;
    }

    /** Returns its archetype: shapes and appearance. */
    public Archetype archetype() {
      return archetype;
    }

    /** Returns the player id of its owner, or -1. */
    public int ownerId() {
      return ownerId;
    }

    /** Returns x of the body origin as drawn, metres. */
    public float x() {
      return pose.x;
    }

    /** Returns y of the body origin as drawn, metres. */
    public float y() {
      return pose.y;
    }

    /** Returns the angle as drawn, radians counter-clockwise. */
    public float angle() {
      return pose.angle;
    }

    /** Returns x of the velocity, m/s. */
    public float velocityX() {
      return pose.vx;
    }

    /** Returns y of the velocity, m/s. */
    public float velocityY() {
      return pose.vy;
    }

    /** Returns the angular velocity, rad/s. */
    public float angularVelocity() {
      return pose.omega;
    }

    /** Returns the opacity, 0..1: an entity that has just appeared fades in. */
    public float alpha() {
      return alpha;
    }

    /** Returns the weight of the prediction, 0..1: 1 = predicted present, 0 = interpolated past. */
    public float predicted() {
      return predicted;
    }
  }

  private static final int NOTICES = 8;

  private final NetStats stats;
  private final List<Drawn> pool = new ArrayList<>();
  private final List<RosterEntry> players = new ArrayList<>();

  /** Entry of the own player, which is asked for in each frame; null before the roster has it. */
  private RosterEntry self;

  private final List<Notice> notices = new ArrayList<>();
  private Runnable composer = () -> {};
  private boolean stale;
  private int count;

  /** Number of entities whose ids ascend; those that no record tells yet follow. */
  private int ofSlots;

  private final List<JointView> joints = new ArrayList<>();
  private int jointCount;
  private int own = -1;

  String room = "";
  String playHost = "";
  PlayPage playPage;
  int matchNumber;
  List<RoomEntry> rooms = List.of();
  List<BestList> best;
  LevelList levels;
  ConnectionPhase phase = ConnectionPhase.IDLE;
  String message = "";
  double progress;
  String game = "";
  Level level;
  Pools pools;
  Queries<HostEntity> geometry;
  int playerId = -1;
  int tickRate = 60;
  int tick;
  double renderTick;
  int watchedPlayer = -1;
  SimulationHost predictedWorld;
  ShownFields fields;
  final Input input = new Input();

  ClientView(NetStats stats) {
    this.stats = stats;
  }

  // ---- written by a ViewWriter

  /** Sets what fills in the entities when they are read: bots look less often than people. */
  void composer(Runnable newComposer) {
    composer = newComposer;
  }

  /** Marks the entities as out of date. */
  void invalidate() {
    stale = true;
  }

  /** Composes the entities if they are out of date. */
  void compose() {
    if (stale) {
      stale = false;
      composer.run();
    }
  }

  void clear() {
    count = 0;
    jointCount = 0;
    own = -1;
  }

  void clearJoints() {
    jointCount = 0;
  }

  JointView addJoint() {
    if (jointCount == joints.size()) {
      joints.add(new JointView());
    }
    return joints.get(jointCount++);
  }

  Drawn add() {
    if (count == pool.size()) {
      pool.add(new Drawn());
    }
    return pool.get(count++);
  }

  void removeLast() {
    count--;
  }

  /** Notes that the entities added so far are those of slots, in ascending order. */
  void endSlots() {
    ofSlots = count;
  }

  /** Makes the entity that was added last the own one. */
  void markLastAsOwn() {
    own = count - 1;
  }

  /** Returns the number of entities that {@link #endSlots} has noted. */
  int slots() {
    return ofSlots;
  }

  /** Returns the index of the own entity, or -1. */
  int ownIndex() {
    return own;
  }

  /** Sets both for entities that were added as they once were. */
  void slots(int slots, int ownIndex) {
    ofSlots = slots;
    own = ownIndex;
  }

  /** Shows the first joints again that {@link #clear} has hidden. */
  void joints(int shown) {
    jointCount = shown;
  }

  void roster(Roster changes) {
    changes.applyTo(players);
    self = listed(playerId);
  }

  void roster(List<RosterEntry> entries) {
    players.clear();
    players.addAll(entries);
    self = listed(playerId);
  }

  void notice(String text, long nowNs) {
    if (notices.size() == NOTICES) {
      notices.remove(0);
    }
    notices.add(new Notice(text, nowNs));
  }

  // ---- read by users

  /** Returns where the client stands on its way into the game. */
  public ConnectionPhase phase() {
    return phase;
  }

  /**
   * Returns one or two sentences for the player about {@link #phase}: what is being done, what went
   * wrong and what to do about it. Empty while playing.
   */
  public String message() {
    return message;
  }

  /** Returns the share of the level that has arrived, 0..1. */
  public double loadingProgress() {
    return progress;
  }

  /** Returns the name of the game, or an empty string before it is known. */
  public String game() {
    return game;
  }

  /** Returns the level with its statics, bounds and colours, or null before it is loaded. */
  public Level level() {
    return level;
  }

  /** Returns the level's water and sand, for reading only; null before the level is loaded. */
  public Pools pools() {
    return pools;
  }

  /**
   * Returns whether a straight way hits the level's static geometry; false before the level is
   * loaded, and in replays.
   *
   * @param x x of the start, metres
   * @param y y of the start, metres
   * @param wayX x from start to end, metres
   * @param wayY y from start to end, metres
   */
  public boolean isWall(float x, float y, float wayX, float wayY) {
    return geometry != null
        && geometry.rayAny(
            x, y, wayX, wayY, (body, shape) -> body.user().isLevel() && !body.sensor(shape));
  }

  /**
   * Returns what {@link #isWall} does, but for one-way platforms, which hold from above only.
   *
   * @param x x of the start, metres
   * @param y y of the start, metres
   * @param wayX x from start to end, metres
   * @param wayY y from start to end, metres
   */
  public boolean isSolid(float x, float y, float wayX, float wayY) {
    return geometry != null
        && geometry.rayAny(
            x,
            y,
            wayX,
            wayY,
            (body, shape) ->
                body.user().isLevel() && !body.sensor(shape) && !body.user().archetype().oneWay());
  }

  /** Returns the player's own id, or -1 before it is known. */
  public int playerId() {
    return playerId;
  }

  /** Returns the server's ticks per second. */
  public int tickRate() {
    return tickRate;
  }

  /** Returns the tick the client has predicted; it is ahead of the server. */
  public int tick() {
    return tick;
  }

  /** Returns the moment of the server's past that interpolated entities are drawn at, ticks. */
  public double renderTick() {
    return renderTick;
  }

  /** Returns the number of visible entities. */
  public int entityCount() {
    compose();
    return count;
  }

  /** Returns a visible entity by index, 0..{@link #entityCount} - 1, ascending by id. */
  public Drawn entity(int index) {
    compose();
    if (index < 0 || index >= count) {
      throw new IndexOutOfBoundsException("index=" + index + " is outside 0.." + (count - 1));
    }
    return pool.get(index);
  }

  /** Returns the number of joints of which both bodies are visible. */
  public int jointCount() {
    compose();
    return jointCount;
  }

  /** Returns a visible joint by index, 0..{@link #jointCount} - 1, ascending by its own index. */
  public JointView joint(int index) {
    compose();
    if (index < 0 || index >= jointCount) {
      throw new IndexOutOfBoundsException("index=" + index + " is outside 0.." + (jointCount - 1));
    }
    return joints.get(index);
  }

  /**
   * Returns the visible entity that has these fields, such as the one that a field of the game
   * means; null if it isn't visible.
   *
   * @param fields null for none
   */
  public Drawn find(FieldView fields) {
    Drawn found = fields == null ? null : find(fields.id());
    return found != null && found.generation() == fields.generation() ? found : null;
  }

  /** Returns the visible entity with this id, or null. */
  public Drawn find(int id) {
    compose();
    int low = 0;
    int high = ofSlots - 1;
    while (low <= high) {
      int middle = (low + high) >>> 1;
      Drawn drawn = pool.get(middle);
      if (drawn.id == id) {
        return drawn;
      }
      if (drawn.id < id) {
        low = middle + 1;
      } else {
        high = middle - 1;
      }
    }
    for (int i = ofSlots; i < count; i++) {
      if (pool.get(i).id == id) {
        return pool.get(i);
      }
    }
    return null;
  }

  /** Returns the body the player steers, or null while there is none or it is not visible. */
  public Drawn own() {
    compose();
    return own < 0 ? null : pool.get(own);
  }

  /**
   * Returns the body of the {@linkplain #watchedPlayer watched player}, or null if no player is
   * watched or the body isn't visible. Cost: one pass over the visible entities.
   */
  public Drawn watched() {
    compose();
    Drawn found = null;
    for (int i = 0; i < count && watchedPlayer >= 0; i++) {
      Drawn drawn = pool.get(i);
      boolean isPlayer = drawn.ownerId == watchedPlayer && isLookedAt(drawn);
      if (isPlayer || (found == null && drawn.ownerId == watchedPlayer)) {
        found = drawn;
        if (isPlayer) {
          break;
        }
      }
    }
    return found;
  }

  private static boolean isLookedAt(Drawn drawn) {
    return drawn.archetype.appearance().look() == Appearance.Look.PLAYER;
  }

  /**
   * Returns the player that the picture follows because the own player watches or is out, or -1.
   */
  public int watchedPlayer() {
    return watchedPlayer;
  }

  /**
   * Returns players and spectators with their scores and how they stand, ascending by id. Do not
   * change the list.
   */
  public List<RosterEntry> players() {
    return players;
  }

  /**
   * Returns what the roster says of a player or spectator, or null if no participant has this id.
   */
  public RosterEntry participant(int id) {
    return self != null && self.playerId() == id ? self : listed(id);
  }

  private RosterEntry listed(int id) {
    int at = Roster.placeOf(id, players);
    boolean there = at < players.size() && players.get(at).playerId() == id;
    return there ? players.get(at) : null;
  }

  /** Returns a player's name, or an empty string if no player has this id. */
  public String playerName(int playerId) {
    RosterEntry entry = participant(playerId);
    return entry == null ? "" : entry.name();
  }

  /** Returns the name of the room, or an empty string before a game was joined. */
  public String room() {
    return room;
  }

  /**
   * Returns the link by which a browser plays in this room, such as {@code
   * http://play.example.org:8080/play#room=cup}; empty if the server has no page for that.
   */
  public String playLink() {
    if (playPage == null) {
      return "";
    }
    String host = playHost.indexOf(':') < 0 ? playHost : "[" + playHost + "]";
    return String.format(
        Locale.ROOT,
        "%s://%s:%d/play#room=%s",
        playPage.encrypted() ? "https" : "http",
        host,
        playPage.port(),
        URLEncoder.encode(room, StandardCharsets.UTF_8).replace("+", "%20"));
  }

  /** Returns the number of the room's match, from 1 on; 0 before a game was joined. */
  public int matchNumber() {
    return matchNumber;
  }

  /**
   * Returns the server's rooms, as it told when the client last asked ({@code
   * GameClient.listRooms}); empty before. Never modified.
   */
  public List<RoomEntry> rooms() {
    return rooms;
  }

  /**
   * Returns the best of what accounts keep in the room's game, as the server told when the client
   * last asked ({@code GameClient.listBest}); null before. Never modified.
   */
  public List<BestList> best() {
    return best;
  }

  /**
   * Returns the levels of players, as the server told when the client last asked ({@code
   * GameClient.listLevels}); null before.
   */
  public LevelList levels() {
    return levels;
  }

  /** Returns the last few lines from the server, oldest first. Do not change the list. */
  public List<Notice> notices() {
    return notices;
  }

  /**
   * Returns the fields of a player: of the own one as predicted, of others as the server told last.
   * What the own player may not know is as declared. Read values by the typed methods {@code get}.
   *
   * @param id 0..1,023
   * @throws IllegalStateException if there is no game yet
   */
  public FieldView player(int id) {
    return fields().player(id);
  }

  /**
   * Returns the fields of an entity: of the own body as predicted, of others as the server told
   * last, which may be a moment newer than the pose that is drawn.
   *
   * @throws IllegalStateException as for {@link #player}
   */
  public FieldView fields(Drawn entity) {
    return fields().entity(entity.id, entity.generation);
  }

  /**
   * Returns the fields of the match.
   *
   * @throws IllegalStateException as for {@link #player}
   */
  public FieldView match() {
    return fields().match();
  }

  /** Returns whether fields can be asked for: there is a game. */
  public boolean knowsFields() {
    return fields != null;
  }

  private ShownFields fields() {
    if (fields == null) {
      throw new IllegalStateException("there are no fields before a game was joined");
    }
    return fields;
  }

  /** Returns the input that was sampled last. Do not change it. */
  public Input input() {
    return input;
  }

  /** Returns figures about the connection. */
  public NetStats stats() {
    return stats;
  }

  /**
   * Returns the predicted simulation, for debug drawing of contacts, AABBs and tree cells; null if
   * nothing is predicted. Do not change it.
   */
  public SimulationHost predictedWorld() {
    return predictedWorld;
  }
}
