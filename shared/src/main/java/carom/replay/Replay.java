package carom.replay;

import carom.physics.archive.ArchiveException;
import carom.sim.Player;
import carom.sim.SimState;
import carom.sim.Simulation;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Simulates a recorded game once more, and finds out where it goes another way. One thread.
 *
 * <p>The state hash is compared after each tick. From the first difference on, the replay goes on
 * until it can name a body, which is in the same tick if one body's motion is what differs, and at
 * the next keyframe at the latest; see {@link #isDecided}. Who goes on further comes to the next
 * whole state of the recording, which is taken over: ticks are compared again from there, so that
 * every stretch that diverged is found.
 */
public final class Replay {
  /** What a call of {@link #step} did. */
  public enum Progress {
    /** One more tick is computed. */
    TICK,
    /** The recording has ended. */
    END,
    /** The file ends in the middle: it is torn, or still being written. */
    WAIT
  }

  private static final int MAX_DIVERGENCES = 1_000;

  private final RecordingReader reader;
  private final Simulation simulation;
  private final Fingerprint own = new Fingerprint();
  private final int[] located = new int[Fingerprint.FIELDS];
  private final List<Divergence> divergences = new ArrayList<>();

  /** What is being found out of the stretch that is played; null while all is equal. */
  private Divergence divergence;

  private boolean decided;
  private int equalTicks;
  private boolean inTick;

  /** True if what comes is computed on; else a state to begin from comes. */
  private boolean computing;

  private int firstTick = Integer.MAX_VALUE;

  /**
   * Builds the simulation at tick 0, or at the one the recording begins with.
   *
   * @param reader where the recording comes from, just opened; stays the caller's to close
   * @throws RecordingException when this build can't play the game
   */
  public Replay(RecordingReader reader) throws IOException {
    this.reader = reader;
    simulation = reader.header().start();
    if (reader.comesState() && reader.next() == RecordingReader.Event.STATE) {
      state();
    }
  }

  /** Says clearly why recordings of another arithmetic can't be expected to be equal. */
  public static void requirePhysics(RecordingHeader header, long digest) throws RecordingException {
    if (header.physicsDigest() != digest) {
      throw new RecordingException(
          String.format(
              "recorded with physics=%016x, this build has %016x: the same inputs give other"
                  + " states; play it with the build that recorded it",
              header.physicsDigest(), digest));
    }
  }

  /**
   * Goes on by one tick, if the file has it.
   *
   * @throws RecordingException when the file is damaged or contradicts itself
   */
  public Progress step() throws IOException {
    while (true) {
      switch (reader.next()) {
        case JOIN -> join();
        case LEAVE -> leave();
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
    computing = true;
    if (simulation.player(reader.playerId()) != null) {
      throw contradicts("player " + reader.playerId() + " joins twice");
    }
    simulation.join(reader.playerId(), reader.playerName());
  }

  private void leave() throws RecordingException {
    simulation.leave(player(reader.playerId(), "leaves"));
  }

  private Player player(int id, String what) throws RecordingException {
    Player player = simulation.player(id);
    if (player == null) {
      throw contradicts("player " + id + " " + what + " without having joined");
    }
    return player;
  }

  private void begin() throws RecordingException {
    if (inTick) {
      throw contradicts("a tick has no end");
    }
    if (!computing) {
      computing = true;
      firstTick = Math.min(firstTick, simulation.tick());
    }
    for (int i = 0; i < reader.changedCount(); i++) {
      int id = reader.changedId(i);
      Player player = player(id, "acts");
      player.input().unpack(reader.input(id));
      player.viewDelay(reader.viewDelay(id));
    }
    inTick = true;
    try {
      simulation.step();
    } catch (RuntimeException | AssertionError e) {
      throw contradicts("the physics fails where they did not while recording: " + e);
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
        divergence = known; // found before somebody jumped back
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
      throw contradicts("a keyframe of tick " + reader.keyframeTick() + " comes");
    }
    if (divergence == null && reader.hash() != simulation.stateHash()) {
      diverge(simulation.stateHash());
    }
    if (divergence != null && !decided) {
      divergence.keyframe(simulation, reader);
      decided = true;
    }
  }

  /** Begins from a state, compares it with the one computed, or goes on from it if that differs. */
  private void state() throws RecordingException {
    if (computing) {
      if (reader.stateTick() != simulation.tick()) {
        throw contradicts("a state of tick " + reader.stateTick() + " comes");
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
    computing = true;
    firstTick = Math.min(firstTick, simulation.tick());
  }

  private void take() throws RecordingException {
    try {
      simulation.restore(simulation.read(reader.state()));
    } catch (ArchiveException e) {
      throw contradicts("this is a state: " + e.getMessage());
    }
    if (simulation.tick() != reader.stateTick() || simulation.stateHash() != reader.hash()) {
      throw contradicts(
          String.format(
              "the state of tick %d has hash %016x, it has %016x",
              reader.stateTick(), reader.hash(), simulation.stateHash()));
    }
  }

  /**
   * Returns the last tick at or before another at which the file has a whole state, to begin from.
   *
   * @return -1 when there is none
   */
  public int stateBefore(int tick) throws IOException {
    return simulation.game().keepsMore() ? -1 : reader.findState(tick);
  }

  /**
   * Goes to the state at {@link #stateBefore} that tick, without computing what lies between; the
   * next {@link #step} goes on from there. A divergence found stays found.
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
    if (reader.next() != RecordingReader.Event.STATE) {
      throw contradicts("a state comes, but it is torn");
    }
    state();
    return true;
  }

  /** Returns the first tick that was there: 0, or that of a state begun from. */
  public int firstTick() {
    return Math.min(firstTick, simulation.tick());
  }

  private RecordingException contradicts(String what) {
    return new RecordingException(
        "damaged: after tick " + simulation.tick() + " the recording says that " + what);
  }

  /** Returns the world, for reading. */
  public Simulation simulation() {
    return simulation;
  }

  /** Returns what the recording began with. */
  public RecordingHeader header() {
    return reader.header();
  }

  /** Returns the first difference found, or null when there has been none. */
  public Divergence divergence() {
    return divergences.isEmpty() ? null : divergences.get(0);
  }

  /**
   * Returns the first difference of each stretch between two whole states that was played and
   * diverged, as they were found; {@value #MAX_DIVERGENCES} at most.
   */
  public List<Divergence> divergences() {
    return List.copyOf(divergences);
  }

  /** Returns how many ticks were computed with the hash that was recorded. */
  public int equalTicks() {
    return equalTicks;
  }

  /**
   * Returns whether {@link #divergence} tells all that can be found out; going on finds out only
   * whether what follows the next whole state is equal.
   */
  public boolean isDecided() {
    return divergences.size() > 1 || (!divergences.isEmpty() && (decided || divergence == null));
  }

  /** A tick to come back to: memory of the size of the world's state. */
  public static final class Mark {
    private final SimState state;
    private final RecordingReader.Mark place;
    private final Divergence divergence;

    private Mark(SimState state, RecordingReader.Mark place, Divergence divergence) {
      this.state = state;
      this.place = place;
      this.divergence = divergence;
    }

    /** Returns the tick it stands for. */
    public int tick() {
      return state.tick();
    }
  }

  /** Returns whether {@link #mark} is possible after this tick; it is about once a second. */
  public boolean canMark() {
    return reader.isBetweenBlocks();
  }

  /**
   * Remembers this tick.
   *
   * @throws IllegalStateException unless {@link #canMark}
   */
  public Mark mark() {
    return new Mark(simulation.save(null), reader.mark(), divergence);
  }

  /**
   * Goes back, or forward, to a tick of this replay that was marked. A divergence found stays
   * found.
   */
  public void reset(Mark mark) {
    simulation.restore(mark.state);
    reader.reset(mark.place);
    divergence = mark.divergence;
    decided = divergence != null;
    inTick = false;
    computing = true;
  }
}
