package carom.replay;

import carom.physics.archive.ArchiveReader;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Newcomer;
import carom.sim.field.Scope;
import carom.sim.message.MessageKind;
import carom.sim.message.PlayerRole;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Reader that returns a recording event by event, also one that is still being written or was cut
 * off. It trusts nothing. For any bytes, it returns an event or throws a {@link RecordingException}
 * that names the fault and its byte. It takes less than about 12 MiB of memory, or 100 MiB with a
 * state. Use it from one thread.
 */
public final class RecordingReader implements AutoCloseable {
  /** Longest name of a player in UTF-8 bytes. */
  private static final int MAX_NAME_BYTES = 256;

  private static final int MAX_REASON_BYTES = 1_024;

  /** An event in a recording. */
  public enum Entry {
    /** The player {@link #playerId}, who is {@link #newcomer}, joins. */
    JOIN,
    /** The spectator {@link #playerId}, who is {@link #newcomer}, comes. */
    WATCH,
    /** The participant {@link #playerId} gets the role {@link #role}. */
    ROLE,
    /** The participant {@link #playerId} gets back what its account has {@link #kept}. */
    KEEP,
    /** The player {@link #playerId} leaves. */
    LEAVE,
    /** The player {@link #playerId} has sent the message {@link #message}, for the next step. */
    MESSAGE,
    /** A step begins; it reads {@link #input} and {@link #viewDelay}. */
    TICK,
    /** The step has ended with the state hash {@link #hash}. */
    STEPPED,
    /** The exact state of every body after {@link #keyframeTick} follows. */
    KEYFRAME,
    /** The whole state after {@link #stateTick} follows. */
    STATE,
    /** The recording ends here, see {@link #isCut} and {@link #reason}. */
    END,
    /** The file ends here without a whole block. Ask again when it may have grown. */
    WAIT
  }

  private record StatePlace(int tick, long position) {}

  /** A place between two blocks to which a reader can return, with what the reader knew there. */
  public static final class Position {
    private final long position;
    private final long[] inputs;
    private final int[] viewDelays;
    private final Fingerprint sums = new Fingerprint();
    private final int[] keyStates;

    private Position(RecordingReader r) {
      position = r.position;
      inputs = r.inputs.clone();
      viewDelays = r.viewDelays.clone();
      sums.set(r.sums);
      keyStates = r.keyStates.clone();
    }
  }

  private final SeekableByteChannel file;
  private final String name;
  private final Inflater inflater = new Inflater();
  private final CRC32 crc = new CRC32();
  private final ByteSource block = new ByteSource();
  private final ByteBuffer head = ByteBuffer.allocate(Block.HEAD_BYTES);
  private byte[] stored = {};
  private byte[] content = {};
  private Block type = Block.HEADER;
  private long position;
  private long blockPosition;
  private boolean ended;

  private final RecordingHeader header;
  private int playerId;
  private Newcomer newcomer = Newcomer.stranger("");
  private PlayerRole role;
  private int[] kept = {};
  private byte[] message = {};
  private final long[] inputs = new long[SimulationHost.MAX_PLAYERS];
  private final int[] viewDelays = new int[SimulationHost.MAX_PLAYERS];
  private final int[] changedIds = new int[SimulationHost.MAX_PLAYERS];
  private int changedCount;
  private long hash;
  private final Fingerprint sums = new Fingerprint();
  private int keyframeTick;
  private int keyframeLimit;
  private int[] kinds = {};
  private int[] generations = {};
  private int[] keyStates = {};
  private byte[] state = {};
  private int collected;
  private int stateTick;
  private int stateBegin;
  private int stateEnd;

  /** The states found so far, and the position at which the scan for more continues. */
  private final List<StatePlace> places = new ArrayList<>();

  private StatePlace begun;
  private long scannedTo = Block.PREAMBLE_BYTES;
  private boolean cut;
  private String reason = "";

  private RecordingReader(SeekableByteChannel file, String name) throws IOException {
    this.file = file;
    this.name = name;
    ByteBuffer preamble = ByteBuffer.allocate(Block.PREAMBLE_BYTES);
    if (!fill(preamble, 0) || preamble.getLong(0) != Block.MAGIC) {
      throw new RecordingException(name + " is no recording: it doesn't begin with CAROMREC");
    }
    int version = preamble.getInt(8);
    if (version < Block.OLDEST_VERSION || version > Block.VERSION) {
      throw new RecordingException(
          name
              + " has format version="
              + version
              + ", this build reads "
              + Block.OLDEST_VERSION
              + ".."
              + Block.VERSION
              + "; play it with the build that recorded it");
    }
    position = Block.PREAMBLE_BYTES;
    if (!nextBlock()) {
      throw new RecordingException(name + " ends before its header does; nothing can be played");
    }
    if (type != Block.HEADER) {
      throw damaged("the first block is " + type + " instead of HEADER");
    }
    try {
      header = RecordingHeader.read(block);
    } catch (RecordingException e) {
      throw damaged(e.getMessage());
    }
    requireBlockEnd();
  }

