package carom.sim;

import carom.physics.WorldDef;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Cooldown;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.NextMatch;
import java.util.List;
import java.util.function.Consumer;

/**
 * The rules of a game. Implement it, name it in a level file and list it as a service, and it is a
 * multiplayer game. {@code docs/games/GAMES.md} is the tutorial.
 *
 * <p>One instance serves one simulation. Variables may hold what {@link #setUp} found (archetypes,
 * zones, scratch objects). Everything that changes while playing belongs into {@link #fields} or
 * the world, where it is hashed, saved and restored.
 *
 * <p>All methods run on the simulation's thread. {@code setUp}, {@code input}, {@code forces},
 * {@code collision} and {@code hit} run on server and client and must do the same there. The rest
 * runs on {@link Role#AUTHORITY} only.
 */
public interface Game {
  /** Returns the name under which the game is found, in lower case. */
  String name();

  /** Returns the resource name of the level it starts with, such as {@code arena}. */
  String defaultLevel();

  /** Returns one line for people who choose a game. */
  default String description() {
    return name();
  }

  /** Returns the settings of the world. The default takes the level's gravity. */
  default WorldDef world(Level level) {
    return new WorldDef().withGravity(level.gravityX(), level.gravityY());
  }

  /**
   * Returns the fields of the game's players, entities and match, in an order that is the same
   * everywhere. They are constants of the class, and this is the one place that lists them.
   */
  default List<Field<?>> fields() {
    return List.of();
  }

  /**
   * Returns whether the game keeps changing state outside of its {@link #fields}, players and
   * entities. A saved state of such a game is incomplete, so its recordings begin at tick 0 and are
   * computed from there. Games should avoid this.
   */
  default boolean keepsMore() {
    return false;
  }

  /**
   * Returns whether clients near a player receive the inputs that wait at the server for the next
   * ticks, seven at most. If true, these clients predict other players exactly instead of guessing,
   * and show their true present. But a modified client can read the inputs and react before they
   * take effect. If false, inputs are sent with their ticks only, and each change of another
   * player's input shows as a correction one round trip later.
   */
  default boolean relaysAhead() {
    return true;
  }

  /**
   * Returns whether the game calls {@link Match#asSeenBy}. If true, the simulation remembers all
   * poses of the last quarter of a second.
   */
  default boolean looksBack() {
    return false;
  }

  /**
   * Registers archetypes and event kinds and remembers zones; both roles, once. The level's statics
   * exist.
   *
   * @throws IllegalArgumentException when the level lacks something that the game needs. The
   *     message says what; it is all that a server prints when it cannot start the game
   */
  void setUp(SetUp s);

  /**
   * Handles the beginning: once after {@link #setUp}, {@link Role#AUTHORITY} only. The level's
   * bodies exist. The place to spawn what is there from the start.
   */
  default void begin(Match m) {}

  /**
   * Returns how many may play at a time, 1 or more. A player who comes when so many play is a
   * spectator and may ask to play later.
   */
  default int maxPlayers() {
    return SimulationHost.MAX_PLAYERS;
  }

  /**
   * Returns the names of the teams among which players may choose, at most 255. The first is team
   * 1. Clients show them. Without names there is nothing to choose.
   */
  default List<String> teams() {
    return List.of();
  }

  /**
   * Returns the colour in which clients show a team, 0xRRGGBB. It should be that of its bodies.
   *
   * @param team one of {@link #teams}, 1 or more
   */
  default int teamRgb(int team) {
    int[] usual = {0xff5d5d, 0x4da3ff, 0x5ad18a, 0xffd166, 0xc792ea, 0x4cc9f0};
    return usual[(team - 1) % usual.length];
  }

  /**
   * Returns whether players may choose a colour. Clients then draw a player's body in it, or only
   * the body's rim if there are {@link #teams}. A game in which colours of bodies have a meaning of
   * their own returns false. The same at every call.
   */
  default boolean ownColours() {
    return true;
  }

  /** Returns the fields that clients show to players. The same at every call. */
  default List<Gauge> gauges() {
    return List.of();
  }

  /** Returns the waits that clients show around the own body. The same at every call. */
  default List<Cooldown> cooldowns() {
    return List.of();
  }

