package carom.server.thin;

import java.util.List;
import java.util.Map;

/**
 * A message from the server to a thin client, sent reliably and in order, see
 * docs/protocol/THIN.md. Each door encodes it in its own form. Snapshots are {@link ThinSnapshot}s
 * instead.
 */
public sealed interface ThinServerMessage {
  /** Returns whether it says why the link closes, so that nothing may follow it. */
  default boolean isLast() {
    return this instanceof Refused || this instanceof Goodbye || this instanceof Redirect;
  }

  /**
   * Admits a client, before its first {@link Match}.
   *
   * @param version {@link ThinLink#VERSION}
   * @param secret takes the seat again over another link; never 0
   * @param tickRate ticks a second
   * @param rate snapshots a second until the client asks for others
   */
  record Welcome(int version, long secret, int tickRate, int rate) implements ThinServerMessage {}

  /** Refuses a client; the link closes after it. */
  record Refused(String reason, String text) implements ThinServerMessage {}

  /**
   * Begins a match, the first or the next: forget all bodies, fields and players of the one before.
   *
   * @param player the own player's id
   * @param tick the newest tick
   * @param room name of the room
   * @param game name of the game
   * @param level name of the level
   * @param bounds least x, least y, greatest x and greatest y that players normally reach, metres
   * @param gravity along x and y, m/s^2
   * @param theme colours of the background
   * @param zones rectangles behind the bodies, such as goals and water
   * @param archetypes kinds of bodies, by index
   * @param ground bodies that never move, all of them
   * @param events kinds of events, by index
   * @param gauges fields that players see
   * @param teams name and colour of each team; empty without teams
   * @param messages kinds of the game's own messages
   */
  record Match(
      int player,
      int tick,
      String room,
      String game,
      String level,
      List<Float> bounds,
      List<Float> gravity,
      Theme theme,
      List<Zone> zones,
      List<Archetype> archetypes,
      List<Ground> ground,
      List<EventLook> events,
      List<Gauge> gauges,
      List<Team> teams,
      List<Kind> messages)
      implements ThinServerMessage {}

  /** Colours behind the bodies, 0xRRGGBB: at the bottom, at the top, and of the grid. */
  record Theme(int background, int sky, int grid) {}

  /** A rectangle of the level, metres, to tint if it has a colour: 0xRRGGBB, -1 for none. */
  record Zone(String name, float minX, float minY, float maxX, float maxY, int rgb) {}

  /**
   * A kind of bodies.
   *
   * @param rgb fill colour, 0xRRGGBB; of the look PLAYER the owner's colour counts
   * @param outline colour of the edge
   * @param look name of a constant of {@code carom.sim.level.Appearance.Look}
   * @param sensor whether all its shapes are sensors, which touch nothing
   * @param parts convex pieces in the body's frame
   */
  record Archetype(
      String name, int rgb, int outline, String look, boolean sensor, List<Part> parts) {}

  /**
   * A convex piece.
   *
   * @param radius by which it is rounded, metres
   * @param corners x and y of each corner: one of a circle, two of a capsule
   */
  record Part(float radius, List<Float> corners) {}

  /** A body that never moves. */
  record Ground(float x, float y, float angle, Archetype kind) {}

  /** The look and sound of a kind of events. */
  record EventLook(
      String name, int rgb, float radius, String label, String sound, float fullStrength) {}

  /**
   * A field that players see.
   *
   * @param kind name of a constant of {@code carom.sim.field.Gauge.Kind}
   * @param scope {@code match}, {@code player} or {@code entity}
   * @param least value of an empty bar
   * @param most value of a full bar
   */
  record Gauge(String kind, String label, String scope, String field, float least, float most) {}

  /** A team. */
  record Team(String name, int rgb) {}

  /**
   * A kind of the game's own messages.
   *
   * @param from {@code client}, {@code server} or {@code both}
   * @param arguments each with its range, such as {@code count item 0..31}, for people
   */
  record Kind(String name, String from, List<String> arguments) {}

  /** Lists the joints in sight, all of them, whenever that list changes. */
  record Joints(List<Joint> joints) implements ThinServerMessage {}

