package carom.net.kryo;

import carom.net.kryo.message.MessageSerializer;
import carom.net.kryo.message.RedirectSerializer;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ClientMessageCodec;
import carom.net.protocol.DatagramMark;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Limits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.GameMessage;
import carom.net.protocol.ServerMessage.Goodbye;
import carom.net.protocol.ServerMessage.Heard;
import carom.net.protocol.ServerMessage.LevelChunk;
import carom.net.protocol.ServerMessage.Notice;
import carom.net.protocol.ServerMessage.Pace;
import carom.net.protocol.ServerMessage.PoolChunk;
import carom.net.protocol.ServerMessage.RecordingChunk;
import carom.net.protocol.ServerMessage.Redirect;
import carom.net.protocol.ServerMessage.Refused;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.protocol.ServerMessage.RoomList;
import carom.net.protocol.ServerMessage.Roster;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.net.protocol.ServerMessage.Watching;
import carom.net.protocol.ServerMessage.Welcome;
import carom.net.transport.MessageCodec;
import com.esotericsoftware.kryo.Kryo;
import com.esotericsoftware.kryo.KryoException;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.KryoBufferUnderflowException;
import com.esotericsoftware.kryo.io.Output;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Codec of the protocol's messages: Kryo for those from the server, the fixed layout of {@link
 * ClientMessageCodec} for those from the client. The first byte tells them apart: Kryo's class ids
 * start at {@code 0x40}, and client tags are below. Any thread may use it. It has one Kryo behind
 * one lock, because messages are rare.
 *
 * <p>Each message has its own serializer, so that this code defines the wire format, and each
 * length is checked before anything is allocated. Numbers are Kryo's: little-endian, lengths
 * variable. A string is a length in bytes followed by UTF-8.
 */
public final class KryoMessageCodec implements MessageCodec {
  private static final int FIRST_SERVER_BYTE = 0x40;
  private static final RefusalReason[] REFUSALS = RefusalReason.values();
  private static final GoodbyeReason[] GOODBYES = GoodbyeReason.values();

  static {
    Setup.ensure();
  }

  private final Kryo kryo = new Kryo();
  private final Output output = new Output(512, Limits.MAX_SERVER_MESSAGE_BYTES);
  private final FrameInput input = new FrameInput();
  private final int classes;

  /** Creates a codec. One is enough for a transport. */
  public KryoMessageCodec() {
    kryo.setRegistrationRequired(true);
    kryo.setReferences(false);
    kryo.setMaxDepth(2);
    int id = FIRST_SERVER_BYTE - 2; // Kryo writes id + 2
    kryo.register(Welcome.class, new WelcomeSerializer(), id++);
    kryo.register(LevelChunk.class, new LevelChunkSerializer(), id++);
    kryo.register(Refused.class, new RefusedSerializer(), id++);
    kryo.register(Roster.class, new RosterSerializer(), id++);
    kryo.register(Notice.class, new NoticeSerializer(), id++);
    kryo.register(Goodbye.class, new GoodbyeSerializer(), id++);
    kryo.register(Watching.class, new WatchingSerializer(), id++);
    kryo.register(RecordingChunk.class, new RecordingChunkSerializer(), id++);
    kryo.register(GameMessage.class, new GameMessageSerializer(), id++);
    kryo.register(Heard.class, new HeardSerializer(), id++);
    kryo.register(RoomList.class, new RoomListSerializer(), id++);
    kryo.register(PoolChunk.class, new PoolChunkSerializer(), id++);
    kryo.register(Pace.class, new PaceSerializer(), id++);
    kryo.register(Redirect.class, new RedirectSerializer(), id++);
    classes = id + 2 - FIRST_SERVER_BYTE;
  }

  @Override
  public byte[] encode(Object message) {
    if (message instanceof ClientMessage client) {
      return ClientMessageCodec.encode(client);
    }
    if (!(message instanceof ServerMessage)) {
      throw new IllegalArgumentException(
          "message="
              + (message == null ? "null" : message.getClass().getName())
              + " must be a ClientMessage or a ServerMessage");
    }
    synchronized (kryo) {
      output.reset();
      try {
        kryo.writeClassAndObject(output, message);
      } catch (KryoException x) {
        throw new IllegalArgumentException(
            message.getClass().getSimpleName()
                + " can't be encoded within "
                + Limits.MAX_SERVER_MESSAGE_BYTES
                + " bytes: "
                + x.getMessage(),
            x);
      }
      return output.toBytes();
    }
  }

