package carom.server.replication;

import carom.net.snapshot.frame.EventRing;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.thin.ThinLink;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinSnapshot;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;

/**
 * Tells one thin client what there is: the bodies in sight that changed, what is gone, fields that
 * changed, and events.
 *
 * <p>When: at the rate that the client asked for, while its budget of bytes lasts and the last
 * snapshot has left. A snapshot that couldn't be sent is replaced by the next. What: a body whose
 * pose, kind or owner isn't the one told last. Where datagrams may be lost, it is told in each
 * snapshot until the client has seen one; and every body once in {@value #AGAIN} snapshots, for
 * clients that say they have seen a snapshot of which a part was lost.
 *
 * <p>The room's thread; a snapshot allocates nothing once the arrays have grown.
 */
final class ThinSender {
  /** Ticks before tick 0. */
  private static final int NEVER = -1;

  /** Most snapshots a second while there is nothing to tell. */
  private static final int IDLE_HZ = 5;

  /** Snapshots in which each body is told at least once where datagrams may be lost. */
  private static final int AGAIN = 32;

  /** Times a second at which changed fields are told; what changed there and back isn't. */
  private static final int FIELDS_HZ = 10;

  /** Snapshots from one look at which joints are in sight to the next. */
  private static final int JOINT_LOOKS = 30;

  /** Most events told in one tick; more are dropped. */
  private static final int MOST_EVENTS = 64;

  /** Longest time in which a budget is saved up, as a part of a second. */
  private static final int BURST_PER_SECOND = 2;

  private final FrameRing frames;
  private final ThinEvents thinEvents;
  private final SimulationHost simulation;
  private final ThinLink link;
  private final Supplier<ServerConfig> config;
  private final Counters counters;
  private final SessionView view;
  private final ThinFields fields;
  private final ThinSnapshot snapshot = new ThinSnapshot();
  private final List<ThinNews> news = new ArrayList<>();
  private final int tickRateHz;

  // By slot: what the client was told last, and since which tick it is told so.
  private boolean[] told = {};
  private int[] generation = {};
  private int[] archetype = {};
  private int[] ownership = {};
  private int[] teleports = {};
  private int[] x = {};
  private int[] y = {};
  private int[] angle = {};
  private int[] poseTick = {};
  private int[] nameTick = {};
  private int[] goneTick = {};

  private long nextEvent;
  private int rateAccumulator;
  private int ticksSinceSent;
  private int firstTick = NEVER;
  private int lastTick = NEVER;
  private int lastInput = NEVER;
  private int snapshots;
  private int fieldsTick = -1_000;
  private long jointsVersion = -1;
  private ThinServerMessage.Joints joints = new ThinServerMessage.Joints(List.of());
  private long bucket;
  private long bytesSent;
  private boolean due;

  /**
   * Begins with a client that knows nothing, and tells it of the match.
   *
   * @param epoch that of the session's Welcome
   */
  ThinSender(
      FrameCapture capture,
      HostPlayer player,
      ThinLink link,
      int epoch,
      Supplier<ServerConfig> config,
      Counters counters) {
    this.link = link;
    this.config = config;
    this.counters = counters;
    frames = capture.frames();
    thinEvents = capture.thinEvents();
    simulation = capture.index().simulation();
    ServerConfig now = config.get();
    tickRateHz = now.get(ServerConfig.TICK_RATE);
    view = new SessionView(capture.index(), player, now.get(ServerConfig.VIEW), tickRateHz);
    fields = new ThinFields(simulation, player, this::sees);
    nextEvent = frames.events().limit();
    rateAccumulator = tickRateHz;
    ticksSinceSent = tickRateHz;
    boolean ownColours = simulation.game().teams().isEmpty() && simulation.game().ownColours();
    link.begin(
        ThinMatches.of(simulation, player.id(), link.room()),
        simulation.messageKinds(),
        ownColours,
        epoch);
  }

  /** Takes over what the client says it shows. */
  void look(float centreX, float centreY, float halfWidth, float halfHeight, int follows) {
    view.look(centreX, centreY, halfWidth, halfHeight, follows);
  }

  /** Returns whether the player looks at the place of an entity and may know it. */
  boolean sees(int entityId) {
    FrameState frame = frames.newest();
    return entityId < frame.slotLimit()
        && frame.alive(entityId)
        && view.sees(frame, entityId, entityId < told.length && told[entityId]);
  }

  /** Earns budget, tells events, and decides whether a snapshot is due; once per tick. */
  void prepare() {
    int bytesPerSecond = config.get().bytesPerSecond();
    long depth = (long) bytesPerSecond * tickRateHz / BURST_PER_SECOND;
    bucket = Math.min(depth, bucket + bytesPerSecond);
    int rate = Math.min(tickRateHz, Math.min(link.rate(), config.get().snapshotRateHz()));
    rateAccumulator = Math.min(tickRateHz + rate - 1, rateAccumulator + rate);
    ticksSinceSent++;
    view.follow(frames.newest());
    tellEvents();
    due = rateAccumulator >= tickRateHz && bucket > 0 && link.takesSnapshot();
    if (due) {
      fill();
      boolean hasNews = !snapshot.isEmpty() || snapshot.input != lastInput;
      due = hasNews || ticksSinceSent * IDLE_HZ >= tickRateHz;
    }
  }

  /** Returns whether the snapshot prepared last should be sent. */
  boolean isDue() {
    return due;
  }

