package carom.server.thin;

import carom.sim.message.Argument;
import carom.sim.message.MessageKind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * The classes by which programs with stock KryoNet send and receive a game's own messages: one for
 * each kind, sorted by the kinds' names, with a public field for each argument. {@code carom plain}
 * writes them as Java, and the door reads and writes their fields; both take names and order from
 * here. Immutable; any thread.
 */
public final class GameClasses {
  /** Name of the class that registers the others. */
  public static final String REGISTRY = "Messages";

  /** Names of Java that can't be those of fields. */
  private static final Set<String> KEYWORDS =
      Set.of(
          ("abstract assert boolean break byte case catch char class const continue default do"
                  + " double else enum extends false final finally float for goto if implements"
                  + " import instanceof int interface long native new null package private"
                  + " protected public return short static strictfp super switch synchronized this"
                  + " throw throws transient true try void volatile while _")
              .split(" "));

  private final List<GameClass> all;
  private final Map<String, GameClass> byKind = new HashMap<>();
  private final Map<Integer, GameClass> byNumber = new HashMap<>();
  private final String digest;

  /**
   * A class.
   *
   * @param kind of its messages
   * @param name of the class
   * @param number place among all registrations: each class, and after it the enums of its fields
   * @param fields in the order of the kind's arguments
   * @param sorted the same by their names, as Kryo writes them
   */
  public record GameClass(
      MessageKind kind, String name, int number, List<GameField> fields, List<GameField> sorted) {
    /** Returns the number of registrations that it takes. */
    private int registrations() {
      int count = 1;
      for (GameField field : fields) {
        count += field.argument().constants().isEmpty() ? 0 : 1;
      }
      return count;
    }
  }

  /**
   * A public field.
   *
   * @param name of the field
   * @param type its Java type; of a choice that of an enum within the class
   * @param argument whose values it has
   */
  public record GameField(String name, String type, Argument argument) {
    /** Returns the names of the constants that a choice has, in their order. */
    public List<String> constants() {
      return argument.constants().stream().map(constant -> ((Enum<?>) constant).name()).toList();
    }
  }

  /**
   * Lays the classes of a game out.
   *
   * @param kinds the game's own, in any order
   */
  public GameClasses(List<MessageKind> kinds) {
    List<MessageKind> sorted = new ArrayList<>(kinds);
    sorted.sort(Comparator.comparing(MessageKind::name));
    Set<String> taken = new HashSet<>(List.of(lower(REGISTRY), "string", "enum"));
    List<GameClass> classes = new ArrayList<>();
    StringBuilder text = new StringBuilder();
    int number = 0;
    for (MessageKind kind : sorted) {
      GameClass made = lay(kind, unique(capital(identifier(kind.name())), taken), number);
      number += made.registrations();
      classes.add(made);
      byKind.put(kind.name(), made);
      byNumber.put(made.number(), made);
      text.append(kind.name()).append(kind.direction()).append(kind.arguments()).append('\n');
    }
    all = List.copyOf(classes);
    digest = String.format(Locale.ROOT, "%016x", hash(text));
  }

  private static GameClass lay(MessageKind kind, String name, int number) {
    Set<String> names = new HashSet<>();
    Set<String> types = new HashSet<>(List.of(lower(name), "string", "enum"));
    List<GameField> fields = new ArrayList<>();
    for (Argument a : kind.arguments()) {
      String field = identifier(a.name());
      String type =
          switch (a.type()) {
            case COUNT, PLAYER, ENTITY -> "int";
            case FLAG -> "boolean";
            case REAL -> "float";
            case TEXT -> "String";
            case CHOICE -> unique(capital(field), types);
          };
      fields.add(
          new GameField(unique(KEYWORDS.contains(field) ? field + "_" : field, names), type, a));
    }
    List<GameField> sorted = new ArrayList<>(fields);
    sorted.sort(Comparator.comparing(GameField::name));
    return new GameClass(kind, name, number, List.copyOf(fields), List.copyOf(sorted));
  }

  /** Returns a name of Java that is like a text. */
  private static String identifier(String text) {
    StringBuilder name = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      boolean fits = c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z' || c >= '0' && c <= '9';
      name.append(fits ? c : '_');
    }
    return Character.isDigit(name.charAt(0)) ? "_" + name : name.toString();
  }

  private static String capital(String name) {
    return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
  }

  /** Returns a name that isn't taken, also where files are told apart without their case. */
  private static String unique(String name, Set<String> taken) {
    String free = name.equals("_") ? "__" : name;
    while (!taken.add(lower(free))) {
      free += "_";
    }
    return free;
  }

  private static String lower(String name) {
    return name.toLowerCase(Locale.ROOT);
  }

  private static long hash(CharSequence text) {
    long hash = 0xcbf29ce484222325L; // FNV-1a
    for (int i = 0; i < text.length(); i++) {
      hash = (hash ^ text.charAt(i)) * 0x100000001b3L;
    }
    return hash;
  }

  /** Returns the classes, sorted by the names of their kinds. */
  public List<GameClass> all() {
    return all;
  }

  /** Returns the class of a kind, or null. */
  public GameClass find(String kind) {
    return byKind.get(kind);
  }

  /** Returns the class that has a number, or null. */
  public GameClass at(int number) {
    return byNumber.get(number);
  }

  /** Returns the digest that a client with these classes tells in {@code Join}. */
  public String digest() {
    return digest;
  }
}
