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

  /** Collections that may be long: fixed tables, and one entry for each keyframe of a recording. */
  private static final Set<String> LONG =
      Set.of("RecordingFile.ends", "DelayedRecording.ticks", "DelayedRecording.types");

  /** Types that hold data that never changes, or nothing of ours. */
  private static final List<String> SKIPPED =
      List.of("carom.sim.level.", "carom.physics.geometry.", "carom.lab.", "carom.replay.Replay");

  private static final Map<Class<?>, Field[]> FIELDS = new HashMap<>();

  private final Map<String, Long> highest = new TreeMap<>();
  private long looks;

  /** Looks at all that can be reached from an object. */
  void check(Collection<?> roots) {
    looks++;
    Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    ArrayDeque<Object> waiting = new ArrayDeque<>();
    for (Object root : roots) {
      reach(root, seen, waiting);
    }
    for (Object next; (next = waiting.poll()) != null; ) {
      if (next instanceof Object[] array) {
        for (Object element : array) {
          reach(element, seen, waiting);
        }
      } else {
        for (Field field : fields(next.getClass())) {
          look(next, field, seen, waiting);
        }
      }
    }
  }

  private void look(Object owner, Field field, Set<Object> seen, ArrayDeque<Object> waiting) {
    try {
      Object value = field.get(owner);
      if (value == null) {
        return;
      }
      long size = size(value);
      if (size >= 0) {
        require(field, value, size);
      }
      if (value instanceof Collection<?> all) {
        all.forEach(element -> reach(element, seen, waiting));
      } else if (value instanceof Map<?, ?> map) {
        map.keySet().forEach(element -> reach(element, seen, waiting));
        map.values().forEach(element -> reach(element, seen, waiting));
      } else {
        reach(value, seen, waiting);
      }
    } catch (IllegalAccessException e) {
      throw new AssertionError(e);
    }
  }

  private void require(Field field, Object value, long size) {
    String name = field.getDeclaringClass().getSimpleName() + "." + field.getName();
    if (LONG.contains(name)) {
      return;
    }
    long general = value.getClass().isArray() ? ARRAY : COLLECTION;
    long bound = BOUNDS.getOrDefault(name, general);
    highest.merge(name, size, Math::max);
    if (size > bound) {
      throw new AssertionError("%s has size=%d, bound=%d".formatted(name, size, bound));
    }
  }

  /** Returns how much a value holds, or -1 if it is no queue. */
  private static long size(Object value) {
    if (value instanceof Collection<?> all) {
      return all.size();
    } else if (value instanceof Map<?, ?> map) {
      return map.size();
    } else if (value instanceof AtomicLong counter) {
      return counter.get();
    } else if (value instanceof Integer count) {
      return count;
    }
    return value.getClass().isArray() ? Array.getLength(value) : -1;
  }

  private static void reach(Object value, Set<Object> seen, ArrayDeque<Object> waiting) {
    if (value != null && isWalked(value.getClass()) && seen.add(value)) {
      waiting.add(value);
    }
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

  /** Returns the fields that are looked at: references, and numbers that are in the list. */
  private static Field[] fields(Class<?> type) {
    return FIELDS.computeIfAbsent(type, QueueBounds::find);
  }

  private static Field[] find(Class<?> type) {
    List<Field> found = new ArrayList<>();
    for (Class<?> c = type; c != null && isWalked(c); c = c.getSuperclass()) {
      for (Field field : c.getDeclaredFields()) {
        boolean number = field.getType().isPrimitive() || field.getType() == AtomicLong.class;
        boolean listed = BOUNDS.containsKey(c.getSimpleName() + "." + field.getName());
        if (!Modifier.isStatic(field.getModifiers())
            && (number ? listed : field.getType() != String.class)) {
          field.setAccessible(true);
          found.add(field);
        }
      }
    }
    return found.toArray(new Field[0]);
  }

  /** Returns the names in the list of which no queue was seen; renamed ones would be among them. */
  List<String> unseen() {
    return BOUNDS.keySet().stream().filter(name -> !highest.containsKey(name)).sorted().toList();
  }

  /** Returns how full the queues were that came nearest to their bounds. */
  String summary() {
    StringBuilder text = new StringBuilder();
    highest.entrySet().stream()
        .filter(e -> BOUNDS.containsKey(e.getKey()) && e.getValue() > 0)
        .sorted((a, b) -> Double.compare(share(b), share(a)))
        .limit(8)
        .forEach(
            e ->
                text.append(
                    " %s=%d/%d".formatted(e.getKey(), e.getValue(), BOUNDS.get(e.getKey()))));
    return "looks at all queues=%d, fullest:%s".formatted(looks, text);
  }

  private static double share(Map.Entry<String, Long> e) {
    return (double) e.getValue() / BOUNDS.get(e.getKey());
  }
}
