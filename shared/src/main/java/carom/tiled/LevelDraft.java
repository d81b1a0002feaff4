package carom.tiled;

import carom.sim.level.CheckedLevel;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A level while it is put together. The reader of level files is the one judge of what may be in
 * it: what it refuses is dropped and named by where it comes from.
 */
final class LevelDraft {
  private static final int MAX_SKIPPED = 1_000;
  private static final int MAX_ROUNDS = 20;
  private static final Pattern ITEM = Pattern.compile("(\\w+)\\[(\\d+)\\](?:\\.(\\w+))?.*");

  /**
   * An item of a list.
   *
   * @param fields as in the file
   * @param origin layer and object in the map
   * @param own fields that are custom properties there
   */
  private record Entry(Map<String, Object> fields, String origin, TreeSet<String> own) {}

  final Map<String, Object> root = new LinkedHashMap<>();
  final Map<String, Object> materials = new TreeMap<>();

  /** Names of the objects that others name, by id; also of those that have none in the map. */
  final Map<Integer, String> objectNames = new TreeMap<>();

  private final Map<String, List<Entry>> lists = new LinkedHashMap<>();
  private final List<String> skipped = new ArrayList<>();
  private int unsaid;

  LevelDraft() {
    for (String list :
        List.of("spawns", "zones", "areas", "pools", "statics", "bodies", "joints", "triggers")) {
      lists.put(list, new ArrayList<>());
    }
  }

  /** Adds an item to a list. */
  void add(String list, Map<String, Object> fields, String origin, Iterable<String> own) {
    TreeSet<String> names = new TreeSet<>();
    own.forEach(names::add);
    lists.get(list).add(new Entry(fields, origin, names));
  }

  /** Returns whether a field of the file is a list of items. */
  boolean isList(String field) {
    return lists.containsKey(field);
  }

  /** Notes what isn't in the level. */
  void skip(String origin, String why) {
    if (skipped.size() < MAX_SKIPPED) {
      skipped.add(origin + ": " + why);
    } else {
      unsaid++;
    }
  }

  /** Returns the name of a material with these fields; a new one is called as wanted, or nearly. */
  String material(String wanted, Map<String, Object> fields) {
    for (Map.Entry<String, Object> known : materials.entrySet()) {
      if (known.getValue().equals(fields)) {
        return known.getKey();
      }
    }
    String name = wanted.isEmpty() ? "material" : wanted;
    String free = name;
    for (int i = 2; materials.containsKey(free); i++) {
      free = name + "-" + i;
    }
    materials.put(free, fields);
    return free;
  }

  /**
   * Returns the level, without what its reader refuses.
   *
   * @throws LevelException if that isn't enough
   */
  TiledLevel level(String fileName) throws LevelException {
    for (int round = 0; ; round++) {
      byte[] json = LevelText.of(fields()).getBytes(StandardCharsets.UTF_8);
      CheckedLevel checked = CheckedLevel.of(fileName, json);
      if (checked.problems().isEmpty()) {
        if (unsaid > 0) {
          skipped.add("and " + unsaid + " more");
        }
        return new TiledLevel(Level.parse(fileName, json), List.copyOf(skipped));
      }
      LevelException first = checked.problems().get(0);
      if (!drop(checked.problems()) || round == MAX_ROUNDS) {
        throw new LevelException(fileName, 0, 0, first.field(), problem(first));
      }
    }
  }

  private Map<String, Object> fields() {
    Map<String, Object> fields = new LinkedHashMap<>(root);
    if (!materials.isEmpty()) {
      fields.put("materials", materials);
    }
    lists.forEach(
        (name, entries) -> {
          if (!entries.isEmpty()) {
            fields.put(name, entries.stream().map(Entry::fields).toList());
          }
        });
    return fields;
  }

  /** Drops what problems are about, last first; returns whether there was anything. */
  private boolean drop(List<LevelException> problems) {
    Map<String, TreeMap<Integer, LevelException>> gone = new TreeMap<>();
    boolean any = false;
    for (LevelException problem : problems) {
      Matcher path = ITEM.matcher(problem.field());
      List<Entry> entries = path.matches() ? lists.get(path.group(1)) : null;
      int index = entries == null ? 0 : Integer.parseInt(path.group(2));
      if (entries == null || index >= entries.size()) {
        continue;
      }
      Entry entry = entries.get(index);
      any = true;
      if (path.group(3) != null && entry.own.remove(path.group(3))) {
        entry.fields.remove(path.group(3));
        skip(entry.origin, "property " + path.group(3) + problem(problem));
      } else {
        gone.computeIfAbsent(path.group(1), list -> new TreeMap<>()).put(index, problem);
      }
    }
    gone.forEach(
        (list, indices) ->
            indices
                .descendingMap()
                .forEach(
                    (index, problem) -> {
                      String rest = problem.field().replaceFirst("\\w+\\[\\d+\\]\\.?", "");
                      skip(lists.get(list).remove((int) index).origin, rest + problem(problem));
                    }));
    return any;
  }

  /** Returns the end of the sentence that begins with the field. */
  private static String problem(LevelException e) {
    String message = e.getMessage();
    int at = e.field().isEmpty() ? -1 : message.indexOf(": " + e.field());
    return at < 0 ? message : message.substring(at + 2 + e.field().length());
  }
}
