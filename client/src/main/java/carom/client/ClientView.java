package carom.client;

import carom.client.interpolation.Pose;
import carom.net.protocol.ServerMessage.Roster;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.Input;
import carom.sim.Simulation;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;

/**
 * What a player sees: a read-only picture of the game at the moment of the last {@link
 * GameClient#update}. One object for the client's life; its content changes only in {@code update}.
 * Read it on the client's thread.
 *
 * <p>Static geometry is not among the entities: draw it from {@link #level}.
 */
public final class ClientView {
  /** A line for the player's screen. */
  public record Notice(String text, long arrivedNs) {}

  /** One visible entity. Reused from frame to frame: read it, don't keep it. */
  public static final class Drawn {
    int id;
    int generation;
    Archetype archetype;
    int ownerId;
    float alpha;
    float predicted;
    final Pose pose = new Pose();

    Drawn() {}

    /** Its slot. */
    public int id() {
      return id;
    }

    /** Tells it from an earlier entity in the same slot. */
    public int generation() {
      return generation;
    }

    /** Shapes and appearance. */
    public Archetype archetype() {
      return archetype;
    }

    /** Player id of its owner, or -1. */
    public int ownerId() {
      return ownerId;
    }

    /** Body origin as drawn, metres. */
    public float x() {
      return pose.x;
    }

    /** Body origin as drawn, metres. */
    public float y() {
      return pose.y;
    }

    /** Angle as drawn, radians counter-clockwise. */
    public float angle() {
      return pose.angle;
    }

    /** Velocity, metres per second. */
    public float velocityX() {
      return pose.vx;
    }

    /** Velocity, metres per second. */
    public float velocityY() {
      return pose.vy;
    }

    /** Angular velocity, radians per second. */
    public float angularVelocity() {
      return pose.omega;
    }

    /** Opacity 0..1: what has just appeared fades in. */
    public float alpha() {
      return alpha;
    }

    /**
     * 1 = drawn as predicted for the present, 0 = as interpolated in the past, between: a blend.
     */
    public float predicted() {
      return predicted;
    }
  }

  private static final int NOTICES = 8;

  private final NetStats stats;
  private final List<Drawn> pool = new ArrayList<>();
  private final List<RosterEntry> players = new ArrayList<>();
  private final List<Notice> notices = new ArrayList<>();
  private Runnable painter = () -> {};
  private boolean stale;
  private int count;
  private int own = -1;

  ConnectionPhase phase = ConnectionPhase.IDLE;
  String message = "";
  double progress;
  String game = "";
  Level level;
  int playerId = -1;
  int tickRate = 60;
  int tick;
  double renderTick;
  Simulation predictedWorld;
  final int[] memory = new int[4];
  final Input input = new Input();

  ClientView(NetStats stats) {
    this.stats = stats;
  }

  // ---- written by the client

  /** Who fills in the entities when somebody looks at them: bots look less often than people. */
  void painter(Runnable painter) {
    this.painter = painter;
  }

  /** There is a new moment to show. */
  void invite() {
    stale = true;
  }

  /** Keeps what is shown: playing has stopped. */
  void freeze() {
    look();
  }

  private void look() {
    if (stale) {
      stale = false;
      painter.run();
    }
  }

  void clear() {
    count = 0;
    own = -1;
  }

  Drawn add() {
    if (count == pool.size()) {
      pool.add(new Drawn());
    }
    return pool.get(count++);
  }

  void dropLast() {
    count--;
  }

  int lastIndex() {
    return count - 1;
  }

  void own(int index) {
    own = index;
  }

  void roster(Roster changes) {
    changes.applyTo(players);
  }

  void roster(List<RosterEntry> entries) {
    players.clear();
    players.addAll(entries);
  }

  void notice(String text, long nowNs) {
    if (notices.size() == NOTICES) {
      notices.remove(0);
    }
    notices.add(new Notice(text, nowNs));
  }

  // ---- read by everybody

  /** Where the client stands on its way into the game. */
  public ConnectionPhase phase() {
    return phase;
  }

  /**
   * One or two sentences for the player about {@link #phase}: what is being done, what went wrong
   * and what to do about it. Empty while playing.
   */
  public String message() {
    return message;
  }

  /** Share of the level that has arrived, 0..1. */
  public double loadingProgress() {
    return progress;
  }

  /** Name of the game that is played, or an empty string before it is known. */
  public String game() {
    return game;
  }

  /** The level with its statics, bounds and colours, or null before it is loaded. */
  public Level level() {
    return level;
  }

  /** The player's own id, or -1 before it is known. */
  public int playerId() {
    return playerId;
  }

  /** The server's ticks per second. */
  public int tickRate() {
    return tickRate;
  }

  /** The tick the client has predicted; ahead of the server. */
  public int tick() {
    return tick;
  }

  /** The moment of the server's past that interpolated entities are drawn at, in ticks. */
  public double renderTick() {
    return renderTick;
  }

  /** Visible entities. */
  public int entityCount() {
    look();
    return count;
  }

  /** A visible entity, index 0..{@link #entityCount} - 1, ascending by id. */
  public Drawn entity(int index) {
    look();
    if (index < 0 || index >= count) {
      throw new IndexOutOfBoundsException("index=" + index + " is outside 0.." + (count - 1));
    }
    return pool.get(index);
  }

  /** The visible entity with this id, or null. */
  public Drawn find(int id) {
    look();
    int low = 0;
    int high = count - 1;
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
    return null;
  }

  /** The body the player steers, or null while there is none or it is not visible. */
  public Drawn own() {
    look();
    return own < 0 ? null : pool.get(own);
  }

  /** Who plays, ascending by id, with scores; unmodifiable by the reader. */
  public List<RosterEntry> players() {
    return players;
  }

  /** A player's name, or an empty string when nobody has this id. */
  public String playerName(int playerId) {
    for (int i = 0; i < players.size(); i++) {
      if (players.get(i).playerId() == playerId) {
        return players.get(i).name();
      }
    }
    return "";
  }

  /** The last few lines from the server, oldest first; unmodifiable by the reader. */
  public List<Notice> notices() {
    return notices;
  }

  /** The game's four ints of the own player, as predicted: cooldowns and the like. */
  public int memory(int index) {
    return memory[index];
  }

  /** The input that was sampled last; do not change it. */
  public Input input() {
    return input;
  }

  /** Numbers about the connection. */
  public NetStats stats() {
    return stats;
  }

  /**
   * The predicted simulation, for debug drawing of contacts, AABBs and tree cells; null when
   * nothing is predicted. Look, don't touch.
   */
  public Simulation predictedWorld() {
    return predictedWorld;
  }
}
