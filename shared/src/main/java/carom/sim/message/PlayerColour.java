package carom.sim.message;

/** The colours that a player can choose for its body. */
public enum PlayerColour {
  /** The body looks as its game made it. */
  OF_THE_GAME("as in the game", -1),
  /** A light red. */
  RED("red", 0xff5d5d),
  /** An orange. */
  ORANGE("orange", 0xff9f43),
  /** A yellow. */
  YELLOW("yellow", 0xffd93d),
  /** A yellowish green. */
  LIME("lime", 0xa8e05f),
  /** A green. */
  GREEN("green", 0x35c274),
  /** A greenish blue. */
  CYAN("cyan", 0x4cd7e0),
  /** A blue. */
  BLUE("blue", 0x4d8dff),
  /** A violet. */
  VIOLET("violet", 0x9b6bff),
  /** A pink. */
  PINK("pink", 0xff79c6),
  /** A brown. */
  BROWN("brown", 0xb5835a),
  /** A white. */
  WHITE("white", 0xe8eef6);

  private static final PlayerColour[] ALL = values();

  private final String label;
  private final int rgb;

  PlayerColour(String label, int rgb) {
    this.label = label;
    this.rgb = rgb;
  }

  /** Returns its name in the settings file and on the screen. */
  public String label() {
    return label;
  }

  /** Returns it as 0xRRGGBB; -1 for {@link #OF_THE_GAME}. */
  public int rgb() {
    return rgb;
  }

  /** Returns its number in rosters and saved states; 0 for {@link #OF_THE_GAME}. */
  @SuppressWarnings("EnumOrdinal") // the order is part of both
  public int number() {
    return ordinal();
  }

  /** Returns the colour of a number; {@link #OF_THE_GAME} if there is none. */
  public static PlayerColour of(int number) {
    return isOne(number) ? ALL[number] : OF_THE_GAME;
  }

  /** Returns whether there is a colour of a number. */
  public static boolean isOne(int number) {
    return number >= 0 && number < ALL.length;
  }
}
