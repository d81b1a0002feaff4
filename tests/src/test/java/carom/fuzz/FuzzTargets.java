package carom.fuzz;

import carom.client.link.StatusAnswerTarget;
import carom.server.access.JoinTokenTarget;
import carom.server.checkpoint.SavedRoomTarget;
import carom.server.query.RemoteConsoleTarget;
import carom.server.query.StatusQueryTarget;
import carom.server.thin.web.ThinTextTarget;
import carom.server.web.WebTarget;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/** The targets by name, and the committed corpus of each: a zip file among the test resources. */
final class FuzzTargets {
  private static final Map<String, Supplier<FuzzTarget>> TARGETS = new LinkedHashMap<>();

  static {
    TARGETS.put("message", MessageTarget::new);
    TARGETS.put("input", InputTarget::new);
    TARGETS.put("snapshot", SnapshotTarget::new);
    TARGETS.put("level", LevelTarget::new);
    TARGETS.put("packed-level", PackedLevelTarget::new);
    TARGETS.put("recording", RecordingTarget::new);
    TARGETS.put("session", SessionTarget::new);
    TARGETS.put("link", LinkTarget::new);
    TARGETS.put("status-answer", StatusAnswerTarget::new);
    TARGETS.put("status-query", StatusQueryTarget::new);
    TARGETS.put("rcon", RemoteConsoleTarget::new);
    TARGETS.put("join-token", JoinTokenTarget::new);
    TARGETS.put("seats", SavedRoomTarget::new);
    TARGETS.put("web", WebTarget::new);
    TARGETS.put("thin-text", ThinTextTarget::new);
  }

  private FuzzTargets() {}

  static List<String> names() {
    return List.copyOf(TARGETS.keySet());
  }

  /** Returns a new target. */
  static FuzzTarget create(String name) {
    Supplier<FuzzTarget> target = TARGETS.get(name);
    if (target == null) {
      throw new IllegalArgumentException("target=" + name + " is unknown, known are " + names());
    }
    return target.get();
  }

  /** Returns the inputs that earlier runs found, by name; none when there is no corpus yet. */
  static Map<String, byte[]> corpus(String name) throws IOException {
    Map<String, byte[]> inputs = new LinkedHashMap<>();
    try (InputStream file = FuzzTargets.class.getResourceAsStream("/fuzz/" + name + ".zip")) {
      if (file != null) {
        ZipInputStream zip = new ZipInputStream(file);
        for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
          inputs.put(entry.getName(), zip.readAllBytes());
        }
      }
    }
    return inputs;
  }

  /** Returns seeds and corpus of a target. */
  static List<byte[]> inputs(String name) throws Exception {
    try (FuzzTarget target = create(name)) {
      List<byte[]> all = new ArrayList<>(target.seeds());
      all.addAll(corpus(name).values());
      return all;
    }
  }
}
