package carom.replay;

import carom.physics.archive.ArchiveWriter;
import carom.sim.Journal;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Newcomer;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import carom.sim.message.PlayerRole;
import carom.sim.message.WaitingMessages;
import java.util.Arrays;
import java.util.function.Predicate;

/**
 * Recorder of a simulation from any tick on. It stores the inputs and a hash of the state after
 * each tick, at intervals the exact state of every body, and at longer intervals the whole state,
 * from which a replay can begin.
 *
 * <p>It runs on the simulation's thread. A tick costs one pass over the entities and allocates
 * nothing once the buffers have grown, except for the few allocations of a whole state. Blocks go
 * to a {@link BlockSink}, at least one a second. When the sink can't take a block, the recording
 * ends, because a game can't be computed across a gap.
 */
public final class Recorder implements Journal {
  /** Seconds between the keyframes of a recording. */
  public static final int KEYFRAME_SECONDS = 5;

  /** Seconds between the whole states of a recording. */
  public static final int STATE_SECONDS = 60;

  /**
   * Intervals at which the parts of a recording are written.
   *
   * @param blocksPerSecond blocks of ticks in a second, 1..10. A process that is killed loses less
   *     than one block, besides what waits for the disk
   * @param keyframeSeconds time between keyframes, s; 0 = none at all
   * @param stateSeconds time between whole states, s; 0 = only one, with which it always begins
   * @param mostStateBytes largest state that is written, bytes, 1..{@link #MOST_STATE_BYTES}
   */
  public record Intervals(
      int blocksPerSecond, int keyframeSeconds, int stateSeconds, int mostStateBytes) {
    /** The pace of a recording that people play and search. */
    public static final Intervals RECORDING =
        new Intervals(1, KEYFRAME_SECONDS, STATE_SECONDS, MOST_STATE_BYTES);

    /** The pace of a log behind a checkpoint, which is read once, from its beginning. */
    public static final Intervals LOG = new Intervals(4, 0, 0, MOST_STATE_BYTES);
  }

  /** Largest number of bytes of a state before the part that the simulation writes. */
  private static final int STATE_HEAD = 1 << 13;

  /** Largest state that a recording can hold, bytes. */
  public static final int MOST_STATE_BYTES = Block.MAX_STATE_BYTES - STATE_HEAD;

  private static final int FULL_BLOCK = 1 << 16;

  private final Intervals pace;
  private final Predicate<Message> leavesOut;
  private final ByteSink out = new ByteSink();
  private final ByteSink keyframe = new ByteSink();
  private final Fingerprint now = new Fingerprint();
  private final Fingerprint before = new Fingerprint();
  private final ArchiveWriter archive = new ArchiveWriter();
  private SimState state;
  private final int[] bits = new int[Fingerprint.FIELDS];
  private int[] keyStates = {};
  private final long[] inputs = new long[SimulationHost.MAX_PLAYERS];
  private final int[] viewDelays = new int[SimulationHost.MAX_PLAYERS];
  private final WaitingMessages.Reader writeMessage = this::writeMessage;
  private MessageKinds messageKinds;
  private BlockSink sink;
  private int blockTicks;
  private int begun = -1; // position in the block of the tick that has begun but not ended, or -1
  private int lastTick;
  private int nextStateTick;
  private long lastHash;
  private boolean stopped;
  private String leftOut;

  /**
   * Begins a recording of a simulation between two steps. A replay builds a simulation at tick 0
   * without players from the header alone; for any other, the recording begins with the whole
   * state.
   *
   * @param header header from {@link RecordingHeader#of}
   * @param sink receives the blocks
   * @throws IllegalArgumentException when the simulation is past its start and its state can't be
   *     stored: the game {@linkplain carom.sim.Game#keepsMore keeps more}, or the state is too
   *     large
   */
  public Recorder(SimulationHost s, RecordingHeader header, BlockSink sink) {
    this(s, header, sink, Intervals.RECORDING);
  }

  /**
   * Begins a recording without some messages of participants.
   *
   * @param leavesOut tells of each message that comes whether it is left out; one that has an
   *     effect on the state must not be
   */
  public Recorder(
      SimulationHost s, RecordingHeader header, BlockSink sink, Predicate<Message> leavesOut) {
    this(s, header, sink, Intervals.RECORDING, leavesOut);
  }

  /** Begins a recording as above, with another pace. */
  public Recorder(SimulationHost s, RecordingHeader header, BlockSink sink, Intervals pace) {
    this(s, header, sink, pace, message -> false);
  }

  private Recorder(
      SimulationHost s,
      RecordingHeader header,
      BlockSink sink,
      Intervals pace,
      Predicate<Message> leavesOut) {
    this.pace = pace;
    this.leavesOut = leavesOut;
    begin(s, header, sink);
  }

  /**
   * Ends the recording and begins another one of the same match, between two steps. Nothing is
   * missing between them, and no buffer grows again.
   *
   * @param why reason for the end, in a few words
   * @param header as for a new recording
   * @param newSink receives the blocks of the new one
   * @throws IllegalArgumentException as for a new recording; the old one has ended then
   */
  public void goOn(SimulationHost s, String why, RecordingHeader header, BlockSink newSink) {
    end(why);
    stopped = false;
    leftOut = null;
    begun = -1;
    out.truncate(0);
    begin(s, header, newSink);
  }