  /**
   * Returns the skill by which a server may put players together who are about as good; null for
   * none. The same at every call.
   */
  default Skill skill() {
    return null;
  }

  /**
   * Returns the phases of a match: warm-up, countdown, play, result. Without a clock a match lasts
   * until the game calls {@link Match#matchOver} or {@link Match#playNext}. The same at every call.
   */
  default MatchClock clock() {
    return null;
  }

  /**
   * Handles the beginning of a phase of the {@link #clock}, but for the warm-up; {@link
   * Role#AUTHORITY} only, before {@link #beforeStep}.
   */
  default void phase(Match m, MatchPhase now) {}

  /**
   * Returns what the room plays when the {@link #clock} has shown the result: what the clock names,
   * unless the game chooses by how the match went, such as the next hole of a course; {@link
   * Role#AUTHORITY} only.
   */
  default NextMatch next(Match m) {
    return clock().next();
  }

  /**
   * Handles a player who has joined, or a spectator who begins to play. It may give the player a
   * body.
   */
  void join(Match m, Player p);

  /**
   * Handles a player who is about to leave, or to become a spectator. Afterwards the simulation
   * despawns everything the player owns.
   */
  default void leave(Match m, Player p) {}

  /**
   * Returns why a player can't change to a team now, in words for the player, or null if it can;
   * {@link Role#AUTHORITY} only. The default keeps teams balanced: it refuses a team that has more
   * players than another, not counting the one that asks.
   *
   * @param team one of {@link #teams}, 1 or more, but not the player's own
   */
  default String refuseTeam(Match m, Player p, int team) {
    return BuiltInMessages.imbalance(m, p, team, teams());
  }

  /**
   * Handles a player who asked for another team and now has it; {@link Role#AUTHORITY} only. The
   * place to give the player another body.
   */
  default void teamChanged(Match m, Player p) {}

  /**
   * Returns why a player can't become a spectator now, or a spectator a player, in words for the
   * one that asks, or null if it can; {@link Role#AUTHORITY} only. There is a place for a player.
   */
  default String refuseRole(Match m, Player p, PlayerRole role) {
    return null;
  }

  /**
   * Turns a player's commands into forces; both roles, each tick before the world steps, for each
   * player with a body, in order of ids. It may change only the player, its fields and its body,
   * and may read contacts.
   */
  void input(Simulation s, Player p, Input in);

  /**
   * Returns the rules of a level that a player should notice at once, such as a door that opens or
   * a pick-up that is taken, or null without any. They apply in both roles, each tick after the
   * inputs and before the {@link #forces}; clients predict what they do, and are told what they
   * need. {@link Rules} says what they may read and change. Whether there are some is the same at
   * every call, before {@link #setUp}, too.
   */
  default Consumer<Rules> rules(Level level) {
    return null;
  }

  /**
   * Handles a message of a player, of a kind that {@link #setUp} registered; {@link Role#AUTHORITY}
   * only, before {@link #beforeStep}, by player id and then in the order of arrival. What the
   * player may do now is for the game to check; ranges and lengths have been checked.
   */
  default void message(Match m, Player p, Message message) {}

  /**
   * Returns what is said when a player writes a line of chat, or null if nothing is; {@link
   * Role#AUTHORITY} only, when {@link #message} would be called. The place to filter words, and to
   * switch chat off.
   *
   * @param p the player, who may be a {@linkplain Player#isSpectator spectator}
   * @param text what the player wrote, 1..120 characters that can be shown
   */
  default String chat(Match m, Player p, String text) {
    return text;
  }

  /**
   * Returns whether a participant without a body, a spectator or one who is out, may look at what
   * is around a player; {@link Role#AUTHORITY} only, called often. The default allows everything.
   */
  default boolean mayFollow(Match m, Player watcher, Player player) {
    return true;
  }

  /** Returns whether a player with a body may show an emote now; {@link Role#AUTHORITY} only. */
  default boolean emote(Match m, Player p, Emote emote) {
    return true;
  }

