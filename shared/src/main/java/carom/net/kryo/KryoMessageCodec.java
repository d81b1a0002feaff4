package carom.net.kryo;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ClientMessageCodec;
import carom.net.protocol.DatagramMark;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.BestEntry;
import carom.net.protocol.ServerMessage.BestList;
import carom.net.protocol.ServerMessage.BestLists;
import carom.net.protocol.ServerMessage.Fleet;
import carom.net.protocol.ServerMessage.GameMessage;
import carom.net.protocol.ServerMessage.Goodbye;
import carom.net.protocol.ServerMessage.Heard;
import carom.net.protocol.ServerMessage.LevelAnswer;
import carom.net.protocol.ServerMessage.LevelChunk;
import carom.net.protocol.ServerMessage.LevelEntry;
import carom.net.protocol.ServerMessage.LevelList;
import carom.net.protocol.ServerMessage.LevelOutcome;
import carom.net.protocol.ServerMessage.Move;
import carom.net.protocol.ServerMessage.Notice;
import carom.net.protocol.ServerMessage.Pace;
import carom.net.protocol.ServerMessage.PlayPage;
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
  private static final LevelOutcome[] OUTCOMES = LevelOutcome.values();
  private static final int MAX_PORT = 65_535;

  static {
    Setup.ensure();
  }

  private final Kryo kryo = new Kryo();
  private final Output output = new Output(512, ProtocolLimits.MAX_SERVER_MESSAGE_BYTES);
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
    kryo.register(Fleet.class, new FleetSerializer(), id++);
    kryo.register(Move.class, new MoveSerializer(), id++);
    kryo.register(BestLists.class, new BestListsSerializer(), id++);
    kryo.register(PlayPage.class, new PlayPageSerializer(), id++);
    kryo.register(LevelAnswer.class, new LevelAnswerSerializer(), id++);
    kryo.register(LevelList.class, new LevelListSerializer(), id++);
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
                + ProtocolLimits.MAX_SERVER_MESSAGE_BYTES
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
        || length > ProtocolLimits.MAX_SERVER_MESSAGE_BYTES
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
      out.writeByte(
          inRange(
              "tickRate",
              m.tickRate(),
              ProtocolLimits.MIN_TICK_RATE,
              ProtocolLimits.MAX_TICK_RATE));
      writeText(out, "room", m.room(), ProtocolLimits.MAX_ROOM_NAME_BYTES);
      writeInt(out, "match", m.match(), 1, Integer.MAX_VALUE);
      out.writeLong(m.claim());
      out.writeInt(m.incarnation());
      out.writeInt(m.courseTick());
      out.writeInt(m.tick());
      out.writeLong(m.seed());
      writeText(out, "game", m.game(), ProtocolLimits.MAX_GAME_NAME_BYTES);
      writeText(out, "levelName", m.levelName(), ProtocolLimits.MAX_LEVEL_NAME_BYTES);
      out.writeLong(m.levelHash());
      writeInt(out, "levelSize", m.levelSize(), 0, ProtocolLimits.MAX_LEVEL_BYTES);
      writeInt(out, "packedSize", m.packedSize(), 0, ProtocolLimits.MAX_LEVEL_BYTES);
      out.writeLong(m.declarationsDigest());
      out.writeLong(m.gameDigest());
      out.writeBoolean(m.takesAnyCode());
      writeInt(out, "fields", m.declarations().size(), 0, ProtocolLimits.MAX_DECLARATIONS);
      for (String line : m.declarations()) {
        writeText(out, "field", line, ProtocolLimits.MAX_DECLARATION_BYTES);
      }
    }

    @Override
    protected Welcome read(Input in) {
      return new Welcome(
          in.readLong(),
          inRange("epoch", in.readByteUnsigned(), 0, DatagramMark.LAST_EPOCH),
          playerId(in.readVarInt(true)),
          inRange(
              "tickRate",
              in.readByteUnsigned(),
              ProtocolLimits.MIN_TICK_RATE,
              ProtocolLimits.MAX_TICK_RATE),
          readText(in, "room", ProtocolLimits.MAX_ROOM_NAME_BYTES),
          readInt(in, "match", 1, Integer.MAX_VALUE),
          in.readLong(),
          in.readInt(),
          in.readInt(),
          in.readInt(),
          in.readLong(),
          readText(in, "game", ProtocolLimits.MAX_GAME_NAME_BYTES),
          readText(in, "levelName", ProtocolLimits.MAX_LEVEL_NAME_BYTES),
          in.readLong(),
          readInt(in, "levelSize", 0, ProtocolLimits.MAX_LEVEL_BYTES),
          readInt(in, "packedSize", 0, ProtocolLimits.MAX_LEVEL_BYTES),
          in.readLong(),
          in.readLong(),
          inRange("takesAnyCode", in.readByteUnsigned(), 0, 1) == 1,
          fields(in));
    }

    private static List<String> fields(Input in) {
      int count = readInt(in, "fields", 0, ProtocolLimits.MAX_DECLARATIONS);
      List<String> lines = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        lines.add(readText(in, "field", ProtocolLimits.MAX_DECLARATION_BYTES));
      }
      return lines;
    }
  }

  private static final class LevelChunkSerializer extends MessageSerializer<LevelChunk> {
    @Override
    protected void write(Output out, LevelChunk m) {
      writeInt(out, "offset", m.offset(), 0, ProtocolLimits.MAX_LEVEL_BYTES - 1);
      writeBlock(out, m.bytes(), 1, ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
    }

    @Override
    protected LevelChunk read(Input in) {
      int offset = readInt(in, "offset", 0, ProtocolLimits.MAX_LEVEL_BYTES - 1);
      return new LevelChunk(offset, readBlock(in, 1, ProtocolLimits.MAX_LEVEL_CHUNK_BYTES));
    }
  }

  private static final class RefusedSerializer extends MessageSerializer<Refused> {
    @Override
    @SuppressWarnings("EnumOrdinal") // the order is part of the protocol
    protected void write(Output out, Refused m) {
      out.writeByte(m.reason().ordinal());
      writeText(out, "text", m.text(), ProtocolLimits.MAX_TEXT_BYTES);
    }

    @Override
    protected Refused read(Input in) {
      int reason = inRange("reason", in.readByteUnsigned(), 0, REFUSALS.length - 1);
      return new Refused(REFUSALS[reason], readText(in, "text", ProtocolLimits.MAX_TEXT_BYTES));
    }
  }

  private static final class RosterSerializer extends MessageSerializer<Roster> {
    private static final int MIN_ENTRY_BYTES = 1 + 1;
    private static final int SPECTATOR = 1;
    private static final int READY = 1 << 1;
    private static final int ALIVE = 1 << 2;
    private static final int COLOUR = 3;

    @Override
    protected void write(Output out, Roster m) {
      writeInt(out, "entries", m.entries().size(), 0, ProtocolLimits.MAX_ROSTER_ENTRIES);
      for (RosterEntry entry : m.entries()) {
        out.writeVarInt(playerId(entry.playerId()), true);
        writeText(out, "name", entry.name(), ProtocolLimits.MAX_NAME_BYTES);
        if (!entry.hasGone()) {
          writeStanding(out, entry);
        }
      }
    }

    private static void writeStanding(Output out, RosterEntry entry) {
      int flags = (entry.spectator() ? SPECTATOR : 0) | (entry.ready() ? READY : 0);
      flags |= entry.alive() ? ALIVE : 0;
      out.writeByte(flags | inRange("colour", entry.colour(), 0, RosterEntry.MAX_COLOUR) << COLOUR);
      out.writeVarInt(entry.team(), false);
      out.writeVarInt(entry.score(), false);
      writeInt(out, "ping", entry.pingMs(), 0, RosterEntry.MAX_PING_MS);
    }

    @Override
    protected Roster read(Input in) {
      int most =
          Math.min(
              ProtocolLimits.MAX_ROSTER_ENTRIES, (in.limit() - in.position()) / MIN_ENTRY_BYTES);
      int count = readInt(in, "entries", 0, most);
      List<RosterEntry> entries = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        entries.add(readEntry(in));
      }
      return new Roster(List.copyOf(entries));
    }

    private static RosterEntry readEntry(Input in) {
      int id = playerId(in.readVarInt(true));
      String name = readText(in, "name", ProtocolLimits.MAX_NAME_BYTES);
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
          readInt(in, "ping", 0, RosterEntry.MAX_PING_MS),
          standing >> COLOUR);
    }
  }

  private static final class PaceSerializer extends MessageSerializer<Pace> {
    @Override
    protected void write(Output out, Pace m) {
      out.writeByte(inRange("percent", m.percent(), 1, 100));
      out.writeByte(m.viewsNarrow() ? 1 : 0);
    }

    @Override
    protected Pace read(Input in) {
      int percent = inRange("percent", in.readByte(), 1, 100);
      return new Pace(percent, inRange("viewsNarrow", in.readByte(), 0, 1) == 1);
    }
  }

  private static final class PlayPageSerializer extends MessageSerializer<PlayPage> {
    @Override
    protected void write(Output out, PlayPage m) {
      writeInt(out, "port", m.port(), 1, MAX_PORT);
      out.writeByte(m.encrypted() ? 1 : 0);
    }

    @Override
    protected PlayPage read(Input in) {
      int port = readInt(in, "port", 1, MAX_PORT);
      return new PlayPage(port, inRange("encrypted", in.readByte(), 0, 1) == 1);
    }
  }

  private static final class NoticeSerializer extends MessageSerializer<Notice> {
    @Override
    protected void write(Output out, Notice m) {
      writeText(out, "text", m.text(), ProtocolLimits.MAX_TEXT_BYTES);
    }

    @Override
    protected Notice read(Input in) {
      return new Notice(readText(in, "text", ProtocolLimits.MAX_TEXT_BYTES));
    }
  }

  private static final class GoodbyeSerializer extends MessageSerializer<Goodbye> {
    @Override
    @SuppressWarnings("EnumOrdinal") // the order is part of the protocol
    protected void write(Output out, Goodbye m) {
      out.writeByte(m.reason().ordinal());
      writeText(out, "text", m.text(), ProtocolLimits.MAX_TEXT_BYTES);
    }

    @Override
    protected Goodbye read(Input in) {
      int reason = inRange("reason", in.readByteUnsigned(), 0, GOODBYES.length - 1);
      return new Goodbye(GOODBYES[reason], readText(in, "text", ProtocolLimits.MAX_TEXT_BYTES));
    }
  }

  private static final class WatchingSerializer extends MessageSerializer<Watching> {
    @Override
    protected void write(Output out, Watching m) {
      writeInt(out, "delaySeconds", m.delaySeconds(), 1, 65_535);
    }

    @Override
    protected Watching read(Input in) {
      return new Watching(readInt(in, "delaySeconds", 1, 65_535));
    }
  }

  private static final class RecordingChunkSerializer extends MessageSerializer<RecordingChunk> {
    @Override
    protected void write(Output out, RecordingChunk m) {
      out.writeLong(notNegative(m.offset()));
      writeBlock(out, m.bytes(), 0, ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
    }

    @Override
    protected RecordingChunk read(Input in) {
      long offset = notNegative(in.readLong());
      return new RecordingChunk(offset, readBlock(in, 0, ProtocolLimits.MAX_LEVEL_CHUNK_BYTES));
    }

    private static long notNegative(long offset) {
      if (offset < 0) {
        throw new IllegalArgumentException("offset=" + offset + " is negative");
      }
      return offset;
    }
  }

  private static final class GameMessageSerializer extends MessageSerializer<GameMessage> {
    @Override
    protected void write(Output out, GameMessage m) {
      writeInt(out, "number", m.number(), 1, Integer.MAX_VALUE);
      writeBlock(out, m.bytes(), 1, ProtocolLimits.MAX_GAME_MESSAGE_BYTES);
    }

    @Override
    protected GameMessage read(Input in) {
      int number = readInt(in, "number", 1, Integer.MAX_VALUE);
      return new GameMessage(number, readBlock(in, 1, ProtocolLimits.MAX_GAME_MESSAGE_BYTES));
    }
  }

  private static final class HeardSerializer extends MessageSerializer<Heard> {
    @Override
    protected void write(Output out, Heard m) {
      writeInt(out, "number", m.number(), 0, Integer.MAX_VALUE);
    }

    @Override
    protected Heard read(Input in) {
      return new Heard(readInt(in, "number", 0, Integer.MAX_VALUE));
    }
  }

  private static final class RoomListSerializer extends MessageSerializer<RoomList> {
    private static final int MAX_ROOMS = 0xffff;
    private static final int MAX_COUNT = 0xffff;

    @Override
    protected void write(Output out, RoomList m) {
      writeInt(out, "left", m.left(), 0, MAX_ROOMS);
      writeInt(out, "rooms", m.rooms().size(), 0, ProtocolLimits.MAX_LISTED_ROOMS);
      for (RoomEntry room : m.rooms()) {
        writeText(out, "name", room.name(), ProtocolLimits.MAX_ROOM_NAME_BYTES);
        writeText(out, "game", room.game(), ProtocolLimits.MAX_GAME_NAME_BYTES);
        writeText(out, "level", room.level(), ProtocolLimits.MAX_LEVEL_NAME_BYTES);
        writeText(out, "phase", room.phase(), ProtocolLimits.MAX_PHASE_BYTES);
        writeInt(out, "players", room.players(), 0, ProtocolLimits.MAX_PLAYERS);
        writeInt(out, "places", room.places(), 0, ProtocolLimits.MAX_PLAYERS);
        writeInt(out, "spectators", room.spectators(), 0, MAX_COUNT);
        Map<String, String> metadata = room.metadata();
        writeInt(out, "metadata", metadata.size(), 0, ProtocolLimits.MAX_ROOM_METADATA);
        metadata.forEach(
            (key, value) -> {
              writeText(out, "key", key, ProtocolLimits.MAX_METADATA_KEY_BYTES);
              writeText(out, "value", value, ProtocolLimits.MAX_METADATA_VALUE_BYTES);
            });
      }
    }

    @Override
    protected RoomList read(Input in) {
      int left = readInt(in, "left", 0, MAX_ROOMS);
      int count = readInt(in, "rooms", 0, ProtocolLimits.MAX_LISTED_ROOMS);
      List<RoomEntry> rooms = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        rooms.add(
            new RoomEntry(
                readText(in, "name", ProtocolLimits.MAX_ROOM_NAME_BYTES),
                readText(in, "game", ProtocolLimits.MAX_GAME_NAME_BYTES),
                readText(in, "level", ProtocolLimits.MAX_LEVEL_NAME_BYTES),
                readText(in, "phase", ProtocolLimits.MAX_PHASE_BYTES),
                readInt(in, "players", 0, ProtocolLimits.MAX_PLAYERS),
                readInt(in, "places", 0, ProtocolLimits.MAX_PLAYERS),
                readInt(in, "spectators", 0, MAX_COUNT),
                metadata(in)));
      }
      return new RoomList(left, rooms);
    }

    private static Map<String, String> metadata(Input in) {
      int count = readInt(in, "metadata", 0, ProtocolLimits.MAX_ROOM_METADATA);
      Map<String, String> metadata = new LinkedHashMap<>();
      for (int i = 0; i < count; i++) {
        String key = readText(in, "key", ProtocolLimits.MAX_METADATA_KEY_BYTES);
        metadata.put(key, readText(in, "value", ProtocolLimits.MAX_METADATA_VALUE_BYTES));
      }
      return Collections.unmodifiableMap(metadata);
    }
  }

  private static final class BestListsSerializer extends MessageSerializer<BestLists> {
    @Override
    protected void write(Output out, BestLists m) {
      writeInt(out, "lists", m.lists().size(), 0, ProtocolLimits.MAX_BEST_LISTS);
      for (BestList list : m.lists()) {
        writeText(out, "field", list.field(), ProtocolLimits.MAX_FIELD_NAME_BYTES);
        int count = list.entries().size();
        writeInt(out, "entries", count, 0, ProtocolLimits.MAX_BEST_ENTRIES);
        writeInt(out, "own", list.own() + 1, 0, count);
        for (BestEntry entry : list.entries()) {
          writeText(out, "name", entry.name(), ProtocolLimits.MAX_NAME_BYTES);
          writeText(out, "value", entry.value(), ProtocolLimits.MAX_BEST_VALUE_BYTES);
        }
      }
    }

    @Override
    protected BestLists read(Input in) {
      int lists = readInt(in, "lists", 0, ProtocolLimits.MAX_BEST_LISTS);
      List<BestList> all = new ArrayList<>(lists);
      for (int i = 0; i < lists; i++) {
        String field = readText(in, "field", ProtocolLimits.MAX_FIELD_NAME_BYTES);
        int count = readInt(in, "entries", 0, ProtocolLimits.MAX_BEST_ENTRIES);
        int own = readInt(in, "own", 0, count) - 1;
        List<BestEntry> entries = new ArrayList<>(count);
        for (int j = 0; j < count; j++) {
          entries.add(
              new BestEntry(
                  readText(in, "name", ProtocolLimits.MAX_NAME_BYTES),
                  readText(in, "value", ProtocolLimits.MAX_BEST_VALUE_BYTES)));
        }
        all.add(new BestList(field, own, entries));
      }
      return new BestLists(all);
    }
  }

  private static final class LevelAnswerSerializer extends MessageSerializer<LevelAnswer> {
    @Override
    @SuppressWarnings("EnumOrdinal") // the order is part of the protocol
    protected void write(Output out, LevelAnswer m) {
      writeInt(out, "received", m.received(), 0, ProtocolLimits.MAX_OFFERED_BYTES);
      out.writeByte(m.outcome().ordinal());
      writeText(out, "text", m.text(), ProtocolLimits.MAX_TEXT_BYTES);
    }

    @Override
    protected LevelAnswer read(Input in) {
      int received = readInt(in, "received", 0, ProtocolLimits.MAX_OFFERED_BYTES);
      int outcome = inRange("outcome", in.readByteUnsigned(), 0, OUTCOMES.length - 1);
      return new LevelAnswer(
          received, OUTCOMES[outcome], readText(in, "text", ProtocolLimits.MAX_TEXT_BYTES));
    }
  }

  private static final class LevelListSerializer extends MessageSerializer<LevelList> {
    private static final int MAX_LEVELS = 0xffff;

    @Override
    protected void write(Output out, LevelList m) {
      writeInt(out, "left", m.left(), 0, MAX_LEVELS);
      out.writeByte(m.mayChoose() ? 1 : 0);
      writeInt(out, "levels", m.levels().size(), 0, ProtocolLimits.MAX_LISTED_LEVELS);
      for (LevelEntry level : m.levels()) {
        writeText(out, "name", level.name(), ProtocolLimits.MAX_NAME_BYTES);
        writeText(out, "game", level.game(), ProtocolLimits.MAX_GAME_NAME_BYTES);
        writeText(out, "author", level.author(), ProtocolLimits.MAX_NAME_BYTES);
        writeInt(out, "votes", level.votes(), 0, ProtocolLimits.MAX_PLAYERS);
        out.writeByte(level.chosen() ? 1 : 0);
      }
    }

    @Override
    protected LevelList read(Input in) {
      int left = readInt(in, "left", 0, MAX_LEVELS);
      boolean mayChoose = inRange("mayChoose", in.readByteUnsigned(), 0, 1) == 1;
      int count = readInt(in, "levels", 0, ProtocolLimits.MAX_LISTED_LEVELS);
      List<LevelEntry> levels = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        levels.add(
            new LevelEntry(
                readText(in, "name", ProtocolLimits.MAX_NAME_BYTES),
                readText(in, "game", ProtocolLimits.MAX_GAME_NAME_BYTES),
                readText(in, "author", ProtocolLimits.MAX_NAME_BYTES),
                readInt(in, "votes", 0, ProtocolLimits.MAX_PLAYERS),
                inRange("chosen", in.readByteUnsigned(), 0, 1) == 1));
      }
      return new LevelList(left, mayChoose, levels);
    }
  }
}