  @Override
  public Object decode(byte[] bytes, int offset, int length) {
    if (length < 1) {
      return null;
    }
    return bytes[offset] < FIRST_SERVER_BYTE
        ? ClientMessageCodec.decode(bytes, offset, length)
        : decodeFromServer(bytes, offset, length);
  }

  /** Reads a message on the client as {@link #decode} does, but accepts only server messages. */
  ServerMessage decodeFromServer(byte[] bytes, int offset, int length) {
    // Only our own classes reach Kryo, because its built-in ones read unbounded lengths, and id 1
    // names a class.
    if (length < 1
        || length > Limits.MAX_SERVER_MESSAGE_BYTES
        || bytes[offset] < FIRST_SERVER_BYTE
        || bytes[offset] >= FIRST_SERVER_BYTE + classes) {
      return null;
    }
    synchronized (kryo) {
      try {
        input.wrap(bytes, offset, length);
        Object message = kryo.readClassAndObject(input);
        return input.position() == input.limit() ? (ServerMessage) message : null;
      } catch (RuntimeException x) { // truncated, or outside a limit
        return null;
      } finally {
        input.release();
      }
    }
  }

  /**
   * Input that reads one frame in place. It never reads past the end of the frame, and it never
   * moves the bytes, which Kryo's Input does at the end.
   */
  private static final class FrameInput extends Input {
    private static final byte[] NOTHING = {};

    void wrap(byte[] bytes, int offset, int length) {
      setBuffer(bytes, offset, length);
    }

    void release() {
      setBuffer(NOTHING, 0, 0);
    }

    @Override
    protected int require(int required) {
      int remaining = limit - position;
      if (remaining < required) {
        throw new KryoBufferUnderflowException("required=" + required + " remaining=" + remaining);
      }
      return remaining;
    }
  }

  private static final class WelcomeSerializer extends MessageSerializer<Welcome> {
    @Override
    protected void write(Output out, Welcome m) {
      out.writeLong(m.sessionSecret());
      out.writeByte(DatagramMark.checkedEpoch(m.epoch()));
      out.writeVarInt(playerId(m.playerId()), true);
      out.writeByte(inRange("tickRate", m.tickRate(), Limits.MIN_TICK_RATE, Limits.MAX_TICK_RATE));
      writeText(out, "room", m.room(), Limits.MAX_ROOM_NAME_BYTES);
      out.writeVarInt(inRange("match", m.match(), 1, Integer.MAX_VALUE), true);
      out.writeInt(m.incarnation());
      out.writeInt(m.courseTick());
      out.writeInt(m.tick());
      out.writeLong(m.seed());
      writeText(out, "game", m.game(), Limits.MAX_GAME_NAME_BYTES);
      writeText(out, "levelName", m.levelName(), Limits.MAX_LEVEL_NAME_BYTES);
      out.writeLong(m.levelHash());
      out.writeVarInt(inRange("levelSize", m.levelSize(), 0, Limits.MAX_LEVEL_BYTES), true);
      out.writeVarInt(inRange("packedSize", m.packedSize(), 0, Limits.MAX_LEVEL_BYTES), true);
      out.writeLong(m.declarationsDigest());
      out.writeVarInt(inRange("fields", m.declarations().size(), 0, Limits.MAX_DECLARATIONS), true);
      for (String line : m.declarations()) {
        writeText(out, "field", line, Limits.MAX_DECLARATION_BYTES);
      }
    }

    @Override
    protected Welcome read(Input in) {
      return new Welcome(
          in.readLong(),
          inRange("epoch", in.readByteUnsigned(), 0, DatagramMark.LAST_EPOCH),
          playerId(in.readVarInt(true)),
          inRange("tickRate", in.readByteUnsigned(), Limits.MIN_TICK_RATE, Limits.MAX_TICK_RATE),
          readText(in, "room", Limits.MAX_ROOM_NAME_BYTES),
          inRange("match", in.readVarInt(true), 1, Integer.MAX_VALUE),
          in.readInt(),
          in.readInt(),
          in.readInt(),
          in.readLong(),
          readText(in, "game", Limits.MAX_GAME_NAME_BYTES),
          readText(in, "levelName", Limits.MAX_LEVEL_NAME_BYTES),
          in.readLong(),
          inRange("levelSize", in.readVarInt(true), 0, Limits.MAX_LEVEL_BYTES),
          inRange("packedSize", in.readVarInt(true), 0, Limits.MAX_LEVEL_BYTES),
          in.readLong(),
          fields(in));
    }

