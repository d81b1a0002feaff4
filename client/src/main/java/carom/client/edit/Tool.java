package carom.client.edit;

/** The tools of an editor: each gives the mouse another meaning. */
public enum Tool {
  SELECT("Select", "V", "Click or draw a frame; drag moves, handles form and turn, Shift adds"),
  BOX("Box", "B", "Drag from corner to corner"),
  CIRCLE("Circle", "C", "Drag from the middle outwards"),
  CAPSULE("Capsule", "U", "Drag from end to end"),
  POLYGON("Polygon", "P", "Click the corners; Enter or the first corner closes it"),
  CHAIN("Chain", "L", "Click the points from left to right; Enter ends, the first point closes it"),
  SENSOR("Sensor", "S", "Drag from corner to corner; triggers ask who is inside"),
  SPAWN("Spawn", "N", "Click where players or things begin; the form has the name"),
  AREA("Area", "A", "Drag a rectangle; press the tool again for another kind"),
  JOINT("Joint", "J", "Click where two bodies overlap, or drag from A to B; again: another kind"),
  TRIGGER("Trigger", "T", "");

  /** Name on its button. */
  public final String title;

  /** The key that takes it. */
  public final String key;

  /** Use of it, in a line. */
  public final String help;

  Tool(String title, String key, String help) {
    this.title = title;
    this.key = key;
    this.help = help;
  }

  /** Returns whether a drag draws from one point to another. */
  boolean draws() {
    return this == BOX || this == CIRCLE || this == CAPSULE || this == SENSOR || this == AREA;
  }

  /** Returns whether clicks set points, one after the other. */
  boolean clicksPoints() {
    return this == POLYGON || this == CHAIN;
  }
}
