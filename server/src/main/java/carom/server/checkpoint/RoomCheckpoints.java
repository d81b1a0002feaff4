package carom.server.checkpoint;

import carom.net.protocol.Protocol;
import carom.replay.Block;
import carom.replay.BlockSink;
import carom.replay.Recorder;
import carom.replay.RecordingHeader;
import carom.replay.RecordingReader;
import carom.server.account.AccountLog;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.Match;
import carom.server.match.MatchInfo;
import carom.server.match.MatchLoader;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.session.Ownership;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps a room on the disk, so that another process can go on with it. Every few seconds a new slot
 * begins: the whole state, which is the checkpoint, and then the inputs of each tick. Beside it,
 * small files say who the players are ({@link SlotSeats}).
 *
 * <pre>
 *   slot 12   state ── inputs ── inputs ── inputs ── end │
 *   slot 13                                              │ state ── inputs ── inputs ─ ─
 *                                                        └─ checkpoint
 * </pre>
 *
 * <p>A slot begins when the disk has the last one. Then the slots before the last are deleted. A
 * slot whose disk fails or is too slow is given up, and another one begins.
 *
 * <p>The room's thread copies the state and hands it over; {@link SlotDisk} compresses and writes.
 */
public final class RoomCheckpoints {
  private static final Logger LOG = LoggerFactory.getLogger(RoomCheckpoints.class);

  private static final long NS_PER_MS = 1_000_000;

  /** Failures in a row after which the checkpoints aren't resumed: they lead to the next one. */
  private static final int MAX_FAILURES = 3;

  /** A room that has played for so long after it was resumed has not failed because of that. */
  private static final int HEALTHY_S = 60;

  /**
   * The room that is kept.
   *
   * @param config settings of the server
   * @param settings returns its own, as they are now
   * @param number 1 for the server's first room
   * @param label begins each log line
   * @param counters of the room
   * @param seats of the room
   * @param ownership whether the server owns the room
   * @param accounts what the room has noted of accounts
   * @param bySeat the live array of the sessions by seat, null where a seat is empty
   */
  @SuppressWarnings("ArrayRecordComponent") // Never compared.
  public record KeptRoom(
      ServerConfig config,
      Supplier<RoomConfig> settings,
      int number,
      String label,
      Counters counters,
      Seats seats,
      Ownership ownership,
      AccountLog accounts,
      Session[] bySeat) {

    RoomConfig room() {
      return settings.get();
    }
  }

  private final KeptRoom room;
  private final SlotDisk disk;
  private final SlotStore store;
  private final int intervalTicks;
  private RoomCourse course;
  private long roomSeed;
  private int lastSlot;
  private long healthyNs;

  /** The last slot that the disk has. The disk's thread changes it. */
  private volatile int safeSlot;

  /** Null if the match isn't kept. */
  private Recorder recorder;

  private RecordingHeader header;
  private volatile SlotFile slot;
  private volatile boolean abandoned;
  private long keptClaim;
  private int slotTick;
  private long slotHash;
  private SavedEvents events;
  private int dueTick;
  private final SlotSeats seats;
  private int seatsVersion;

  /** The last tick that has been handed to the disk. */
  private int handedTick;

  private long nowNs;
  private boolean countedFailure;

  /** True if the disk took no checkpoint lately, which the log has. The disk's thread ends it. */
  private volatile boolean failing;

  /** The number of writes of accounts that belong to ticks that are written. */
  private volatile long accountsKept;

  /** The number of those that were handed to the disk. */
  private long handedAccounts;

  private boolean toldTooLarge;

  /** Says when the follower has each block; null if the room doesn't wait for that. */
  private SlotLink confirms;

  private Runnable confirmed = () -> {};

  /** Number of blocks that were handed to the disk. */
  private long handed;

  /** Number of those that the follower has. */
  private volatile long there;

  /** True from when the room waited in vain until the follower has a whole checkpoint again. */
  private volatile boolean givenUp;

  /**
   * Creates checkpoints that have nothing yet.
   *
   * @param disk writes
   * @param path folder of this room's slots alone
   * @param seconds time between checkpoints, s
   */
  public RoomCheckpoints(KeptRoom room, SlotDisk disk, Path path, int seconds) {
    this(room, disk, new SlotFolder(path), seconds);
  }

  /**
   * Creates checkpoints at the server that follows the room.
   *
   * @param disk writes
   * @param link takes what it writes there
   * @param seconds time between checkpoints, s
   */
  public RoomCheckpoints(KeptRoom room, SlotDisk disk, SlotLink link, int seconds) {
    this(room, disk, new RemoteSlots(link), seconds);
  }

