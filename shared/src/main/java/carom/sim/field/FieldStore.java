package carom.sim.field;

import carom.sim.phase.Findings;
import carom.sim.phase.Phase;
import carom.sim.phase.Phases;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntSupplier;

/**
 * The fields of one simulation: their schema, how references are found, and which writes count at
 * the moment. The values themselves are with the players, the entities and the match.
 *
 * <p>A server takes every write but those of {@code Game.collision} and {@code Game.forces}, and in
 * {@code Game.rules} those of fields that not all players near are told. A client takes the writes
 * that it can predict: those of {@code Game.input} to that player, its body and what it spawned, of
 * fields that players are told, and those of {@code Game.rules} and of the level's triggers, of
 * fields that all near are told. It drops all others, and the server's word follows. One thread; a
 * write allocates nothing.
 */
public final class FieldStore implements Phases.Listener {
  /** Finds what references mean; the simulation knows. */
  public interface References<E, P> {
    /** Returns the entity under an id if it has this generation, or null. */
    E entity(int id, int generation);

    /** Returns the player under an id, or null. */
    P player(int id);
  }

  /** A player as fields see it. */
  public interface Owner {
    /** Returns the values of the player. */
    FieldValues fieldValues();

    /** Returns the values of the player's body, or null if it has none. */
    FieldValues bodyFieldValues();
  }

  private final Schema schema;
  private final IntSupplier clock;
  private final References<?, ?> references;
  private final long[] changes = new long[Scope.values().length];
  private final FieldValues[] shared = new FieldValues[Scope.values().length];
  private final Phases<? extends Owner> phases;
  private FieldValues own;
  private FieldValues ownBody;
  private boolean hasReadHidden;
  private boolean hasReadUntold;
  private boolean hasWrittenShared;
  private int hiddenWord;
  private Scope hiddenScope = Scope.PLAYER;
  private FieldUse use;
  private Consumer<FieldValues> ruleWrites;

  /**
   * Creates the store of a simulation.
   *
   * @param clock returns the simulation's tick
   * @param phases the simulation's
   */
  public FieldStore(
      Schema schema,
      IntSupplier clock,
      References<?, ?> references,
      Phases<? extends Owner> phases) {
    this.schema = schema;
    this.clock = clock;
    this.references = references;
    this.phases = phases;
    phases.listen(this, Phase.INPUT, Phase.RULES, Phase.FORCES);
    for (Scope scope : Scope.values()) {
      shared[scope.ordinal()] = new FieldValues(this, scope, true, schema.starts(scope));
    }
  }

  /** Returns the declarations. */
  public Schema schema() {
    return schema;
  }

  /** Creates the values of a player, an entity or the match, which begin as declared. */
  public FieldValues create(Scope scope) {
    return create(scope, schema.starts(scope));
  }

  /**
   * Creates values that begin otherwise.
   *
   * @param starts of {@link Schema#starts(Scope, List)}
   */
  public FieldValues create(Scope scope, int[] starts) {
    boolean empty = schema.words(scope) == 0;
    return empty ? shared[scope.ordinal()] : new FieldValues(this, scope, true, starts);
  }

  /**
   * Creates the values of static level geometry, which can't be written.
   *
   * @param starts of {@link Schema#starts(Scope, List)}
   */
  public FieldValues createOfLevel(int[] starts) {
    return new FieldValues(this, Scope.ENTITY, false, starts);
  }

  /**
   * Returns a number that grows with each change of a value in a scope. {@link FieldValues#stamp}
   * tells which target has changed since.
   */
  public long changes(Scope scope) {
    return changes[scope.ordinal()];
  }

  /**
   * Notes from now on how the game uses its fields. A server calls it.
   *
   * @param findings receives what no client can predict
   */
  public void noteUse(Findings findings, FieldUse.Owners owners) {
    use = new FieldUse(schema, findings, owners);
  }

  /** Sets what receives the values that rules write, at each write; null for nothing. */
  public void ruleWrites(Consumer<FieldValues> receiver) {
    ruleWrites = receiver;
  }

