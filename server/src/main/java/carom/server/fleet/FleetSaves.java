package carom.server.fleet;

import carom.server.command.SaveSource;
import carom.server.config.DataFolder;
import carom.text.FileErrors;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The saved matches of all servers of a fleet. Each stays where it was saved, and goes over the
 * sealed links to the server that loads it; the newest of a name counts, by the servers' clocks.
 * Any thread.
 */
final class FleetSaves implements SaveSource {
  private static final Logger LOG = LoggerFactory.getLogger(FleetSaves.class);

  /** Most bytes of a save that goes to another server. */
  static final int MOST_BYTES = PeerChannel.MAX_FRAME - 1_024;

  private static final long NONE = 0;
  private static final long REFUSED = -1;

  private final DataFolder data;
  private final FleetView view;
  private final Peers peers;
  private final Lease self;

  FleetSaves(DataFolder data, FleetView view, Peers peers, Lease self) {
    this.data = data;
    this.view = view;
    this.peers = peers;
    this.self = self;
  }

  /** Answers another server, which asks for a save that is newer than its own. */
  PeerFrame answer(PeerFrame ask) {
    if (!DataFolder.isSaveName(ask.room())) {
      return refused("the name can't be one of a save");
    }
    Path file = data.saved(ask.room());
    try {
      long savedMs = savedMs(file);
      if (savedMs <= ask.number()) {
        return PeerFrame.of(PeerFrame.Kind.ANSWER, NONE);
      }
      if (Files.size(file) > MOST_BYTES) {
        return refused("it has more than " + MOST_BYTES + " bytes");
      }
      return PeerFrame.of(PeerFrame.Kind.ANSWER, savedMs, "", Files.readAllBytes(file));
    } catch (IOException e) {
      return refused(FileErrors.reason(e));
    }
  }

  private static PeerFrame refused(String why) {
    byte[] text = why.getBytes(StandardCharsets.UTF_8);
    return PeerFrame.of(PeerFrame.Kind.ANSWER, REFUSED, "", text);
  }

  private static long savedMs(Path file) throws IOException {
    return Files.exists(file) ? Files.getLastModifiedTime(file).toMillis() : NONE;
  }

  @Override
  public String bring(String name) throws IOException {
    Path file = data.saved(name);
    String from = "";
    for (ServerRecord server : view.servers().values()) {
      if (server.lease() == self.number()) {
        continue;
      }
      PeerFrame answer;
      try {
        byte[] nothing = {};
        answer =
            peers.ask(server, PeerFrame.of(PeerFrame.Kind.SAVED, savedMs(file), name, nothing));
      } catch (IOException e) {
        LOG.warn("fleet: server {} can't be asked for save {}: {}", server.name(), name, e);
        continue;
      }
      if (answer.number() == REFUSED) {
        throw new IOException(
            "%s has a newer save %s, which can't be brought: %s"
                .formatted(
                    server.name(), name, new String(answer.bytes(), StandardCharsets.UTF_8)));
      }
      if (answer.number() != NONE) {
        keep(file, answer);
        from = server.name();
      }
    }
    return from;
  }

  private static void keep(Path file, PeerFrame save) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path written = file.resolveSibling(file.getFileName() + ".new");
    Files.write(written, save.bytes());
    Files.setLastModifiedTime(written, FileTime.fromMillis(save.number()));
    Files.move(written, file, StandardCopyOption.REPLACE_EXISTING);
  }
}
