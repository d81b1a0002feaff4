package carom.net.protocol;

import static carom.net.protocol.ClientMessage.Diverged.BODY_INTS;
import static carom.net.protocol.ClientMessage.Diverged.MAX_BODIES;
import static carom.net.protocol.ClientMessage.Diverged.MAX_WORDS;

import carom.text.Texts;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Codec of client messages with a fixed layout: a tag byte, then the fields, big-endian, with exact
 * length. It uses no object graph and no reflection, and it is safe on any bytes. It has no state;
 * any thread may use it.
 */
public final class ClientMessageCodec {

  private static final byte HELLO = 1;
  private static final byte LEVEL_REQUEST = 2;
  private static final byte READY = 3;
  private static final byte LEAVE = 4;
  private static final byte LOOK = 5;
  private static final byte DIVERGED = 6;
  private static final byte WATCH = 7;
  private static final byte RECORDING_REQUEST = 8;
  private static final byte DIVERGED_NEAR = 9;
  private static final byte GAME_MESSAGE = 10;
  private static final byte HEARD = 11;
  private static final byte LIST_ROOMS = 12;
  private static final byte CHANGE_ROOM = 13;
  private static final byte POOL_REQUEST = 14;
  private static final byte PASSWORD = 15;
  private static final byte STANDBY = 16;
  private static final byte LIST_BEST = 17;
  private static final byte OFFER_LEVEL = 18;
  private static final byte LEVEL_PIECE = 19;
  private static final byte LIST_LEVELS = 20;
  private static final byte CHOOSE_LEVEL = 21;
  private static final int HELLO_FIXED_BYTES = 4 + 8 + 8;

  private ClientMessageCodec() {}

