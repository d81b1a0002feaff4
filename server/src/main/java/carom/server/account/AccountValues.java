package carom.server.account;

import carom.physics.archive.Archive;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * The values of one account in all games. A value that a game declares otherwise by now counts as
 * far as it can: a count is held to its new range, all else begins anew. Immutable; any thread.
 */
public final class AccountValues {
  /** Most games of which an account keeps values on this server. */
  private static final int MAX_GAMES = 1_024;

  private static final int MAX_NAME = 1 << 12;
  private static final int MAX_FORM = 1 << 14;

  /** The values of an account that has never played. */
  public static final AccountValues NONE = new AccountValues(Map.of());

  /**
   * One value.
   *
   * @param form how the field was declared, such as {@code count 0..100}
   * @param word the value as the field stores it
   */
  public record Kept(String form, int word) {}

  /** By game, and by the name of the field. */
  private final Map<String, Map<String, Kept>> games;

  /**
   * Creates values.
   *
   * @param games by game, and by the name of the field; not changed from now on
   */
  public AccountValues(Map<String, Map<String, Kept>> games) {
    this.games = games;
  }

  /** Returns what a field with several values calls one of them, such as {@code best[3]}. */
  private static String name(Schema schema, int word) {
    String path = schema.name(Scope.PLAYER, word);
    return path.substring(path.indexOf('.') + 1);
  }

  /** Returns the values of a game by the names of its fields; unmodifiable. */
  Map<String, Kept> of(String game) {
    return games.getOrDefault(game, Map.of());
  }

  /** Returns what a player of a game begins with, in the order of {@link Schema#lastingWords}. */
  public int[] words(String game, Schema schema) {
    int[] at = schema.lastingWords();
    int[] words = new int[at.length];
    Map<String, Kept> kept = of(game);
    for (int i = 0; i < at.length; i++) {
      Field<?> field = schema.field(Scope.PLAYER, at[i]);
      words[i] = word(field, kept.get(name(schema, at[i])));
    }
    return words;
  }

  private static int word(Field<?> field, Kept kept) {
    if (kept == null) {
      return field.start();
    }
    boolean same = kept.form.equals(field.range());
    boolean fits = same || field instanceof Count && kept.form.startsWith("count ");
    return fits ? Math.max(field.min(), Math.min(field.max(), kept.word)) : field.start();
  }

  /**
   * Returns what a field of a game has, which is a {@link Count} of one value.
   *
   * @param start its value for a player who is new to the game
   */
  int count(String game, String field, int start) {
    Kept kept = of(game).get(field);
    return kept != null && kept.form.startsWith("count ") ? kept.word : start;
  }

  /** Returns the same with other values in a game. */
  public AccountValues with(String game, Schema schema, int[] words) {
    int[] at = schema.lastingWords();
    Map<String, Kept> kept = new TreeMap<>(of(game));
    for (int i = 0; i < at.length; i++) {
      kept.put(name(schema, at[i]), new Kept(schema.field(Scope.PLAYER, at[i]).range(), words[i]));
    }
    Map<String, Map<String, Kept>> all = new TreeMap<>(games);
    all.put(game, Collections.unmodifiableMap(kept));
    return new AccountValues(all);
  }

  /** Reads or writes values. */
  public static AccountValues pass(Archive a, AccountValues values) {
    Map<String, Map<String, Kept>> games = values == null ? new TreeMap<>() : values.games;
    var names = games.keySet().iterator();
    int count = a.count("games", games.size(), MAX_GAMES, 2 * Integer.BYTES);
    Map<String, Map<String, Kept>> read = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      String game = a.text("game", a.reads() ? "" : names.next(), MAX_NAME);
      read.put(game, passKept(a, a.reads() ? Map.of() : games.get(game)));
    }
    return a.reads() ? new AccountValues(read) : values;
  }

  /** Reads or writes the values of one game. */
  static Map<String, Kept> passKept(Archive a, Map<String, Kept> kept) {
    var entries = kept.entrySet().iterator();
    int count = a.count("values", kept.size(), 2 * Scope.ACCOUNT.mostWords(), 3 * Integer.BYTES);
    Map<String, Kept> read = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      Map.Entry<String, Kept> e = a.reads() ? null : entries.next();
      String name = a.text("field", e == null ? "" : e.getKey(), MAX_NAME);
      String form = a.text("form", e == null ? "" : e.getValue().form, MAX_FORM);
      int word =
          a.integer(
              "value", e == null ? 0 : e.getValue().word, Integer.MIN_VALUE, Integer.MAX_VALUE);
      read.put(name, new Kept(form, word));
    }
    return a.reads() ? Collections.unmodifiableMap(read) : kept;
  }
}
