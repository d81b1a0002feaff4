package carom.server.lobby;

import carom.net.admission.AddressGroup;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.server.recording.DelayedRecording;
import carom.server.recording.ShownRecordings;
import carom.server.room.Room;
import carom.server.session.PartingLinks;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends recordings to the spectators of all rooms. A spectator requests chunks of its room's
 * recording and computes the game itself, so it costs the server a few file reads a second and the
 * room nothing. No spectator receives anything younger than the delay.
 *
 * <p>Runs on the lobby's thread. Bounded: {@value #MAX} spectators, {@value #BYTES_PER_S} bytes per
 * second each. A spectator beyond its rate gets an empty chunk and asks again.
 */
final class Spectators implements LinkHandler {
  /** Most spectators of all rooms together at a time. */
  static final int MAX = 256;

  /** Most bytes per second for one spectator. An hour of a busy match takes half a minute. */
  static final int BYTES_PER_S = 512 * 1_024;

  private static final Logger LOG = LoggerFactory.getLogger(Spectators.class);
  private static final int MAX_POLL = 32;

  /** A network's share of the places is one in so many, as soon as all are taken. */
  private static final int SHARES = 16;

  private static final long NS_PER_MS = 1_000_000;
  private static final long SILENCE_MS = 10_000;
  private static final long PARTING_MS = 1_000;

  private static final class Spectator {
    private final Link link;
    private final AddressGroup origin;
    private final Room room;
    private final DelayedRecording recording;

    /**
     * Number of bytes that this spectator needn't read, see {@link
     * DelayedRecording#skippableBytes}. Constant for the spectator's stay.
     */
    private final long skipped;

    private long heardNs;
    private long filledNs;
    private double bytes = BYTES_PER_S;

    Spectator(Link link, Room room, DelayedRecording recording, long nowNs) {
      this.link = link;
      origin = AddressGroup.ofRemote(link.remote());
      this.room = room;
      this.recording = recording;
      skipped = recording.skippableBytes(room.age());
      heardNs = nowNs;
      filledNs = nowNs;
    }
  }

  private final List<Room> rooms;
  private final List<Spectator> spectators = new ArrayList<>();
  private final PartingLinks partings = new PartingLinks(MAX);
  private Function<String, ShownRecordings> recordings; // null while nobody may watch
  private int delaySeconds;
  private long nowNs;
  private Spectator speaking;
  private String end;

  Spectators(List<Room> rooms) {
    this.rooms = rooms;
  }

  /** Lets spectators in from now on; the function finds the recordings of a room by its name. */
  void allow(Function<String, ShownRecordings> newRecordings, int newDelaySeconds) {
    recordings = newRecordings;
    delaySeconds = newDelaySeconds;
  }

  /**
   * Adds a link whose versions are right.
   *
   * @param room number of the room, from 1
   * @return null, or why the link can't watch
   */
  ServerMessage.Refused add(Link link, int room, long timeNs) {
    if (recordings == null) {
      return new ServerMessage.Refused(
          RefusalReason.NOT_SHOWN, "Its operator can change that by --spectator-delay.");
    }
    if (room > rooms.size()) {
      return new ServerMessage.Refused(
          RefusalReason.ROOM_UNKNOWN,
          "There is no room=" + room + ", they are 1.." + rooms.size() + ".");
    }
    if (spectators.size() >= MAX && !makeRoom(AddressGroup.ofRemote(link.remote()))) {
      return new ServerMessage.Refused(RefusalReason.SERVER_FULL, MAX + " people watch already.");
    }
    Room watched = rooms.get(room - 1);
    DelayedRecording recording = recordings.apply(watched.name()).present(watched.age());
    spectators.add(new Spectator(link, watched, recording, timeNs));
    count(watched);
    link.send(new ServerMessage.Watching(delaySeconds));
    LOG.info("spectator joined room {}: {}, {} in all", room, link.remote(), spectators.size());
    return null;
  }