  /**
   * Writes a message.
   *
   * @param message a message within {@link ProtocolLimits}
   * @param out at least {@link ProtocolLimits#MAX_CLIENT_MESSAGE_BYTES} from {@code offset} on
   * @return number of bytes written
   * @throws IllegalArgumentException when a field is outside its limit; the message names field,
   *     value and limit
   */
  public static int encode(ClientMessage message, byte[] out, int offset) {
    ByteBuffer buffer = ByteBuffer.wrap(out, offset, out.length - offset);
    if (message instanceof ClientMessage.Hello hello) {
      buffer.put(HELLO);
      buffer.putInt(hello.protocolVersion());
      buffer.putLong(hello.physicsDigest());
      buffer.putLong(hello.resumeSecret());
      putText("Hello.name", hello.name(), ProtocolLimits.MAX_NAME_BYTES, buffer);
      putText("Hello.room", hello.room(), ProtocolLimits.MAX_ROOM_NAME_BYTES, buffer);
      putText("Hello.game", hello.game(), ProtocolLimits.MAX_GAME_NAME_BYTES, buffer);
      putText("Hello.party", hello.party(), ProtocolLimits.MAX_PARTY_NAME_BYTES, buffer);
      putToken(hello.token(), buffer);
    } else if (message instanceof ClientMessage.LevelRequest request) {
      buffer.put(LEVEL_REQUEST);
      buffer.put((byte) DatagramMark.checkedEpoch(request.epoch()));
      buffer.putInt(
          inRange("LevelRequest.offset", request.offset(), 0, ProtocolLimits.MAX_LEVEL_BYTES - 1));
    } else if (message instanceof ClientMessage.Look look) {
      buffer.put(LOOK);
      buffer.putFloat(finite("Look.x", look.x(), -Float.MAX_VALUE));
      buffer.putFloat(finite("Look.y", look.y(), -Float.MAX_VALUE));
      buffer.putFloat(finite("Look.halfWidth", look.halfWidth(), 0));
      buffer.putFloat(finite("Look.halfHeight", look.halfHeight(), 0));
      buffer.putShort(
          (short)
              inRange(
                  "Look.follows",
                  look.follows(),
                  ClientMessage.Look.NOBODY,
                  ProtocolLimits.MAX_PLAYERS - 1));
    } else if (message instanceof ClientMessage.Diverged diverged) {
      encodeDiverged(diverged, buffer);
    } else if (message instanceof ClientMessage.Password password) {
      if (password.text().isEmpty()) {
        throw new IllegalArgumentException("Password.text is empty; a password has 1 byte or more");
      }
      buffer.put(PASSWORD);
      putText("Password.text", password.text(), ProtocolLimits.MAX_PASSWORD_BYTES, buffer);
    } else if (message instanceof ClientMessage.Watch watch) {
      buffer.put(WATCH).putInt(watch.protocolVersion()).putLong(watch.physicsDigest());
      buffer.put((byte) inRange("Watch.room", watch.room(), 1, 255));
    } else if (message instanceof ClientMessage.RecordingRequest request) {
      if (request.offset() < 0) {
        throw new IllegalArgumentException(
            "RecordingRequest.offset=" + request.offset() + " is negative");
      }
      buffer.put(RECORDING_REQUEST).putLong(request.offset());
    } else if (message instanceof ClientMessage.GameMessage m) {
      inRange("GameMessage.bytes", m.bytes().length, 1, ProtocolLimits.MAX_GAME_MESSAGE_BYTES);
      buffer.put(GAME_MESSAGE);
      buffer.putInt(inRange("GameMessage.number", m.number(), 1, Integer.MAX_VALUE));
      buffer.put(m.bytes());
    } else if (message instanceof ClientMessage.PoolRequest request) {
      buffer.put(POOL_REQUEST);
      buffer.putInt(
          inRange(
              "PoolRequest.offset", request.offset(), 0, ProtocolLimits.MAX_POOL_STATE_BYTES - 1));
    } else if (message instanceof ClientMessage.Heard heard) {
      buffer.put(HEARD).putInt(inRange("Heard.number", heard.number(), 0, Integer.MAX_VALUE));
    } else if (message instanceof ClientMessage.ListRooms list) {
      buffer.put(LIST_ROOMS).putInt(list.protocolVersion());
    } else if (message instanceof ClientMessage.OfferLevel offer) {
      int most = ProtocolLimits.MAX_OFFERED_BYTES;
      buffer.put(OFFER_LEVEL).putInt(offer.protocolVersion());
      buffer.putInt(inRange("OfferLevel.levelSize", offer.levelSize(), 1, most));
      buffer.putInt(inRange("OfferLevel.packedSize", offer.packedSize(), 1, most));
      putText("OfferLevel.name", offer.name(), ProtocolLimits.MAX_NAME_BYTES, buffer);
      putToken(offer.token(), buffer);
    } else if (message instanceof ClientMessage.LevelPiece piece) {
      int length = piece.bytes().length;
      inRange("LevelPiece.bytes", length, 1, ProtocolLimits.MAX_LEVEL_PIECE_BYTES);
      int last = ProtocolLimits.MAX_OFFERED_BYTES - length;
      buffer.put(LEVEL_PIECE).putInt(inRange("LevelPiece.offset", piece.offset(), 0, last));
      buffer.put(piece.bytes());
    } else if (message instanceof ClientMessage.ListLevels) {
      buffer.put(LIST_LEVELS);
    } else if (message instanceof ClientMessage.ChooseLevel choice) {
      buffer.put(CHOOSE_LEVEL);
      putText("ChooseLevel.name", choice.name(), ProtocolLimits.MAX_NAME_BYTES, buffer);
    } else if (message instanceof ClientMessage.ListBest) {
      buffer.put(LIST_BEST);
    } else if (message instanceof ClientMessage.ChangeRoom change) {
      if (change.room().isEmpty()) {
        throw new IllegalArgumentException("ChangeRoom.room is empty; it must name a room");
      }
      buffer.put(CHANGE_ROOM);
      putText("ChangeRoom.room", change.room(), ProtocolLimits.MAX_ROOM_NAME_BYTES, buffer);
    } else if (message instanceof ClientMessage.Standby standby) {
      if (standby.room().isEmpty()) {
        throw new IllegalArgumentException("Standby.room is empty; it must name a room");
      }
      buffer.put(STANDBY).putInt(standby.protocolVersion()).putLong(standby.physicsDigest());
      buffer.putLong(standby.secret());
      putText("Standby.room", standby.room(), ProtocolLimits.MAX_ROOM_NAME_BYTES, buffer);
    } else if (message instanceof ClientMessage.Ready ready) {
      buffer.put(READY).put((byte) DatagramMark.checkedEpoch(ready.epoch()));
      buffer.putLong(ready.declarationsDigest()).putLong(ready.gameDigest());
    } else {
      buffer.put(LEAVE);
    }
    return buffer.position() - offset;
  }

