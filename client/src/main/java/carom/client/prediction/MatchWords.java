package carom.client.prediction;

import carom.net.field.FieldTables;
import carom.net.snapshot.table.TableInbox;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.Arrays;

/**
 * The match's fields that players are told, each with the tick after which it has its value. A
 * prediction that has simulated later ticks rolls back to there, as for a mispredicted input. Rules
 * that clients run predict words; each state of the server says whether they were right. One
 * prediction's; allocates nothing.
 */
final class MatchWords {
  private final SimulationHost simulation;
  private final Schema schema;
  private final int[] words;
  private final int[] ticks;
  private int received;
  private int newestTick = -1;

  /** The tick of the newest state that was received: what the server said is all up to there. */
  private int confirmedTick = -1;

  private boolean stale;

  /** Creates words that are as declared. */
  public MatchWords(SimulationHost simulation) {
    this.simulation = simulation;
    schema = simulation.schema();
    words = new int[schema.toldWords(Scope.MATCH)];
    ticks = new int[words.length];
    Arrays.fill(ticks, -1);
    for (int i = 0; i < words.length; i++) {
      words[i] = schema.field(Scope.MATCH, i).start();
    }
  }

  /**
   * Takes what the server told.
   *
   * @param tick of the newest state
   * @return the first tick after which a word has another value than known before; {@link
   *     Integer#MAX_VALUE} if none has
   */
  public int receive(TableInbox inbox, int tick) {
    confirmedTick = tick;
    int first = Integer.MAX_VALUE;
    if (words.length == 0 || inbox.changes(FieldTables.MATCH) == received) {
      return first;
    }
    received = inbox.changes(FieldTables.MATCH);
    int width = inbox.layout(FieldTables.MATCH).width();
    for (int i = 0; i < words.length; i++) {
      int value = inbox.get(FieldTables.MATCH, i / width, i % width);
      Field<?> field = schema.field(Scope.MATCH, i);
      if (value != words[i] && value >= field.min() && value <= field.max()) {
        words[i] = value;
        ticks[i] = inbox.changedTick(FieldTables.MATCH, i / width);
        first = Math.min(first, ticks[i]);
        newestTick = Math.max(newestTick, ticks[i]);
        stale = true;
      }
    }
    return first;
  }

  /** Notes that the simulation was taken back to a state in which words may be older. */
  public void restored() {
    stale = true;
  }

  /**
   * Returns whether a state has the words that the server had after its tick, as far as they are
   * known: of a word that changed later it isn't known what it was.
   */
  boolean agrees(SimState state) {
    for (int i = 0; i < words.length; i++) {
      if (ticks[i] <= state.tick() && state.matchWord(i) != words[i]) {
        return false;
      }
    }
    return true;
  }

  /**
   * Sets the words that are so after a tick. Where there are rules that predict them, these have
   * the say after the newest state of the server.
   */
  public void apply(int tick) {
    boolean isPredicted = simulation.hasRules();
    if (isPredicted ? tick > confirmedTick : !stale && tick > newestTick) {
      return;
    }
    for (int i = 0; i < words.length; i++) {
      if (ticks[i] <= tick) {
        simulation.fieldValues().mirror(i, words[i]);
      }
    }
    stale = tick < newestTick;
    if (isPredicted) {
      simulation.mirror().anchor();
    }
  }
}