  /**
   * Applies the game's forces to one body: a wing's lift, a spring, a thruster; both roles, each
   * tick after the inputs, once for each entity whose body is dynamic and awake. Clients predict
   * what it does exactly, so push bodies here rather than in {@link #beforeStep}.
   *
   * <p>It must be a function of this entity, of fields that all players near are told (its own, its
   * owner's, the match's), the tick and the level. It may push this entity's body and change its
   * velocity, and must change nothing else. Queries of the world see the level's static geometry
   * only. A body that only {@link carom.physics.Body#applyAmbientForce ambient forces} act on can
   * fall asleep.
   *
   * @param s the simulation
   * @param e an entity with a dynamic body that is awake
   */
  default void forces(Simulation s, Entity e) {}

  /**
   * Handles a trigger of the level that says where a player comes back from now on; {@link
   * Role#AUTHORITY} only, after the physics. Games in which nobody comes back ignore it.
   *
   * @param x the place, metres
   * @param y the place, metres
   */
  default void checkpoint(Match m, Player p, float x, float y) {}

  /**
   * Handles an entity that has entered a sensor, of the level or spawned; {@link Role#AUTHORITY}
   * only, once per visit, after the physics and before {@link #afterStep}, in the order of the
   * bodies in the world. It may do anything. What a player should notice at once belongs into
   * {@link #input}, which may ask {@link Entity#isInside}.
   *
   * @param sensor an entity of an archetype that is a {@linkplain
   *     carom.sim.level.Archetype#sensor() sensor}; it notices solid dynamic bodies, and if it is
   *     dynamic itself, all solid ones, the level's statics too
   * @param visitor the entity in it; {@link Entity#owner} is the player it belongs to
   */
  default void entered(Match m, Entity sensor, Entity visitor) {}

  /**
   * Handles an entity that has left a sensor, as {@link #entered}. If one of both was despawned or
   * became another archetype in the visit, that is told here, too, in the same tick; of what {@link
   * #afterStep} despawns, after it. Of a despawned entity only archetype, id, owner and fields can
   * be asked.
   */
  default void left(Match m, Entity sensor, Entity visitor) {}

  /** Applies the rules of a tick before the players' inputs. */
  default void beforeStep(Match m) {}

  /** Applies the rules of a tick after the world has stepped: goals, scores, respawns. */
  default void afterStep(Match m) {}

  /**
   * Returns whether a touching pair collides in this tick; both roles, during the step. It may read
   * entities, their fields and those of their owners, and must change nothing but the friction,
   * restitution and tangent speed of this contact for this tick ({@link Contact#setFriction}). It
   * is also asked about what a fast body would be stopped at within the tick ({@link
   * Contact#isSwept}). The default lets bodies pass one-way platforms from below.
   */
  default boolean collision(Simulation s, Contact c) {
    return c.holdsOneWay();
  }

  /**
   * Handles an impact harder than {@link WorldDef#hitSpeed}; both roles, during the step, once per
   * impact. It is the place to {@linkplain Simulation#emit emit} an event. It may read, and must
   * change nothing else.
   *
   * @param c with {@link Contact#hitSpeed}, place and strength; valid during the call
   */
  default void hit(Simulation s, Contact c) {}

  /**
   * Handles a joint that breaks because it bears more than it can; both roles, during the step. The
   * joint is gone after the step. It is the place to {@linkplain Simulation#emit emit} an event. It
   * may read, and must change nothing else.
   *
   * @param joint still valid, with the force that broke it
   */
  default void broke(Simulation s, EntityJoint joint) {}

  /**
   * Returns which players are told about an entity; {@link Role#AUTHORITY} only, after each tick
   * for each entity. All of an assembly has the audience of its root. Players always know their own
   * body. A client that is not told about an entity receives neither its exact state nor the {@link
   * Audience#NEAR} events in which it takes part, and no input of a player whose body it is. An
   * entity that nobody is told about costs nothing, and no cheat can find it on the wire.
   */
  default Audience audience(Match m, Entity e) {
    return Audience.NEAR;
  }

  /**
   * Returns whether a player is told about everything everywhere, as a referee or a spectator may
   * be; {@link Role#AUTHORITY} only, called often. It costs as much bandwidth as the whole world.
   */
  default boolean seesAll(Match m, Player p) {
    return false;
  }
}