  private void begin(SimulationHost s, RecordingHeader header, BlockSink newSink) {
    sink = newSink;
    boolean begins = pace.stateSeconds() > 0 && s.tick() == 0 && s.playerCapacity() == 0;
    if (!begins && s.game().keepsMore()) {
      throw new IllegalArgumentException(
          "game "
              + s.game().name()
              + " keeps more than its state: it can be recorded from tick 0 on only, not from tick="
              + s.tick());
    }
    header.write(out);
    seal(Block.HEADER);
    lastTick = s.tick();
    lastHash = s.stateHash();
    if (!begins && !writeState(s)) {
      throw new IllegalArgumentException("the state can't be stored: " + leftOut);
    }
    if (pace.keyframeSeconds() > 0) {
      writeKeyframe(s);
    }
    boolean goesOn = pace.stateSeconds() > 0 && !s.game().keepsMore();
    nextStateTick = goesOn ? lastTick + pace.stateSeconds() * s.tickRate() : Integer.MAX_VALUE;
  }

  @Override
  public void joining(SimulationHost s, int id, Newcomer newcomer) {
    enters(Block.JOIN, id, newcomer);
  }

  @Override
  public void watching(SimulationHost s, int id, Newcomer newcomer) {
    enters(Block.WATCH, id, newcomer);
  }

  private void enters(int how, int id, Newcomer newcomer) {
    if (stopped) {
      return;
    }
    if (!newcomer.account().isEmpty() || newcomer.values() != null) {
      out.u8(Block.ACCOUNT);
      out.text(newcomer.account());
      writeValues(newcomer.values());
    }
    out.u8(how);
    out.varint(id);
    out.text(newcomer.name());
    inputs[id] = 0;
    viewDelays[id] = 0;
  }

  private void writeValues(int[] values) {
    out.varint(values == null ? 0 : values.length);
    for (int i = 0; values != null && i < values.length; i++) {
      out.varint(zigzag(values[i]));
    }
  }

  @Override
  public void keeping(SimulationHost s, int id, int[] values) {
    if (stopped) {
      return;
    }
    out.u8(Block.KEEP);
    out.varint(id);
    writeValues(values);
  }

  @Override
  public void changing(SimulationHost s, int id, PlayerRole role) {
    if (stopped) {
      return;
    }
    out.u8(Block.ROLE);
    out.varint(id);
    out.u8(role.ordinal());
  }

  @Override
  public void leaving(SimulationHost s, int id) {
    if (stopped) {
      return;
    }
    out.u8(Block.LEAVE);
    out.varint(id);
  }

