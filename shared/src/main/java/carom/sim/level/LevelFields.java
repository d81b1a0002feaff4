package carom.sim.level;

import java.util.List;

/** The names of the fields of level files, for programs that write them. Stateless. */
public final class LevelFields {
  private LevelFields() {}

  /** Returns the fields of a file. */
  public static List<String> root() {
    return LevelReader.ROOT;
  }

  /** Returns the fields of a material. */
  public static List<String> material() {
    return MaterialReader.FIELDS;
  }

  /**
   * Returns the fields of an item of {@code statics}, {@code bodies}, {@code spawns} or {@code
   * zones}.
   */
  public static List<String> item(String list) {
    return switch (list) {
      case "statics" -> LevelReader.STATIC;
      case "bodies" -> LevelReader.BODY;
      case "spawns" -> LevelReader.SPAWN;
      case "zones" -> LevelReader.ZONE;
      default -> throw new IllegalArgumentException("list=" + list + " has no fields of its own");
    };
  }

  /** Returns the types of areas. */
  public static List<String> areas() {
    return AreaReader.AREAS;
  }

  /** Returns the fields of a type of area. */
  public static List<String> area(String type) {
    return switch (type) {
      case "water" -> AreaReader.WATER;
      case "wind" -> AreaReader.WIND;
      case "gravity" -> AreaReader.GRAVITY;
      case "drag" -> AreaReader.DRAG;
      default -> AreaReader.ATTRACTOR;
    };
  }

  /** Returns the types of joints. */
  public static List<String> joints() {
    return LevelJointReader.TYPES;
  }

  /** Returns the fields of a type of joint. */
  public static List<String> joint(String type) {
    return LevelJointReader.fields(type);
  }
}
