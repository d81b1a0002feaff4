package carom.sim;

import carom.physics.Collision;
import carom.physics.WorldDef;
import carom.sim.event.Audience;
import carom.sim.level.Level;

/**
 * The rules of a game. Write one, name it in a level file, list it as a service, and it is a
 * multiplayer game; {@code docs/GAMES.md} is the tutorial.
 *
 * <p>One instance serves one simulation. Fields may hold what {@link #setUp} found (archetypes,
 * zones, scratch objects); everything that changes while playing belongs into {@link
 * Player#memory}, {@link Simulation#memory} or the world, where it is hashed, saved and restored.
 *
 * <p>All methods run on the simulation's thread. {@code setUp}, {@code input} and {@code collision}
 * run on server and client and must do the same there; the rest runs on {@link Role#AUTHORITY}
 * only.
 */
public interface Game {
  /** The name under which it is found, lower case. */
  String name();

  /** The resource name of the level it starts with, such as {@code arena}. */
  String defaultLevel();

  /** One line for people who choose a game. */
  default String description() {
    return name();
  }

  /** Settings of the world; the default takes the level's gravity. */
  default WorldDef world(Level level) {
    return new WorldDef().withGravity(level.gravityX(), level.gravityY());
  }

  /** Ints of {@link Simulation#memory} the game wants in that level, 0..65536. */
  default int memorySize(Level level) {
    return 16;
  }

  /**
   * Whether the game keeps anything that changes outside of {@link Simulation#memory}, players and
   * entities. Its states aren't whole then: recordings of it begin at tick 0 and are computed from
   * there. Better not.
   */
  default boolean keepsMore() {
    return false;
  }

  /**
   * Whether inputs that wait at the server for the next ticks are told to the clients of those near
   * (seven ticks at most). Then these foresee what others do instead of guessing it, and the
   * present they show is right; but a modified client can read it, and react before it happens.
   * False tells inputs with their ticks only: each change of mind of others near shows as a
   * correction as late as the round trip.
   */
  default boolean relaysAhead() {
    return true;
  }

  /**
   * Whether the game asks {@link Simulation#asSeenBy}: then every tick of the last quarter of a
   * second is remembered.
   */
  default boolean looksBack() {
    return false;
  }

  /**
   * Both roles, once: registers archetypes and remembers zones. The level's statics exist. On
   * {@link Role#AUTHORITY} it may spawn entities after registering; the level's own bodies exist
   * already.
   *
   * @throws IllegalArgumentException when the level lacks what the game needs; the message tells
   *     what, and is all that a server which can't start with it says
   */
  void setUp(Simulation s);

  /** A player has joined and may get a body. */
  void join(Simulation s, Player p);

  /** A player is about to leave. Afterwards the simulation despawns everything the player owns. */
  default void leave(Simulation s, Player p) {}

  /**
   * Both roles, each tick before the world steps, for each player with a body in order of their
   * ids: turns commands into forces. May touch only the player, its memory, its body, and read
   * contacts.
   */
  void input(Simulation s, Player p, Input in);

  /** Each tick before the players' inputs. */
  default void beforeStep(Simulation s) {}

  /** Each tick after the world has stepped: goals, scores, respawns. */
  default void afterStep(Simulation s) {}

  /**
   * Both roles, during the step, for each touching pair: false refuses the response this tick. May
   * read entities and the memory of their owners; must change nothing. The default lets one-way
   * platforms pass what comes from below.
   */
  default boolean collision(Simulation s, Collision<Entity> c) {
    return OneWay.responds(s, c);
  }

  /**
   * Both roles, during the step, for each pair that hits each other harder than {@link
   * WorldDef#hitSpeed}, once per impact: the place to {@linkplain Simulation#emit tell} of it. May
   * read; must change nothing.
   *
   * @param c with {@link Collision#hitSpeed}, where and how hard; valid during the call
   */
  default void hit(Simulation s, Collision<Entity> c) {}

  /**
   * {@link Role#AUTHORITY} only, after each tick for each entity: who is told about it. Players
   * always know their own body. Who isn't told about an entity isn't told its exact state either,
   * nor of events of what is near that it takes part in; of a player whose body it is, no input.
   * What nobody is told about costs nothing, and no client can cheat it out of the wire.
   */
  default Audience audience(Simulation s, Entity e) {
    return Audience.NEAR;
  }

  /**
   * {@link Role#AUTHORITY} only, often: whether a player is told about everything everywhere, as a
   * referee or a spectator may be. It costs as much as the whole world.
   */
  default boolean seesAll(Simulation s, Player p) {
    return false;
  }
}