  /** Sends the snapshot prepared last, and the fields that changed. */
  void send() {
    rateAccumulator -= tickRateHz;
    ticksSinceSent = 0;
    snapshots++;
    lastTick = snapshot.tick;
    firstTick = firstTick == NEVER ? lastTick : firstTick;
    lastInput = snapshot.input;
    int bytes = link.maySend() ? link.show(snapshot) : 0;
    bucket -= (long) bytes * tickRateHz;
    bytesSent += bytes;
    counters.add(Counter.DATAGRAMS_OUT, 1);
    counters.add(Counter.SNAPSHOT_BYTES, bytes);
    if (snapshot.tick - fieldsTick >= tickRateHz / FIELDS_HZ) {
      fieldsTick = snapshot.tick;
      ThinServerMessage.Fields changed = fields.changes();
      if (changed != null) {
        news.add(new ThinNews(changed));
      }
    }
    tellJoints();
    tellNews();
  }

  private void tellNews() {
    if (!news.isEmpty()) {
      link.news(news);
      news.clear();
    }
  }

  /** Tells the joints whenever one came or went, and looks now and then for what came in sight. */
  private void tellJoints() {
    long version = simulation.joints().version();
    if (version == jointsVersion && snapshots % JOINT_LOOKS != 0) {
      return;
    }
    jointsVersion = version;
    ThinServerMessage.Joints now = ThinMatches.joints(simulation, this::sees);
    if (!now.equals(joints)) {
      joints = now;
      news.add(new ThinNews(now));
    }
  }

  private void tellEvents() {
    EventRing events = frames.events();
    int count = 0;
    for (; nextEvent < events.limit(); nextEvent++) {
      if (!events.holds(nextEvent)
          || !view.hears(frames, events.at(nextEvent), events.audience(nextEvent))) {
        continue;
      }
      if (count++ < MOST_EVENTS) {
        news.add(thinEvents.at(nextEvent));
        counters.add(Counter.EVENTS_OFFERED, 1);
      } else {
        counters.add(Counter.EVENTS_LOST, 1);
      }
    }
    tellNews();
  }

  private void fill() {
    FrameState frame = frames.newest();
    int now = frame.tick();
    // What is told since a later tick may be unknown to the client. A stream loses nothing.
    int seen = link.isStream() ? lastTick : seenOfMatch();
    grow(frame.slotLimit());
    snapshot.clear(now, link.inputCount());
    for (int slot = 0; slot < told.length; slot++) {
      boolean there =
          slot < frame.slotLimit() && frame.alive(slot) && view.sees(frame, slot, told[slot]);
      if (there) {
        tell(frame, slot, seen, now);
      } else if (told[slot]) {
        told[slot] = false;
        goneTick[slot] = now;
        snapshot.addGone(slot);
      } else if (goneTick[slot] != NEVER) {
        if (goneTick[slot] > seen) {
          snapshot.addGone(slot);
        } else {
          goneTick[slot] = NEVER;
        }
      }
    }
  }

  /** Returns the newest tick that the client has seen; never for one of another match. */
  private int seenOfMatch() {
    int seen = link.seenTick();
    return firstTick == NEVER || seen < firstTick || seen > lastTick ? NEVER : seen;
  }

  private void tell(FrameState frame, int slot, int seen, int now) {
    if (!told[slot]
        || generation[slot] != frame.generation(slot)
        || archetype[slot] != frame.archetype(slot)
        || ownership[slot] != frame.ownership(slot)
        || teleports[slot] != frame.teleports(slot)) {
      told[slot] = true;
      generation[slot] = frame.generation(slot);
      archetype[slot] = frame.archetype(slot);
      ownership[slot] = frame.ownership(slot);
      teleports[slot] = frame.teleports(slot);
      goneTick[slot] = NEVER;
      nameTick[slot] = now;
      poseTick[slot] = now;
    } else if (x[slot] != frame.x(slot)
        || y[slot] != frame.y(slot)
        || angle[slot] != frame.angle(slot)) {
      poseTick[slot] = now;
    }
    x[slot] = frame.x(slot);
    y[slot] = frame.y(slot);
    angle[slot] = frame.angle(slot);
    boolean again = !link.isStream() && (slot + snapshots) % AGAIN == 0;
    if (again || poseTick[slot] > seen) {
      boolean named = nameTick[slot] > seen;
      snapshot.add(
          slot, x[slot], y[slot], angle[slot], named ? archetype[slot] : -1, ownership[slot]);
    }
  }

  private void grow(int slots) {
    if (told.length >= slots) {
      return;
    }
    int from = told.length;
    int size = Math.max(64, 2 * slots);
    told = Arrays.copyOf(told, size);
    generation = Arrays.copyOf(generation, size);
    archetype = Arrays.copyOf(archetype, size);
    ownership = Arrays.copyOf(ownership, size);
    teleports = Arrays.copyOf(teleports, size);
    x = Arrays.copyOf(x, size);
    y = Arrays.copyOf(y, size);
    angle = Arrays.copyOf(angle, size);
    poseTick = Arrays.copyOf(poseTick, size);
    nameTick = Arrays.copyOf(nameTick, size);
    goneTick = Arrays.copyOf(goneTick, size);
    Arrays.fill(goneTick, from, size, NEVER);
  }

  /** Returns what the line has done since the link began; what datagrams lose isn't known. */
  LinkFigures figures() {
    int arrived = link.isStream() ? snapshots : 0;
    return new LinkFigures(link.roundTripMs(), bytesSent, arrived, arrived, 0, 0);
  }
}
