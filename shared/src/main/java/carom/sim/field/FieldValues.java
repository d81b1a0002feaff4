package carom.sim.field;

import carom.physics.math.StateHash;
import carom.sim.phase.RecurrenceMeter;
import java.util.Arrays;

/**
 * The words of one player, one entity or the match, by the layout of the {@link Schema}. Games use
 * the typed methods of {@link FieldHolder} instead. One thread; only the constructor allocates.
 */
public final class FieldValues {
  private final FieldStore store;
  private final Scope scope;
  private final boolean writable;
  private int[] starts;
  private final int[] words;
  private long stamp;
  private long ruled;

  /** The player whose input spawned what the values belong to, or null. */
  private Object spawner;

  /** By word: how often rules write it; null where they never did. */
  private RecurrenceMeter[] meters;

  /**
   * Creates values that are as at the start.
   *
   * @param starts what each word begins with; shared, never changed
   */
  FieldValues(FieldStore store, Scope scope, boolean writable, int[] starts) {
    this.store = store;
    this.scope = scope;
    this.writable = writable;
    this.starts = starts;
    words = starts.clone();
  }

  /** Returns what these words belong to. */
  public Scope scope() {
    return scope;
  }

  /** Returns the player whose {@code Game.input} spawned what the values belong to, or null. */
  public Object spawner() {
    return spawner;
  }

  /** Sets the player whose {@code Game.input} spawned what the values belong to; not saved. */
  public void spawner(Object player) {
    if (words.length > 0) { // without words many share one object
      spawner = player;
    }
  }

  /** Returns the number of words. */
  public int size() {
    return words.length;
  }

  /** Returns a word. */
  public int word(int index) {
    return words[index];
  }

  /**
   * Lets the values count as begun otherwise. They stay as they are, so they may differ from the
   * start from now on.
   *
   * @param otherStarts what each word would have begun with; shared, never changed
   */
  public void begunAs(int[] otherStarts) {
    if (words.length > 0 && !Arrays.equals(starts, otherStarts)) { // else many share one object
      starts = otherStarts;
      stamp = store.noteChange(scope);
    }
  }

  /** Returns what a word was when the values were created, or as {@link #begunAs} says. */
  public int start(int index) {
    return starts[index];
  }

  /** Returns a word that a game asks for. */
  int read(int index) {
    store.noteRead(scope, index);
    return readToAdd(index);
  }

  /** Returns a word that a game adds to, without seeing it. */
  int readToAdd(int index) {
    if (store.use() != null) {
      store.use().read(this, index);
    }
    return words[index];
  }

  /**
   * Sets a word to what the server says, also where the game must not write now.
   *
   * @throws IllegalArgumentException if the word is outside its field's range
   */
  public void mirror(int index, int value) {
    Field<?> field = store.schema().field(scope, index);
    if (value < field.min() || value > field.max()) {
      throw new IllegalArgumentException(
          store.schema().name(scope, index)
              + "="
              + value
              + " is outside "
              + field.min()
              + ".."
              + field.max());
    }
    put(index, value);
  }

  /** Takes a word over from a prediction of this client, where it may mean a provisional entity. */
  public void copy(int index, FieldValues predicted) {
    put(index, predicted.words[index]);
  }

  /**
   * Returns the value of {@link FieldStore#changes} at the last change, or 0 if nothing has changed
   * since the values were created.
   */
  public long stamp() {
    return stamp;
  }

  /**
   * Returns how often a game wrote another value of a field that players are told. What {@code
   * Game.input} wrote isn't counted where the values belong to its player or the player's body, nor
   * what {@code Game.rules} and triggers wrote to fields that all near are told. A client doesn't
   * run what wrote the others, so it can't predict them. Not saved.
   */
  public long ruled() {
    return ruled;
  }

  /** Sets a word as a game asks for it, if the write counts now. */
  void write(int index, int value) {
    if (!writable) {
      throw new IllegalStateException(
          store.schema().name(scope, index)
              + " can't be written: level geometry has no values of its own; ask Entity.isLevel");
    }
    if (words[index] != value && store.takes(this, index)) {
      if (store.isRuling(this, index)) {
        ruled += index < store.schema().toldWords(scope) ? 1 : 0;
        noteWrite(index);
        store.noteRule(this);
      }
      store.noteWrite(scope, index);
      put(index, value);
    }
  }

  private void noteWrite(int index) {
    if (store.use() == null) {
      return;
    }
    if (meters == null) {
      meters = new RecurrenceMeter[words.length];
    }
    if (meters[index] == null) {
      meters[index] = new RecurrenceMeter();
    }
    store.use().wrote(this, index, meters[index], store.phase(), store.tick());
  }

  private void put(int index, int value) {
    if (words[index] != value) {
      words[index] = value;
      stamp = store.noteChange(scope);
    }
  }

  /** Sets all words but those of accounts to their start values, as a game asks for it. */
  void reset() {
    for (int i = 0; i < words.length; i++) {
      if (store.schema().field(scope, i).scope() == scope) {
        write(i, starts[i]);
      }
    }
  }

  /** Returns the fields of the game that these are values of. */
  public Schema schema() {
    return store.schema();
  }

  /** Returns the words that accounts keep, in the order of {@link Schema#lastingWords}. */
  public int[] lasting() {
    int[] at = store.schema().lastingWords();
    int[] values = new int[at.length];
    for (int i = 0; i < at.length; i++) {
      values[i] = words[at[i]];
    }
    return values;
  }

  /**
   * Begins with what an account has kept.
   *
   * @param values as {@link #lasting} returns them
   * @throws IllegalArgumentException if there are more or fewer, or one is outside its range
   */
  public void begin(int[] values) {
    int[] at = store.schema().lastingWords();
    if (values.length != at.length) {
      throw new IllegalArgumentException(
          "values=" + values.length + " of an account, but the game declares " + at.length);
    }
    for (int i = 0; i < at.length; i++) {
      mirror(at[i], values[i]);
    }
  }

  /** Forgets a player, who leaves. */
  public void forget(int playerId) {
    for (int word : store.schema().playerWords(scope)) {
      if (words[word] == playerId + 1) {
        put(word, 0);
      }
    }
  }

  /** Lets fields mean another entity instead of one, both as {@link EntityRef#word} has them. */
  public void replaceEntity(int word, int by) {
    for (int i = 0; i < words.length; i++) {
      if (words[i] == word && store.schema().field(scope, i) instanceof EntityRef) {
        put(i, by);
      }
    }
  }

  /** Mixes all words into a hash. */
  public long hash(long hash) {
    return hash(hash, words.length);
  }

  private long hash(long hash, int count) {
    long h = hash;
    for (int i = 0; i < count; i++) {
      h = StateHash.mix(h, words[i]);
    }
    return h;
  }

  /** Copies all words into an array. */
  public void copyTo(int[] target, int at) {
    System.arraycopy(words, 0, target, at, words.length);
  }

  /** Takes all words from an array that {@link #copyTo} filled. */
  public void copyFrom(int[] source, int at) {
    for (int i = 0; i < words.length; i++) {
      put(i, source[at + i]);
    }
  }

  FieldStore store() {
    return store;
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < words.length; i++) {
      text.append(i == 0 ? "" : " ").append(store.schema().name(scope, i)).append('=');
      text.append(store.schema().field(scope, i).show(words[i]));
    }
    return text.toString();
  }

  /** Returns the first word of a field of this scope. */
  int word(Field<?> field) {
    return store().schema().word(field, scope());
  }

  /** Returns the word of one of several values of a field of this scope. */
  int word(Field<?> field, int index) {
    return store().schema().word(field, scope(), index);
  }
}
