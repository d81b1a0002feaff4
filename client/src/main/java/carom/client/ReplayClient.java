package carom.client;

import carom.client.events.EventListener;
import carom.client.interpolation.Pose;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.physics.Body;
import carom.replay.Divergence;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.sim.Entity;
import carom.sim.Event;
import carom.sim.Player;
import carom.sim.Simulation;
import carom.sim.scene.SceneGame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * Plays a recording instead of a game: the same {@link ClientView}, filled by a {@link Replay}.
 * Also one that is still being written, whose end it follows. One thread; {@link #update} drives
 * it.
 *
 * <p>Going back restores the nearest tick remembered and computes from there; remembered are at
 * most {@value #MAX_MARKS} of the ticks that were played. Going forward computes what lies between,
 * a little in every update, so that the window stays alive.
 */
public final class ReplayClient implements AutoCloseable {
  /** Ticks remembered at most; beyond, every second one is forgotten. */
  static final int MAX_MARKS = 64;

  /** Smallest and largest exponent of 2 of the speed. */
  private static final int SLOWEST = -4;

  private static final int FASTEST = 4;
  private static final int FIRST_GAP_SECONDS = 5;
  private static final double NS_PER_S = 1e9;

  /** Most time one update spends on computing. */
  private static final long WORK_NS = 12_000_000;

  /** The same while a tick far away is computed, which is worth a choppy picture. */
  private static final long SEEK_NS = 40_000_000;

  /** Farther in a tick than this, metres, a body has jumped and is not drawn in between. */
  private static final float JUMP = 3;

  private final Path file;
  private final ClientView view = new ClientView(new NetStats());
  private final List<Replay.Mark> marks = new ArrayList<>();
  private EventListener listener = EventListener.NONE;
  private final Consumer<Event> hears = this::hear;
  private RecordingReader reader;
  private Replay replay;
  private int markGap;
  private int newestTick;
  private int target = -1;
  private int exponent;
  private boolean paused;
  private boolean ended;
  private boolean waiting;
  private String problem = "";
  private double due; // ticks, with their fraction
  private long lastNs;
  private boolean started;
  private int followed = -1;

  // Poses one tick ago, by entity id.
  private float[] before = {};
  private int[] beforeGeneration = {};

  /**
   * Opens a recording.
   *
   * @throws IOException with a message for the user, when it can't be read or played
   */
  public ReplayClient(Path file) throws IOException {
    this.file = file;
    open();
    view.painter(this::paint);
    view.phase = ConnectionPhase.PLAYING;
  }

  private void open() throws IOException {
    close();
    reader = RecordingReader.open(file);
    try {
      Replay.requirePhysics(reader.header(), Protocol.physicsDigest());
      replay = new Replay(reader);
    } catch (IOException e) {
      reader.close();
      throw e;
    }
    marks.clear();
    Simulation s = replay.simulation();
    markGap = FIRST_GAP_SECONDS * s.tickRate();
    view.level = s.level();
    view.game = s.game().name();
    view.tickRate = s.tickRate();
    view.predictedWorld = s;
    remember();
    show();
  }

  /**
   * Lets time pass.
   *
   * @param nowNs nanoseconds of any clock that never goes back
   */
  public void update(long nowNs) {
    double seconds = started ? Math.max(0, (nowNs - lastNs) / NS_PER_S) : 0;
    started = true;
    lastNs = nowNs;
    if (target >= 0) {
      workTowards(target);
    } else if (!paused) {
      due = Math.min(due + seconds * speed() * view.tickRate, view.tickRate * speed());
      long stopNs = System.nanoTime() + WORK_NS;
      while (due >= 1 && next(true)) {
        due--;
        if (System.nanoTime() > stopNs) {
          due = Math.min(due, 1); // too fast for this machine: it plays as fast as it can
        }
      }
      if (ended || waiting) {
        due = Math.min(due, 1);
      }
    }
    replay.simulation().drainNotices(text -> view.notice(text, nowNs));
    show();
  }

  private void workTowards(int tick) {
    long stopNs = System.nanoTime() + SEEK_NS;
    while (replay.simulation().tick() < tick && next(true)) {
      if (System.nanoTime() > stopNs) {
        return;
      }
    }
    target = -1;
    due = 0;
  }

  /** One more tick; false at the end, for now or for good. */
  private boolean next(boolean keepsPoses) {
    if (!problem.isEmpty()) {
      return false;
    }
    if (keepsPoses) {
      keepPoses();
    }
    try {
      Replay.Progress progress = replay.step();
      ended = progress == Replay.Progress.END;
      waiting = progress == Replay.Progress.WAIT;
    } catch (IOException e) {
      problem = e.getMessage();
      return false;
    }
    replay.simulation().drainEvents(hears);
    newestTick = Math.max(newestTick, replay.simulation().tick());
    remember();
    return !ended && !waiting;
  }

  private void hear(Event event) {
    if (target < 0) {
      listener.happened(event, false);
    }
  }

  private void remember() {
    int tick = replay.simulation().tick();
    int last = marks.isEmpty() ? -markGap : marks.get(marks.size() - 1).tick();
    boolean fits = !view.game.startsWith(SceneGame.PREFIX); // a scene keeps state of its own
    if (fits && tick - last >= markGap && replay.canMark()) {
      marks.add(replay.mark());
      if (marks.size() > MAX_MARKS) {
        for (int i = marks.size() - 1; i > 0; i -= 2) {
          marks.remove(i);
        }
        markGap *= 2;
      }
    }
  }

  private void show() {
    Simulation s = replay.simulation();
    view.tick = s.tick();
    view.renderTick = s.tick();
    if (rosterChanged(s)) {
      List<RosterEntry> entries = new ArrayList<>();
      for (int id = 0; id < s.playerCapacity(); id++) {
        Player p = s.player(id);
        if (p != null) {
          entries.add(new RosterEntry(id, p.name(), p.score()));
        }
      }
      view.roster(entries);
    }
    view.invite();
  }

  private boolean rosterChanged(Simulation s) {
    int at = 0;
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null) {
        if (at == view.players().size()
            || view.players().get(at).playerId() != id
            || view.players().get(at).score() != p.score()
            || !view.players().get(at).name().equals(p.name())) {
          return true;
        }
        at++;
      }
    }
    return at != view.players().size();
  }

  private void keepPoses() {
    Simulation s = replay.simulation();
    int limit = s.entityCapacity();
    if (beforeGeneration.length < limit) {
      before = new float[6 * limit];
      beforeGeneration = new int[2 * limit];
    }
    Arrays.fill(beforeGeneration, -1);
    for (int id = 0; id < limit; id++) {
      Entity e = s.entity(id);
      if (e != null) {
        before[3 * id] = e.body().x();
        before[3 * id + 1] = e.body().y();
        before[3 * id + 2] = e.body().angle();
        beforeGeneration[id] = e.generation();
      }
    }
  }

  private void paint() {
    view.clear();
    Simulation s = replay.simulation();
    float fraction = paused || target >= 0 ? 1 : (float) Math.max(0, Math.min(1, due));
    for (int id = 0; id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e == null) {
        continue;
      }
      ClientView.Drawn drawn = view.add();
      Body<Entity> body = e.body();
      drawn.id = id;
      drawn.generation = e.generation();
      drawn.archetype = e.archetype();
      drawn.ownerId = e.ownerId();
      drawn.alpha = 1;
      drawn.predicted = 1;
      Pose pose = drawn.pose;
      pose.set(
          body.x(),
          body.y(),
          body.angle(),
          body.velocityX(),
          body.velocityY(),
          body.angularVelocity());
      if (id < beforeGeneration.length && beforeGeneration[id] == e.generation()) {
        float dx = body.x() - before[3 * id];
        float dy = body.y() - before[3 * id + 1];
        if (dx * dx + dy * dy < JUMP * JUMP) {
          float turn = Pose.wrap(body.angle() - before[3 * id + 2]);
          pose.x -= (1 - fraction) * dx;
          pose.y -= (1 - fraction) * dy;
          pose.angle -= (1 - fraction) * turn;
        }
      }
      Player p = s.player(followed);
      if (p != null && p.body() == e) {
        view.own(view.lastIndex());
      }
    }
  }

  /** Sets who hears what happens, but while a tick far away is being computed. */
  public void events(EventListener newListener) {
    listener = newListener;
  }

  /** Stops or goes on. */
  public void pause(boolean stopped) {
    paused = stopped;
  }

  /** Whether it stands still. */
  public boolean paused() {
    return paused;
  }

  /** Pauses, and makes one step. */
  public void single() {
    paused = true;
    target = -1;
    next(true);
    show();
  }

  /** Doubles the speed that often, or halves it when negative; between 1/16 and 16. */
  public void speedUp(int steps) {
    exponent = Math.max(SLOWEST, Math.min(FASTEST, exponent + steps));
  }

  /** How many times as fast as it was played. */
  public double speed() {
    return Math.scalb(1.0, exponent);
  }

  /**
   * Goes to a tick: back at once, or in a few updates, forward as fast as it can be computed.
   *
   * @param tick below 0 means 0; beyond the end means the end
   */
  public void seek(int tick) {
    int to = Math.max(0, tick);
    int now = replay.simulation().tick();
    int nearest = Math.max(marked(to), stored(to));
    if (to < now || nearest > now) {
      goBack(to);
    }
    Arrays.fill(beforeGeneration, -1);
    target = to;
    workTowards(to);
    show();
  }

  private int marked(int tick) {
    int found = -1;
    for (Replay.Mark mark : marks) {
      found = mark.tick() <= tick ? mark.tick() : found;
    }
    return found;
  }

  /** The last whole state in the file at or before a tick; -1 when there is none. */
  private int stored(int tick) {
    try {
      return replay.stateBefore(tick);
    } catch (IOException e) {
      return -1; // whoever plays that far is told
    }
  }

  /** Takes the last state remembered, or in the file, at or before a tick. */
  private void goBack(int tick) {
    int from = marked(tick);
    problem = "";
    try {
      if (stored(tick) > from) {
        replay.goToStateBefore(tick);
      } else if (from < 0) {
        open();
        return;
      }
    } catch (IOException e) {
      problem = e.getMessage();
      return;
    }
    for (Replay.Mark mark : marks) {
      if (mark.tick() == from) {
        replay.reset(mark);
      }
    }
    ended = false;
    waiting = false;
  }

  /** Follows the next player who has a body with the camera, or nobody after the last. */
  public void followNext() {
    Simulation s = replay.simulation();
    for (int id = followed + 1; id < s.playerCapacity(); id++) {
      if (s.player(id) != null && s.player(id).body() != null) {
        followed = id;
        return;
      }
    }
    followed = -1;
  }

  /** Name of the player who is followed, or an empty string. */
  public String followed() {
    return view.playerName(followed);
  }

  /** The present tick. */
  public int tick() {
    return replay.simulation().tick();
  }

  /** The newest tick computed so far. */
  public int newestTick() {
    return newestTick;
  }

  /** Whether the recording's end is reached. */
  public boolean ended() {
    return ended;
  }

  /** Whether the file ends here without saying so: it is torn, or still being written. */
  public boolean waiting() {
    return waiting;
  }

  /** Whether a tick far away is being computed. */
  public boolean seeking() {
    return target >= 0;
  }

  /** Why it can't go on, or an empty string. */
  public String problem() {
    return problem;
  }

  /** The first difference from the recording, or null. */
  public Divergence divergence() {
    return replay.divergence();
  }

  /** The computed game, for reading. */
  public Simulation simulation() {
    return replay.simulation();
  }

  /** What there is to see. */
  public ClientView view() {
    return view;
  }

  @Override
  public void close() throws IOException {
    if (reader != null) {
      reader.close();
    }
  }
}
