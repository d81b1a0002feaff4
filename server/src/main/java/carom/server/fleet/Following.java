package carom.server.fleet;

import carom.server.checkpoint.SlotLink;
import carom.server.checkpoint.SlotMirror;
import carom.server.config.RoomConfig;
import carom.server.room.FleetRoom;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The rooms that this server follows: their journals come from their owners, so that this server
 * can go on with them. Any thread, but one at a time for each owner.
 */
final class Following {
  private static final Logger LOG = LoggerFactory.getLogger(Following.class);
  private static final SlotLink.Step[] STEPS = SlotLink.Step.values();

  /**
   * A followed room that was built in advance.
   *
   * @param room has no owner yet; null if it can't be built
   * @param match number of the match that it is built for
   */
  record Prepared(FleetRoom room, int match) {}

  /** A room that is followed. */
  static final class Followed {
    private final long owner;
    private final long claim;
    private final RoomRecord record;
    private final SlotMirror mirror;
    private volatile boolean broken;
    private volatile boolean handedOver;
    private volatile Prepared prepared; // or null

    Followed(long owner, long claim, RoomRecord record, SlotMirror mirror) {
      this.owner = owner;
      this.claim = claim;
      this.record = record;
      this.mirror = mirror;
    }

    /** Returns the owner's claim. */
    long claim() {
      return claim;
    }

    /** Returns what the owner told about the room. */
    RoomRecord record() {
      return record;
    }

    /** Returns the number of the match that is played, 0 before it is known. */
    int match() {
      return mirror.match();
    }

    /** Keeps a room that was built in advance. */
    void prepared(Prepared newPrepared) {
      prepared = newPrepared;
    }

    /** Returns whether a room of these settings is built for the present match. */
    boolean isPrepared(RoomConfig settings) {
      Prepared present = prepared;
      return present != null
          && present.match == match()
          && (present.room == null || present.room.settings().equals(settings));
    }

    /** Returns the room of these settings that was built in advance, once; null for none. */
    FleetRoom takePrepared(RoomConfig settings) {
      Prepared present = prepared;
      prepared = null;
      FleetRoom room = present == null ? null : present.room;
      return room != null && room.settings().equals(settings) ? room : null;
    }

    /** Returns the folder from which the room can go on. */
    Path folder() {
      return mirror.path();
    }

    /** Returns whether the owner has given the room up for this server. */
    boolean isHandedOver() {
      return handedOver;
    }
  }

  private final Path folder;
  private final Map<String, Followed> rooms = new ConcurrentHashMap<>();
  private final Set<Long> heard = ConcurrentHashMap.newKeySet();

  /**
   * Creates an object that follows no room.
   *
   * @param folder gets a folder for each room
   */
  Following(Path folder) {
    this.folder = folder;
  }

  /** Returns the followed rooms by name; live. */
  Map<String, Followed> rooms() {
    return rooms;
  }

  /** Returns whether a session of a followed room has this secret. */
  boolean knows(String room, long secret) {
    Followed followed = rooms.get(room);
    return followed != null && followed.mirror.knows(secret);
  }

  /** Returns the lease of a followed room's owner, 0 for none. */
  long ownerOf(String room) {
    Followed followed = rooms.get(room);
    return followed == null ? 0 : followed.owner;
  }

  /** Returns a followed room from which this server can go on, or null. */
  Followed usable(String room) {
    Followed followed = rooms.get(room);
    return followed != null && !followed.broken && followed.mirror.isUsable() ? followed : null;
  }

  /** Returns whether an owner's link is still open, so that more of its journals may come. */
  boolean hears(long owner) {
    return heard.contains(owner);
  }

  /** Learns that an owner's link has ended. */
  void lost(long owner) {
    heard.remove(owner);
  }

  /** Takes a frame of a room's owner. */
  void take(long owner, PeerFrame frame) throws IOException {
    heard.add(owner);
    switch (frame.kind()) {
      case FOLLOW -> {
        RoomRecord record = RoomRecord.parse(new String(frame.bytes(), StandardCharsets.UTF_8));
        if (!record.settings().name().equals(frame.room())) { // its name is one of a folder
          throw new IOException("room=" + frame.room() + " has the record of another room");
        }
        end(frame.room());
        SlotMirror mirror = new SlotMirror(folder.resolve(frame.room()), frame.number());
        rooms.put(frame.room(), new Followed(owner, frame.number(), record, mirror));
        LOG.info("follows room={} claim={}", frame.room(), frame.number());
      }
      case STEP -> step(owner, frame);
      case END -> end(frame.room(), owner);
      case HAND_OVER -> {
        Followed followed = rooms.get(frame.room());
        if (followed != null && followed.owner == owner) {
          followed.mirror.close();
          followed.handedOver = true;
        }
      }
      default -> throw new IOException("kind=" + frame.kind() + " comes from no owner");
    }
  }

  private void step(long owner, PeerFrame frame) {
    Followed followed = rooms.get(frame.room());
    if (followed == null || followed.owner != owner || followed.broken) {
      return;
    }
    try {
      if (frame.step() >= STEPS.length) {
        throw new IOException("step=" + frame.step() + " is unknown");
      }
      followed.mirror.apply(STEPS[frame.step()], frame.slot(), frame.bytes());
    } catch (IOException e) {
      followed.broken = true;
      LOG.error("room={} can't be followed: {}", frame.room(), e.getMessage());
    }
  }

  private void end(String room, long owner) {
    Followed followed = rooms.get(room);
    if (followed != null && followed.owner == owner) {
      end(room);
    }
  }

  /** Ends to follow a room. */
  void end(String room) {
    Followed followed = rooms.remove(room);
    if (followed != null) {
      try {
        followed.mirror.delete();
      } catch (IOException e) {
        LOG.warn("room={} was followed in files that can't be deleted: {}", room, e.getMessage());
      }
    }
  }
}
