package carom.server.upload;

import carom.net.protocol.PackedLevel;
import carom.net.protocol.PlayerName;
import carom.server.match.MatchLibrary;
import carom.server.session.LoadedLevel;
import carom.server.threads.LastingThread;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import carom.text.Suggestion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.regex.Pattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The levels of players of a server. A thread of its own checks what is sent, one level after the
 * other; nobody waits for it but the player who sent it. Any thread.
 */
public final class Uploads implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Uploads.class);

  /** Fewest digits of a hash by which a level is found; a list of levels shows so many. */
  static final int LEAST_DIGITS = 12;

  private static final Pattern HASH = Pattern.compile("[0-9a-f]{" + LEAST_DIGITS + ",64}");

  private static final String NONE =
      "no player has sent a level of this name, or one whose hash begins so";

  /** Most levels of an account. */
  static final int MOST_OF_ACCOUNT = 8;

  /** Most levels in all. */
  static final int MOST = 256;

  /** Most bytes in all. */
  static final long MOST_BYTES = 16 << 20;

  /** Most levels that wait for their check. */
  static final int MOST_WAITING = 4;

  /** Time between two levels of an account, and of a host. */
  static final long PAUSE_NS = TimeUnit.SECONDS.toNanos(10);

  /** Most accounts and hosts of which the last offer is known. */
  private static final int MOST_KNOWN = 4_096;

  /** Time of the processor that a check may take. */
  private static final Duration BUDGET = Duration.ofSeconds(20);

  /**
   * The outcome of a level that was sent.
   *
   * @param taken whether the server has it
   * @param text for the player
   */
  public record Outcome(boolean taken, String text) {}

  /** Judges levels. */
  interface Judge {
    /**
     * Judges a level; waits for that.
     *
     * @param level the file, which is there until this returns
     * @param verdict file for what the judge says
     * @throws IOException if it can't judge
     * @throws InterruptedException if this thread is interrupted; the judgement has ended then
     */
    TrialProcess.Verdict judge(Path level, Path verdict) throws IOException, InterruptedException;
  }

  @SuppressWarnings("ArrayRecordComponent") // nobody compares them
  private record Job(
      String account, String author, byte[] packed, int size, CompletableFuture<Outcome> outcome) {}

  private final UploadStore store;
  private final Judge trial;
  private final InstantSource clock;
  private final LongSupplier nanos;
  private final BlockingQueue<Job> jobs = new LinkedBlockingQueue<>(MOST_WAITING);
  private final Map<String, Long> lastOffers = new HashMap<>();
  private final Thread thread;
  private volatile List<UploadedLevel> levels;
  private volatile boolean closing;

  /**
   * Reads what is there, and starts the thread.
   *
   * @param clock tells when a level came
   * @param nanos monotonic nanoseconds
   * @throws IOException if the folder can't be used; the message says what to do
   */
  public Uploads(Path folder, InstantSource clock, LongSupplier nanos) throws IOException {
    this(folder, clock, nanos, new TrialProcess(BUDGET));
  }

  Uploads(Path folder, InstantSource clock, LongSupplier nanos, Judge trial) throws IOException {
    store = new UploadStore(folder);
    this.trial = trial;
    this.clock = clock;
    this.nanos = nanos;
    publish();
    thread = LastingThread.start("carom-uploads", () -> !closing, this::work);
  }

  private void publish() {
    levels =
        store.levels().stream()
            .sorted(Comparator.comparing(level -> PlayerName.folded(level.name())))
            .toList();
  }

  /** Returns all levels, sorted by name. Immutable. */
  public List<UploadedLevel> levels() {
    return levels;
  }

  /**
   * Returns the level of a name, or whose hash begins so, or null. A hash comes before a name, and
   * an older level before a newer one, so that no player can put a level in the place of another.
   *
   * @param name with or without {@link UploadedLevel#PREFIX}; of a hash, {@value #LEAST_DIGITS}
   *     digits or more
   */
  public UploadedLevel find(String name) {
    return find(levels, name);
  }

  private static UploadedLevel find(List<UploadedLevel> levels, String name) {
    boolean full = name.startsWith(UploadedLevel.PREFIX);
    String sought = full ? name.substring(UploadedLevel.PREFIX.length()) : name;
    if (HASH.matcher(sought).matches()) {
      Optional<UploadedLevel> hashed =
          levels.stream()
              .filter(level -> level.hash().startsWith(sought))
              .min(Comparator.comparingLong(UploadedLevel::since));
      if (hashed.isPresent()) {
        return hashed.get();
      }
    }
    String folded = PlayerName.folded(sought);
    return levels.stream()
        .filter(level -> PlayerName.folded(level.name()).equals(folded))
        .findAny()
        .orElse(null);
  }

  /**
   * Returns a level as {@link #find} finds it, of a folder that may be another server's; changes
   * nothing.
   *
   * @throws LevelException if there is none, or it can't be read; the message says why
   */
  public static Level level(Path folder, String name) throws LevelException {
    try {
      List<UploadedLevel> there = UploadStore.read(folder);
      UploadedLevel level = find(there, name);
      if (level != null) {
        return Level.parse(level.title(), UploadStore.bytes(folder, level));
      }
      List<String> titles = there.stream().map(UploadedLevel::title).toList();
      throw new LevelException(name, 0, 0, "", NONE + Suggestion.didYouMean(name, titles));
    } catch (IOException e) {
      throw new LevelException(name, 0, 0, "", "it can't be read: " + FileErrors.reason(e));
    }
  }

  /**
   * Notes that an account offers a level, and returns why it may not do so now, or null.
   *
   * @param host from where it comes
   */
  public synchronized String refusal(String account, String host) {
    if (account.isEmpty()) {
      return "A level belongs to an account: join with a token, or with a key of your own.";
    }
    long now = nanos.getAsLong();
    lastOffers.values().removeIf(last -> now - last >= PAUSE_NS);
    if (lastOffers.containsKey(account) || lastOffers.containsKey(host)) {
      return "One level in "
          + TimeUnit.NANOSECONDS.toSeconds(PAUSE_NS)
          + " s may come from you. Try again in a moment.";
    }
    if (jobs.remainingCapacity() == 0 || lastOffers.size() >= MOST_KNOWN) {
      return "The levels of others are being checked. Try again in a moment.";
    }
    lastOffers.put(account, now);
    lastOffers.put(host, now);
    return null;
  }

  /**
   * Checks a level, and keeps it if it is good.
   *
   * @param packed the packed file; not changed from now on
   * @param size of the file in bytes
   */
  public CompletableFuture<Outcome> submit(String account, String author, byte[] packed, int size) {
    CompletableFuture<Outcome> outcome = new CompletableFuture<>();
    if (!jobs.offer(new Job(account, author, packed, size, outcome))) {
      outcome.complete(
          new Outcome(false, "The levels of others are being checked. Try again in a moment."));
    }
    return outcome;
  }

  private void work() throws InterruptedException {
    Job job = jobs.take();
    Outcome outcome = new Outcome(false, "The server has failed to check it.");
    try {
      outcome = judge(job);
    } catch (IOException e) {
      LOG.error("levels of players: a check fails: {}", e.toString());
    } finally {
      LOG.info(
          "level of a player: account={} name={} size={} -> {}",
          job.account,
          job.author,
          job.size,
          outcome.text);
      job.outcome.complete(outcome);
    }
  }

  private Outcome judge(Job job) throws IOException, InterruptedException {
    byte[] json = PackedLevel.unpack(job.packed, job.size);
    if (json == null) {
      return new Outcome(false, "It didn't arrive whole. Send it again.");
    }
    Path level = store.scratch("trial.level");
    Path said = store.scratch("trial.verdict");
    TrialProcess.Verdict verdict;
    try {
      Files.write(level, json);
      verdict = trial.judge(level, said);
    } finally {
      Files.deleteIfExists(level);
      Files.deleteIfExists(said);
    }
    return verdict.problems().isEmpty()
        ? keep(job, json, verdict)
        : new Outcome(false, String.join("; ", verdict.problems()));
  }

  private synchronized Outcome keep(Job job, byte[] json, TrialProcess.Verdict verdict) {
    UploadedLevel old = null;
    int own = 0;
    long bytes = json.length;
    for (UploadedLevel other : levels) {
      boolean isOwn = other.account().equals(job.account);
      own += isOwn ? 1 : 0;
      bytes += other.size();
      if (PlayerName.looksLike(other.name(), verdict.name())) {
        if (!isOwn) {
          return new Outcome(
              false,
              "%s has sent a level \"%s\"; give yours another \"name\"."
                  .formatted(other.author(), other.name()));
        }
        old = other;
      }
    }
    if (old == null && own >= MOST_OF_ACCOUNT) {
      return new Outcome(
          false, "You have " + own + " levels here, the limit. A moderator removes some.");
    }
    if (old == null && levels.size() >= MOST || bytes > MOST_BYTES) {
      return new Outcome(false, "The server has room for no more levels of players.");
    }
    UploadedLevel fresh =
        new UploadedLevel(
            UploadStore.hash(json),
            verdict.name(),
            verdict.game(),
            json.length,
            clock.instant().getEpochSecond(),
            job.account,
            job.author);
    try {
      store.put(fresh, json, old);
    } catch (IOException e) {
      LOG.error("levels of players: {}", FileErrors.reason(e));
      return new Outcome(false, "The server's disk doesn't take it.");
    }
    publish();
    return new Outcome(
        true,
        "The server has \"%s\" now%s."
            .formatted(fresh.name(), old == null ? "" : ", in the place of the one before"));
  }

  /**
   * Removes a level. A match that is played in it goes on.
   *
   * @return false if there is none of this name
   * @throws IOException if the disk doesn't take it; the message says what to do
   */
  public synchronized boolean remove(String name) throws IOException {
    UploadedLevel level = find(name);
    if (level == null) {
      return false;
    }
    try {
      store.remove(level);
    } catch (IOException e) {
      throw new IOException("the index can't be written: " + FileErrors.reason(e), e);
    }
    publish();
    return true;
  }

  /** Returns a library that finds these levels by name before it asks another. */
  public MatchLibrary library(MatchLibrary otherwise) {
    return new MatchLibrary() {
      @Override
      public Game game(String name) {
        return otherwise.game(name);
      }

      @Override
      public LoadedLevel level(String name) throws LevelException {
        return name.startsWith(UploadedLevel.PREFIX) ? load(name) : otherwise.level(name);
      }

      @Override
      public boolean isGone(String name) {
        return name.startsWith(UploadedLevel.PREFIX) ? find(name) == null : otherwise.isGone(name);
      }
    };
  }

  private LoadedLevel load(String name) throws LevelException {
    UploadedLevel level = find(name);
    try {
      if (level != null) {
        return new LoadedLevel(Level.parse(level.title(), store.bytes(level)));
      }
    } catch (IOException e) {
      throw new LevelException(name, 0, 0, "", "it can't be read: " + FileErrors.reason(e));
    }
    throw new LevelException(name, 0, 0, "", NONE);
  }

  /** Ends the thread, and a check that is under way. */
  @Override
  public void close() {
    closing = true;
    thread.interrupt();
  }
}
