package carom.server.thin.plain;

import carom.net.protocol.ProtocolLimits;
import carom.server.thin.GameClasses;
import carom.server.thin.GameClasses.GameClass;
import carom.server.thin.GameClasses.GameField;
import carom.server.thin.ThinClientMessage;
import carom.sim.entity.Input;
import carom.sim.message.MessageKind;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Decodes what a client with stock Kryo 2.24 writes: the number of a class of {@code carom.plain},
 * and its public fields, sorted by name. Each class has its lines here; no other is created, and
 * nothing is larger than the bounds below say. One thread.
 */
final class PlainDecoder {
  /** Largest message of a client, bytes. */
  static final int MAX_BYTES = 4_096;

  /** Longest name of anything, in characters; what it names checks the rest. */
  private static final int MAX_NAME = 64;

  private final KryoInput in = new KryoInput();
  private final Input packer = new Input();

  /**
   * Decodes a message.
   *
   * @param classes of the game's messages that the client may send; null for none
   * @return a {@link ThinClientMessage} or {@link PlainControl}; null if the bytes are none, and
   *     {@link #problem} says why
   */
  Object decode(byte[] bytes, int from, int to, GameClasses classes) {
    in.begin(bytes, from, to);
    if (to - from > MAX_BYTES) {
      in.fail("it has " + (to - from) + " bytes, more than " + MAX_BYTES);
      return null;
    }
    Object message = decode(in.count(), classes);
    if (in.problem() == null && in.remaining() > 0) {
      in.fail("it has " + in.remaining() + " bytes too many");
    }
    return in.problem() == null ? message : null;
  }

  /** Returns what is wrong with the message decoded last, or null. */
  String problem() {
    return in.problem();
  }

  private Object decode(int id, GameClasses classes) {
    switch (id) {
      case PlainIds.REGISTER_UDP:
        return new PlainControl.RegisterUdp(in.whole());
      case PlainIds.KEEP_ALIVE:
        return new PlainControl.KeepAlive();
      case PlainIds.PING:
        return new PlainControl.Ping(in.whole(), in.flag());
      case PlainIds.JOIN:
        return join();
      case PlainIds.INPUT:
        return input();
      case PlainIds.CHAT:
        return chat();
      case PlainIds.EMOTE:
        return emote();
      case PlainIds.CHOOSE:
        return choose();
      case PlainIds.RATE:
        return new ThinClientMessage.Rate(in.whole());
      case PlainIds.VIEW:
        return view();
      case PlainIds.LIST_ROOMS:
        return new ThinClientMessage.ListRooms();
      case PlainIds.LIST_BEST:
        return new ThinClientMessage.ListBest();
      case PlainIds.CUSTOM:
        return custom();
      case PlainIds.ALIVE:
        return new ThinClientMessage.Alive();
      case PlainIds.LEAVE:
        return new ThinClientMessage.Leave();
      default:
        GameClass own = classes == null ? null : classes.at(id - PlainIds.FIRST_OF_GAME);
        if (own != null) {
          return ofGame(own);
        }
        in.fail("the server takes no class of number " + id);
        return null;
    }
  }

  /** Reads the fields of a class of the game's; one that is null is left out. */
  private ThinClientMessage ofGame(GameClass own) {
    Map<String, Object> values = new HashMap<>();
    for (GameField field : own.sorted()) {
      Object value =
          switch (field.argument().type()) {
            case COUNT, PLAYER, ENTITY -> in.whole();
            case FLAG -> in.flag();
            case REAL -> in.real();
            case TEXT -> in.text(MessageKind.MAX_BYTES);
            case CHOICE -> constant(field.constants(), in.count());
          };
      if (value != null) {
        values.put(field.argument().name(), value);
      }
    }
    return new ThinClientMessage.Custom(own.kind().name(), values);
  }

  private String constant(List<String> constants, int number) {
    if (number < 0 || number > constants.size()) {
      in.fail("an enum has the number " + number + ", outside 0.." + constants.size());
    }
    return in.problem() != null || number == 0 ? null : constants.get(number - 1);
  }

  private ThinClientMessage join() {
    String digest = text(MAX_NAME);
    String game = text(MAX_NAME);
    String name = text(MAX_NAME);
    String party = text(MAX_NAME);
    String password = text(ProtocolLimits.MAX_PASSWORD_BYTES);
    String room = text(MAX_NAME);
    long secret = in.longWhole();
    String token = text(ProtocolLimits.MAX_TOKEN_BYTES);
    return new ThinClientMessage.Join(
        in.whole(), name, room, game, party, token, password, secret, digest);
  }

  private ThinClientMessage input() {
    int count = in.whole();
    int length = in.length(ThinClientMessage.MAX_INPUTS);
    if (length == 0) {
      in.fail("inputs=0 is outside 1.." + ThinClientMessage.MAX_INPUTS);
    }
    long[] inputs = new long[length];
    for (int i = 0; i < length; i++) {
      if (!in.isThere()) {
        in.fail("inputs[" + i + "] is null");
      }
      packer.aim(in.real());
      packer.buttons(in.whole());
      float moveX = in.real();
      inputs[i] = packer.move(moveX, in.real()).pack();
    }
    return new ThinClientMessage.Input(count, in.whole(), inputs);
  }

  private ThinClientMessage chat() {
    in.whole(); // the player, which the server knows
    boolean team = in.flag();
    return new ThinClientMessage.Chat(text(MessageKind.MAX_BYTES), team);
  }

  private ThinClientMessage emote() {
    String emote = text(MAX_NAME);
    in.whole(); // the player
    return new ThinClientMessage.Emote(emote);
  }

  private ThinClientMessage choose() {
    String colour = in.text(MAX_NAME);
    Boolean ready = in.isThere() ? (Boolean) in.flag() : null;
    String role = in.text(MAX_NAME);
    String room = in.text(MAX_NAME);
    Integer team = in.isThere() ? (Integer) in.whole() : null;
    return new ThinClientMessage.Choose(team, role, ready, colour, room);
  }

  private ThinClientMessage view() {
    float halfHeight = in.real();
    float halfWidth = in.real();
    float x = in.real();
    return new ThinClientMessage.View(x, in.real(), halfWidth, halfHeight);
  }

  private ThinClientMessage custom() {
    String kind = text(MAX_NAME);
    int length = in.length(MessageKind.MAX_ARGUMENTS);
    Map<String, Object> values = new HashMap<>();
    for (int i = 0; i < length; i++) {
      if (!in.isThere()) {
        continue;
      }
      String name = text(MAX_NAME);
      Object value = value();
      if (value != null) {
        values.put(name, value);
      }
    }
    return new ThinClientMessage.Custom(kind, values);
  }

  /** Reads a field whose class is only known when it is written. */
  private Object value() {
    int id = in.count();
    switch (id) {
      case PlainIds.NULL:
        return null;
      case PlainIds.INT:
        return in.whole();
      case PlainIds.STRING:
        return text(MessageKind.MAX_BYTES);
      case PlainIds.FLOAT:
        return in.real();
      case PlainIds.BOOLEAN:
        return in.flag();
      case PlainIds.BYTE:
        return (int) (byte) in.read();
      case PlainIds.CHAR:
        return String.valueOf(in.unit());
      case PlainIds.SHORT:
        return in.shortWhole();
      case PlainIds.LONG:
        return in.longWhole();
      case PlainIds.DOUBLE:
        return in.longReal();
      default:
        in.fail("a value has the class of number " + id);
        return null;
    }
  }

  /** Reads a text that is empty if it is null. */
  private String text(int most) {
    String text = in.text(most);
    return text == null ? "" : text;
  }
}
