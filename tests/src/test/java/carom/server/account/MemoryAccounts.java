package carom.server.account;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Accounts in memory, which fail on demand. A copy is what a crash leaves. */
public final class MemoryAccounts implements AccountStore {
  private record Row(long issued, long stamp, boolean playing, String name) {}

  private final Map<String, Row> accounts = new HashMap<>();
  private final Map<String, Map<String, Map<String, AccountValues.Kept>>> kept = new HashMap<>();

  /** Makes writes fail while it is true. */
  public boolean takesNothing;

  /** Makes all fail while it is true. */
  public boolean isDown;

  /** Returns a store with the same content. */
  public MemoryAccounts copy() {
    MemoryAccounts copy = new MemoryAccounts();
    copy.accounts.putAll(accounts);
    kept.forEach(
        (account, games) -> {
          Map<String, Map<String, AccountValues.Kept>> all = new TreeMap<>();
          games.forEach((game, values) -> all.put(game, new TreeMap<>(values)));
          copy.kept.put(account, all);
        });
    return copy;
  }

  /** Returns a value, or 0. */
  public int value(String account, String game, String field) {
    AccountValues.Kept value =
        kept.getOrDefault(account, Map.of()).getOrDefault(game, Map.of()).get(field);
    return value == null ? 0 : value.word();
  }

  private void require(boolean works) throws IOException {
    if (!works) {
      throw new IOException("the store fails, as the test wants");
    }
  }

  @Override
  public String title() {
    return "memory";
  }

  @Override
  public void open() {}

  @Override
  public Stay begin(String account, long known, boolean takesOver) throws IOException {
    require(!isDown);
    Row row = accounts.getOrDefault(account, new Row(0, 0, false, ""));
    boolean isElsewhere = known == 0 || row.stamp > known;
    if (row.playing && isElsewhere && !takesOver) {
      return null;
    }
    long next = Stay.nextJoin(Math.max(Math.max(row.issued, row.stamp), known));
    accounts.put(account, new Row(next, row.stamp, true, row.name));
    Map<String, Map<String, AccountValues.Kept>> games = new TreeMap<>();
    kept.getOrDefault(account, Map.of())
        .forEach((game, values) -> games.put(game, new TreeMap<>(values)));
    return new Stay(account, next, isElsewhere ? new AccountValues(games) : null);
  }

  @Override
  public boolean write(AccountWrite w) throws IOException {
    require(!isDown && !takesNothing);
    Row row = accounts.getOrDefault(w.account, new Row(w.stamp, 0, false, ""));
    if (row.stamp > w.stamp) {
      return false;
    }
    boolean playing = row.issued <= w.stamp ? !w.ends : row.playing;
    accounts.put(w.account, new Row(row.issued, w.stamp, playing, w.name));
    if (!w.values.isEmpty()) {
      kept.computeIfAbsent(w.account, account -> new TreeMap<>())
          .computeIfAbsent(w.game, game -> new TreeMap<>())
          .putAll(w.values);
    }
    if (w.ends && row.issued <= w.stamp && !kept.containsKey(w.account)) {
      accounts.remove(w.account);
    }
    return true;
  }

  @Override
  public List<AccountStore.Row> best(String game, String field, boolean lowest, int start, int most)
      throws IOException {
    require(!isDown);
    List<AccountStore.Row> rows = new ArrayList<>();
    accounts.forEach(
        (account, row) -> {
          int value = value(account, game, field);
          if (value != start) {
            rows.add(new AccountStore.Row(account, row.name, value));
          }
        });
    Comparator<AccountStore.Row> order = Comparator.comparingInt(AccountStore.Row::word);
    rows.sort(lowest ? order : order.reversed());
    return rows.subList(0, Math.min(most, rows.size()));
  }

  @Override
  public List<KnownValue> valuesOf(String account) throws IOException {
    require(!isDown);
    List<KnownValue> values = new ArrayList<>();
    AccountWrite.Place nowhere = new AccountWrite.Place("", 0, 0);
    kept.getOrDefault(account, Map.of())
        .forEach(
            (game, all) -> all.forEach((f, v) -> values.add(new KnownValue(game, f, v, nowhere))));
    return values;
  }

  @Override
  public List<Known> find(String who, int most) throws IOException {
    require(!isDown);
    List<Known> found = new ArrayList<>();
    for (Map.Entry<String, Row> one : accounts.entrySet()) {
      if (one.getKey().equals(who) || one.getValue().name.equalsIgnoreCase(who)) {
        found.add(new Known(one.getKey(), one.getValue().name, valuesOf(one.getKey())));
      }
    }
    found.sort(Comparator.comparing(Known::account));
    return found.subList(0, Math.min(most, found.size()));
  }

  @Override
  public long forget(String account, long known) throws IOException {
    require(!isDown);
    Row row = accounts.get(account);
    if (row == null) {
      return 0;
    }
    long next = Stay.nextJoin(Math.max(known, Math.max(row.issued, row.stamp)));
    accounts.put(account, new Row(next, next, false, ""));
    kept.remove(account);
    return next;
  }

  @Override
  public void close() {}
}