  /**
   * Creates checkpoints as above, of which the room knows what the follower has.
   *
   * @param newConfirmed runs each time when {@link #isThere} may have changed, on any thread
   */
  public RoomCheckpoints(
      KeptRoom room, SlotDisk disk, SlotLink link, int seconds, Runnable newConfirmed) {
    this(room, disk, link, seconds);
    confirms = link;
    confirmed = newConfirmed;
  }

  private RoomCheckpoints(KeptRoom room, SlotDisk disk, SlotStore store, int seconds) {
    this.room = room;
    this.disk = disk;
    this.store = store;
    intervalTicks = seconds * room.config().get(ServerConfig.TICK_RATE);
    seats = new SlotSeats(room.seats(), room.bySeat());
  }

  /**
   * Returns the room as an earlier run has left it in the folder. Slots that can't be used are
   * named in the log, and the one before is used.
   *
   * @param loader builds the match
   * @return null if there is no slot that can be used
   * @throws IOException if the folder can't be used
   */
  public ResumedRoom resume(MatchLoader loader, long nowNs) throws IOException {
    if (!(store instanceof SlotFolder folder)) {
      throw new IllegalStateException("slots of a follower are resumed there");
    }
    folder.create();
    List<Integer> slots = folder.slots();
    lastSlot = slots.isEmpty() ? 0 : slots.get(0);
    boolean isLatest = room.ownership().isLatest(folder.claim());
    boolean mayResume = isLatest && folder.failures() < MAX_FAILURES;
    for (int number : mayResume ? slots : List.<Integer>of()) {
      RoomResume resume = new RoomResume(folder, number, room, loader, nowNs);
      try {
        ResumedRoom resumed = resume.run();
        safeSlot = number;
        room.counters().add(Counter.ROOMS_RESUMED, 1);
        return resumed;
      } catch (IOException | RuntimeException e) {
        refuse(resume, number, e.getMessage());
      } catch (AssertionError | VirtualMachineError | LinkageError e) { // of the game's code
        refuse(resume, number, e.toString());
      }
    }
    if (!isLatest && !slots.isEmpty()) {
      LOG.warn("{}another server has owned the room since its checkpoints", room.label());
    } else if (!mayResume) {
      LOG.error(
          "{}the room has failed {} times in a row soon after its checkpoints",
          room.label(),
          MAX_FAILURES);
    }
    for (int number : slots) {
      folder.refuse(number);
    }
    folder.forgetFailures();
    if (!slots.isEmpty()) {
      LOG.error(
          "{}no checkpoint can be used, the room begins anew; {} keeps them as *.refused",
          room.label(),
          folder.path());
    }
    return null;
  }

  /**
   * Builds the match that {@link #resume} will go on with, while its journal still grows, so that
   * this takes no longer than its ticks do.
   *
   * @param path folder of the room's slots
   * @return null if there is no slot yet whose match can be built
   */
  public static Match prepare(Path path, MatchLoader loader) {
    SlotFolder folder = new SlotFolder(path);
    try {
      for (int slot : folder.slots()) {
        if (Files.exists(folder.seats(slot))) { // which are written after the state
          int number = SavedRoom.parse(Files.readAllBytes(folder.seats(slot))).match();
          try (RecordingReader reader = RecordingReader.open(folder.log(slot))) {
            return loader.prepare(reader.header(), number);
          }
        }
      }
    } catch (IOException | MatchLoader.Unplayable e) {
      LOG.debug("the match in {} isn't built in advance: {}", path, e.toString());
    }
    return null;
  }

  private void refuse(RoomResume resume, int number, String why) {
    resume.forgetSeats();
    LOG.warn("{}checkpoint {} is refused: {}", room.label(), number, why);
  }

  /**
   * Begins to keep the present match.
   *
   * @param newCourse tells where the room is, from now on
   * @param newRoomSeed seed of the room's first match
   */
  public void begin(RoomCourse newCourse, long newRoomSeed, long timeNs) {
    course = newCourse;
    roomSeed = newRoomSeed;
    healthyNs = timeNs + HEALTHY_S * 1_000 * NS_PER_MS;
    beginMatch(timeNs);
  }

  /** Keeps another match from now on, which has begun with its players. */
  public void beginMatch(long timeNs) {
    nowNs = timeNs;
    if (abandoned) {
      return;
    }
    SimulationHost s = course.match().simulation();
    if (s.game().keepsMore()) {
      LOG.error(
          "{}no checkpoints: game={} keeps more than its state; after a crash the room begins anew",
          room.label(),
          s.game().name());
      header = null;
      disk.write(() -> disk.sync(() -> deleteBelow(Integer.MAX_VALUE)));
      return;
    }
    MatchInfo info = course.match().info();
    toldTooLarge = false;
    header = RecordingHeader.of(s, info.seed(), Protocol.physicsDigest());
    beginSlot();
  }

  /** Ends the log of the present match, because another one begins or the room ends. */
  public void endMatch(String why) {
    if (recorder != null) {
      recorder.end(why);
      course.match().simulation().removeJournal(recorder);
      recorder = null;
    }
    closeSlot();
  }