  /**
   * Ends the stay of a network's newest spectator, if that network has more than its share and more
   * than the newcomer's. Returns whether there is room now.
   */
  private boolean makeRoom(AddressGroup newcomer) {
    Map<String, Integer> counts = new HashMap<>();
    spectators.forEach(s -> counts.merge(s.origin.network(), 1, Integer::sum));
    int most = counts.values().stream().mapToInt(n -> n).max().orElse(0);
    if (most <= MAX / SHARES || counts.getOrDefault(newcomer.network(), 0) >= most) {
      return false;
    }
    for (int i = spectators.size() - 1; i >= 0; i--) {
      Spectator s = spectators.get(i);
      if (counts.get(s.origin.network()) == most) {
        spectators.remove(i);
        count(s.room);
        s.link.send(new ServerMessage.Goodbye(GoodbyeReason.CROWDED, ""));
        partings.add(s.link, "gave way to a newcomer", nowNs + PARTING_MS * NS_PER_MS);
        return true;
      }
    }
    return false;
  }

  private void count(Room room) {
    room.watchedBy(spectators.stream().filter(s -> s.room == room).count());
  }

  /** Answers requests and drops silent spectators. Returns the amount of work done. */
  int doWork(long timeNs) {
    nowNs = timeNs;
    int work = partings.doWork(timeNs);
    for (int i = spectators.size() - 1; i >= 0; i--) {
      speaking = spectators.get(i);
      end = null;
      work += speaking.link.poll(this, MAX_POLL);
      if (end == null
          && rooms.stream().noneMatch(room -> room.name().equals(speaking.room.name()))) {
        end = "the room is closed";
        speaking.link.send(new ServerMessage.Goodbye(GoodbyeReason.ROOM_CLOSED, ""));
      }
      if (end == null && nowNs - speaking.heardNs > SILENCE_MS * NS_PER_MS) {
        end = "silent";
      }
      if (end != null) {
        spectators.remove(i);
        count(speaking.room);
        partings.add(speaking.link, end, nowNs + PARTING_MS * NS_PER_MS);
        LOG.info("spectator gone: {}, {}", speaking.link.remote(), end);
      }
    }
    return work;
  }

  @Override
  public void message(Link from, Object message) {
    speaking.heardNs = nowNs;
    if (message instanceof ClientMessage.RecordingRequest request) {
      send(speaking, request.offset());
    } else if (message instanceof ClientMessage.Leave) {
      end = "left";
    } else {
      end = "sent a message that spectators must not send";
      from.send(new ServerMessage.Goodbye(GoodbyeReason.PROTOCOL_ERROR, ""));
    }
  }

  private void send(Spectator s, long offset) {
    s.bytes = Math.min(BYTES_PER_S, s.bytes + (nowNs - s.filledNs) * 1e-9 * BYTES_PER_S);
    s.filledNs = nowNs;
    try {
      int most = (int) Math.min(ProtocolLimits.MAX_LEVEL_CHUNK_BYTES, s.bytes);
      byte[] bytes = s.recording.read(s.skipped, offset, most, s.room.age());
      s.bytes -= bytes.length;
      s.link.send(new ServerMessage.RecordingChunk(offset, bytes));
    } catch (IOException e) {
      LOG.error("the recording of room {} can't be read", s.room.number(), e);
      s.link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_ERROR, ""));
      end = "the recording can't be read";
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    // Spectators send no datagrams; one that arrives means nothing.
  }

  @Override
  public void closed(Link from, String reason) {
    end = reason;
  }

  /** Sends all spectators to another server. */
  void redirect(ServerMessage.Redirect to, long timeNs) {
    for (Spectator s : spectators) {
      s.link.send(to);
      partings.add(s.link, "sent to " + to.server(), timeNs + PARTING_MS * NS_PER_MS);
    }
    spectators.clear();
    rooms.forEach(this::count);
  }

  /** Says goodbye to all spectators. */
  void close(long timeNs) {
    for (Spectator s : spectators) {
      s.link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_STOPPING, ""));
      partings.add(s.link, "server stops", timeNs + PARTING_MS * NS_PER_MS);
    }
    spectators.clear();
  }

  boolean isDeserted() {
    return spectators.isEmpty() && partings.isEmpty();
  }

  void closeLinks() {
    partings.closeAll();
  }
}