  @Override
  public void stepping(SimulationHost s) {
    if (stopped) {
      return;
    }
    begun = out.length();
    messageKinds = s.messageKinds();
    s.forEachReceived(writeMessage);
    out.u8(Block.TICK);
    int changed = 0;
    for (int id = 0; id < s.playerCapacity(); id++) {
      changed += hasChanged(s.participant(id)) ? 1 : 0;
    }
    out.varint(changed);
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.participant(id);
      if (hasChanged(p)) {
        out.varint(id);
        out.varint(p.input().pack() ^ inputs[id]);
        out.varint(zigzag(p.viewDelay() - viewDelays[id]));
        inputs[id] = p.input().pack();
        viewDelays[id] = p.viewDelay();
      }
    }
  }

  private void writeMessage(int player, Message message) {
    if (leavesOut.test(message)) {
      return;
    }
    byte[] bytes = messageKinds.encode(message, Direction.FROM_CLIENT);
    out.u8(Block.MESSAGE);
    out.varint(player);
    out.varint(bytes.length);
    out.bytes(bytes, bytes.length);
  }

  private boolean hasChanged(HostPlayer p) {
    return p != null && (p.input().pack() != inputs[p.id()] || p.viewDelay() != viewDelays[p.id()]);
  }

  private static long zigzag(int value) {
    return ((value << 1) ^ (value >> 31)) & 0xffffffffL;
  }

  @Override
  public void stepped(SimulationHost s) {
    if (stopped) {
      return;
    }
    begun = -1;
    lastTick = s.tick();
    lastHash = s.stateHash();
    now.take(s);
    out.u8(Block.STEPPED);
    out.i64(lastHash);
    out.varint(now.weight ^ before.weight);
    out.varint(now.moment ^ before.moment);
    for (int f = 0; f < Fingerprint.FIELDS; f++) {
      out.varint((now.fields[f] ^ before.fields[f]) & 0xffffffffL);
    }
    before.set(now);
    blockTicks++;
    boolean keyframeDue =
        pace.keyframeSeconds() > 0 && lastTick % (pace.keyframeSeconds() * s.tickRate()) == 0;
    boolean stateDue = lastTick >= nextStateTick;
    if (keyframeDue
        || stateDue
        || blockTicks * pace.blocksPerSecond() >= s.tickRate()
        || out.length() >= FULL_BLOCK) {
      seal(Block.TICKS);
    }
    if (keyframeDue) {
      writeKeyframe(s);
    }
    if (stateDue) {
      writeState(s);
      nextStateTick += pace.stateSeconds() * s.tickRate();
    }
  }

  /**
   * Writes the whole state in pieces. Later blocks are coded as if nothing had come before, so that
   * a reader can begin here. Returns false if the state can't be stored.
   */
  private boolean writeState(SimulationHost s) {
    archive.clear();
    try {
      state = s.save(state);
      state.write(archive);
    } catch (IllegalArgumentException e) {
      leftOut = "tick=" + lastTick + " has no state to begin from: " + e.getMessage();
      return false; // the world has a number that isn't finite or is out of range
    }
    if (archive.length() > pace.mostStateBytes()) {
      leftOut =
          "tick="
              + lastTick
              + ": bytes="
              + archive.length()
              + " are more than "
              + pace.mostStateBytes()
              + ", so a replay can't begin there; fewer bodies make it smaller";
      return false;
    }
    keyframe.truncate(0);
    keyframe.varint(lastTick);
    keyframe.i64(lastHash);
    keyframe.varint(s.playerCapacity());
    Arrays.fill(inputs, 0);
    Arrays.fill(viewDelays, 0);
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.participant(id);
      if (p != null) {
        inputs[id] = p.input().pack();
        viewDelays[id] = p.viewDelay();
      }
      keyframe.varint(inputs[id]);
      keyframe.varint(viewDelays[id]);
    }
    before.clear();
    Arrays.fill(keyStates, 0);
    int head = keyframe.length();
    int length = head + archive.length();
    for (int at = 0; at < length && !stopped; at += Block.STATE_PIECE) {
      int end = Math.min(at + Block.STATE_PIECE, length);
      int ofHead = Math.min(end, head) - Math.min(at, head);
      out.varint(at);
      out.varint(length);
      out.bytes(keyframe.array(), Math.min(at, head), ofHead);
      out.bytes(archive.array(), at + ofHead - head, end - at - ofHead);
      seal(Block.STATE);
    }
    return true;
  }

  /**
   * Writes a keyframe field by field as differences from the last one. Bodies at rest give zeros,
   * which compress to almost nothing.
   */
  private void writeKeyframe(SimulationHost s) {
    keyframe.truncate(0);
    keyframe.varint(lastTick);
    keyframe.i64(lastHash);
    int limit = s.entityCapacity();
    keyframe.varint(limit);
    if (keyStates.length < limit * Fingerprint.FIELDS) {
      keyStates = Arrays.copyOf(keyStates, 2 * limit * Fingerprint.FIELDS);
    }
    for (int id = 0; id < limit; id++) {
      HostEntity e = s.entity(id);
      keyframe.varint(e == null ? 0 : e.archetype().index() + 1);
      keyframe.u8(e == null ? 0 : e.generation());
    }
    for (int f = 0; f < Fingerprint.FIELDS; f++) {
      for (int id = 0; id < limit; id++) {
        HostEntity e = s.entity(id);
        if (e != null) {
          Fingerprint.read(e, bits);
          int at = id * Fingerprint.FIELDS + f;
          keyframe.i32(bits[f] ^ keyStates[at]);
          keyStates[at] = bits[f];
        }
      }
    }
    if (!stopped) {
      stopped = !sink.take(Block.KEYFRAME, keyframe.array(), keyframe.length());
    }
  }

  private void seal(Block type) {
    if (out.length() > 0 && !stopped) {
      stopped = !sink.take(type, out.array(), out.length());
    }
    out.truncate(0);
    blockTicks = 0;
  }

  /**
   * Returns why the last whole state that wasn't recorded is missing, or null if none is missing.
   * The recording stays complete, but no replay can begin at that state.
   */
  public String leftOut() {
    return leftOut;
  }

  /**
   * Returns whether recording has stopped, because the sink could not take a block or the recording
   * has ended.
   */
  public boolean isCut() {
    return stopped;
  }

  /**
   * Ends the recording. The sink gets the rest and the reason for the end. A step that threw is not
   * part of the recording.
   *
   * @param why reason in a few words, shown by the replay
   */
  public void end(String why) {
    if (stopped) {
      return;
    }
    if (begun >= 0) {
      out.truncate(begun);
    }
    seal(Block.TICKS);
    writeEnd(out, false, why);
    seal(Block.END);
    stopped = true;
  }

  /**
   * Returns the content of the END block for a recording that was cut because its sink could not
   * keep up.
   */
  public static byte[] cutBlock(String why) {
    ByteSink out = new ByteSink();
    writeEnd(out, true, why);
    return Arrays.copyOf(out.array(), out.length());
  }

  private static void writeEnd(ByteSink out, boolean cut, String why) {
    out.u8(cut ? 1 : 0);
    out.text(why);
  }

  /** Hands in what has been recorded since the last block, between two steps. */
  public void flush() {
    seal(Block.TICKS);
  }
}