    private static List<String> fields(Input in) {
      int count = inRange("fields", in.readVarInt(true), 0, Limits.MAX_DECLARATIONS);
      List<String> lines = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        lines.add(readText(in, "field", Limits.MAX_DECLARATION_BYTES));
      }
      return lines;
    }
  }

  private static final class LevelChunkSerializer extends MessageSerializer<LevelChunk> {
    @Override
    protected void write(Output out, LevelChunk m) {
      out.writeVarInt(inRange("offset", m.offset(), 0, Limits.MAX_LEVEL_BYTES - 1), true);
      out.writeVarInt(inRange("bytes", m.bytes().length, 1, Limits.MAX_LEVEL_CHUNK_BYTES), true);
      out.writeBytes(m.bytes());
    }

    @Override
    protected LevelChunk read(Input in) {
      int offset = inRange("offset", in.readVarInt(true), 0, Limits.MAX_LEVEL_BYTES - 1);
      int length = inRange("bytes", in.readVarInt(true), 1, Limits.MAX_LEVEL_CHUNK_BYTES);
      return new LevelChunk(offset, readBytes(in, length));
    }
  }

  private static final class RefusedSerializer extends MessageSerializer<Refused> {
    @Override
    @SuppressWarnings("EnumOrdinal") // the order is part of the protocol
    protected void write(Output out, Refused m) {
      out.writeByte(m.reason().ordinal());
      writeText(out, "text", m.text(), Limits.MAX_TEXT_BYTES);
    }

    @Override
    protected Refused read(Input in) {
      int reason = inRange("reason", in.readByteUnsigned(), 0, REFUSALS.length - 1);
      return new Refused(REFUSALS[reason], readText(in, "text", Limits.MAX_TEXT_BYTES));
    }
  }

  private static final class RosterSerializer extends MessageSerializer<Roster> {
    private static final int MIN_ENTRY_BYTES = 1 + 1;
    private static final int SPECTATOR = 1;
    private static final int READY = 1 << 1;
    private static final int ALIVE = 1 << 2;
    private static final int COLOUR_SHIFT = 3;

    @Override
    protected void write(Output out, Roster m) {
      out.writeVarInt(inRange("entries", m.entries().size(), 0, Limits.MAX_ROSTER_ENTRIES), true);
      for (RosterEntry entry : m.entries()) {
        out.writeVarInt(playerId(entry.playerId()), true);
        writeText(out, "name", entry.name(), Limits.MAX_NAME_BYTES);
        if (!entry.hasGone()) {
          writeStanding(out, entry);
        }
      }
    }

    private static void writeStanding(Output out, RosterEntry entry) {
      int spectator = entry.spectator() ? SPECTATOR : 0;
      int ready = entry.ready() ? READY : 0;
      int alive = entry.alive() ? ALIVE : 0;
      int colour = inRange("colour", entry.colour(), 0, RosterEntry.MAX_COLOUR);
      out.writeByte(spectator | ready | alive | colour << COLOUR_SHIFT);
      out.writeVarInt(entry.team(), false);
      out.writeVarInt(entry.score(), false);
      out.writeVarInt(inRange("ping", entry.pingMs(), 0, RosterEntry.MAX_PING_MS), true);
    }

    @Override
    protected Roster read(Input in) {
      int most =
          Math.min(Limits.MAX_ROSTER_ENTRIES, (in.limit() - in.position()) / MIN_ENTRY_BYTES);
      int count = inRange("entries", in.readVarInt(true), 0, most);
      List<RosterEntry> entries = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        entries.add(readEntry(in));
      }
      return new Roster(List.copyOf(entries));
    }

    private static RosterEntry readEntry(Input in) {
      int id = playerId(in.readVarInt(true));
      String name = readText(in, "name", Limits.MAX_NAME_BYTES);
      if (name.isEmpty()) {
        return RosterEntry.gone(id);
      }
      int standing = in.readByteUnsigned();
      return new RosterEntry(
          id,
          name,
          in.readVarInt(false),
          in.readVarInt(false),
          (standing & SPECTATOR) != 0,
          (standing & READY) != 0,
          (standing & ALIVE) != 0,
          inRange("ping", in.readVarInt(true), 0, RosterEntry.MAX_PING_MS),
          standing >> COLOUR_SHIFT);
    }
  }

  private static final class PaceSerializer extends MessageSerializer<Pace> {
    @Override
    protected void write(Output out, Pace m) {
      out.writeByte(m.percent());
    }

    @Override
    protected Pace read(Input in) {
      return new Pace(inRange("percent", in.readByte(), 1, 100));
    }
  }

  private static final class NoticeSerializer extends MessageSerializer<Notice> {
    @Override
    protected void write(Output out, Notice m) {
      writeText(out, "text", m.text(), Limits.MAX_TEXT_BYTES);
    }

    @Override
    protected Notice read(Input in) {
      return new Notice(readText(in, "text", Limits.MAX_TEXT_BYTES));
    }
  }

  private static final class GoodbyeSerializer extends MessageSerializer<Goodbye> {
    @Override
    @SuppressWarnings("EnumOrdinal") // the order is part of the protocol
    protected void write(Output out, Goodbye m) {
      out.writeByte(m.reason().ordinal());
      writeText(out, "text", m.text(), Limits.MAX_TEXT_BYTES);
    }

    @Override
    protected Goodbye read(Input in) {
      int reason = inRange("reason", in.readByteUnsigned(), 0, GOODBYES.length - 1);
      return new Goodbye(GOODBYES[reason], readText(in, "text", Limits.MAX_TEXT_BYTES));
    }
  }

  private static final class WatchingSerializer extends MessageSerializer<Watching> {
    @Override
    protected void write(Output out, Watching m) {
      out.writeVarInt(inRange("delaySeconds", m.delaySeconds(), 1, 65_535), true);
    }

    @Override
    protected Watching read(Input in) {
      return new Watching(inRange("delaySeconds", in.readVarInt(true), 1, 65_535));
    }
  }

  private static final class RecordingChunkSerializer extends MessageSerializer<RecordingChunk> {
    @Override
    protected void write(Output out, RecordingChunk m) {
      out.writeLong(notNegative(m.offset()));
      out.writeVarInt(inRange("bytes", m.bytes().length, 0, Limits.MAX_LEVEL_CHUNK_BYTES), true);
      out.writeBytes(m.bytes());
    }

    @Override
    protected RecordingChunk read(Input in) {
      long offset = notNegative(in.readLong());
      int length = inRange("bytes", in.readVarInt(true), 0, Limits.MAX_LEVEL_CHUNK_BYTES);
      return new RecordingChunk(offset, readBytes(in, length));
    }

    private static long notNegative(long offset) {
      if (offset < 0) {
        throw new IllegalArgumentException("offset=" + offset + " is negative");
      }
      return offset;
    }
  }

  private static final class PoolChunkSerializer extends MessageSerializer<PoolChunk> {
    @Override
    protected void write(Output out, PoolChunk m) {
      out.writeVarInt(inRange("size", m.size(), 1, Limits.MAX_POOL_STATE_BYTES), true);
      out.writeVarInt(inRange("offset", m.offset(), 0, m.size() - 1), true);
      out.writeVarInt(inRange("bytes", m.bytes().length, 1, Limits.MAX_LEVEL_CHUNK_BYTES), true);
      out.writeBytes(m.bytes());
    }

    @Override
    protected PoolChunk read(Input in) {
      int size = inRange("size", in.readVarInt(true), 1, Limits.MAX_POOL_STATE_BYTES);
      int offset = inRange("offset", in.readVarInt(true), 0, size - 1);
      int most = Math.min(Limits.MAX_LEVEL_CHUNK_BYTES, size - offset);
      return new PoolChunk(
          size, offset, readBytes(in, inRange("bytes", in.readVarInt(true), 1, most)));
    }
  }

  private static final class GameMessageSerializer extends MessageSerializer<GameMessage> {
    @Override
    protected void write(Output out, GameMessage m) {
      out.writeVarInt(m.number(), true);
      out.writeVarInt(inRange("bytes", m.bytes().length, 1, Limits.MAX_GAME_MESSAGE_BYTES), true);
      out.writeBytes(m.bytes());
    }

    @Override
    protected GameMessage read(Input in) {
      int number = inRange("number", in.readVarInt(true), 1, Integer.MAX_VALUE);
      int length = inRange("bytes", in.readVarInt(true), 1, Limits.MAX_GAME_MESSAGE_BYTES);
      return new GameMessage(number, readBytes(in, length));
    }
  }

  private static final class HeardSerializer extends MessageSerializer<Heard> {
    @Override
    protected void write(Output out, Heard m) {
      out.writeVarInt(inRange("number", m.number(), 0, Integer.MAX_VALUE), true);
    }

    @Override
    protected Heard read(Input in) {
      return new Heard(inRange("number", in.readVarInt(true), 0, Integer.MAX_VALUE));
    }
  }

  private static final class RoomListSerializer extends MessageSerializer<RoomList> {
    private static final int MAX_ROOMS = 0xffff;
    private static final int MAX_COUNT = 0xffff;

    @Override
    protected void write(Output out, RoomList m) {
      out.writeVarInt(inRange("left", m.left(), 0, MAX_ROOMS), true);
      out.writeVarInt(inRange("rooms", m.rooms().size(), 0, Limits.MAX_LISTED_ROOMS), true);
      for (RoomEntry room : m.rooms()) {
        writeText(out, "name", room.name(), Limits.MAX_ROOM_NAME_BYTES);
        writeText(out, "game", room.game(), Limits.MAX_GAME_NAME_BYTES);
        writeText(out, "level", room.level(), Limits.MAX_LEVEL_NAME_BYTES);
        writeText(out, "phase", room.phase(), Limits.MAX_PHASE_BYTES);
        out.writeVarInt(inRange("players", room.players(), 0, Limits.MAX_PLAYERS), true);
        out.writeVarInt(inRange("places", room.places(), 0, Limits.MAX_PLAYERS), true);
        out.writeVarInt(inRange("spectators", room.spectators(), 0, MAX_COUNT), true);
        Map<String, String> metadata = room.metadata();
        out.writeVarInt(inRange("metadata", metadata.size(), 0, Limits.MAX_ROOM_METADATA), true);
        metadata.forEach(
            (key, value) -> {
              writeText(out, "key", key, Limits.MAX_METADATA_KEY_BYTES);
              writeText(out, "value", value, Limits.MAX_METADATA_VALUE_BYTES);
            });
      }
    }

    @Override
    protected RoomList read(Input in) {
      int left = inRange("left", in.readVarInt(true), 0, MAX_ROOMS);
      int count = inRange("rooms", in.readVarInt(true), 0, Limits.MAX_LISTED_ROOMS);
      List<RoomEntry> rooms = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        rooms.add(
            new RoomEntry(
                readText(in, "name", Limits.MAX_ROOM_NAME_BYTES),
                readText(in, "game", Limits.MAX_GAME_NAME_BYTES),
                readText(in, "level", Limits.MAX_LEVEL_NAME_BYTES),
                readText(in, "phase", Limits.MAX_PHASE_BYTES),
                inRange("players", in.readVarInt(true), 0, Limits.MAX_PLAYERS),
                inRange("places", in.readVarInt(true), 0, Limits.MAX_PLAYERS),
                inRange("spectators", in.readVarInt(true), 0, MAX_COUNT),
                metadata(in)));
      }
      return new RoomList(left, rooms);
    }

    private static Map<String, String> metadata(Input in) {
      int count = inRange("metadata", in.readVarInt(true), 0, Limits.MAX_ROOM_METADATA);
      Map<String, String> metadata = new LinkedHashMap<>();
      for (int i = 0; i < count; i++) {
        String key = readText(in, "key", Limits.MAX_METADATA_KEY_BYTES);
        metadata.put(key, readText(in, "value", Limits.MAX_METADATA_VALUE_BYTES));
      }
      return Collections.unmodifiableMap(metadata);
    }
  }
}
