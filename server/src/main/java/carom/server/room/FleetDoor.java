package carom.server.room;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.account.PlayerSkill;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;

/**
 * Shows lobby and rooms the rest of the fleet: which rooms other servers own, and how players get
 * there and come from there. Every method returns at once. Any thread.
 */
public interface FleetDoor {

  /** The door of a server without a fleet, behind which there is nothing. */
  FleetDoor NONE =
      new FleetDoor() {
        @Override
        public Place find(String room, Link.Door door) {
          return null;
        }

        @Override
        public Place best(RoomSearch search, Link.Door door) {
          return null;
        }

        @Override
        public void look(List<Looker> lookers) {}

        @Override
        public List<Looker> lookersElsewhere() {
          return List.of();
        }

        @Override
        public String roomOfParty(String party, Link.Door door) {
          return null;
        }

        @Override
        public Future<String> settle(String party, String room) {
          throw new IllegalStateException("there is no fleet");
        }

        @Override
        public int roomsOf(String account) {
          return 0;
        }

        @Override
        public Future<Boolean> seats(String account) {
          throw new IllegalStateException("there is no fleet");
        }

        @Override
        public Future<Boolean> spend(String token, long seconds, boolean wasRead) {
          throw new IllegalStateException("there is no fleet");
        }

        @Override
        public boolean mayComeBack(String room) {
          return false;
        }

        @Override
        public boolean follows(String room, long secret) {
          return false;
        }

        @Override
        public void standsBy(String room, long secret) {}

        @Override
        public Future<ServerMessage> move(Place to, Guest guest, Link.Door door) {
          throw new IllegalStateException("there is no fleet");
        }

        @Override
        public Future<Guest> redeem(String ticket) {
          throw new IllegalStateException("there is no fleet");
        }

        @Override
        public List<ServerMessage.RoomEntry> roomsElsewhere(Link.Door door) {
          return List.of();
        }
      };

  /**
   * A room that another server owns.
   *
   * @param server that server's number in the directory
   * @param room name of the room
   * @param offer what its server told last
   */
  record Place(long server, String room, RoomOffer offer) {}

  /**
   * A player who looks for players about as good.
   *
   * @param game name of the game that the player is likely to play
   * @param skill in it
   */
  record Looker(String game, int skill) {}

  /**
   * A player on the way from one server to another.
   *
   * @param name the player's name
   * @param account the player's account by a join token, or empty
   * @param room name of the room
   * @param game name of the game that the player asked for, or empty
   * @param party name of the player's party, or empty
   * @param skill that the player's join token claims, or {@link PlayerSkill#NO_CLAIM}
   * @param anywhere whether the player didn't ask for this room, so that another one will do
   */
  record Guest(
      String name,
      String account,
      String room,
      String game,
      String party,
      int skill,
      boolean anywhere) {}

  /** Begins every ticket, so that it can't be taken for a join token. */
  String TICKET = "ticket.";

  /** Returns what came of a question that is answered; null if the directory didn't answer. */
  static <T> T outcome(Future<T> answered) {
    try {
      return answered.get();
    } catch (ExecutionException | InterruptedException e) {
      return null;
    }
  }

  /** Returns where a room is that another server owns and clients of a door reach, or null. */
  Place find(String room, Link.Door door);

  /**
   * Returns the room elsewhere that suits best and isn't too busy; null if none has a place.
   *
   * @param door by which the client must reach it
   */
  Place best(RoomSearch search, Link.Door door);

  /** Tells the other servers who looks for players about as good here; at most some tens. */
  void look(List<Looker> lookers);

  /**
   * Returns who looks for players about as good at servers with a higher number than this one's: of
   * two players who suit each other, the one here goes to an empty room, the other one follows.
   */
  List<Looker> lookersElsewhere();

  /** Returns a room elsewhere in which a party has members and to which a door leads, or null. */
  String roomOfParty(String party, Link.Door door);

  /**
   * Settles where the first member of a party goes, so that those who come at the same moment go
   * there, too; for some seconds, until its room has told of the party.
   *
   * @param room where to go unless another member's server has settled it
   * @return the room to which all go; null if the directory doesn't answer
   */
  Future<String> settle(String party, String room);

  /** Returns in how many rooms elsewhere an account has a seat. */
  int roomsOf(String account);

  /**
   * Asks to give an account a seat now, which the fleet lets one server do at a time: until the
   * seat is told, {@link #roomsOf} doesn't know of it.
   *
   * @return whether this server may; null if the directory doesn't answer
   */
  Future<Boolean> seats(String account);

  /**
   * Asks whether a join token counts, which others haven't shown in the fleet where it could be
   * read.
   *
   * @param token what is known of it
   * @param seconds for which it is good
   * @param wasRead whether others may have read it now: it never counts again
   * @return the answer; null if the directory doesn't answer
   */
  Future<Boolean> spend(String token, long seconds, boolean wasRead);

  /**
   * Returns whether a room has had an owner a moment ago and has none now, or leaves its owner, so
   * that another server may be about to go on with it.
   */
  boolean mayComeBack(String room);

  /** Returns whether this server follows a room in which a session has this secret. */
  boolean follows(String room, long secret);

  /**
   * Tells the owner of a room that this server follows that a session's client stands by here, so
   * that the owner may hand the room over.
   */
  void standsBy(String room, long secret);

  /**
   * Makes a ticket for a player and returns what to send to its client; null if the directory
   * doesn't answer.
   */
  Future<ServerMessage> move(Place to, Guest guest, Link.Door door);

  /** Takes a ticket of this server, once, and returns who has it; null if it isn't good. */
  Future<Guest> redeem(String ticket);

  /** Returns what lists of rooms say about the rooms of other servers to which a door leads. */
  List<ServerMessage.RoomEntry> roomsElsewhere(Link.Door door);
}
