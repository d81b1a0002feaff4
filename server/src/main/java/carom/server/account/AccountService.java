package carom.server.account;

import carom.server.metrics.Figure;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The accounts of a server. A thread of its own asks the store: no tick waits for it. While the
 * store doesn't answer, players join without what their accounts have, and writes wait, the newest
 * of each player and game.
 *
 * <p>Every method but {@link #close} returns at once. Any thread.
 */
public final class AccountService implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(AccountService.class);

  /** Most writes that wait for the store. */
  static final int MOST_WAITING = 10_000;

  /** Longest time for which a join waits for the last write of another server, ms. */
  private static final long OTHER_MS = 1_500;

  /** Longest time for which a join is of use, ms. */
  private static final long LOAD_MS = 2_500;

  private static final long ASK_AGAIN_MS = 100;
  private static final long NAP_MS = 50;
  private static final long RETRY_MS = 1_000;
  private static final long SAY_AGAIN_NS = TimeUnit.MINUTES.toNanos(1);
  private static final long CLOSE_MS = 5_000;

  /** The key of writes of which the latest counts. */
  private record Key(String account, long stamp, String game) {}

  /** Asks the store something for an operator. */
  private interface Question<T> {
    T ask() throws IOException;
  }

  private record Load(String account, CompletableFuture<Stay> stay, long sinceNs, long nextNs) {}

  private final AccountStore store;
  private final LongSupplier clock;
  private final Thread thread = new Thread(this::run, "carom-accounts");

  /** The newest stays here that the store may not have in full, by account. */
  private final Map<String, Stay> live = new ConcurrentHashMap<>();

  // Guarded by this.
  private final Map<Key, AccountWrite> writes = new LinkedHashMap<>();
  private final ArrayDeque<Load> loads = new ArrayDeque<>();
  private final ArrayDeque<Runnable> questions = new ArrayDeque<>();
  private final Map<BestLists.Query, Long> wanted = new LinkedHashMap<>();
  private boolean closing;

  /** Stays whose writes were refused, which the log has. */
  private final Set<String> told = new HashSet<>();

  private volatile BestLists best = BestLists.NONE;
  private volatile boolean failing;
  private long saidNs;
  private long retryNs;
  private long bestNs;

  private final LongAdder read = new LongAdder();
  private final LongAdder written = new LongAdder();
  private final LongAdder refused = new LongAdder();
  private final LongAdder failed = new LongAdder();
  private final LongAdder dropped = new LongAdder();

  /**
   * Creates the service of a store, which it owns from now on.
   *
   * @param clock monotonic nanoseconds
   */
  public AccountService(AccountStore store, LongSupplier clock) {
    this.store = store;
    this.clock = clock;
    saidNs = clock.getAsLong() - SAY_AGAIN_NS;
    thread.setDaemon(true);
  }

  /** Starts the thread. */
  public void start() {
    thread.start();
  }

  /**
   * Begins a stay of an account.
   *
   * @return null if the store doesn't answer: what the account has isn't known then. One that is
   *     cancelled ends by itself
   */
  public CompletableFuture<Stay> begin(String account) {
    CompletableFuture<Stay> stay = new CompletableFuture<>();
    synchronized (this) {
      long now = clock.getAsLong();
      loads.add(new Load(account, stay, now, now));
      notifyAll();
    }
    return stay;
  }

  /** Notes that a stay goes on, in another room or after a crash. */
  public void goesOn(Stay stay) {
    live.merge(stay.account(), stay, (a, b) -> a.stamp() > b.stamp() ? a : b);
  }

  /** Stores a write as soon as the store takes it. */
  public synchronized void offer(AccountWrite write) {
    Key key = new Key(write.account, write.stamp, write.game);
    AccountWrite before = writes.get(key);
    if (before == null && writes.size() >= MOST_WAITING) {
      dropped.increment();
      write.done();
    } else if (before == null || !before.ends) {
      writes.put(key, write);
    }
    notifyAll();
  }

  /** Ends a stay that no room has seen. */
  public void ends(Stay stay) {
    offer(AccountWrite.of(stay, "", "", new AccountWrite.Place("", 0, 0), false, true));
  }

  /** Returns how many writes wait for the store. */
  public synchronized int waiting() {
    return writes.size();
  }

  /** Returns what the metrics tell of accounts. */
  public List<Figure> figures() {
    return List.of(
        counter("accounts.read", "Stays of accounts that have begun with the store.", read),
        counter("accounts.written", "Writes of accounts that the store took.", written),
        counter("accounts.refused", "Writes that came after those of a newer stay.", refused),
        counter("accounts.failed", "Calls that the store of accounts failed.", failed),
        counter("accounts.dropped", "Writes that were one too many to wait.", dropped),
        new Figure(
            "accounts.waiting", "Writes that wait for the store of accounts.", true, this::waiting),
        new Figure(
            "accounts.store.down",
            "1 if the store of accounts didn't answer the last time.",
            true,
            () -> failing ? 1 : 0));
  }

  private static Figure counter(String name, String help, LongAdder value) {
    return new Figure(name, help, false, value::sum);
  }

  /**
   * Finds what is kept of accounts, see {@link AccountStore#find}. What players have gained lately
   * may be missing.
   */
  public CompletableFuture<List<AccountStore.Known>> find(String who, int most) {
    return ask(() -> store.find(who, most));
  }

  /**
   * Forgets what is kept of an account. A player who is in keeps what it has in the match, of which
   * nothing is stored any longer.
   *
   * @return whether anything was kept
   */
  public CompletableFuture<Boolean> forget(String account) {
    return ask(
        () -> {
          Stay known = live.get(account);
          long stamp = store.forget(account, known == null ? 0 : known.stamp());
          if (stamp > 0) {
            live.put(account, new Stay(account, stamp, AccountValues.NONE));
          }
          return stamp > 0;
        });
  }

  /**
   * Reads what an account has, for a player who hasn't joined yet; fails if the store doesn't
   * answer.
   */
  public CompletableFuture<AccountValues> valuesOf(String account) {
    Stay known = live.get(account);
    return known != null
        ? CompletableFuture.completedFuture(known.values())
        : ask(() -> values(account));
  }

  private AccountValues values(String account) throws IOException {
    Map<String, Map<String, AccountValues.Kept>> games = new LinkedHashMap<>();
    for (AccountStore.KnownValue value : store.valuesOf(account)) {
      games
          .computeIfAbsent(value.game(), game -> new LinkedHashMap<>())
          .put(value.field(), value.kept());
    }
    return new AccountValues(games);
  }

  private <T> CompletableFuture<T> ask(Question<T> question) {
    CompletableFuture<T> answer = new CompletableFuture<>();
    Runnable asks =
        () -> {
          try {
            answer.complete(question.ask());
            answers();
          } catch (IOException | IllegalArgumentException e) {
            fails(e, "a question isn't answered");
            answer.completeExceptionally(e);
          }
        };
    synchronized (this) {
      questions.add(asks);
      notifyAll();
    }
    return answer;
  }

  /** Returns the best lists as they were lately, and asks for some from now on. */
  public BestLists best(List<BestLists.Query> queries) {
    synchronized (this) {
      long now = clock.getAsLong();
      boolean isNew = false;
      for (BestLists.Query query : queries) {
        isNew |= wanted.put(query, now) == null;
      }
      if (isNew) {
        bestNs = now;
        notifyAll();
      }
    }
    return best;
  }

  private void run() {
    try {
      store.open();
    } catch (IOException e) {
      fails(e, "players join without what their accounts have");
    }
    try {
      while (true) {
        while (turn()) {}
        synchronized (this) {
          if (closing && (writes.isEmpty() || failing)) {
            return;
          }
          boolean rests =
              loads.isEmpty() && writes.isEmpty() && questions.isEmpty() && wanted.isEmpty();
          wait(rests ? 0 : NAP_MS);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      store.close();
    }
  }

  /**
   * Does one thing that is due; by hand, instead of {@link #start}.
   *
   * @return false if nothing was
   */
  public boolean turn() {
    Load load;
    AccountWrite write = null;
    Runnable question = null;
    boolean asks = false;
    synchronized (this) {
      load = nextLoad();
      long now = clock.getAsLong();
      if (load == null && (!failing || now - retryNs >= 0)) {
        Iterator<AccountWrite> first = writes.values().iterator();
        write = first.hasNext() ? first.next() : null;
        question = write == null ? questions.poll() : null;
        asks = write == null && question == null && !wanted.isEmpty() && now - bestNs >= 0;
      }
    }
    if (load != null) {
      serve(load);
    } else if (write != null) {
      serve(write);
    } else if (question != null) {
      question.run();
    } else if (asks) {
      askForBest();
    }
    return load != null || write != null || question != null || asks;
  }

  private Load nextLoad() {
    for (Iterator<Load> each = loads.iterator(); each.hasNext(); ) {
      Load load = each.next();
      if (clock.getAsLong() - load.nextNs >= 0) {
        each.remove();
        return load;
      }
    }
    return null;
  }

  private void serve(Load load) {
    if (clock.getAsLong() - load.sinceNs > TimeUnit.MILLISECONDS.toNanos(LOAD_MS)) {
      load.stay.complete(null); // nobody waits any longer
      return;
    }
    Stay known = live.get(load.account);
    long stamp = known == null ? 0 : known.stamp();
    boolean late = clock.getAsLong() - load.sinceNs > TimeUnit.MILLISECONDS.toNanos(OTHER_MS);
    try {
      Stay stay = store.begin(load.account, stamp, late);
      answers();
      if (stay == null) {
        synchronized (this) {
          long next = clock.getAsLong() + TimeUnit.MILLISECONDS.toNanos(ASK_AGAIN_MS);
          loads.add(new Load(load.account, load.stay, load.sinceNs, next));
        }
        return;
      }
      read.increment();
      if (stay.values() == null) {
        stay = new Stay(load.account, stay.stamp(), known.values());
      }
      live.put(load.account, stay);
      if (!load.stay.complete(stay)) {
        ends(stay); // the player has gone meanwhile
      }
    } catch (IOException | IllegalArgumentException e) {
      fails(e, "players join without what their accounts have");
      load.stay.complete(null);
    }
  }

  private void serve(AccountWrite write) {
    try {
      boolean taken = store.write(write);
      (taken ? written : refused).increment();
      if (!taken && isLost(write)) {
        LOG.warn(
            "accounts: account={} has joined elsewhere since; what room={} game={} gave it until"
                + " tick={} isn't kept",
            write.account,
            write.place.room(),
            write.game,
            write.place.tick());
      }
      answers();
    } catch (IOException e) {
      fails(e, "what players gain waits");
      return;
    } catch (IllegalArgumentException e) {
      LOG.error("accounts: a write of account={} is dropped: {}", write.account, e.getMessage());
    }
    write.done();
    synchronized (this) {
      writes.remove(new Key(write.account, write.stamp, write.game), write);
    }
    if (write.ends) {
      live.computeIfPresent(
          write.account, (account, stay) -> stay.stamp() <= write.stamp ? null : stay);
    }
  }

  /**
   * Returns whether what a stay wrote that is none of the newest is lost, and nobody was told. A
   * stay that had ended before the next began here has told that what it had.
   */
  private boolean isLost(AccountWrite write) {
    Stay newest = live.get(write.account);
    boolean passedOn = write.ends && newest != null && newest.stamp() > write.stamp;
    if (write.values.isEmpty() || passedOn) {
      return false;
    }
    if (told.size() >= MOST_WAITING) {
      told.clear();
    }
    return told.add(write.account + " " + write.stamp);
  }

  private void askForBest() {
    List<BestLists.Query> asked;
    synchronized (this) {
      long old = clock.getAsLong() - BestLists.WANTED_NS;
      wanted.values().removeIf(since -> since - old < 0);
      asked = new ArrayList<>(wanted.keySet());
      bestNs = clock.getAsLong() + BestLists.AGE_NS;
    }
    try {
      Map<BestLists.Query, List<AccountStore.Row>> rows = new LinkedHashMap<>();
      for (BestLists.Query q : asked) {
        rows.put(q, store.best(q.game(), q.field(), q.lowest(), q.start(), BestLists.MOST));
      }
      best = new BestLists(rows);
      answers();
    } catch (IOException | IllegalArgumentException e) {
      fails(e, "best lists stay as they were");
    }
  }

  private void answers() {
    if (failing) {
      failing = false;
      LOG.info("accounts: {} answers again, writes={} waited", store.title(), waiting());
    }
  }

  private void fails(Exception e, String meaning) {
    failing = true;
    failed.increment();
    long now = clock.getAsLong();
    retryNs = now + TimeUnit.MILLISECONDS.toNanos(RETRY_MS);
    if (now - saidNs >= SAY_AGAIN_NS) {
      saidNs = now;
      LOG.warn(
          "accounts: {}; {}, writes={} wait, dropped={} (of {} that may wait)",
          e.getMessage(),
          meaning,
          waiting(),
          dropped.sum(),
          MOST_WAITING);
    }
  }

  /** Stores what waits, for at most {@value #CLOSE_MS} ms, and ends. */
  @Override
  public void close() {
    synchronized (this) {
      closing = true;
      notifyAll();
    }
    try {
      if (!thread.isAlive()) { // driven by hand
        while (turn()) {}
        store.close();
      }
      thread.join(CLOSE_MS);
      if (thread.isAlive()) {
        thread.interrupt();
        thread.join(CLOSE_MS);
      }
      int left = waiting();
      if (left > 0) {
        LOG.error("accounts: writes={} are lost: {} doesn't answer", left, store.title());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
