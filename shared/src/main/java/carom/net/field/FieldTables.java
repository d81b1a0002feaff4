package carom.net.field;

import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.TableLayout;
import carom.sim.event.Audience;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.List;

/**
 * The tables of a game, in the order that server and client share. There are tables of joints, of
 * the fields of other players, of entities, and of the match, and of what acts on pools. Words that
 * stay on the server are in none of them. The own player's words are in the own section instead.
 * Immutable; any thread.
 */
public final class FieldTables {
  /** Place of the table of players. */
  public static final int PLAYERS = JointWords.TABLE + 1;

  /** Place of the table of entities. */
  public static final int ENTITIES = PLAYERS + 1;

  /** Place of the table of the match. Prediction depends on it, so it is urgent. */
  public static final int MATCH = ENTITIES + 1;

  /** Place of the table of what acts on pools; see {@link PoolTable}. */
  public static final int POOLS = MATCH + 1;

  private static final int GENERATION_BITS = 8;
  private static final int NEAR = 1;
  private static final int TEAM = 2;
  private static final int OWNER = 4;

  /** Classes of audience: a class is 1 plus the sum of what holds for the client. */
  private static final int CLASSES = 1 + NEAR + TEAM + OWNER;

  private final List<TableLayout> layouts;

  /**
   * Derives the tables from a game's fields.
   *
   * @param players largest number of players
   * @param entities largest number of entities
   */
  public FieldTables(Schema schema, int players, int entities) {
    layouts =
        List.of(
            JointWords.LAYOUT,
            layout(schema, Scope.PLAYER, players, 0, false),
            layout(schema, Scope.ENTITY, entities, GENERATION_BITS, false),
            layout(schema, Scope.MATCH, 1, 0, true),
            PoolTable.LAYOUT);
  }

  private static TableLayout layout(
      Schema schema, Scope scope, int targets, int identityBits, boolean urgent) {
    int words = schema.toldWords(scope);
    int[] bits = new int[words];
    int[] least = new int[words];
    int[] start = new int[words];
    int[] audiences = new int[words];
    for (int i = 0; i < words; i++) {
      Field<?> field = schema.field(scope, i);
      bits[i] = field.bits();
      least[i] = field.min();
      start[i] = field.start();
      audiences[i] = classes(field.audience());
    }
    return new TableLayout(targets, identityBits, false, bits, least, start, audiences, urgent);
  }

  /** Returns the classes of audience that are told a field: bit i for class i. */
  private static int classes(Audience audience) {
    int classes = 0;
    for (int as = 1; as <= CLASSES; as++) {
      int holds = as - 1;
      boolean told =
          switch (audience) {
            case ALL -> true;
            case NEAR -> (holds & NEAR) != 0;
            case TEAM -> (holds & (TEAM | OWNER)) != 0;
            case OWNER -> (holds & OWNER) != 0;
            case NOBODY -> false;
          };
      classes |= told ? 1 << as : 0;
    }
    return classes;
  }

  /**
   * Returns the class of audience of a client.
   *
   * @param near whether it sees the entity, or the player's body
   * @param team whether its player is on the owner's team
   * @param owner whether its player is the owner
   */
  public static int audience(boolean near, boolean team, boolean owner) {
    return 1 + (near ? NEAR : 0) + (team ? TEAM : 0) + (owner ? OWNER : 0);
  }

  /** Returns the tables' layouts, in their order. */
  public List<TableLayout> layouts() {
    return layouts;
  }

  /** Returns the table of the targets of a scope. */
  public static int table(Scope scope) {
    return switch (scope.holder()) {
      case PLAYER -> PLAYERS;
      case ENTITY -> ENTITIES;
      case MATCH, ACCOUNT -> MATCH;
    };
  }
}
