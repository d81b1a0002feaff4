package carom.server.fleet;

import carom.server.config.RoomConfig;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryException;
import carom.server.session.Ownership;
import java.io.IOException;
import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The rooms that this server owns, by its claims in the directory. Any thread. */
final class Claims {
  /** Begins the keys of the notes of each room's last claim, which outlive owners. */
  private static final String LAST = "succession/";

  private static final Logger LOG = LoggerFactory.getLogger(Claims.class);

  /** The claim of a room. Its fields are the fleet's thread's, unless they say otherwise. */
  static final class Claim {
    private final RoomConfig settings;
    private final Ownership ownership;
    private volatile long number;

    /** The record that the directory was told last; while it is handed over, any thread's. */
    String told;

    /** When it is told next; 0 before the room is built. */
    long nextNs;

    /** Lease of the server that follows the room, 0 for none. */
    long follower;

    /** Secrets of the sessions whose clients stand by at the follower; any thread. */
    final Set<Long> standbys = ConcurrentHashMap.newKeySet();

    /** Since when the room could move, but for its clients, ns; 0 for not yet. */
    long gathersNs;

    /** When the follower could go on with the room last, ns. */
    long followedNs;

    /** Lease of the last follower that was too slow, 0 for none. */
    long slow;

    /** True if the follower wasn't even asked to follow; any thread. */
    volatile boolean unasked;

    /** Lease of the server to which the room moves, 0 for none; any thread. */
    volatile long movesTo;

    /** True once the room has ended here, because another server goes on with it. */
    volatile boolean handedOver;

    private Claim(RoomConfig settings, Ownership ownership) {
      this.settings = settings;
      this.ownership = ownership;
    }

    String room() {
      return settings.name();
    }

    String key() {
      return RoomRecord.key(settings.name());
    }

    RoomConfig settings() {
      return settings;
    }

    Ownership ownership() {
      return ownership;
    }

    long number() {
      return number;
    }
  }

  private final Directory directory;
  private final Lease lease;
  private final FleetNews news;
  private final Map<String, Claim> claims = new ConcurrentHashMap<>();

  Claims(Directory directory, Lease lease, FleetNews news) {
    this.directory = directory;
    this.lease = lease;
    this.news = news;
  }

  /** Returns the claim of a room, or null. */
  Claim of(String room) {
    return claims.get(room);
  }

  /** Returns all claims; live. */
  Collection<Claim> all() {
    return claims.values();
  }

  /**
   * Claims a room.
   *
   * @return null if another server owns it
   */
  Claim make(RoomConfig room) throws DirectoryException {
    return make(room, unclaimed());
  }

  /** Returns the ownership of a room that isn't this server's yet. */
  Ownership unclaimed() {
    return Ownership.under(lease);
  }

  /**
   * Claims a room that was built before.
   *
   * @param ownership of the room, {@link #unclaimed} so far
   * @return null if another server owns it
   */
  Claim make(RoomConfig room, Ownership ownership) throws DirectoryException {
    Claim claim = new Claim(room, ownership);
    if (!renew(claim)) {
      news.claimsRefused.incrementAndGet();
      return null;
    }
    claims.put(room.name(), claim);
    return claim;
  }

  /**
   * Claims a room again, after the lease of its claim has ended.
   *
   * @return false if another server owns it
   */
  boolean renew(Claim claim) throws DirectoryException {
    String value = RoomRecord.claimed(lease.number(), claim.settings).toJson();
    Directory.Succession made =
        directory.succeed(claim.key(), value, lease.number(), LAST + claim.room());
    if (made.number() == 0) {
      return false;
    }
    claim.told = value;
    claim.nextNs = Math.min(claim.nextNs, 1);
    claim.number = made.number();
    claim.ownership.claim(made.number(), made.before());
    news.claimsWon.incrementAndGet();
    LOG.info("owns room={} claim={}", claim.room(), made.number());
    return true;
  }

  /** Forgets a claim that is another server's by now. */
  void lose(Claim claim) {
    LOG.warn("lost room={} claim={}", claim.room(), claim.number);
    news.lost(claim.room(), claim.number);
    claim.ownership.claim(0);
    claims.remove(claim.room());
  }

  /**
   * Tells that a room is about to be released for its follower; if that one is gone, any other
   * server may go on with it.
   *
   * @return false if the room is another server's by now
   */
  boolean leave(Claim claim) throws DirectoryException {
    try {
      claim.told = RoomRecord.parse(claim.told).leaving(claim.follower).toJson();
      return directory.update(claim.key(), claim.told, claim.number);
    } catch (DirectoryException e) {
      throw e;
    } catch (IOException e) {
      throw new IllegalStateException("a record of our own can't be read", e);
    }
  }

  /** Gives a room up, so that another server may claim it. */
  void release(Claim claim) throws DirectoryException {
    claim.ownership.claim(0);
    claims.remove(claim.room());
    directory.delete(claim.key(), claim.number);
    LOG.info("released room={} claim={}", claim.room(), claim.number);
  }
}