  /**
   * A joint, for drawing.
   *
   * @param type such as {@code DISTANCE} or {@code REVOLUTE}
   * @param first body, or -1 for the ground
   * @param second body, or -1 for the ground
   * @param ax anchor in the first body's frame, or in the world's for the ground
   * @param ay anchor in the first body's frame, or in the world's for the ground
   * @param bx anchor in the second body's frame, or in the world's for the ground
   * @param by anchor in the second body's frame, or in the world's for the ground
   */
  record Joint(String type, int first, int second, float ax, float ay, float bx, float by) {}

  /**
   * Tells of players that came, changed or went; the first after a {@link Match} lists all.
   *
   * @param gone ids of those that went
   */
  record Roster(List<Participant> players, List<Integer> gone) implements ThinServerMessage {}

  /**
   * A player or a spectator.
   *
   * @param rgb colour of its body; -1 for that of the team or the archetype
   */
  record Participant(
      int id,
      String name,
      int team,
      int score,
      boolean spectator,
      boolean ready,
      boolean alive,
      int ping,
      int rgb) {}

  /** Tells of players that changed in nothing but score or ping: id, score and ping of each. */
  record Scores(List<Integer> scores) implements ThinServerMessage {}

  /** Tells of fields that changed and that this player may know. */
  record Fields(List<FieldValue> values) implements ThinServerMessage {}

  /**
   * A field's value.
   *
   * @param scope {@code match}, {@code player} or {@code entity}
   * @param id of the player or entity; 0 of the match
   * @param name such as {@code health}, or {@code lamp[3]} of a field with several values
   * @param value Boolean, Integer, Float or String; a countdown is the tick at which it is over, a
   *     choice the name of its constant, a player or entity its id or -1; null when the player may
   *     no longer know it
   */
  record FieldValue(String scope, int id, String name, Object value) {}

  /**
   * Tells of something that happened once.
   *
   * @param kind index in {@link Match#events}
   * @param player who caused it, or -1
   * @param first entity that it happened to, or -1
   * @param second other entity that took part, or -1
   * @param data number whose meaning depends on the kind
   */
  record Event(
      int kind,
      int tick,
      float x,
      float y,
      float strength,
      int player,
      int first,
      int second,
      int data)
      implements ThinServerMessage {}

  /**
   * A line of chat.
   *
   * @param player who, or -1 for the server
   * @param team whether the player's team alone hears it
   */
  record Chat(int player, String text, boolean team) implements ThinServerMessage {}

  /** Tells that a player shows an emote. */
  record Emote(int player, String emote) implements ThinServerMessage {}

  /**
   * Lists rooms.
   *
   * @param left number of rooms that follow in further messages
   */
  record Rooms(List<Room> rooms, int left) implements ThinServerMessage {}

  /** A room. */
  record Room(
      String name,
      String game,
      String level,
      String phase,
      int players,
      int places,
      Map<String, String> info) {}

  /** Lists the best of what accounts keep in the game, a list for each field that has any. */
  record Best(List<BestList> lists) implements ThinServerMessage {}

  /**
   * The best of one field.
   *
   * @param own index of the player's own entry, or -1
   * @param entries the best first
   */
  record BestList(String field, int own, List<BestEntry> entries) {}

  /** An entry: the name under which the account played last, and the value for people. */
  record BestEntry(String name, String value) {}

  /** Carries a message of the game: its kind's name, and its values by name. */
  record Custom(String kind, Map<String, Object> values) implements ThinServerMessage {}

  /**
   * Sends the client to another server; the link closes after it.
   *
   * @param server {@code host:port}
   * @param room to ask for there
   * @param token to show there as a join token; empty for the one that the client has
   */
  record Redirect(String server, String room, String token) implements ThinServerMessage {}

  /**
   * Says where the room goes on if this server is lost: {@code host:port}, empty for nowhere. The
   * client joins there with its secret and the name of the room.
   */
  record Standby(String server) implements ThinServerMessage {}

  /** Ends the session; the link closes after it. */
  record Goodbye(String reason, String text) implements ThinServerMessage {}
}
