package carom.lab.soak;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Looks at every queue, list, map and array that servers and clients hold, and requires that it is
 * within its bound. It finds them by walking along all references, so it forgets none: what has no
 * bound in the list below has the general one.
 */
final class QueueBounds {
  /** Bound of collections that aren't in the list: no more than two for each seat of a server. */
  private static final long COLLECTION = 256;

  /** Bound of arrays, such as those of bodies, rows and snapshots. */
  private static final int ARRAY = 1 << 16;

  /** Bounds by class and field, as the classes state them; in bytes where the name says so. */
  private static final Map<String, Long> BOUNDS =
      Map.ofEntries(
          // links
          Map.entry("InProcessNetwork.waiting", 1_024L),
          Map.entry("InProcessLink.inboxDatagrams", 1_024L),
          Map.entry("InProcessLink.inboxMessageBytes", 4L << 20),
          Map.entry("InProcessLink.inbox", 2 * 1_024L),
          Map.entry("InProcessLink.spareDatagrams", 1_024L),
          Map.entry("ImpairedDirection.datagrams", 8_192L + 1), // a duplicate may be the last
          Map.entry("ImpairedDirection.spare", 8_192L + 1),
          Map.entry("PartingLinks.partings", 1_024L),
          // sessions
          Map.entry("Arrivals.queue", 2L * Soak.SEATS),
          Map.entry("RoomSessions.sessions", (long) Soak.SEATS),
          Map.entry("Seats.foldedNames", (long) Soak.SEATS),
          Map.entry("Seats.skeletons", (long) Soak.SEATS),
          Map.entry("OperatorCommands.waiting", 64L),
          Map.entry("MessageStream.kept", 64L),
          Map.entry("SessionMessages.waiting", 128L),
          Map.entry("WaitingMessages.list", 16L * Soak.SEATS),
          Map.entry("AdmissionRate.buckets", 4_096L),
          // games
          Map.entry("NoticeQueue.texts", 16L),
          Map.entry("Outbox.messages", 1_024L),
          Map.entry("Findings.texts", 64L),
          Map.entry("Findings.known", 64L),
          Map.entry("FieldUse.written", 64L),
          // prediction
          Map.entry("EntityList.count", 1_024L),
          Map.entry("KeyList.count", 1_024L),
          Map.entry("PredictedPoses.others", 1_024L),
          Map.entry("EventReconciler.entries", 256L),
          // disk
          Map.entry("SlotFile.queued", 48L << 20),
          Map.entry("ByteSink.bytes", 32L << 20), // a whole state, as in the next three
          Map.entry("ArchiveWriter.bytes", 32L << 20),
          Map.entry("BlockWriter.stored", 32L << 20),
          Map.entry("Item.bytes", 32L << 20),
          Map.entry("RecordingFile.waiting", 17L),
          Map.entry("RecordingFile.spare", 16L),
          Map.entry("SavedEvents.lacked", (long) Soak.SEATS),
          // clients
          Map.entry("LevelDownload.kept", 16L),
          Map.entry("Redirects.followedNs", 3L),
          Map.entry("ClientView.notices", 64L));

  /** Names in the list that only clients have that decode snapshots. */
  private static final Set<String> OF_DECODERS =
      Set.of(
          "ClientView.notices",
          "EventReconciler.entries",
          "LevelDownload.kept",
          "PredictedPoses.others",
          "Redirects.followedNs");

  /** Names in the list that only servers have that send predicted sets, and their clients. */
  private static final Set<String> OF_PREDICTION =
      Set.of("EntityList.count", "KeyList.count", "PredictedPoses.others");

  /** Collections that may be long: fixed tables, and one entry for each keyframe of a recording. */
  private static final Set<String> LONG =
      Set.of("RecordingFile.ends", "DelayedRecording.ticks", "DelayedRecording.types");

  /** Types that hold data that never changes, or nothing of ours. */
  private static final List<String> SKIPPED =
      List.of("carom.sim.level.", "carom.physics.geometry.", "carom.lab.", "carom.replay.Replay");

  /** The bound of all fields of a name, and how much was seen. */
  private static final class Bound {
    final String name;
    final long limit;

    /** The most that one held, or -1 if none was seen. */
    long highest = -1;

    Bound(String name, Class<?> type) {
      this.name = name;
      long general = type.isArray() ? ARRAY : COLLECTION;
      limit = LONG.contains(name) ? Long.MAX_VALUE : BOUNDS.getOrDefault(name, general);
    }

    void require(long size) {
      highest = Math.max(highest, size);
      if (size > limit) {
        throw new AssertionError(
            String.format(Locale.ROOT, "%s has size=%d, bound=%d", name, size, limit));
      }
    }
  }

  /** A field that is looked at: a reference, or a number that is in the list. */
  private record Probe(Field field, Bound bound) {}

  /** The fields of a class whose values the scan looks at; none if it skips the class. */
  private record Plan(List<Probe> probes, boolean isArray, boolean isLeaf) {
    static final Plan SKIP = new Plan(List.of(), false, true);
    static final Plan ARRAY = new Plan(List.of(), true, false);