  /** Returns a value that is certain to be in a range, both ends included. */
  private static int inRange(String what, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(what + "=" + value + " is outside " + min + ".." + max);
    }
    return value;
  }

  /** Returns a number that is certain to be finite and not below a least one. */
  private static float finite(String what, float value, float least) {
    if (!Float.isFinite(value) || value < least) {
      throw new IllegalArgumentException(
          what + "=" + value + " must be finite and at least " + least);
    }
    return value;
  }

  private static void putText(String what, String text, int maxBytes, ByteBuffer buffer) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    if (bytes.length > maxBytes) {
      throw new IllegalArgumentException(
          what + " has bytes=" + bytes.length + ", limit=" + maxBytes);
    }
    buffer.put((byte) bytes.length).put(bytes);
  }

  private static void putToken(String token, ByteBuffer buffer) {
    byte[] bytes = token.getBytes(StandardCharsets.US_ASCII);
    if (bytes.length > ProtocolLimits.MAX_TOKEN_BYTES) {
      throw new IllegalArgumentException(
          "Hello.token has bytes=" + bytes.length + ", limit=" + ProtocolLimits.MAX_TOKEN_BYTES);
    }
    if (!isToken(token)) {
      throw new IllegalArgumentException(
          "Hello.token has characters beside those of ASCII that are visible");
    }
    buffer.putShort((short) bytes.length).put(bytes);
  }

  /** Reads a token, or returns null if its length is wrong or it is no ASCII. */
  private static String token(ByteBuffer buffer) {
    int length = buffer.remaining() < Short.BYTES ? -1 : buffer.getShort();
    if (length < 0 || length > ProtocolLimits.MAX_TOKEN_BYTES || length > buffer.remaining()) {
      return null;
    }
    byte[] bytes = new byte[length];
    buffer.get(bytes);
    String token = new String(bytes, StandardCharsets.ISO_8859_1);
    return isToken(token) ? token : null;
  }

  private static boolean isToken(String text) {
    return text.chars().allMatch(c -> c > ' ' && c < 127);
  }

  /** Reads a text, or returns null if it is too long or no UTF-8. */
  private static String text(ByteBuffer buffer, int maxBytes) {
    int length = buffer.hasRemaining() ? buffer.get() & 0xff : Integer.MAX_VALUE;
    if (length > maxBytes || length > buffer.remaining()) {
      return null;
    }
    ByteBuffer bytes = buffer.slice(buffer.position(), length);
    buffer.position(buffer.position() + length);
    return Texts.ofUtf8(bytes);
  }

  /**
   * Writes a message into a new array of exactly the right length, as {@link #encode(ClientMessage,
   * byte[], int)} does.
   */
  public static byte[] encode(ClientMessage message) {
    byte[] out = new byte[ProtocolLimits.MAX_CLIENT_MESSAGE_BYTES];
    return Arrays.copyOf(out, encode(message, out, 0));
  }

  /**
   * Reads a message. The content never makes it throw. It allocates at most the message and its
   * texts. It checks only that a text is UTF-8 within its length; {@link PlayerName} and {@link
   * RoomName} check the rest.
   *
   * @return the message, or null when the bytes are not exactly one message within the limits
   */
  public static ClientMessage decode(byte[] bytes, int offset, int length) {
    if (length < 1) {
      return null;
    }
    ByteBuffer buffer = ByteBuffer.wrap(bytes, offset, length);
    return switch (buffer.get()) {
      case HELLO -> decodeHello(buffer);
      case LEVEL_REQUEST -> decodeLevelRequest(buffer);
      case READY -> decodeReady(buffer);
      case LEAVE -> buffer.hasRemaining() ? null : new ClientMessage.Leave();
      case LOOK -> decodeLook(buffer);
      case DIVERGED -> decodeDiverged(buffer);
      case DIVERGED_NEAR -> decodeDivergedNear(buffer);
      case WATCH -> decodeWatch(buffer);
      case RECORDING_REQUEST -> decodeRecordingRequest(buffer);
      case GAME_MESSAGE -> decodeGameMessage(buffer);
      case HEARD -> decodeHeard(buffer);
      case POOL_REQUEST -> decodePoolRequest(buffer);
      case LIST_ROOMS -> decodeListRooms(buffer);
      case CHANGE_ROOM -> decodeChangeRoom(buffer);
      case PASSWORD -> decodePassword(buffer);
      case OFFER_LEVEL -> decodeOfferLevel(buffer);
      case LEVEL_PIECE -> decodeLevelPiece(buffer);
      case LIST_LEVELS -> buffer.hasRemaining() ? null : new ClientMessage.ListLevels();
      case CHOOSE_LEVEL -> decodeChooseLevel(buffer);
      case LIST_BEST -> buffer.hasRemaining() ? null : new ClientMessage.ListBest();
      case STANDBY -> decodeStandby(buffer);
      default -> null;
    };
  }

  private static ClientMessage decodeOfferLevel(ByteBuffer buffer) {
    if (buffer.remaining() < 3 * Integer.BYTES) {
      return null;
    }
    int version = buffer.getInt();
    int size = buffer.getInt();
    int packed = buffer.getInt();
    String name = text(buffer, ProtocolLimits.MAX_NAME_BYTES);
    String token = name == null ? null : token(buffer);
    boolean good =
        token != null && !buffer.hasRemaining() && isOfferedSize(size) && isOfferedSize(packed);
    return good ? new ClientMessage.OfferLevel(version, size, packed, name, token) : null;
  }

  private static boolean isOfferedSize(int size) {
    return size >= 1 && size <= ProtocolLimits.MAX_OFFERED_BYTES;
  }

  private static ClientMessage decodeLevelPiece(ByteBuffer buffer) {
    int length = buffer.remaining() - Integer.BYTES;
    if (length < 1 || length > ProtocolLimits.MAX_LEVEL_PIECE_BYTES) {
      return null;
    }
    int offset = buffer.getInt();
    if (offset < 0 || offset > ProtocolLimits.MAX_OFFERED_BYTES - length) {
      return null;
    }
    byte[] bytes = new byte[length];
    buffer.get(bytes);
    return new ClientMessage.LevelPiece(offset, bytes);
  }

  private static ClientMessage decodeChooseLevel(ByteBuffer buffer) {
    String name = text(buffer, ProtocolLimits.MAX_NAME_BYTES);
    return name == null || buffer.hasRemaining() ? null : new ClientMessage.ChooseLevel(name);
  }

  private static ClientMessage decodeLevelRequest(ByteBuffer buffer) {
    if (buffer.remaining() != Byte.BYTES + Integer.BYTES) {
      return null;
    }
    int epoch = buffer.get();
    int offset = buffer.getInt();
    return DatagramMark.isEpoch(epoch) && validOffset(offset)
        ? new ClientMessage.LevelRequest(epoch, offset)
        : null;
  }

  private static ClientMessage decodeReady(ByteBuffer buffer) {
    if (buffer.remaining() != Byte.BYTES + 2 * Long.BYTES) {
      return null;
    }
    int epoch = buffer.get();
    return DatagramMark.isEpoch(epoch)
        ? new ClientMessage.Ready(epoch, buffer.getLong(), buffer.getLong())
        : null;
  }

  /**
   * Reads a view. It accepts finite numbers with sizes that aren't negative, and a player or
   * nobody; the server judges their meaning.
   */
  private static ClientMessage decodeLook(ByteBuffer buffer) {
    if (buffer.remaining() != 4 * Float.BYTES + Short.BYTES) {
      return null;
    }
    float x = buffer.getFloat();
    float y = buffer.getFloat();
    float halfWidth = buffer.getFloat();
    float halfHeight = buffer.getFloat();
    int follows = buffer.getShort();
    boolean numbers =
        Float.isFinite(x)
            && Float.isFinite(y)
            && Float.isFinite(halfWidth)
            && Float.isFinite(halfHeight);
    return numbers && halfWidth >= 0 && halfHeight >= 0 && isFollowable(follows)
        ? new ClientMessage.Look(x, y, halfWidth, halfHeight, follows)
        : null;
  }

  private static boolean isFollowable(int player) {
    return player >= ClientMessage.Look.NOBODY && player < ProtocolLimits.MAX_PLAYERS;
  }

  /** Writes a report. A report of the own body alone has a tag and a shorter layout of its own. */
  private static void encodeDiverged(ClientMessage.Diverged d, ByteBuffer buffer) {
    int ints = d.bodies().size();
    int bodies = ints / BODY_INTS;
    if (ints % BODY_INTS != 0 || bodies < 1 || bodies > MAX_BODIES) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "Diverged.bodies has size=%d, which is not %d for each of 1..%d bodies",
              ints,
              BODY_INTS,
              MAX_BODIES));
    }
    int words = d.words().size();
    if (d.ofSet() ? words > 0 : bodies != 1 || words > MAX_WORDS) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "Diverged.words has size=%d with bodies=%d; at most %d belong to one own body",
              words,
              bodies,
              MAX_WORDS));
    }
    inRange("Diverged.equalTick", d.equalTick(), 0, d.tick() - 1);
    buffer.put(d.ofSet() ? DIVERGED_NEAR : DIVERGED).putInt(d.tick()).putInt(d.equalTick());
    int first = 0;
    if (!d.ofSet()) {
      buffer.putShort((short) d.number(0)).put((byte) (d.number(0) >>> Short.SIZE));
      first = 1;
    }
    for (int i = first; i < d.count(); i++) {
      buffer.putInt(d.number(i));
    }
  }

  private static ClientMessage decodeDiverged(ByteBuffer buffer) {
    int bytes = buffer.remaining() - (4 + 4 + 2 + 1 + Integer.BYTES * (BODY_INTS - 1));
    int words = bytes / Integer.BYTES;
    if (bytes < 0 || bytes % Integer.BYTES != 0 || words > MAX_WORDS) {
      return null;
    }
    int tick = buffer.getInt();
    int equalTick = buffer.getInt();
    List<Integer> body = new ArrayList<>(BODY_INTS);
    body.add(buffer.getShort() & 0xffff | (buffer.get() & 0xff) << Short.SIZE);
    addInts(buffer, BODY_INTS - 1, body);
    List<Integer> fields = new ArrayList<>(words);
    addInts(buffer, words, fields);
    return diverged(new ClientMessage.Diverged(tick, equalTick, false, body, fields));
  }

  private static ClientMessage decodeDivergedNear(ByteBuffer buffer) {
    int bodyBytes = Integer.BYTES * BODY_INTS;
    int bytes = buffer.remaining() - 2 * Integer.BYTES;
    if (bytes < bodyBytes || bytes % bodyBytes != 0 || bytes > bodyBytes * MAX_BODIES) {
      return null;
    }
    int tick = buffer.getInt();
    int equalTick = buffer.getInt();
    List<Integer> bodies = new ArrayList<>(bytes / Integer.BYTES);
    addInts(buffer, bytes / Integer.BYTES, bodies);
    return diverged(new ClientMessage.Diverged(tick, equalTick, true, bodies, List.of()));
  }

  private static void addInts(ByteBuffer buffer, int count, List<Integer> to) {
    for (int i = 0; i < count; i++) {
      to.add(buffer.getInt());
    }
  }

  private static ClientMessage diverged(ClientMessage.Diverged d) {
    return d.equalTick() >= 0 && d.equalTick() < d.tick() ? d : null;
  }

  private static ClientMessage decodeWatch(ByteBuffer buffer) {
    if (buffer.remaining() != 4 + 8 + 1) {
      return null;
    }
    int version = buffer.getInt();
    long digest = buffer.getLong();
    int room = buffer.get() & 0xff;
    return room >= 1 ? new ClientMessage.Watch(version, digest, room) : null;
  }

  private static ClientMessage decodeRecordingRequest(ByteBuffer buffer) {
    if (buffer.remaining() != 8) {
      return null;
    }
    long offset = buffer.getLong();
    return offset >= 0 ? new ClientMessage.RecordingRequest(offset) : null;
  }

  private static ClientMessage decodeGameMessage(ByteBuffer buffer) {
    int length = buffer.remaining() - Integer.BYTES;
    if (length < 1 || length > ProtocolLimits.MAX_GAME_MESSAGE_BYTES) {
      return null;
    }
    int number = buffer.getInt();
    byte[] bytes = new byte[length];
    buffer.get(bytes);
    return number >= 1 ? new ClientMessage.GameMessage(number, bytes) : null;
  }

  private static ClientMessage decodePoolRequest(ByteBuffer buffer) {
    if (buffer.remaining() != Integer.BYTES) {
      return null;
    }
    int offset = buffer.getInt();
    return isPoolOffset(offset) ? new ClientMessage.PoolRequest(offset) : null;
  }

  private static boolean isPoolOffset(int offset) {
    return offset >= 0 && offset < ProtocolLimits.MAX_POOL_STATE_BYTES;
  }

  private static ClientMessage decodeHeard(ByteBuffer buffer) {
    if (buffer.remaining() != Integer.BYTES) {
      return null;
    }
    int number = buffer.getInt();
    return number >= 0 ? new ClientMessage.Heard(number) : null;
  }

  private static ClientMessage decodeListRooms(ByteBuffer buffer) {
    return buffer.remaining() == Integer.BYTES
        ? new ClientMessage.ListRooms(buffer.getInt())
        : null;
  }

  private static ClientMessage decodeChangeRoom(ByteBuffer buffer) {
    String room = text(buffer, ProtocolLimits.MAX_ROOM_NAME_BYTES);
    return room == null || room.isEmpty() || buffer.hasRemaining()
        ? null
        : new ClientMessage.ChangeRoom(room);
  }

  private static ClientMessage decodePassword(ByteBuffer buffer) {
    String text = text(buffer, ProtocolLimits.MAX_PASSWORD_BYTES);
    return text == null || text.isEmpty() || buffer.hasRemaining()
        ? null
        : new ClientMessage.Password(text);
  }

  private static ClientMessage decodeStandby(ByteBuffer buffer) {
    if (buffer.remaining() < HELLO_FIXED_BYTES) {
      return null;
    }
    int version = buffer.getInt();
    long digest = buffer.getLong();
    long secret = buffer.getLong();
    String room = text(buffer, ProtocolLimits.MAX_ROOM_NAME_BYTES);
    return room == null || room.isEmpty() || buffer.hasRemaining()
        ? null
        : new ClientMessage.Standby(version, digest, secret, room);
  }

  private static ClientMessage decodeHello(ByteBuffer buffer) {
    if (buffer.remaining() < HELLO_FIXED_BYTES) {
      return null;
    }
    int version = buffer.getInt();
    long digest = buffer.getLong();
    long secret = buffer.getLong();
    String name = text(buffer, ProtocolLimits.MAX_NAME_BYTES);
    String room = text(buffer, ProtocolLimits.MAX_ROOM_NAME_BYTES);
    String game =
        name == null || room == null ? null : text(buffer, ProtocolLimits.MAX_GAME_NAME_BYTES);
    String party = game == null ? null : text(buffer, ProtocolLimits.MAX_PARTY_NAME_BYTES);
    String token = party == null ? null : token(buffer);
    return token == null || buffer.hasRemaining()
        ? null
        : new ClientMessage.Hello(version, digest, name, secret, room, game, party, token);
  }

  private static boolean validOffset(int offset) {
    return offset >= 0 && offset < ProtocolLimits.MAX_LEVEL_BYTES;
  }
}
