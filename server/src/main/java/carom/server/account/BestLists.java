package carom.server.account;

import carom.net.protocol.ServerMessage;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** The accounts with the best values of some fields, as they were lately. Immutable. */
public final class BestLists {
  /** Rows of a list. */
  public static final int MOST = 10;

  /** A list is asked for again after this time. */
  static final long AGE_NS = TimeUnit.SECONDS.toNanos(5);

  /** A list that nobody has wanted for this time is forgotten. */
  static final long WANTED_NS = TimeUnit.MINUTES.toNanos(10);

  static final BestLists NONE = new BestLists(Map.of());

  /**
   * A list that is wanted.
   *
   * @param lowest whether the lowest value is the best
   * @param start the value that counts as none
   */
  public record Query(String game, String field, boolean lowest, int start) {}

  /**
   * A list as people read it.
   *
   * @param field name of the field
   * @param rows names and values, the best first
   */
  public record Table(String field, List<Line> rows) {
    /** Returns the table as a player is told it, whose account is one, or none if that is empty. */
    public ServerMessage.BestList toldTo(String account) {
      int own = account.isEmpty() ? -1 : rows.stream().map(Line::account).toList().indexOf(account);
      return new ServerMessage.BestList(
          field,
          own,
          rows.stream().map(row -> new ServerMessage.BestEntry(row.name, row.value)).toList());
    }
  }

  /** A row of a table. */
  public record Line(String account, String name, String value) {}

  private final Map<Query, List<AccountStore.Row>> lists;

  BestLists(Map<Query, List<AccountStore.Row>> lists) {
    this.lists = lists;
  }

  /**
   * Returns the best lists of a game as they were lately, and asks for them from now on; none that
   * is empty or not known yet.
   */
  public static List<Table> of(AccountService service, String game, Schema schema) {
    List<Field<?>> listed = schema.fields().stream().filter(Field::isListed).toList();
    List<Query> queries = new ArrayList<>();
    listed.forEach(f -> queries.add(new Query(game, f.name(), f.isLowestBest(), f.start())));
    BestLists known = service.best(queries);
    List<Table> tables = new ArrayList<>();
    for (int i = 0; i < queries.size(); i++) {
      Field<?> field = listed.get(i);
      List<Line> rows =
          known.of(queries.get(i)).stream()
              .filter(row -> row.word() >= field.min() && row.word() <= field.max())
              .map(row -> new Line(row.account(), row.name(), field.show(row.word())))
              .toList();
      if (!rows.isEmpty()) {
        tables.add(new Table(field.name(), rows));
      }
    }
    return tables;
  }

  /** Returns a list, the best first; empty if it isn't known yet. */
  List<AccountStore.Row> of(Query query) {
    return lists.getOrDefault(query, List.of());
  }
}