  /**
   * Opens a recording and reads its header.
   *
   * @throws RecordingException when the file is no recording, has another version or is damaged
   * @throws IOException when the file can't be read
   */
  public static RecordingReader open(Path file) throws IOException {
    SeekableByteChannel channel;
    try {
      channel = Files.newByteChannel(file);
    } catch (NoSuchFileException e) {
      throw new RecordingException("there is no file " + file);
    }
    try {
      return new RecordingReader(channel, String.valueOf(file.getFileName()));
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  /** Returns the header. */
  public RecordingHeader header() {
    return header;
  }

  /**
   * Reads the next event.
   *
   * @throws RecordingException when the file is damaged here; earlier events stay valid
   */
  public Entry next() throws IOException {
    if (ended) {
      return Entry.END;
    }
    Entry event = null;
    while (event == null) {
      while (block.isEmpty()) {
        if (!nextBlock()) {
          return Entry.WAIT;
        }
      }
      try {
        event =
            switch (type) {
              case HEADER -> throw new RecordingException("damaged: a second header");
              case TICKS -> readTicks();
              case KEYFRAME -> readKeyframe();
              case END -> readEnd();
              case STATE -> readState() ? Entry.STATE : null;
            };
      } catch (RecordingException e) {
        throw damaged(e.getMessage());
      }
    }
    return event;
  }

  /** Collects a piece of a state. Returns true with the last piece. */
  private boolean readState() throws RecordingException {
    int at = block.varint("offset of a state's piece", 0, Block.MAX_STATE_BYTES);
    int length = block.varint("bytes of a state", 1, Block.MAX_STATE_BYTES);
    int piece = block.left();
    if ((at == 0 ? 0 : collected) != at || at + piece > length) {
      throw new RecordingException(
          "damaged: a state's piece at " + at + " with " + piece + " bytes of " + length);
    }
    if (state.length < at + piece) {
      state = Arrays.copyOf(state, Math.max(at + piece, Math.min(length, 2 * state.length)));
    }
    System.arraycopy(block.bytes(piece), 0, state, at, piece);
    collected = at + piece;
    if (collected < length) {
      return false;
    }
    ByteSource in = new ByteSource();
    in.set(state, length);
    stateTick = in.varint("tick", 0, Integer.MAX_VALUE);
    hash = in.i64();
    int players = in.varint("players", 0, SimulationHost.MAX_PLAYERS);
    Arrays.fill(inputs, 0);
    Arrays.fill(viewDelays, 0);
    for (int id = 0; id < players; id++) {
      inputs[id] = in.varint();
      viewDelays[id] = in.varint("view delay", 0, HostPlayer.MAX_VIEW_DELAY);
    }
    sums.clear();
    Arrays.fill(keyStates, 0);
    stateBegin = length - in.left();
    collected = 0;
    stateEnd = length;
    return true;
  }

  private Entry readTicks() throws RecordingException {
    int tag = block.u8();
    switch (tag) {
      case Block.JOIN, Block.WATCH:
        return readNewcomer(tag, "", null);
      case Block.ACCOUNT:
        String account = block.text("account", 4 * Newcomer.MAX_ACCOUNT);
        if (account.length() > Newcomer.MAX_ACCOUNT) {
          throw new RecordingException("damaged: an account of characters=" + account.length());
        }
        int[] lasting = readValues();
        return readNewcomer(block.u8(), account, lasting);
      case Block.KEEP:
        playerId = block.varint("player", 0, SimulationHost.MAX_PLAYERS - 1);
        kept = readValues();
        return Entry.KEEP;
      case Block.ROLE:
        playerId = block.varint("player", 0, SimulationHost.MAX_PLAYERS - 1);
        role = PlayerRole.values()[block.varint("role", 0, PlayerRole.values().length - 1)];
        return Entry.ROLE;
      case Block.LEAVE:
        playerId = block.varint("player", 0, SimulationHost.MAX_PLAYERS - 1);
        return Entry.LEAVE;
      case Block.MESSAGE:
        playerId = block.varint("player", 0, SimulationHost.MAX_PLAYERS - 1);
        message = block.bytes(block.varint("bytes of a message", 1, MessageKind.MAX_BYTES));
        return Entry.MESSAGE;
      case Block.TICK:
        changedCount = block.varint("changed inputs", 0, SimulationHost.MAX_PLAYERS);
        for (int i = 0; i < changedCount; i++) {
          int id = block.varint("player", 0, SimulationHost.MAX_PLAYERS - 1);
          changedIds[i] = id;
          inputs[id] ^= block.varint();
          long delay = block.varint();
          viewDelays[id] += (int) (delay >>> 1) ^ -((int) delay & 1);
        }
        return Entry.TICK;
      case Block.STEPPED:
        hash = block.i64();
        sums.weight ^= block.varint();
        sums.moment ^= block.varint();
        for (int f = 0; f < Fingerprint.FIELDS; f++) {
          sums.fields[f] ^= (int) block.varint();
        }
        return Entry.STEPPED;
      default:
        throw new RecordingException("damaged: unknown entry=" + tag);
    }
  }

  /** Reads what an account has kept, null for nothing. */
  private int[] readValues() throws RecordingException {
    int count = block.varint("values of an account", 0, Scope.ACCOUNT.mostWords());
    int[] values = count == 0 ? null : new int[count];
    for (int i = 0; i < count; i++) {
      long value = block.varint();
      values[i] = (int) (value >>> 1) ^ -((int) value & 1);
    }
    return values;
  }

  private Entry readNewcomer(int tag, String account, int[] values) throws RecordingException {
    if (tag != Block.JOIN && tag != Block.WATCH) {
      throw new RecordingException("damaged: an account is followed by entry=" + tag);
    }
    playerId = block.varint("player", 0, SimulationHost.MAX_PLAYERS - 1);
    newcomer = new Newcomer(block.text("player name", MAX_NAME_BYTES), account, values);
    inputs[playerId] = 0;
    viewDelays[playerId] = 0;
    return tag == Block.JOIN ? Entry.JOIN : Entry.WATCH;
  }

  private Entry readKeyframe() throws RecordingException {
    keyframeTick = block.varint("tick", 0, Integer.MAX_VALUE);
    hash = block.i64();
    keyframeLimit = block.varint("entities", 0, SimulationHost.MAX_ENTITIES);
    if (kinds.length < keyframeLimit) {
      kinds = new int[keyframeLimit];
      generations = new int[keyframeLimit];
      keyStates = Arrays.copyOf(keyStates, keyframeLimit * Fingerprint.FIELDS);
    }
    for (int id = 0; id < keyframeLimit; id++) {
      kinds[id] = block.varint("archetype", 0, 65_536) - 1;
      generations[id] = block.u8();
    }
    for (int f = 0; f < Fingerprint.FIELDS; f++) {
      for (int id = 0; id < keyframeLimit; id++) {
        if (kinds[id] >= 0) {
          keyStates[id * Fingerprint.FIELDS + f] ^= block.i32();
        }
      }
    }
    if (!block.isEmpty()) {
      throw new RecordingException("damaged: a keyframe has bytes left over");
    }
    return Entry.KEYFRAME;
  }

  private Entry readEnd() throws IOException {
    cut = block.u8() != 0;
    reason = block.text("reason", MAX_REASON_BYTES);
    long more = file.size() - position + block.left();
    if (more > 0) {
      throw new RecordingException("damaged: " + more + " bytes follow the end");
    }
    ended = true;
    return Entry.END;
  }

  /** Reads the next block as a whole. Returns false when the file ends before the block does. */
  private boolean nextBlock() throws IOException {
    blockPosition = position;
    if (!fill(head.clear(), position)) {
      return false;
    }
    long size = file.size();
    Block found = Block.of(head.get(0));
    int length = head.getInt(1);
    int count = head.getInt(5);
    if (found == null || length < 1 || length > Block.MAX_BYTES || count < 1 || count > bound()) {
      if (isEmptyFrom(position + Block.HEAD_BYTES, size)) {
        return false;
      }
      throw damaged(
          "damaged: a block of type=" + head.get(0) + " length=" + length + " stored=" + count);
    }
    long end = position + Block.HEAD_BYTES + count;
    if (end > size) {
      return false;
    }
    if (stored.length < count) {
      stored = new byte[count];
    }
    if (!fill(ByteBuffer.wrap(stored, 0, count), position + Block.HEAD_BYTES)) {
      return false;
    }
    crc.reset();
    crc.update(head.array(), 0, Block.HEAD_BYTES - 4);
    crc.update(stored, 0, count);
    if ((int) crc.getValue() != head.getInt(Block.HEAD_BYTES - 4)) {
      if (isEmptyFrom(end, size)) {
        return false; // the last block, which is partly on the disk
      }
      throw damaged("damaged: a block's checksum is wrong");
    }
    inflate(length, count);
    type = found;
    position = end;
    return true;
  }

  /**
   * Returns whether only zeros follow. The disk then knows the file's length, but lacks the bytes.
   */
  private boolean isEmptyFrom(long from, long size) throws IOException {
    ByteBuffer chunk = ByteBuffer.allocate(1 << 13);
    for (long at = from; at < size; at += chunk.limit()) {
      chunk.clear().limit((int) Math.min(chunk.capacity(), size - at));
      if (!fill(chunk, at)) {
        return true;
      }
      for (int i = 0; i < chunk.limit(); i++) {
        if (chunk.get(i) != 0) {
          return false;
        }
      }
    }
    return true;
  }

  private static int bound() {
    return Block.MAX_BYTES + Block.MAX_BYTES / 1_000 + 64;
  }

  private void inflate(int length, int count) throws RecordingException {
    if (content.length < length) {
      content = new byte[length];
    }
    inflater.reset();
    inflater.setInput(stored, 0, count);
    try {
      int got = inflater.inflate(content, 0, length);
      boolean whole = got == length && (inflater.finished() || isFinished());
      if (!whole) {
        throw damaged("damaged: a block's content differs from its stored length=" + length);
      }
    } catch (DataFormatException e) {
      throw damaged("damaged: a block can't be decompressed");
    }
    block.set(content, length);
  }

  /**
   * Returns whether the compressed data ends here. The end mark may still be unread when all bytes
   * are decompressed.
   */
  private boolean isFinished() throws DataFormatException {
    return inflater.inflate(new byte[1]) == 0 && inflater.finished();
  }

  private boolean fill(ByteBuffer to, long from) throws IOException {
    file.position(from);
    while (to.hasRemaining()) {
      if (file.read(to) < 0) {
        return false;
      }
    }
    return true;
  }

  private void requireBlockEnd() throws RecordingException {
    if (!block.isEmpty()) {
      throw damaged("damaged: the header has bytes left over");
    }
  }

  private RecordingException damaged(String what) {
    return new RecordingException(name + ", block at byte " + blockPosition + ": " + what);
  }

  /** Returns the player who joins, leaves or has sent a message. */
  public int playerId() {
    return playerId;
  }

  /** Returns the player or spectator who enters. */
  public Newcomer newcomer() {
    return newcomer;
  }

  /** Returns what the account of a participant has kept, null for nothing; never changed. */
  public int[] kept() {
    return kept;
  }

  /** Returns the role that a participant gets. */
  public PlayerRole role() {
    return role;
  }

  /**
   * Returns the message that a player has sent, as {@link SimulationHost#messageKinds} codes it.
   */
  byte[] message() {
    return message;
  }

  /** Returns how many players' inputs or view delays changed at {@link Entry#TICK}. */
  public int changedCount() {
    return changedCount;
  }

  /** Returns the i-th player whose input or view delay changed. */
  public int changedId(int i) {
    return changedIds[i];
  }

  /** Returns a player's packed input, see {@link carom.sim.entity.Input#pack}. */
  public long input(int player) {
    return inputs[player];
  }

  /** Returns a player's view delay, in sixteenths of a tick. */
  public int viewDelay(int player) {
    return viewDelays[player];
  }

  /** Returns the state hash after the step, or at the keyframe or state. */
  public long hash() {
    return hash;
  }

  Fingerprint sums() {
    return sums;
  }

  /** Returns the tick of the last keyframe read. */
  public int keyframeTick() {
    return keyframeTick;
  }

  /** Returns the tick of the last state read. */
  public int stateTick() {
    return stateTick;
  }

  /**
   * Returns the last state read, for {@link SimulationHost#read}; valid until {@link #next} is
   * called.
   */
  ArchiveReader state() {
    return new ArchiveReader(Arrays.copyOfRange(state, stateBegin, stateEnd));
  }

  /**
   * Finds the last whole state at or before a tick that the file has so far. It reads only the
   * heads of the blocks between, and each head once.
   *
   * @return the state's tick, or -1 if there is none
   * @throws RecordingException when a block of a state on the way is damaged
   */
  public int findState(int tick) throws IOException {
    StatePlace place = place(tick);
    return place == null ? -1 : place.tick;
  }

  /**
   * Goes to the state that {@link #findState} finds for a tick; {@link Entry#STATE} comes next.
   *
   * @return false when there is none; nothing has changed then
   */
  boolean goToState(int tick) throws IOException {
    StatePlace place = place(tick);
    if (place != null) {
      goTo(place.position);
    }
    return place != null;
  }

  private StatePlace place(int tick) throws IOException {
    scan();
    StatePlace found = null;
    for (StatePlace place : places) {
      if (place.tick <= tick) {
        found = place;
      }
    }
    return found;
  }

  private void scan() throws IOException {
    long size = file.size();
    ByteBuffer at = ByteBuffer.allocate(Block.HEAD_BYTES);
    while (fill(at.clear(), scannedTo)) {
      int count = at.getInt(5);
      long end = scannedTo + Block.HEAD_BYTES + count;
      if (Block.of(at.get(0)) == null || count < 1 || count > bound() || end > size) {
        return; // cut off or damaged; the reader reports it when it gets there
      }
      if (Block.of(at.get(0)) == Block.STATE && !addState(scannedTo)) {
        return;
      }
      scannedTo = end;
    }
  }

  /** Adds a block's state to those found. Returns false when the block isn't whole. */
  private boolean addState(long where) throws IOException {
    long back = position;
    byte[] unread = block.isEmpty() ? new byte[0] : block.bytes(block.left());
    Block backType = type;
    long backBlock = blockPosition;
    position = where;
    boolean whole = nextBlock();
    if (whole) {
      int at = block.varint("offset of a state's piece", 0, Block.MAX_STATE_BYTES);
      int length = block.varint("bytes of a state", 1, Block.MAX_STATE_BYTES);
      int piece = block.left();
      if (at == 0) {
        begun = new StatePlace(block.varint("tick", 0, Integer.MAX_VALUE), where);
      }
      if (at + piece == length && begun != null) {
        places.add(begun);
        begun = null;
      }
    }
    position = back;
    type = backType;
    blockPosition = backBlock;
    block.set(unread, unread.length);
    return whole;
  }

  private void goTo(long where) {
    position = where;
    block.set(content, 0);
    collected = 0;
    ended = false;
  }

  /** Returns the limit of the keyframe's entity ids, exclusive. */
  int keyframeLimit() {
    return keyframeLimit;
  }

  /** Returns the archetype index of an entity in the keyframe, or -1 if there is no such entity. */
  int kind(int id) {
    return id < keyframeLimit ? kinds[id] : -1;
  }

  int generation(int id) {
    return generations[id];
  }

  /** Copies an entity's exact state in the keyframe. */
  void keyState(int id, int[] out) {
    System.arraycopy(keyStates, id * Fingerprint.FIELDS, out, 0, Fingerprint.FIELDS);
  }

  /** Returns whether the recording ended because the recorder could not keep up. */
  public boolean isCut() {
    return cut;
  }

  /** Returns why the recording ended. */
  public String reason() {
    return reason;
  }

  /** Returns the number of bytes after the last whole block, at {@link Entry#WAIT}. */
  public long tornBytes() throws IOException {
    return file.size() - position;
  }

  /** Returns whether the reader is between two blocks, where {@link #mark} is possible. */
  public boolean isBetweenBlocks() {
    return block.isEmpty() && collected == 0;
  }

  /** Returns whether the next block is a state or a piece of one. Its head is enough to tell. */
  boolean isStateNext() throws IOException {
    return block.isEmpty() && fill(head.clear(), position) && Block.of(head.get(0)) == Block.STATE;
  }

  /**
   * Marks this place. It is possible only between two blocks, as after a keyframe.
   *
   * @throws IllegalStateException when the reader is within a block
   */
  public Position mark() {
    if (!block.isEmpty()) {
      throw new IllegalStateException("a mark can be set between two blocks only");
    }
    return new Position(this);
  }

  /** Goes back to a mark of this reader. */
  public void reset(Position mark) {
    goTo(mark.position);
    System.arraycopy(mark.inputs, 0, inputs, 0, inputs.length);
    System.arraycopy(mark.viewDelays, 0, viewDelays, 0, viewDelays.length);
    sums.set(mark.sums);
    keyStates = Arrays.copyOf(mark.keyStates, keyStates.length);
  }

  @Override
  public void close() throws IOException {
    inflater.end();
    file.close();
  }
}
