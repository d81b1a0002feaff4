package carom.client.replay;

import carom.client.EventListener;
import carom.client.field.RecordedFields;
import carom.client.interpolation.Pose;
import carom.client.link.ConnectionPhase;
import carom.client.stats.NetStatsRecorder;
import carom.client.view.ClientView;
import carom.client.view.ViewWriter;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.physics.Body;
import carom.replay.Divergence;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.outbox.Event;
import carom.sim.scene.SceneGame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Plays a recording: fills a {@link ClientView} from a {@link Replay} instead of a server. A
 * recording that is still being written works, too; the client follows its end. One thread; {@link
 * #update} drives it.
 *
 * <p>Going back restores the nearest saved tick and computes from there. Going forward computes the
 * ticks in between, a few per update, so that the window stays alive.
 */
public final class ReplayClient implements AutoCloseable {
  /** Smallest exponent of 2 of the speed. */
  private static final int SLOWEST = -4;

  /** Largest exponent of 2 of the speed. */
  private static final int FASTEST = 4;

  private static final int FIRST_GAP_SECONDS = 5;
  private static final double NS_PER_S = 1e9;

  /** Most time that one update computes, while playing. */
  private static final long WORK_NS = 12_000_000;

  /** Most time that one update computes while seeking, which is worth a choppy picture. */
  private static final long SEEK_NS = 40_000_000;

  private final Path file;
  private final ViewWriter view = new ViewWriter(new NetStatsRecorder().stats());
  private final ReplayMarks marks = new ReplayMarks();
  private final PreviousPoses previous = new PreviousPoses();
  private EventListener listener = EventListener.NONE;
  private final Consumer<Event> fireEvent = this::fire;
  private RecordingReader reader;
  private Replay replay;
  private int newestTick;
  private int target = -1;
  private int exponent;
  private boolean paused;
  private boolean ended;
  private boolean waiting;
  private boolean patient;
  private int lastTick;
  private String problem = "";

  /** Ticks that are due, with their fraction. */
  private double due;

  private long lastNs;
  private boolean started;
  private int followed = -1;

  /**
   * Opens a recording.
   *
   * @throws IOException with a message for the user, when it can't be read or played
   */
  public ReplayClient(Path file) throws IOException {
    this.file = file;
    open();
    view.composer(this::compose);
    view.connection(ConnectionPhase.PLAYING, "", 0);
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
    SimulationHost s = replay.simulation();
    marks.reset(FIRST_GAP_SECONDS * s.tickRate());
    view.game(s.game().name(), s.level(), -1, s.tickRate(), s);
    view.fields(new RecordedFields(s));
    view.pools(s.pools());
    mark();
    show();
    lastTick = RecordingLength.lastTick(file, s.tick());
  }

  /** Computes all that is due in each update, however long it takes: for films, not for windows. */
  public void patient(boolean always) {
    patient = always;
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
      due = Math.min(due + seconds * speed() * view().tickRate(), view().tickRate() * speed());
      long stopNs = System.nanoTime() + WORK_NS;
      while (due >= 1 && next()) {
        due--;
        if (!patient && System.nanoTime() > stopNs) {
          due = Math.min(due, 1); // this machine is too slow: it plays as fast as it can
        }
      }
      if (ended || waiting) {
        due = Math.min(due, 1);
      }
    }
    replay.simulation().outbox().drainNotices(text -> view.notice(text, nowNs));
    show();
  }

  private void workTowards(int tick) {
    long stopNs = System.nanoTime() + SEEK_NS;
    boolean inTime = true;
    while (inTime && replay.simulation().tick() < tick && next()) {
      inTime = System.nanoTime() <= stopNs;
    }
    replay.simulation().outbox().drainNotices(skipped -> {}); // they are of another time
    if (inTime) {
      target = -1;
      due = 0;
    }
  }

  /** Computes one tick; returns false at the end, for now or for good. */
  private boolean next() {
    if (!problem.isEmpty()) {
      return false;
    }
    previous.read(replay.simulation());
    try {
      Replay.Progress progress = replay.step();
      ended = progress == Replay.Progress.END;
      waiting = progress == Replay.Progress.WAIT;
    } catch (IOException e) {
      problem = e.getMessage();
      return false;
    }
    replay.simulation().outbox().drainEvents(fireEvent);
    newestTick = Math.max(newestTick, replay.simulation().tick());
    mark();
    return !ended && !waiting;
  }

  private void fire(Event event) {
    if (target < 0) {
      listener.happened(event, false);
    }
  }

  private void mark() {
    // A scene keeps state of its own, which a mark doesn't hold.
    if (!view().game().startsWith(SceneGame.PREFIX)) {
      marks.add(replay);
    }
  }

  private void show() {
    SimulationHost s = replay.simulation();
    view.tick(s.tick());
    view.renderTick(s.tick());
    if (hasNewRoster(s)) {
      List<RosterEntry> entries = new ArrayList<>();
      for (int id = 0; id < s.playerCapacity(); id++) {
        HostPlayer p = s.participant(id);
        if (p != null) {
          entries.add(entry(p));
        }
      }
      view.roster(entries);
    }
    view.invalidate();
  }

  private static RosterEntry entry(HostPlayer p) {
    return new RosterEntry(
        p.id(),
        p.name(),
        p.team(),
        p.score(),
        p.isSpectator(),
        p.isReady(),
        p.isAlive(),
        0,
        p.colour().number());
  }

  private boolean hasNewRoster(SimulationHost s) {
    int at = 0;
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.participant(id);
      if (p != null) {
        if (at == view().players().size() || !isShown(view().players().get(at), p)) {
          return true;
        }
        at++;
      }
    }
    return at != view().players().size();
  }

  private static boolean isShown(RosterEntry entry, HostPlayer p) {
    return entry.playerId() == p.id()
        && entry.score() == p.score()
        && entry.team() == p.team()
        && entry.spectator() == p.isSpectator()
        && entry.ready() == p.isReady()
        && entry.alive() == p.isAlive()
        && entry.colour() == p.colour().number()
        && entry.name().equals(p.name());
  }

  private void compose() {
    view.clear();
    SimulationHost s = replay.simulation();
    HostPlayer p = s.player(followed);
    float fraction = paused || target >= 0 ? 1 : (float) Math.max(0, Math.min(1, due));
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e == null) {
        continue;
      }
      Pose pose = view.add(id, e.generation(), e.archetype(), e.ownerId(), 1, 1);
      Body<HostEntity> body = e.body();
      pose.set(
          body.x(),
          body.y(),
          body.angle(),
          body.velocityX(),
          body.velocityY(),
          body.angularVelocity());
      previous.interpolate(e, fraction, pose);
      if (p != null && p.entity() == e) {
        view.markLastAsOwn();
      }
    }
  }

  /** Sets who receives the events, except those of ticks that a seek computes. */
  public void events(EventListener newListener) {
    listener = newListener;
  }

  /** Pauses or goes on. */
  public void pause(boolean stopped) {
    paused = stopped;
  }

  /** Returns whether the replay is paused. */
  public boolean paused() {
    return paused;
  }

  /** Pauses and computes one tick. */
  public void single() {
    paused = true;
    target = -1;
    next();
    show();
  }

  /** Doubles the speed so many times, or halves it if negative; it stays within 1/16..16. */
  public void speedUp(int steps) {
    exponent = Math.max(SLOWEST, Math.min(FASTEST, exponent + steps));
  }

  /** Returns the speed; 1 = as it was played. */
  public double speed() {
    return Math.scalb(1.0, exponent);
  }

  /**
   * Goes to a tick: back from the nearest saved tick, forward as fast as ticks can be computed.
   *
   * @param tick below 0 means 0; beyond the end means the end
   */
  public void seek(int tick) {
    int to = Math.max(0, tick);
    int now = replay.simulation().tick();
    int nearest = Math.max(marks.before(to), stored(to));
    if (to < now || nearest > now) {
      goBack(to);
    }
    previous.clear();
    target = to;
    workTowards(to);
    show();
  }

  /** Returns the tick of the last whole state in the file at or before a tick, or -1. */
  private int stored(int tick) {
    try {
      return replay.stateBefore(tick);
    } catch (IOException e) {
      return -1; // playing that far reports it
    }
  }

  /** Restores the newest state at or before a tick, from a mark or from the file. */
  private void goBack(int tick) {
    int from = marks.before(tick);
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
    marks.restore(replay, from);
    ended = false;
    waiting = false;
  }

  /** Makes the camera follow the next player with a body, or none after the last one. */
  public void followNext() {
    SimulationHost s = replay.simulation();
    for (int id = followed + 1; id < s.playerCapacity(); id++) {
      if (s.player(id) != null && s.player(id).entity() != null) {
        followed = id;
        return;
      }
    }
    followed = -1;
  }

  /** Makes the camera follow a player by id, while that player has a body; -1 for none. */
  public void follow(int playerId) {
    followed = playerId;
  }

  /** Returns the name of the player that is followed, or an empty string. */
  public String followed() {
    return view().playerName(followed);
  }

  /** Returns the present tick. */
  public int tick() {
    return replay.simulation().tick();
  }

  /** Returns the last tick of the recording, as far as it was written when it was opened. */
  public int lastTick() {
    return Math.max(lastTick, newestTick);
  }

  /** Returns whether the recording's end is reached. */
  public boolean ended() {
    return ended;
  }

  /** Returns whether the file ends without an end mark: torn, or still being written. */
  public boolean waiting() {
    return waiting;
  }

  /** Returns whether a seek is under way. */
  public boolean seeking() {
    return target >= 0;
  }

  /** Returns why the replay can't go on, or an empty string. */
  public String problem() {
    return problem;
  }

  /** Returns the first difference from the recording, or null. */
  public Divergence divergence() {
    return replay.divergence();
  }

  /** Returns the computed game. Do not change it. */
  public SimulationHost simulation() {
    return replay.simulation();
  }

  /** Returns the view of the present moment; the same object for ever. */
  public ClientView view() {
    return view.view();
  }

  @Override
  public void close() throws IOException {
    if (reader != null) {
      reader.close();
    }
  }
}
