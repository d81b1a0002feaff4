package carom.server.thin.plain;

/**
 * Numbers of classes on the wire. Kryo counts registrations from 0 and writes two more. KryoNet's
 * own messages come first, then those of {@code carom.plain.Plain}, in its order.
 */
final class PlainIds {
  static final int NULL = 0;
  static final int INT = 2;
  static final int STRING = 3;
  static final int FLOAT = 4;
  static final int BOOLEAN = 5;
  static final int BYTE = 6;
  static final int CHAR = 7;
  static final int SHORT = 8;
  static final int LONG = 9;
  static final int DOUBLE = 10;

  static final int REGISTER_TCP = 12;
  static final int REGISTER_UDP = 13;
  static final int KEEP_ALIVE = 14;
  static final int DISCOVER_HOST = 15;
  static final int PING = 16;

  static final int JOIN = 20;
  static final int INPUT = 23;
  static final int CHAT = 24;
  static final int EMOTE = 25;
  static final int CHOOSE = 26;
  static final int RATE = 27;
  static final int VIEW = 28;
  static final int LIST_ROOMS = 29;
  static final int CUSTOM = 32;
  static final int ALIVE = 33;
  static final int LEAVE = 34;

  static final int WELCOME = 35;
  static final int REFUSED = 36;
  static final int MATCH = 51;
  static final int MORE = 52;
  static final int SNAPSHOT = 55;
  static final int ROSTER = 58;
  static final int SCORES = 59;
  static final int FIELDS = 62;
  static final int EVENT = 63;
  static final int ROOMS = 66;
  static final int REDIRECT = 67;
  static final int GOODBYE = 68;
  static final int JOINTS = 74;

  static final int LIST_BEST = 75;
  static final int BEST = 80;
  static final int STANDBY = 81;

  /** The first of a game's own classes, see {@link carom.server.thin.GameClasses}. */
  static final int FIRST_OF_GAME = 82;

  private PlainIds() {}
}
