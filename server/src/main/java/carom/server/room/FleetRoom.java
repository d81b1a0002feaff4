package carom.server.room;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.checkpoint.SlotDisk;
import carom.server.checkpoint.SlotLink;
import carom.server.config.RoomConfig;
import carom.server.session.Ownership;
import java.util.Set;
import java.util.function.Function;

/**
 * A room as its fleet sees it: what it tells, and how it goes from server to server. Any thread.
 */
public interface FleetRoom {
  /** Returns the name of the room. */
  String name();

  /** Returns the settings with which another server can go on with it. */
  RoomConfig settings();

  /** Returns what a list of rooms says about it. */
  ServerMessage.RoomEntry entry();

  /** Returns what newcomers who name no room are told by. */
  RoomOffer offer();

  /** Returns how many seats are taken. */
  int players();

  /** Returns the parties of which a member has a seat. */
  Set<String> parties();

  /** Returns the accounts that have a seat. */
  Set<String> accounts();

  /** Returns the part of their time that its ticks take, percent. */
  int loadPercent();

  /** Returns the last tick of the present match that was computed. */
  int tick();

  /** Returns the ticks a second. */
  int tickRateHz();

  /** Returns whether the room closed itself because of an error. */
  boolean hasFailed();

  /** Returns whether the room has closed. */
  boolean isClosed();

  /** Returns whether this server owns the room. */
  Ownership ownership();

  /** Learns that the server owns it again, or no longer. */
  void ownershipChanged();

  /** Returns whether another server could go on with the room now. */
  boolean isFollowed();

  /**
   * Returns how many ticks the room's follower may lack, to within the second between two states.
   */
  int followerLag();

  /**
   * Returns how many ticks of its journal the room couldn't compute again when it went on from one.
   */
  int lostTicks();

  /**
   * Sends the room's journal to another server from its next turn on, which can go on with the
   * room; or ends that.
   *
   * @param disk sends; stays the caller's to close, after this room
   * @param link takes the journal there; null for none
   * @param seconds time between whole states, s
   * @param waits whether the room tells a tick only when the other server has it
   */
  void followedBy(SlotDisk disk, SlotLink link, int seconds, boolean waits);

  /** Returns the secrets of the sessions whose clients, of Carom's own, have links to the room. */
  Set<Long> linked();

  /** Closes the links of all clients. */
  void closeClients();

  /**
   * Sends clients to the server that is about to have the room, because it can't speak to them.
   *
   * @param standbys secrets of the sessions whose clients stand by there, and aren't sent
   */
  void sendOn(ServerMessage.Move move, Set<Long> standbys);

  /**
   * Ends the room in its next turn without a word to its players, because another server goes on
   * with it; its journals get the last tick.
   *
   * @param where leads to that server, by the doors of clients; null where it can't be told
   * @param ended told when the room has ended, for this reason or another, on the room's thread
   */
  void handOver(Function<Link.Door, ServerMessage.Redirect> where, Runnable ended);
}