  /** Deletes what an earlier room of this name has left, before {@link #begin}. */
  public void forgetAll() throws IOException {
    if (store instanceof SlotFolder folder) {
      folder.create();
    }
    for (int old : store.slots()) {
      lastSlot = Math.max(lastSlot, old);
      store.delete(old);
    }
    store.forgetFailures();
  }

  /** Returns whether a whole checkpoint is certain to stay; from any thread. */
  public boolean isSafe() {
    return safeSlot > 0 && isKept();
  }

  /**
   * Returns whether the room could go on at the follower with the present tick, or has no follower
   * that could go on with it at all.
   */
  public boolean isThere() {
    return confirms == null || there == handed || givenUp || !isSafe();
  }

  /**
   * Gives the present slot up, because the room can't wait for the follower any longer. It waits
   * again when the follower has a later checkpoint.
   */
  public void waitNoLonger() {
    givenUp = true;
    SlotFile present = slot;
    if (present != null) {
      present.cut(store.title() + " is too slow; the room goes on without it");
    }
  }

  /** Returns whether what happens in the room is on the disk in a moment; from any thread. */
  public boolean isKept() {
    SlotFile present = slot;
    return present != null && present.failure() == null;
  }

  /**
   * Returns how many blocks of the log may be missing where they are kept; in a follower's journal,
   * each is a tick. From any thread.
   */
  public int uncertainBlocks() {
    SlotFile present = slot;
    return present == null ? 0 : present.uncertainBlocks();
  }

  /** Begins a slot if one is due; once per tick. */
  public void tickEnds(long timeNs) {
    nowNs = timeNs;
    if (header == null || abandoned) {
      return;
    }
    int tick = course.match().simulation().tick();
    String failure = slot == null ? "" : slot.failure();
    if (failure != null) {
      giveUp(failure);
      if (tick >= dueTick && (slot == null || slot.queuedBytes() == 0)) {
        beginSlot();
      }
    } else if (tick >= dueTick && slot.isSafe()) {
      beginSlot();
    }
  }

  /** Hands the disk what has happened since the last block, because the room pauses. */
  public void rests(long timeNs) {
    nowNs = timeNs;
    if (header != null && recorder != null && !abandoned && isKept()) {
      recorder.flush();
      if (seatsVersion != room.seats().version()) {
        writeSeats(slot);
      }
      keepAccounts(slot);
    }
  }

  /** Hands the disk a block, and before it the seats of those who come or go in it. */
  private boolean take(SlotFile to, Block type, byte[] bytes, int length) {
    if (type != Block.TICKS) {
      return to.take(type, bytes, length);
    }
    boolean changed = seatsVersion != room.seats().version();
    if (changed) {
      writeSeats(to);
    }
    handedTick = course.match().simulation().tick();
    boolean taken = to.take(type, bytes, length);
    if (changed) {
      settle(to);
    }
    keepAccounts(to);
    if (confirms != null) {
      long number = ++handed;
      to.then(() -> confirms.whenThere(() -> confirm(number)));
    }
    return taken;
  }

  /** Lets the room know when what it has noted of accounts so far is written. */
  private void keepAccounts(SlotFile to) {
    long noted = room.accounts().noted();
    if (noted > handedAccounts) {
      handedAccounts = noted;
      to.then(() -> accountsKept = Math.max(accountsKept, noted));
    }
  }

  /**
   * Returns how many of the writes of accounts that the room has noted belong to ticks from which
   * it could go on.
   *
   * @param noted how many it has noted
   */
  public long accountsKept(long noted) {
    return header == null || abandoned ? noted : accountsKept;
  }

  /** Learns that the follower has the blocks up to one; one thread at a time. */
  private void confirm(long number) {
    there = number;
    confirmed.run();
  }

  /** Frees the seats that players have left in other rooms, once the disk has their arrival. */
  private void settle(SlotFile to) {
    List<Seats.Seat> arrived = seats.unsettled();
    if (!arrived.isEmpty()) {
      to.then(() -> arrived.forEach(Seats.Seat::settle));
    }
  }

  private void giveUp(String failure) {
    if (!countedFailure && !failure.isEmpty()) {
      countedFailure = true;
      room.counters().add(Counter.CHECKPOINTS_FAILED, 1);
      if (!failing) {
        failing = true;
        LOG.error(
            "{}checkpoint {}: {}; another one is tried each second, and the log says when {} takes"
                + " it",
            room.label(),
            slot.number(),
            failure,
            store.title());
      }
      dueTick = course.match().simulation().tick() + room.config().get(ServerConfig.TICK_RATE);
    }
  }

