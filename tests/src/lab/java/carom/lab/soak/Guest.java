package carom.lab.soak;

import carom.net.transport.Impairment;
import carom.sim.message.Emote;
import java.util.List;

/** A client of a soak, as far as incidents reach it. */
interface Guest {
  /** Advances the client to a moment, ns, if nobody else does. */
  void update(long nowNs);

  /** Returns whether the client has a link and its process lives. */
  boolean isConnected();

  /** Returns whether it plays. */
  boolean isPlaying();

  /** Returns the name that it asks for; no other client has the same. */
  String name();

  /** Returns the name of the room that welcomed it, or an empty text. */
  String room();

  /** Returns the number of its seat in that room, or -1. */
  int playerId();

  /** Breaks the connection; the client comes back. */
  void cut();

  /** Kills the line for some time, s: nothing gets through, and new links don't connect. */
  void blackout(double seconds);

  /** Stops the process, or lets it go on. */
  void freeze(boolean stopped);

  /** Changes the network. */
  void impair(Impairment network);

  /** Says a line to all. */
  void say(String text);

  /** Shows an emote. */
  void show(Emote emote);

  /** Asks for another room. */
  void changeRoom(String name);

  /** Leaves for good, with a goodbye or, when the process dies, without. */
  void end(boolean dies);

  /** Returns the objects from which its queues can be reached, if no stepper has them. */
  List<Object> roots();

  /** Returns how many states it compared with the server's. */
  long compared();
}
