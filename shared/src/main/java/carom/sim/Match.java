package carom.sim;

import carom.physics.Body;
import carom.physics.JointDef;
import carom.physics.effects.Explosion;
import carom.physics.math.SimRandom;
import carom.sim.entity.Assembly;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.EntityQueries;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.FieldHolder;
import carom.sim.level.Archetype;
import carom.sim.message.Message;
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.Delivery;
import carom.sim.outbox.NextMatch;
import carom.sim.outbox.Outbox;
import java.util.function.BiFunction;
import java.util.function.Predicate;

/**
 * The server's side of a simulation, beyond what both sides have: it spawns and joins, counts
 * scores, draws random numbers and talks to players. The callbacks that run on the server alone
 * receive it, such as {@link Game#join} and {@link Game#afterStep}. {@code get} and {@code set} are
 * for the fields of the match.
 */
public interface Match extends Simulation, FieldHolder<Entity, Player> {

  // ---- entities

  /**
   * Creates an entity under the smallest free id. An entity owned by a player without a body
   * becomes the player's body.
   *
   * @param archetype its archetype
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   * @param owner the player it belongs to, or null
   * @throws IllegalStateException during the physics, or beyond {@value
   *     SimulationHost#MAX_ENTITIES}
   */
  Entity spawn(Archetype archetype, float x, float y, float angle, Player owner);

  /** Creates an entity that belongs to nobody and isn't turned, see {@link #spawn}. */
  default Entity spawn(Archetype archetype, float x, float y) {
    return spawn(archetype, x, y, 0, null);
  }

  /**
   * Creates the bodies of an assembly as entities, and its joints. All belong to one owner. If that
   * is a player without a body, the root becomes the player's body.
   *
   * @param assembly what to make
   * @param x where the assembly's origin is, metres
   * @param y where the assembly's origin is, metres
   * @param angle of the whole assembly, radians, counterclockwise
   * @param owner the player it belongs to, or null
   * @return the root
   * @throws IllegalStateException as {@link #spawn(Archetype, float, float, float, Player)}
   */
  Entity spawn(Assembly assembly, float x, float y, float angle, Player owner);

  /** Returns the entity under an id, or null when the id is free or out of range. */
  Entity entity(int id);

  /**
   * Returns the entities in the order of their ids, without the level's static geometry. What is
   * despawned meanwhile is left out.
   */
  Iterable<Entity> entities();

  /** Returns the number of entities. */
  int entityCount();

  /**
   * Creates a joint between two entities. Clients mirror and predict it. It goes with either of
   * them, by {@link EntityJoint#destroy}, or when it breaks.
   *
   * @param a an entity, or null for the world
   * @param b another entity
   * @param how makes the definition from two bodies that stand for them: {@code (a, b) ->
   *     JointDef.revolute(a, b, x, y)}, with points of the world
   * @return the joint, whose motor, limits, spring and target may be changed at any time
   * @throws IllegalStateException during the physics, or beyond 65,535 joints
   */
  EntityJoint connect(
      Entity a, Entity b, BiFunction<Body<Object>, Body<Object>, JointDef<Object>> how);

  /**
   * Visits the entities whose boxes overlap a box, statics and sensors too, each once.
   *
   * @param minX left, m; and so on
   * @param visitor returns false to stop; it may push what it visits
   */
  void forEachInBox(float minX, float minY, float maxX, float maxY, Predicate<Entity> visitor);

  /** Pushes what is near away from a place, at once. */
  void explode(Explosion explosion);

  // ---- players

  /** Returns the players in the order of their ids, without spectators. */
  Iterable<Player> players();

  /** Returns the player under an id, or null when there is none; a spectator is none. */
  Player player(int id);

  /** Returns the number of players, without spectators. */
  int playerCount();

  /** Returns a player's name, which is any text. */
  String name(Player p);

  /** Returns a player's points. */
  int score(Player p);

  /** Sets a player's points. */
  void score(Player p, int points);

  /** Adds to a player's points. */
  default void addScore(Player p, int points) {
    score(p, score(p) + points);
  }

  /** Returns the player with the highest score, or null if several have it. */
  Player leader();

  /** Returns a player's team, a number with a meaning of the game's own; 0 by default. */
  int team(Player p);

  /** Sets a player's team. */
  void team(Player p, int team);

  /** Returns the number of players in a team. */
  int teamSize(int team);

  /** Returns the colour that a player has chosen. Nothing of the game depends on it. */
  PlayerColour colour(Player p);

  /** Returns whether a player has said to be ready. What that begins is for the game to say. */
  boolean isReady(Player p);

  /** Sets whether a player is ready, such as to false when a round has begun. */
  void ready(Player p, boolean value);

  /** Returns whether there are players, and all of them are ready. */
  boolean allReady();

  /** Returns whether a participant watches: it has no body, no team, no score and no fields. */
  boolean isSpectator(Player p);

  /**
   * Makes a player a spectator, or a spectator a player. For the game a player who becomes a
   * spectator leaves: {@link Game#leave} is called, everything the player owns is despawned, and
   * its fields, score and team are gone. A spectator who becomes a player joins: {@link Game#join}
   * is called. Id, name and link stay.
   */
  void role(Player p, PlayerRole role);

  /** Returns what a player commands in this tick. */
  Input input(Player p);

  /**
   * Returns questions about the world as a player saw it when it gave the input for this tick. Each
   * entity is where that player's screen showed it, at most a quarter of a second ago. Entities
   * that came or went since then are not found. The player's own body was on its screen where it is
   * now, so leave it out by a filter.
   *
   * @return valid until the next call; allocates nothing
   * @throws IllegalStateException when {@link Game#looksBack} is false
   */
  EntityQueries asSeenBy(Player p);

  // ---- the match

  /** Returns the random numbers of the simulation. */
  SimRandom random();

  /**
   * Sends a short text to all players, such as who scored.
   *
   * @param text cut to {@value Outbox#MAX_NOTICE_LENGTH} characters
   */
  void notice(String text);

  /**
   * Sends a message to clients: {@code m.send(SOLD.of(3)).to(player)}.
   *
   * @param message of a kind that {@link Game#setUp} registered
   * @return what names the recipients
   * @throws IllegalArgumentException when the kind isn't registered, or clients send it
   */
  Delivery send(Message message);

  /**
   * Asks the room to play something else after this tick: another level, or another game. It loads
   * while this match goes on, which takes some ticks, and then begins at tick 0 with the same
   * players. If it can't be played, this match goes on. Of several requests in a tick the last
   * counts, and while one loads, further ones are ignored.
   */
  void playNext(NextMatch next);

  /**
   * Says that the match is over: the room goes on with the next level of its rotation. In a room
   * without a rotation nothing happens, so the game should begin again by itself.
   */
  default void matchOver() {
    playNext(NextMatch.OF_ROTATION);
  }
}
