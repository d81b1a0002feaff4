package carom.client.settings;

/** The colours in which games are drawn. */
public enum Palette {
  /** The colours that games and levels choose. */
  STANDARD("standard"),
  /** Eight colours that people with any kind of colour blindness tell apart. */
  COLOUR_BLIND("colour-blind");

  private final String label;

  Palette(String label) {
    this.label = label;
  }

  /** Returns its name in the settings file and on the screen. */
  public String label() {
    return label;
  }
}
