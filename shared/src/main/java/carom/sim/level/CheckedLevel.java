package carom.sim.level;

import carom.text.Json;
import carom.text.JsonException;
import java.util.ArrayList;
import java.util.List;

/**
 * A level file that was read to be judged: all that is wrong with it, and where in the file its
 * items are. {@link Level#parse} ends at the first problem and keeps no places.
 */
public final class CheckedLevel {
  private final String fileName;
  private final Level level; // or null
  private final List<LevelException> problems;
  private final Json root; // or null
  private final List<Json> items;
  private final List<Placed> placed;

  /**
   * A body at one of the places of an item.
   *
   * @param path of the item in the file, such as {@code bodies[3]}
   * @param kind what it is
   * @param at where it is
   */
  public record Placed(String path, Archetype kind, Level.Placement at) {}

  private CheckedLevel(
      String fileName,
      Level level,
      List<LevelException> problems,
      Json root,
      List<Json> items,
      List<Placed> placed) {
    this.fileName = fileName;
    this.level = level;
    this.problems = List.copyOf(problems);
    this.root = root;
    this.items = List.copyOf(items);
    this.placed = List.copyOf(placed);
  }

  /**
   * Reads a level from the bytes of its file, and goes on behind items that can't be used.
   *
   * @param fileName for the messages
   * @param json UTF-8; copied
   */
  public static CheckedLevel of(String fileName, byte[] json) {
    byte[] source = json.clone();
    List<LevelException> problems = new ArrayList<>();
    try {
      Level.requireSize(fileName, source.length);
      Json root = Json.parse(source);
      LevelReader reader = new LevelReader(fileName, root, problems);
      Level level = problems.isEmpty() ? new Level(reader, source) : null;
      return new CheckedLevel(fileName, level, problems, root, reader.items, placed(reader));
    } catch (JsonException e) {
      problems.add(new LevelException(fileName, e.line(), e.column(), e.path(), e.getMessage()));
    } catch (LevelException e) {
      problems.add(e);
    }
    return new CheckedLevel(fileName, null, problems, null, List.of(), List.of());
  }

  private static List<Placed> placed(LevelReader reader) {
    Archetypes kinds = new Archetypes();
    reader.archetypes.forEach(kinds::add);
    List<Placed> placed = new ArrayList<>();
    for (List<Level.Placement> all : List.of(reader.statics, reader.bodies)) {
      for (Level.Placement at : all) {
        String path = reader.items.get(at.archetype()).path();
        placed.add(new Placed(path, kinds.get(at.archetype()), at));
      }
    }
    return placed;
  }

  /** Returns the bodies of all items that can be used, even if others can't: statics first. */
  public List<Placed> placed() {
    return placed;
  }

  /** Returns the level, or null if there are problems. */
  public Level level() {
    return level;
  }

  /**
   * Returns what is wrong, in the order of the file. Joints and triggers are judged only if all
   * else can be used, because they name it.
   */
  public List<LevelException> problems() {
    return problems;
  }

  /**
   * Returns a remark on a level that can be used, in the form of the problems.
   *
   * @param list a list of the file, such as {@code spawns}
   * @param index of the item in it
   * @param remark the rest of the sentence that begins with the item's path
   */
  public LevelException remark(String list, int index, String remark) {
    return at(root.fields.get(list).items.get(index), remark);
  }

  /**
   * Returns a remark on the item that has placed a body.
   *
   * @param placed one of {@link Level#statics} or {@link Level#bodies}
   * @param remark the rest of the sentence that begins with the item's path
   */
  public LevelException remark(Level.Placement placed, String remark) {
    return at(items.get(placed.archetype()), remark);
  }

  /**
   * Returns the path of the item that has placed a body, such as {@code bodies[3]}, and its name.
   */
  public String title(Level.Placement placed) {
    Json item = items.get(placed.archetype());
    Json name = item.fields.get("name");
    return item.path() + (name == null ? "" : " (" + name.shown() + ")");
  }

  private LevelException at(Json node, String remark) {
    return new LevelException(fileName, node.line, node.column, node.path(), remark);
  }
}