  private void beginSlot() {
    SimulationHost s = course.match().simulation();
    SlotFile next = new SlotFile(disk, store, ++lastSlot);
    BlockSink sink = (type, bytes, length) -> take(next, type, bytes, length);
    dueTick = s.tick() + intervalTicks;
    long claim = room.ownership().claim();
    if (claim != keptClaim) {
      keptClaim = claim;
      disk.write(() -> noteClaim(claim));
    }
    countedFailure = false;
    try {
      if (recorder == null) {
        recorder = new Recorder(s, header, sink, disk.pace());
        s.addJournal(recorder);
      } else {
        recorder.goOn(s, "CHECKPOINT", header, sink);
      }
    } catch (IllegalArgumentException e) {
      if (!toldTooLarge) {
        toldTooLarge = true;
        LOG.error(
            "{}no checkpoint of game={} level={}: {}",
            room.label(),
            header.game(),
            header.levelName(),
            e.getMessage());
      }
      room.counters().add(Counter.CHECKPOINTS_FAILED, 1);
      endMatch("NO CHECKPOINT");
      next.close();
      int refused = next.number();
      disk.write(() -> disk.sync(() -> delete(refused)));
      return;
    }
    closeSlot();
    slot = next;
    slotTick = s.tick();
    slotHash = s.stateHash();
    events = SavedEvents.of(course.match().capture().frames().events(), room.bySeat());
    handedTick = slotTick - 1;
    seats.clear();
    writeSeats(next);
    handedTick = slotTick;
    settle(next);
    int number = next.number();
    long noted = room.accounts().noted();
    handedAccounts = noted;
    boolean healthy = nowNs - healthyNs >= 0;
    next.sync(
        () -> {
          deleteBelow(number);
          if (healthy) {
            forgetFailures();
          }
          safeSlot = number;
          accountsKept = Math.max(accountsKept, noted);
          givenUp = false;
          if (failing) {
            failing = false;
            LOG.info(
                "{}checkpoint {}: {} takes checkpoints again", room.label(), number, store.title());
          }
        });
    room.counters().add(Counter.CHECKPOINTS, 1);
  }

  private void noteClaim(long claim) {
    try {
      store.writeClaim(claim);
    } catch (IOException e) {
      LOG.warn("{}the claim of the checkpoints can't be noted: {}", room.label(), e.toString());
    }
  }

  private void closeSlot() {
    if (slot != null) {
      slot.close();
      slot = null;
    }
  }

  /** Deletes all slots below one but the last that the disk had. On the disk's thread. */
  private void deleteBelow(int number) {
    try {
      for (int old : store.slots()) {
        if (old < number && (old != safeSlot || number == Integer.MAX_VALUE)) {
          store.delete(old);
        }
      }
    } catch (IOException e) {
      LOG.warn("{}old checkpoints can't be deleted: {}", room.label(), e.toString());
    }
  }

  /** Deletes one slot. On the disk's thread. */
  private void delete(int number) {
    try {
      store.delete(number);
    } catch (IOException e) {
      LOG.warn("{}checkpoint {} can't be deleted: {}", room.label(), number, e.toString());
    }
  }

  private void forgetFailures() {
    try {
      store.forgetFailures();
    } catch (IOException e) {
      LOG.warn("{}old failures can't be forgotten: {}", room.label(), e.toString());
    }
  }

  private void addFailure() {
    try {
      store.addFailure();
    } catch (IOException e) {
      LOG.warn("{}the failure can't be noted: {}", room.label(), e.toString());
    }
  }

  private void writeSeats(SlotFile to) {
    seatsVersion = room.seats().version();
    SavedRoom saved =
        new SavedRoom(
            Protocol.physicsDigest(),
            SimState.LAYOUT,
            SavedRoom.config(room.room(), room.config().get(ServerConfig.TICK_RATE)),
            roomSeed,
            course.match().info().number(),
            course.rotation(),
            course.pending(),
            slotTick,
            slotHash,
            events,
            seats.next(handedTick + 1, events, nowNs),
            room.accounts().departed());
    to.seats(saved.toBytes());
  }

  /**
   * Ends, with a last checkpoint while all players still have their seats.
   *
   * @param good whether the room ends in good order; otherwise its state isn't worth another
   *     checkpoint
   */
  public void end(boolean good, long timeNs) {
    nowNs = timeNs;
    if (header == null || abandoned) {
      return;
    }
    if (good && recorder != null && course.match().simulation().tick() > slotTick) {
      beginSlot();
    }
    if (!good) {
      addFailure();
    }
    endMatch(good ? "STOPPED" : "FAILED");
    header = null;
  }

  /**
   * Keeps nothing more, because the room's thread doesn't come back: what it does if it comes back
   * after all belongs to no slot. From any thread.
   */
  public void abandon(String why) {
    abandoned = true;
    addFailure();
    SlotFile present = slot;
    if (present != null) {
      present.cut(why);
      present.close();
    }
  }
}