  /** Notes that the game writes what no client can predict. */
  void noteRule(FieldValues values) {
    if (ruleWrites != null && phases.now().isOfRules()) {
      ruleWrites.accept(values);
    }
  }

  /** Returns what notes how the game uses its fields, or null; a server has it. */
  public FieldUse use() {
    return use;
  }

  @Override
  public void began(Phase phase) {
    if (phase == Phase.INPUT) {
      own = phases.player().fieldValues();
      ownBody = phases.player().bodyFieldValues();
      hasReadHidden = false;
      hasReadUntold = false;
      hasWrittenShared = false;
    }
    if (use != null) {
      use.beginReading(phase, tick());
    }
  }

  @Override
  public void ended(Phase phase) {
    if (use != null) {
      use.endReading();
    }
  }

  private boolean isInput() {
    return phases.now() == Phase.INPUT;
  }

  /** Notes that the game reads a word. */
  void noteRead(Scope scope, int word) {
    if (isInput() && !schema.isShared(scope, word)) {
      hasReadHidden = true;
      hiddenScope = scope;
      hiddenWord = word;
      hasReadUntold |= word >= schema.toldWords(scope);
    }
  }

  /** Notes that the game changes a word. */
  void noteWrite(Scope scope, int word) {
    hasWrittenShared |= isInput() && schema.isShared(scope, word);
  }

  /**
   * Returns whether the last {@code Game.input} read a field that not all players near are told.
   * What it did then depends on what other clients don't know. Adding to a field isn't reading it.
   */
  public boolean hasReadHidden() {
    return hasReadHidden;
  }

  /** Returns the scope of a word that {@link #hasReadHidden} is about. */
  public Scope hiddenScope() {
    return hiddenScope;
  }

  /** Returns a word that {@link #hasReadHidden} is about, in {@link #hiddenScope}. */
  public int hiddenWord() {
    return hiddenWord;
  }

  /** Returns whether the last {@code Game.input} read a field that is sent to no player. */
  public boolean hasReadUntold() {
    return hasReadUntold;
  }

  /** Returns whether the last {@code Game.input} changed a field that all players near are told. */
  public boolean hasWrittenShared() {
    return hasWrittenShared;
  }

  /** Returns whether a client couldn't predict a write to these values now. */
  boolean isRuling(FieldValues values, int word) {
    return isInput()
        ? !isOwn(values)
        : !phases.now().isPredicted() || !schema.isShared(values.scope(), word);
  }

  private boolean isOwn(FieldValues values) {
    return values == own
        || values == ownBody
        || (values.spawner() != null && values.spawner() == phases.player());
  }

  /**
   * Returns whether a write counts now.
   *
   * @throws IllegalStateException if writes are refused
   */
  boolean takes(FieldValues values, int word) {
    switch (phases.now()) {
      case COLLISION:
        throw refusal(
            values,
            word,
            "Game.collision, which must change nothing; write it in Game.hit or Game.afterStep");
      case FORCES:
        throw refusal(
            values, word, "Game.forces, which may only push its body; write it in Game.input");
      case SET_UP:
        return true;
      case INPUT:
        return phases.decides() || (isOwn(values) && word < schema.toldWords(values.scope()));
      case RULES:
        if (!schema.isShared(values.scope(), word)) {
          throw refusal(
              values,
              word,
              "Game.rules, because not all players near are told; declare it .to(NEAR) or .to(ALL),"
                  + " or write it in Game.afterStep");
        }
        return true;
      case TRIGGERS:
        return phases.decides() || schema.isShared(values.scope(), word);
      default:
        return phases.decides();
    }
  }

  private IllegalStateException refusal(FieldValues values, int word, String where) {
    return new IllegalStateException(
        schema.name(values.scope(), word) + " can't be written in " + where);
  }

  /** Returns the phase that runs. */
  Phase phase() {
    return phases.now();
  }

  /** Notes a change and returns its number. */
  long noteChange(Scope scope) {
    return ++changes[scope.ordinal()];
  }

  int tick() {
    return clock.getAsInt();
  }

  References<?, ?> references() {
    return references;
  }
}
