package carom.replay;

import carom.physics.archive.ArchiveException;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Simulation of a recorded game that finds where it differs from the recording. Use it from one
 * thread.
 *
 * <p>It compares the state hash after each tick. After the first difference, it goes on until it
 * can name a body, see {@link #isDecided}. If one body's motion differs, that is in the same tick;
 * otherwise it is at the next keyframe at the latest. A replay that continues takes over the next
 * whole state of the recording and compares from there again. So it finds every stretch that
 * differs.
 */
public final class Replay {
  /** Result of {@link #step}. */
  public enum Progress {
    /** The replay computed one more tick. */
    TICK,
    /** The recording has ended. */
    END,
    /** The file ends in the middle, because it was cut off or is still being written. */
    WAIT
  }

  private static final int MAX_DIVERGENCES = 1_000;

  private final RecordingReader reader;
  private final SimulationHost simulation;
  private final Fingerprint own = new Fingerprint();
  private final int[] located = new int[Fingerprint.FIELDS];
  private final List<Divergence> divergences = new ArrayList<>();

  /** The divergence in the stretch being played, or null while all is equal. */
  private Divergence divergence;

  private boolean decided;
  private int equalTicks;
  private long inputs;
  private boolean inTick;

  /**
   * True if the simulation continues from its present state, false if it must first take over a
   * recorded state.
   */
  private boolean computing;

  private int firstTick = Integer.MAX_VALUE;

  /**
   * Builds the simulation at tick 0, or at the state that begins the recording.
   *
   * @param reader a recording just opened, which the caller closes
   * @throws RecordingException when this build can't play the game
   */
  public Replay(RecordingReader reader) throws IOException {
    this(reader, reader.header().start());
  }

  /**
   * Plays a recording in a simulation that the caller has built.
   *
   * @param reader a recording just opened, which the caller closes
   * @param simulation fresh, of the recorded game, level, seed and tick rate
   * @throws RecordingException when the recording begins with a state that doesn't fit
   */
  public Replay(RecordingReader reader, SimulationHost simulation) throws IOException {
    this.reader = reader;
    this.simulation = simulation;
    if (reader.isStateNext() && reader.next() == RecordingReader.Entry.STATE) {
      state();
    }
  }

  /**
   * Puts a simulation into the state that begins a recording, which a build with other arithmetic
   * may have made: its ticks can't be computed here, and its hash can't be checked.
   *
   * @param reader a recording just opened, which the caller closes
   * @param simulation fresh, of the recorded game, level, seed and tick rate
   * @throws RecordingException when the recording begins with no whole state, or one that doesn't
   *     fit
   */
  public static void restoreFirstState(RecordingReader reader, SimulationHost simulation)
      throws IOException {
    if (!reader.isStateNext() || reader.next() != RecordingReader.Entry.STATE) {
      throw new RecordingException("it begins with no whole state");
    }
    try {
      simulation.restore(simulation.read(reader.state()));
    } catch (ArchiveException e) {
      throw new RecordingException("its state can't be restored: " + e.getMessage());
    }
  }

  /**
   * Refuses a recording made by a build with other arithmetic, with a message that says why its
   * replay would differ.
   *
   * @throws RecordingException when the digests differ
   */
  public static void requirePhysics(RecordingHeader header, long digest) throws RecordingException {
    if (header.physicsDigest() != digest) {
      throw new RecordingException(
          String.format(
              Locale.ROOT,
              "recorded with physics=%016x, this build has %016x: the same inputs give other"
                  + " states; play it with the build that recorded it",
              header.physicsDigest(),
              digest));
    }
  }

  /**
   * Computes the next tick, if the file has it.
   *
   * @throws RecordingException when the file is damaged or contradicts itself
   */
  public Progress step() throws IOException {
    while (true) {
      switch (reader.next()) {
        case JOIN -> join();
        case WATCH -> watch();
        case ROLE -> simulation.role(player(reader.playerId(), "changes"), reader.role());
        case KEEP -> keep();
        case LEAVE -> leave();
        case MESSAGE -> message();
        case TICK -> begin();
        case STEPPED -> {
          end();
          return Progress.TICK;
        }
        case KEYFRAME -> keyframe();
        case STATE -> state();
        case END -> {
          return Progress.END;
        }
        case WAIT -> {
          return Progress.WAIT;
        }
      }
    }
  }

  private void join() throws RecordingException {
    requireNew();
    enters(() -> simulation.join(reader.playerId(), reader.newcomer(), 0, 0));
  }

  private void watch() throws RecordingException {
    requireNew();
    enters(() -> simulation.joinAsSpectator(reader.playerId(), reader.newcomer()));
  }

  private void enters(Runnable entry) throws RecordingException {
    try {
      entry.run();
    } catch (IllegalArgumentException e) {
      throw contradicts("player " + reader.playerId() + " can't enter: " + e.getMessage());
    }
  }

  private void requireNew() throws RecordingException {
    compute();
    if (simulation.participant(reader.playerId()) != null) {
      throw contradicts("player " + reader.playerId() + " joins twice");
    }
  }

  private void keep() throws RecordingException {
    HostPlayer player = player(reader.playerId(), "gets back what it has");
    int[] values = reader.kept() == null ? new int[0] : reader.kept();
    try {
      simulation.keep(player, values);
    } catch (IllegalArgumentException e) {
      throw contradicts("player " + player.id() + " gets back what it can't: " + e.getMessage());
    }
  }

  private void leave() throws RecordingException {
    simulation.leave(player(reader.playerId(), "leaves"));
  }

  private void message() throws RecordingException {
    byte[] bytes = reader.message();
    Message message =
        simulation.messageKinds().decode(bytes, 0, bytes.length, Direction.FROM_CLIENT);
    if (message == null) {
      throw contradicts("player " + reader.playerId() + " sends what is no message of this game");
    }
    simulation.receive(player(reader.playerId(), "sends a message"), message);
  }

  private HostPlayer player(int id, String what) throws RecordingException {
    HostPlayer player = simulation.participant(id);
    if (player == null) {
      throw contradicts("player " + id + " " + what + " without having joined");
    }
    return player;
  }

  private void begin() throws RecordingException {
    if (inTick) {
      throw contradicts("a tick has no end");
    }
    compute();
    for (int i = 0; i < reader.changedCount(); i++) {
      int id = reader.changedId(i);
      HostPlayer player = player(id, "acts");
      player.input().unpack(reader.input(id));
      player.viewDelay(reader.viewDelay(id));
    }
    inputs += reader.changedCount();
    inTick = true;
    try {
      simulation.step();
    } catch (RuntimeException | AssertionError e) {
      throw contradicts("an error that did not occur while recording: " + e);
    }
  }

  private void end() throws RecordingException {
    if (!inTick) {
      throw contradicts("a tick has no beginning");
    }
    inTick = false;
    if (divergence == null) {
      long hash = simulation.stateHash();
      if (hash == reader.hash()) {
        equalTicks++;
        return;
      }
      diverge(hash);
    }
    if (divergence.bodyTick() < 0 && !decided) {
      findBody();
    }
  }

  private void diverge(long hash) {
    decided = false;
    for (Divergence known : divergences) {
      if (known.tick() == simulation.tick()) {
        divergence = known; // found before a jump backwards
        decided = true;
        return;
      }
    }
    divergence = new Divergence(simulation.tick(), reader.hash(), hash);
    if (divergences.size() < MAX_DIVERGENCES) {
      divergences.add(divergence);
    }
  }

  private void findBody() {
    own.take(simulation);
    if (own.sameAs(reader.sums())) {
      return;
    }
    int id = own.locate(simulation, reader.sums(), located);
    if (id < 0) {
      divergence.severalBodies(simulation.tick());
    } else {
      divergence.oneBody(simulation.tick(), simulation, id, located);
      decided = true;
    }
  }

  private void keyframe() throws RecordingException {
    if (reader.keyframeTick() != simulation.tick()) {
      throw contradicts("a keyframe of tick " + reader.keyframeTick() + " is out of place");
    }
    if (divergence == null && reader.hash() != simulation.stateHash()) {
      diverge(simulation.stateHash());
    }
    if (divergence != null && !decided) {
      divergence.keyframe(simulation, reader);
      decided = true;
    }
  }

  /**
   * Takes a recorded state: begins from it, compares it with the computed one, or takes it over if
   * that differs.
   */
  private void state() throws RecordingException {
    if (computing) {
      if (reader.stateTick() != simulation.tick()) {
        throw contradicts("a state of tick " + reader.stateTick() + " is out of place");
      }
      if (divergence == null && reader.hash() != simulation.stateHash()) {
        diverge(simulation.stateHash());
      }
      if (divergence == null) {
        return;
      }
      divergence.endsAt(simulation.tick());
      divergence = null;
    }
    take();
    compute();
  }

  /** Notes that the simulation goes on from the state that it has now. */
  private void compute() {
    if (!computing) {
      computing = true;
      firstTick = Math.min(firstTick, simulation.tick());
    }
  }

  private void take() throws RecordingException {
    try {
      simulation.restore(simulation.read(reader.state()));
    } catch (ArchiveException e) {
      throw contradicts("a state can't be restored: " + e.getMessage());
    }
    if (simulation.tick() != reader.stateTick() || simulation.stateHash() != reader.hash()) {
      throw contradicts(
          String.format(
              Locale.ROOT,
              "the state of tick=%d has the recorded hash %016x, but %016x when restored",
              reader.stateTick(),
              reader.hash(),
              simulation.stateHash()));
    }
  }

  /**
   * Returns the tick of the last whole state at or before a tick, from which the replay can begin.
   *
   * @return -1 when there is none
   */
  public int stateBefore(int tick) throws IOException {
    return simulation.game().keepsMore() ? -1 : reader.findState(tick);
  }

  /**
   * Goes to the state at {@link #stateBefore} the tick without computing the ticks between. The
   * next {@link #step} continues from there. Divergences found are kept.
   *
   * @return false when there is none; nothing has changed then
   * @throws RecordingException when the file is damaged there
   */
  public boolean goToStateBefore(int tick) throws IOException {
    if (simulation.game().keepsMore() || !reader.goToState(tick)) {
      return false;
    }
    computing = false;
    inTick = false;
    divergence = null;
    if (reader.next() != RecordingReader.Entry.STATE) {
      throw contradicts("a state is cut off");
    }
    state();
    return true;
  }

  /** Returns the first tick that this replay had: 0, or the tick of the state it began from. */
  public int firstTick() {
    return Math.min(firstTick, simulation.tick());
  }

  private RecordingException contradicts(String what) {
    return new RecordingException("damaged, after tick=" + simulation.tick() + ": " + what);
  }

  /** Returns the simulation, for reading only. */
  public SimulationHost simulation() {
    return simulation;
  }

  /** Returns the first difference found, or null if there is none. */
  public Divergence divergence() {
    return divergences.isEmpty() ? null : divergences.get(0);
  }

  /**
   * Returns the first difference of each stretch that was played and differed, in the order found.
   * A stretch lies between two whole states. The list has at most {@value #MAX_DIVERGENCES}
   * differences.
   */
  public List<Divergence> divergences() {
    return List.copyOf(divergences);
  }

  /** Returns how many computed ticks had the recorded hash. */
  public int equalTicks() {
    return equalTicks;
  }

  /** Returns how many changed inputs the computed ticks had. */
  public long inputs() {
    return inputs;
  }

  /**
   * Returns whether {@link #divergence} has all its details. Going on then finds only whether the
   * ticks after the next whole state are equal.
   */
  public boolean isDecided() {
    return divergences.size() > 1 || (!divergences.isEmpty() && (decided || divergence == null));
  }

  /** A tick to which the replay can return. It takes as much memory as the world's state. */
  public static final class SavedTick {
    private final SimState state;
    private final RecordingReader.Position place;
    private final Divergence divergence;

    private SavedTick(SimState state, RecordingReader.Position place, Divergence divergence) {
      this.state = state;
      this.place = place;
      this.divergence = divergence;
    }

    /** Returns the tick of this mark. */
    public int tick() {
      return state.tick();
    }
  }

  /** Returns whether {@link #mark} is possible after this tick, which is about once a second. */
  public boolean canMark() {
    return reader.isBetweenBlocks();
  }

  /**
   * Marks this tick.
   *
   * @throws IllegalStateException when {@link #canMark} is false
   */
  public SavedTick mark() {
    return new SavedTick(simulation.save(null), reader.mark(), divergence);
  }

  /** Goes to a marked tick of this replay, backwards or forwards. Divergences found are kept. */
  public void reset(SavedTick mark) {
    simulation.restore(mark.state);
    reader.reset(mark.place);
    divergence = mark.divergence;
    decided = divergence != null;
    inTick = false;
    computing = true;
  }
}
