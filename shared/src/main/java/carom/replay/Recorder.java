package carom.replay;

import carom.physics.archive.ArchiveWriter;
import carom.sim.Entity;
import carom.sim.Journal;
import carom.sim.Player;
import carom.sim.SimState;
import carom.sim.Simulation;
import java.util.Arrays;

/**
 * Records a simulation, from any tick on: what enters it, a hash of its state after each tick, and
 * from time to time the exact state of every body, and seldom that of everything, from which a
 * replay can begin.
 *
 * <p>On the simulation's thread; a tick costs one pass over the entities and allocates nothing once
 * buffers have grown, but for the few a whole state needs. Blocks go to a {@link BlockSink}, at
 * least one a second; when it can't take one, recording stops: a game can't be computed across a
 * hole.
 */
public final class Recorder implements Journal {
  /** Seconds between keyframes. */
  public static final int KEYFRAME_SECONDS = 5;

  /** Seconds between whole states. */
  public static final int STATE_SECONDS = 60;

  /** Most bytes of a state before what the simulation writes. */
  private static final int STATE_HEAD = 1 << 13;

  private static final int FULL_BLOCK = 1 << 16;

  private final BlockSink sink;
  private final ByteSink out = new ByteSink();
  private final ByteSink keyframe = new ByteSink();
  private final Fingerprint now = new Fingerprint();
  private final Fingerprint before = new Fingerprint();
  private final ArchiveWriter archive = new ArchiveWriter();
  private SimState state;
  private final int[] bits = new int[Fingerprint.FIELDS];
  private int[] keyStates = {};
  private final long[] inputs = new long[Simulation.MAX_PLAYERS];
  private final int[] viewDelays = new int[Simulation.MAX_PLAYERS];
  private int blockTicks;
  private int begun = -1; // where in the block the tick begins that has not ended yet
  private int lastTick;
  private int nextStateTick;
  private long lastHash;
  private boolean stopped;
  private String leftOut;

  /**
   * Begins a recording of a simulation between two steps. One that stands at tick 0 without players
   * is built again from the header; else its state comes first.
   *
   * @param header as {@link RecordingHeader#of} makes it
   * @param sink takes the blocks
   * @throws IllegalArgumentException when the simulation has gone on and its state can't be stored:
   *     the game {@linkplain carom.sim.Game#keepsMore keeps more}, or the state is too large
   */
  public Recorder(Simulation s, RecordingHeader header, BlockSink sink) {
    this.sink = sink;
    boolean begins = s.tick() == 0 && s.playerCapacity() == 0;
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
    writeKeyframe(s);
    int gap = STATE_SECONDS * s.tickRate();
    nextStateTick = s.game().keepsMore() ? Integer.MAX_VALUE : lastTick + gap;
  }

  @Override
  public void joining(Simulation s, int id, String name) {
    if (stopped) {
      return;
    }
    out.u8(Block.JOIN);
    out.varint(id);
    out.text(name);
    inputs[id] = 0;
    viewDelays[id] = 0;
  }

  @Override
  public void leaving(Simulation s, int id) {
    if (stopped) {
      return;
    }
    out.u8(Block.LEAVE);
    out.varint(id);
  }

  @Override
  public void stepping(Simulation s) {
    if (stopped) {
      return;
    }
    begun = out.length();
    out.u8(Block.TICK);
    int changed = 0;
    for (int id = 0; id < s.playerCapacity(); id++) {
      changed += hasChanged(s.player(id)) ? 1 : 0;
    }
    out.varint(changed);
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (hasChanged(p)) {
        out.varint(id);
        out.varint(p.input().pack() ^ inputs[id]);
        out.varint(zigzag(p.viewDelay() - viewDelays[id]));
        inputs[id] = p.input().pack();
        viewDelays[id] = p.viewDelay();
      }
    }
  }

  private boolean hasChanged(Player p) {
    return p != null && (p.input().pack() != inputs[p.id()] || p.viewDelay() != viewDelays[p.id()]);
  }

  private static long zigzag(int value) {
    return ((value << 1) ^ (value >> 31)) & 0xffffffffL;
  }

  @Override
  public void stepped(Simulation s) {
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
    boolean keyframeDue = lastTick % (KEYFRAME_SECONDS * s.tickRate()) == 0;
    boolean stateDue = lastTick >= nextStateTick;
    if (keyframeDue || stateDue || blockTicks >= s.tickRate() || out.length() >= FULL_BLOCK) {
      seal(Block.TICKS);
    }
    if (keyframeDue) {
      writeKeyframe(s);
    }
    if (stateDue) {
      writeState(s);
      nextStateTick += STATE_SECONDS * s.tickRate();
    }
  }

  /**
   * Returns the whole state in pieces. What follows is told as if nothing had come before, so that
   * a reader can begin here.
   */
  private boolean writeState(Simulation s) {
    archive.clear();
    try {
      state = s.save(state);
      state.write(archive);
    } catch (IllegalArgumentException e) {
      leftOut = "tick=" + lastTick + " has no state to begin from: " + e.getMessage();
      return false; // the world has blown up
    }
    if (archive.length() > Block.MAX_STATE_BYTES - STATE_HEAD) {
      int most = Block.MAX_STATE_BYTES - STATE_HEAD;
      leftOut =
          "tick="
              + lastTick
              + ": bytes="
              + archive.length()
              + " are more than "
              + most
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
      Player p = s.player(id);
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

  /** Field by field, against the last keyframe: what rests is zeros, which compress to nothing. */
  private void writeKeyframe(Simulation s) {
    keyframe.truncate(0);
    keyframe.varint(lastTick);
    keyframe.i64(lastHash);
    int limit = s.entityCapacity();
    keyframe.varint(limit);
    if (keyStates.length < limit * Fingerprint.FIELDS) {
      keyStates = Arrays.copyOf(keyStates, 2 * limit * Fingerprint.FIELDS);
    }
    for (int id = 0; id < limit; id++) {
      Entity e = s.entity(id);
      keyframe.varint(e == null ? 0 : e.archetype().index() + 1);
      keyframe.u8(e == null ? 0 : e.generation());
    }
    for (int f = 0; f < Fingerprint.FIELDS; f++) {
      for (int id = 0; id < limit; id++) {
        Entity e = s.entity(id);
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
   * Why the last whole state that wasn't recorded is missing, or null when all are there. The
   * recording is whole all the same, only that no replay can begin there.
   */
  public String leftOut() {
    return leftOut;
  }

  /** Returns whether the sink could not take a block: nothing is recorded any more. */
  public boolean isCut() {
    return stopped;
  }

  /**
   * Ends the recording: what is left goes to the sink, and how it ended. A step that threw is not
   * part of it.
   *
   * @param why in a few words, for whoever plays it
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

  /** Content of the last block of a recording that was cut because its sink could not keep up. */
  public static byte[] cutBlock(String why) {
    ByteSink out = new ByteSink();
    writeEnd(out, true, why);
    return Arrays.copyOf(out.array(), out.length());
  }

  private static void writeEnd(ByteSink out, boolean cut, String why) {
    out.u8(cut ? 1 : 0);
    out.text(why);
  }

  /** Returns the last tick recorded. */
  public int tick() {
    return lastTick;
  }
}
