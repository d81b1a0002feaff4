package carom.sim.field;

import carom.sim.event.Audience;
import carom.sim.phase.Findings;
import carom.sim.phase.Phase;
import carom.sim.phase.RecurrenceMeter;
import java.util.ArrayList;
import java.util.List;

/**
 * Finds fields that a game uses so that no client can predict them. Either rules write them again
 * and again, and {@code Game.input} or {@code Game.forces} reads them; or these read what clients,
 * or the clients of others, aren't told. Writes are noted always, reads in some ticks only. One
 * thread; allocates for a finding, and for the first write of a rule to a word.
 */
public final class FieldUse {
  /** Names what the values of a finding belong to. */
  public interface Owners {
    /** Returns what has these values, such as {@code player 2}. */
    String nameOf(FieldValues values);
  }

  /** Reads are noted in one tick of so many. */
  private static final int TICKS = 8;

  /** A word that is written at 5 Hz and more is recurrent after some seconds. */
  private static final int RISE = 12;

  /** Most words whose writes wait for a reader. */
  private static final int MOST_WRITTEN = 64;

  /** A word that rules write again and again. */
  private record Written(FieldValues values, int word, Phase phase, int firstTick) {}

  private final Schema schema;
  private final Findings findings;
  private final Owners owners;
  private final List<Written> written = new ArrayList<>();

  /** By scope and word: the phase that reads it, or null. */
  private final Phase[][] readers = new Phase[Scope.values().length][];

  /** By scope and word: how often other clients are told what an input did that read it. */
  private final RecurrenceMeter[][] told = new RecurrenceMeter[Scope.values().length][];

  /** By scope and word: whether there is a finding about it. */
  private final boolean[][] isFound = new boolean[Scope.values().length][];

  /** The phase whose reads are noted now, or null. */
  private Phase reader;

  FieldUse(Schema schema, Findings findings, Owners owners) {
    this.schema = schema;
    this.findings = findings;
    this.owners = owners;
    for (Scope scope : Scope.values()) {
      readers[scope.ordinal()] = new Phase[schema.words(scope)];
      told[scope.ordinal()] = new RecurrenceMeter[schema.words(scope)];
      isFound[scope.ordinal()] = new boolean[schema.words(scope)];
    }
  }

  /** Notes reads from now on, if it is a tick for that. */
  void beginReading(Phase phase, int tick) {
    reader = tick % TICKS == 0 ? phase : null;
  }

  /** Ends {@link #beginReading}. */
  void endReading() {
    if (reader != null) {
      reader = null;
      judge();
    }
  }

  void read(FieldValues values, int word) {
    if (reader == null) {
      return;
    }
    Scope scope = values.scope();
    if (readers[scope.ordinal()][word] == null) {
      readers[scope.ordinal()][word] = reader;
      Audience audience = schema.field(scope, word).audience();
      boolean needsAll = reader != Phase.INPUT;
      if (audience == Audience.NOBODY) {
        unknown(scope, word, "no client is told", needsAll ? "NEAR" : "OWNER");
      } else if (needsAll && audience != Audience.NEAR && audience != Audience.ALL) {
        unknown(scope, word, "not all clients near are told", "NEAR");
      }
    }
  }

  private void unknown(Scope scope, int word, String why, String better) {
    String name = schema.name(scope, word);
    isFound[scope.ordinal()][word] = true;
    findings.add(
        "reads " + name,
        reader.callback()
            + " reads "
            + name
            + ", which "
            + why
            + ", so clients can't predict what follows; declare it .to("
            + better
            + ") or don't read it in "
            + reader.callback()
            + ".");
  }

  /**
   * Notes that another client must be told what an input did, because it read a word that not all
   * players near are told. If that happens again and again, it is a finding.
   *
   * @param owner what the input is of
   */
  public void toldInput(Scope scope, int word, FieldValues owner, int tick) {
    RecurrenceMeter[] meters = told[scope.ordinal()];
    if (meters[word] == null) {
      meters[word] = new RecurrenceMeter();
    }
    if (!meters[word].note(tick) || isFound[scope.ordinal()][word]) {
      return;
    }
    isFound[scope.ordinal()][word] = true;
    String name = schema.name(scope, word);
    findings.add(
        "reads " + name,
        "input reads "
            + name
            + ", which not all players near are told, so their clients learn what it did a round"
            + " trip later; declare it .to(NEAR) if they may know it. First seen at tick "
            + meters[word].firstTick()
            + ", "
            + owners.nameOf(owner)
            + ".");
  }

  /** Notes a write that no client can predict. */
  void wrote(FieldValues values, int word, RecurrenceMeter meter, Phase phase, int tick) {
    if (meter.note(tick, RISE) && written.size() < MOST_WRITTEN) {
      written.add(new Written(values, word, phase, meter.firstTick()));
    }
  }

  private void judge() {
    for (int i = written.size() - 1; i >= 0; i--) {
      Written w = written.get(i);
      Scope scope = w.values.scope();
      Phase by = readers[scope.ordinal()][w.word];
      if (by != null) {
        written.remove(i);
        String name = schema.name(scope, w.word);
        isFound[scope.ordinal()][w.word] = true;
        String advice =
            scope == Scope.MATCH
                ? "use Field.countdown for a clock, or read it in afterStep"
                : "move the write to input or make the field server-only";
        findings.add(
            "writes " + w.phase.callback() + " " + name,
            w.phase.callback()
                + " writes "
                + name
                + ", which "
                + by.callback()
                + " reads, so clients can't predict it; "
                + advice
                + ". First seen at tick "
                + w.firstTick
                + ", "
                + owners.nameOf(w.values)
                + ".");
      }
    }
  }
}