    static Plan of(List<Probe> probes) {
      return new Plan(
          List.copyOf(probes), false, probes.stream().allMatch(p -> isLeaf(p.field.getType())));
    }

    private static boolean isLeaf(Class<?> type) {
      return type.isPrimitive()
          || type == AtomicLong.class
          || type.isArray() && type.getComponentType().isPrimitive();
    }
  }

  private final Map<Class<?>, Plan> plans = new HashMap<>();
  private final Map<String, Bound> bounds = new TreeMap<>();
  private final Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final ArrayDeque<Object> waiting = new ArrayDeque<>();
  private long looks;

  /** Looks at all that can be reached from some objects. */
  void check(Collection<?> roots) {
    looks++;
    roots.forEach(this::reach);
    for (Object next; (next = waiting.poll()) != null; ) {
      Plan plan = plan(next.getClass());
      if (plan.isArray) {
        for (Object element : (Object[]) next) {
          reach(element);
        }
      }
      look(next, plan);
    }
    seen.clear();
  }

  private void look(Object owner, Plan plan) {
    for (int i = 0; i < plan.probes.size(); i++) {
      look(owner, plan.probes.get(i));
    }
  }

  private void look(Object owner, Probe probe) {
    Object value;
    try {
      value = probe.field.get(owner);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e);
    }
    if (value == null) {
      return;
    }
    if (value instanceof Object[] array) {
      probe.bound.require(array.length);
      reach(value);
    } else if (value.getClass().isArray()) {
      probe.bound.require(Array.getLength(value));
    } else if (value instanceof Collection<?> all) {
      probe.bound.require(all.size());
      all.forEach(this::reach);
    } else if (value instanceof Map<?, ?> map) {
      probe.bound.require(map.size());
      map.keySet().forEach(this::reach);
      map.values().forEach(this::reach);
    } else if (value instanceof AtomicLong counter) {
      probe.bound.require(counter.get());
    } else if (value instanceof Integer count) {
      probe.bound.require(count);
    } else {
      reach(value);
    }
  }

  private void reach(Object value) {
    if (value == null) {
      return;
    }
    Plan plan = plan(value.getClass());
    if (plan.isLeaf) {
      look(value, plan); // nothing is behind it, so it needn't be remembered
    } else if (seen.add(value)) {
      waiting.add(value);
    }
  }

  private Plan plan(Class<?> type) {
    Plan plan = plans.get(type);
    if (plan == null) {
      plan = find(type);
      plans.put(type, plan);
    }
    return plan;
  }

  private Plan find(Class<?> type) {
    if (type.isArray()) {
      return isWalked(type) ? Plan.ARRAY : Plan.SKIP;
    }
    List<Probe> found = new ArrayList<>();
    for (Class<?> c = type; c != null && isWalked(c); c = c.getSuperclass()) {
      for (Field field : c.getDeclaredFields()) {
        String owner = c.isAnonymousClass() ? c.getName() : c.getSimpleName();
        String name = owner + "." + field.getName();
        boolean number = field.getType().isPrimitive() || field.getType() == AtomicLong.class;
        if (!Modifier.isStatic(field.getModifiers())
            && (number ? BOUNDS.containsKey(name) : field.getType() != String.class)) {
          field.setAccessible(true);
          Bound bound = bounds.computeIfAbsent(name, n -> new Bound(n, field.getType()));
          found.add(new Probe(field, bound));
        }
      }
    }
    return Plan.of(found);
  }

  private static boolean isWalked(Class<?> type) {
    if (type.isArray()) {
      return !type.getComponentType().isPrimitive();
    }
    String name = type.getName();
    return name.startsWith("carom.")
        && !type.isEnum()
        && !type.isHidden()
        && SKIPPED.stream().noneMatch(name::startsWith);
  }

  /**
   * Returns the names in the list of which no queue was seen, although clients that play so have
   * them; renamed ones would be among them.
   */
  List<String> unseen(Soak.Play play) {
    return BOUNDS.keySet().stream()
        .filter(name -> !bounds.containsKey(name) || bounds.get(name).highest < 0)
        .filter(name -> play != Soak.Play.INPUT_ONLY || !OF_DECODERS.contains(name))
        .filter(name -> play != Soak.Play.INTERPOLATING || !OF_PREDICTION.contains(name))
        .sorted()
        .toList();
  }

  /** Returns how full the queues were that came nearest to their bounds. */
  String summary() {
    StringBuilder text = new StringBuilder();
    bounds.values().stream()
        .filter(bound -> BOUNDS.containsKey(bound.name) && bound.highest > 0)
        .sorted((a, b) -> Double.compare(share(b), share(a)))
        .limit(8)
        .forEach(
            bound ->
                text.append(
                    String.format(
                        Locale.ROOT, " %s=%d/%d", bound.name, bound.highest, bound.limit)));
    return String.format(Locale.ROOT, "looks at all queues=%d, fullest:%s", looks, text);
  }

  private static double share(Bound bound) {
    return (double) bound.highest / bound.limit;
  }
}
