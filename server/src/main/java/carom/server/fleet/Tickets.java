package carom.server.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetDoor;
import carom.text.Json;
import java.io.IOException;
import java.security.SecureRandom;
import java.util.Base64;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tickets by which players get from one server of a fleet to another: random, good once, at one
 * server, for ten seconds. The directory has their hashes only, so nobody who reads it can use
 * them. No clock is compared with another machine's: the ticket goes with its lease. Any thread.
 */
final class Tickets {
  private static final Logger LOG = LoggerFactory.getLogger(Tickets.class);
  private static final String PREFIX = "tickets/";
  private static final int TTL_MS = 10_000;
  private static final int BYTES = 16;

  private final Directory directory;
  private final SecureRandom random = new SecureRandom();

  Tickets(Directory directory) {
    this.directory = directory;
  }

  /**
   * Makes a ticket.
   *
   * @param server at which it is good
   * @param guest who has it
   */
  String make(long server, FleetDoor.Guest guest) throws DirectoryException {
    byte[] bytes = new byte[BYTES];
    random.nextBytes(bytes);
    String ticket =
        FleetDoor.TICKET + Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
    String value =
        FleetJson.write(
            json -> {
              json.writeNumberField("server", server);
              json.writeStringField("name", guest.name());
              json.writeStringField("account", guest.account());
              json.writeStringField("room", guest.room());
              json.writeStringField("game", guest.game());
              json.writeStringField("party", guest.party());
              json.writeNumberField("skill", guest.skill());
              json.writeBooleanField("anywhere", guest.anywhere());
            });
    if (directory.create(HashedKey.of(PREFIX, ticket), value, directory.lease(TTL_MS)) == 0) {
      throw new DirectoryException("the directory took no ticket", null);
    }
    return ticket;
  }

  /**
   * Takes a ticket, so that nobody can use it again.
   *
   * @param server this server
   * @return who has it, or null if it isn't good here
   */
  FleetDoor.Guest redeem(long server, String ticket) throws DirectoryException {
    DirectoryEntry entry = directory.get(HashedKey.of(PREFIX, ticket));
    if (entry == null) {
      return null;
    }
    try {
      Json json = FleetJson.read(entry.value());
      FleetDoor.Guest guest =
          new FleetDoor.Guest(
              FleetJson.text(json, "name"),
              FleetJson.text(json, "account"),
              FleetJson.text(json, "room"),
              FleetJson.text(json, "game"),
              FleetJson.text(json, "party"),
              (int) FleetJson.number(json, "skill"),
              FleetJson.flag(json, "anywhere"));
      boolean isHere = FleetJson.number(json, "server") == server;
      return isHere && directory.delete(entry.key(), entry.number()) ? guest : null;
    } catch (DirectoryException e) {
      throw e;
    } catch (IOException e) {
      LOG.warn("fleet: the entry {} can't be read: {}", entry.key(), e.getMessage());
      return null;
    }
  }
}
