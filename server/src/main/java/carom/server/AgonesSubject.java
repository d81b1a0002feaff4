package carom.server;

import java.util.Set;

/** A server as Agones is told about it. Any thread. */
interface AgonesSubject {
  /** Returns what is wrong, or an empty text; as {@code /healthz} answers. */
  String problem();

  /** Returns the names of the players, who are here or expected back. */
  Set<String> players();

  /** Returns the number of rooms with players. */
  int roomsInUse();

  /** Takes no newcomers, and begins to move all rooms to other servers if there are any. */
  void drain();

  /** Returns whether the server drains, for whatever reason. */
  boolean isDraining();

  /** Returns whether no room moves any longer: all are gone, or none can go. */
  boolean isDrained();
}
