package carom.sim.field;

import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.sim.event.Audience;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The fields of one game, and where the words of each lie. Server and client build it from the same
 * declarations, so an index of a word means the same on both.
 *
 * <p>Each value takes a word of 32 bits in memory. In each scope the words that some player may be
 * told come first, in the order of declaration, and then those that stay on the server ({@link
 * Audience#NOBODY}). Immutable; any thread.
 */
public final class Schema {
  /** Most fields of a game. */
  public static final int MAX_FIELDS = 1_024;

  /** The schema of a game without fields. */
  public static final Schema EMPTY = of(List.of());

  /** Words of one scope. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Layout(
      Field<?>[] fields,
      int[] indices,
      int told,
      boolean[] shared,
      int[] players,
      int[] lasting,
      int[] starts) {}

  private final List<Field<?>> declared;
  private final List<String> lines;
  private final long digest;
  private final int firstId;

  /** First word of a field by its id minus {@link #firstId}; -1 for one that isn't declared. */
  private final int[] offsets;

  private final Layout[] layouts = new Layout[Scope.values().length];
  private final boolean hasHidden;

  private Schema(List<? extends Field<?>> fields) {
    if (fields.size() > MAX_FIELDS) {
      throw new IllegalArgumentException(
          "fields=" + fields.size() + " are above the limit of " + MAX_FIELDS);
    }
    declared = List.copyOf(fields);
    List<String> texts = new ArrayList<>();
    int first = Integer.MAX_VALUE;
    int last = -1;
    long hash = StateHash.SEED;
    boolean anyHidden = false;
    for (Field<?> field : declared) {
      anyHidden |= !isShared(field);
      first = Math.min(first, field.id());
      last = Math.max(last, field.id());
      String line = field.toString();
      texts.add(line);
      for (int i = 0; i < line.length(); i++) {
        hash = StateHash.mix(hash, line.charAt(i));
      }
      hash = StateHash.mix(hash, -1);
    }
    lines = List.copyOf(texts);
    digest = StateHash.finish(hash);
    firstId = first;
    offsets = new int[declared.isEmpty() ? 0 : last - first + 1];
    Arrays.fill(offsets, -1);
    for (Scope scope : Scope.values()) {
      layouts[scope.ordinal()] = layOut(scope);
    }
    hasHidden = anyHidden;
  }

  /**
   * Creates the schema of a game.
   *
   * @param fields its declarations, in an order that is the same everywhere
   * @throws IllegalArgumentException if two fields of a scope have one name, there are more than
   *     {@value #MAX_FIELDS}, or those of a scope take more words than {@link Scope#mostWords}
   */
  public static Schema of(List<? extends Field<?>> fields) {
    return new Schema(fields);
  }

  private Layout layOut(Scope scope) {
    List<Field<?>> order = new ArrayList<>();
    for (Field<?> field : declared) {
      if (isIn(scope, field) && field.audience() != Audience.NOBODY) {
        order.add(field);
      }
    }
    int toldFields = order.size();
    for (Field<?> field : declared) {
      if (isIn(scope, field) && field.audience() == Audience.NOBODY) {
        order.add(field);
      }
    }
    long size = 0;
    long lastingSize = 0;
    int told = 0;
    for (int i = 0; i < order.size(); i++) {
      Field<?> field = order.get(i);
      requireNewName(order, i);
      offsets[field.id() - firstId] = (int) size;
      size += field.times();
      requireRoom(field, scope, size);
      if (field.scope() == Scope.ACCOUNT) {
        lastingSize += field.times();
        requireRoom(field, Scope.ACCOUNT, lastingSize);
      }
      told = i < toldFields ? (int) size : told;
    }
    Field<?>[] fields = new Field<?>[(int) size];
    int[] indices = new int[(int) size];
    boolean[] shared = new boolean[(int) size];
    int[] players = new int[(int) size];
    int[] starts = new int[(int) size];
    int[] lasting = new int[(int) lastingSize];
    int playerCount = 0;
    int lastingCount = 0;
    for (Field<?> field : order) {
      for (int i = 0; i < field.times(); i++) {
        int word = offsets[field.id() - firstId] + i;
        fields[word] = field;
        indices[word] = i;
        starts[word] = field.start();
        shared[word] = isShared(field);
        if (field instanceof PlayerRef) {
          players[playerCount++] = word;
        }
        if (field.scope() == Scope.ACCOUNT) {
          lasting[lastingCount++] = word;
        }
      }
    }
    return new Layout(
        fields, indices, told, shared, Arrays.copyOf(players, playerCount), lasting, starts);
  }

  private static boolean isIn(Scope scope, Field<?> field) {
    return field.scope().holder() == scope;
  }

  private static void requireRoom(Field<?> field, Scope scope, long size) {
    if (size > scope.mostWords()) {
      throw new IllegalArgumentException(
          "field "
              + field.path()
              + " makes words="
              + size
              + " of scope "
              + scope
              + ", above the limit of "
              + scope.mostWords()
              + "; declare fewer values with times");
    }
  }

  private static boolean isShared(Field<?> field) {
    return field.audience() == Audience.NEAR || field.audience() == Audience.ALL;
  }

  private static void requireNewName(List<Field<?>> order, int at) {
    for (int i = 0; i < at; i++) {
      if (order.get(i).name().equals(order.get(at).name())) {
        throw new IllegalArgumentException(
            "field " + order.get(at).path() + " is declared twice; give one another name");
      }
    }
  }

  /** Returns the fields in the order of declaration; unmodifiable. */
  public List<Field<?>> fields() {
    return declared;
  }

  /** Returns the number of words that each target of a scope has. */
  public int words(Scope scope) {
    return layouts[scope.ordinal()].fields.length;
  }

  /** Returns the number of words that some player may be told; they come first. */
  public int toldWords(Scope scope) {
    return layouts[scope.ordinal()].told;
  }

  /**
   * Returns whether all players near are told a word, so that all who predict its owner know it.
   */
  public boolean isShared(Scope scope, int word) {
    return layouts[scope.ordinal()].shared[word];
  }

  /** Returns whether there are words that not all players near are told. */
  public boolean hasHidden() {
    return hasHidden;
  }

  /** Returns the field to which a word belongs. It has the word's range, start and audience. */
  public Field<?> field(Scope scope, int word) {
    return layouts[scope.ordinal()].fields[word];
  }

  /** Returns which of its field's values a word is, from 0 on. */
  public int index(Scope scope, int word) {
    return layouts[scope.ordinal()].indices[word];
  }

  /** Returns what a word is called, such as {@code player.health} or {@code match.lamp[3]}. */
  public String name(Scope scope, int word) {
    Field<?> field = field(scope, word);
    return field.times() == 1 ? field.path() : field.path() + "[" + index(scope, word) + "]";
  }

  /** Returns the words with which the targets of a scope begin. The array is the live one. */
  int[] starts(Scope scope) {
    return layouts[scope.ordinal()].starts;
  }

  /**
   * Returns the words with which targets of a kind of their own begin.
   *
   * @param changed declared fields with another start
   * @return a new array; the live one if nothing changes
   * @throws IllegalArgumentException if a field isn't declared in this scope, or otherwise
   */
  public int[] starts(Scope scope, List<? extends Field<?>> changed) {
    int[] starts = changed.isEmpty() ? starts(scope) : starts(scope).clone();
    for (Field<?> field : changed) {
      Field<?> mine = find(scope, field.name());
      if (mine == null || !mine.isLike(field)) {
        throw new IllegalArgumentException(
            "field \""
                + field
                + "\" isn't declared"
                + (mine == null ? "; return it from Game.fields" : " so, but as \"" + mine + "\""));
      }
      int word = word(mine, scope, 0);
      Arrays.fill(starts, word, word + mine.times(), field.start());
    }
    return starts;
  }

  /** Returns the field of a name in a scope, or null. */
  public Field<?> find(Scope scope, String name) {
    for (Field<?> field : declared) {
      if (field.scope() == scope && field.name().equals(name)) {
        return field;
      }
    }
    return null;
  }

  /**
   * Returns the words of players that accounts keep, in the order of a join. The array is the live
   * one.
   */
  public int[] lastingWords() {
    return layouts[Scope.PLAYER.ordinal()].lasting;
  }

  /** Returns the words of a scope that mean players. The array is the live one. */
  int[] playerWords(Scope scope) {
    return layouts[scope.ordinal()].players;
  }

  /**
   * Returns the word of a field's value.
   *
   * @throws IllegalArgumentException if the field is of another scope or game, or has no such index
   */
  int word(Field<?> field, Scope scope, int index) {
    int at = Limits.notNull("field", field).id() - firstId;
    if (at < 0 || at >= offsets.length || offsets[at] < 0) {
      throw new IllegalArgumentException(
          "field " + field.path() + " isn't declared; return it from Game.fields");
    }
    if (!isIn(scope, field)) {
      throw new IllegalArgumentException(
          "field " + field.path() + " belongs to scope " + field.scope() + ", not to " + scope);
    }
    if (index < 0 || index >= field.times()) {
      throw new IndexOutOfBoundsException(
          "index=" + index + " of field " + field.path() + " is outside 0.." + (field.times() - 1));
    }
    return offsets[at] + index;
  }

  /**
   * Returns the word of a field with one value.
   *
   * @throws IllegalArgumentException if the field is of another scope or game, or has several
   *     values
   */
  int word(Field<?> field, Scope scope) {
    if (Limits.notNull("field", field).times() != 1) {
      throw new IllegalArgumentException(
          "field " + field.path() + " has values=" + field.times() + "; say which by an index");
    }
    return word(field, scope, 0);
  }

  /** Returns 64 bits that differ when any declaration or their order differs. */
  public long digest() {
    return digest;
  }

  /** Returns a line for each field, in the order of declaration; unmodifiable. */
  public List<String> lines() {
    return lines;
  }

  /**
   * Returns what the first difference to another schema's {@link #lines} is.
   *
   * @param others the lines, which may come from a file or another machine
   * @return a phrase that names the field, or null if there is no difference
   */
  public String difference(List<String> others) {
    for (int i = 0; i < Math.max(lines.size(), others.size()); i++) {
      if (i == others.size()) {
        return "field " + path(lines.get(i)) + " is declared here only";
      }
      if (i == lines.size()) {
        return "field " + path(others.get(i)) + " is declared there only";
      }
      if (!lines.get(i).equals(others.get(i))) {
        return difference(lines.get(i), others.get(i), others);
      }
    }
    return null;
  }

  private String difference(String mine, String other, List<String> others) {
    if (path(mine).equals(path(other))) {
      return "field " + path(mine) + " is \"" + mine + "\" here and \"" + other + "\" there";
    }
    if (!isAmong(path(mine), others)) {
      return "field " + path(mine) + " is declared here only";
    }
    if (!isAmong(path(other), lines)) {
      return "field " + path(other) + " is declared there only";
    }
    return "field " + path(mine) + " is declared here where " + path(other) + " is there";
  }

  private static boolean isAmong(String path, List<String> lines) {
    for (String line : lines) {
      if (path(line).equals(path)) {
        return true;
      }
    }
    return false;
  }

  private static String path(String line) {
    int end = line.indexOf(' ');
    return end < 0 ? line : line.substring(0, end);
  }

  @Override
  public String toString() {
    return "fields=" + declared.size() + " digest=" + Long.toHexString(digest);
  }
}
