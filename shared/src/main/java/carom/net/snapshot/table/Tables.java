package carom.net.snapshot.table;

import java.util.Arrays;
import java.util.List;

/** The tables of a room, in an order that server and client share. Immutable list. */
public final class Tables {
  /** No tables. */
  public static final Tables NONE = new Tables(List.of());

  private final Table[] tables;

  /**
   * Creates a list.
   *
   * @param tables at most 16; a table's place in the list is its name on the wire
   */
  public Tables(List<Table> tables) {
    if (tables.size() > TableCodec.MAX_TABLES) {
      throw new IllegalArgumentException(
          "tables=" + tables.size() + " is outside 0.." + TableCodec.MAX_TABLES);
    }
    this.tables = tables.toArray(new Table[0]);
  }

  /** Returns the number of tables. */
  public int count() {
    return tables.length;
  }

  /** Returns the table at a place. */
  public Table get(int place) {
    return tables[place];
  }

  TableLayout[] layouts() {
    return Arrays.stream(tables).map(Table::layout).toArray(TableLayout[]::new);
  }
}
