package carom.game.playground;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.event.Audience.OWNER;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.PlayerRef;
import carom.sim.field.Real;
import java.util.List;

/** The state of the playground: what is saved, hashed and sent. */
public final class PlaygroundFields {
  /** A contest, which lasts for a third of a match. */
  public enum Contest {
    /** Nothing counts: before the match and after it. */
    FREE,
    /** Loose things of the level are brought into baskets. */
    BASKETS,
    /** Own things are piled up on a site. */
    TOWER,
    /** One star is kept from the others. */
    STAR
  }

  /** Most joints of a player; an older one goes when there is another. */
  public static final int MAX_LINKS = 24;

  /** Most motors of a player that obey its drive. */
  static final int MAX_MOTORS = 8;

  /** The body that a player's beam holds, or null. */
  public static final EntityRef HELD = Field.entity("held");

  /** Flag of a player whose beam is closed. */
  public static final Flag GRABS = Field.flag("grabs");

  // Of a player, written by input: the held point in the frame of the held body, metres, how far
  // from the robot it is kept, and which way the motors turn.
  static final Real AT_X = Field.real("atX");
  static final Real AT_Y = Field.real("atY");
  static final Real REACH = Field.real("reach");
  static final Count DRIVE = Field.count("drive", -1, 1);

  /** Number of things that a player has made. */
  public static final Count THINGS = Field.count("things", 0, PlaygroundGame.MAX_THINGS);

  /** Number of things that a player has brought into a basket. */
  public static final Count BASKETS = Field.count("baskets", 0, 999).to(ALL);

  /** Height of a player's best tower, whole metres. */
  public static final Count TOWER = Field.count("tower", 0, 99).to(ALL);

  /** Seconds for which a player has kept the star. */
  public static final Count STAR_SECONDS = Field.count("starSeconds", 0, 99).to(ALL);

  /** The present contest. */
  public static final Choice<Contest> CONTEST =
      Field.choice("contest", Contest.class).of(MATCH).to(ALL);

  /** The star; null while it isn't played for. */
  public static final EntityRef STAR = Field.entity("star").of(MATCH).to(ALL);

  /** The player who has the star, or null. */
  public static final PlayerRef KEEPER = Field.player("keeper").of(MATCH).to(ALL);

  /** Ticks for which nobody else can grab the star. */
  public static final Countdown SAFE = Field.countdown("safe").of(MATCH).to(ALL);

  // The server's.
  static final Count STAR_TICKS = Field.count("starTicks", 0, 1_000).to(NOBODY);
  static final EntityRef MOTOR = Field.entity("motor").to(OWNER).times(MAX_MOTORS);
  static final Count MOTORS = Field.count("motors", 0, MAX_MOTORS - 1).to(NOBODY);
  static final EntityRef LINK_A = Field.entity("linkA").to(NOBODY).times(MAX_LINKS);
  static final EntityRef LINK_B = Field.entity("linkB").to(NOBODY).times(MAX_LINKS);
  static final Count LINKS = Field.count("links", 0, MAX_LINKS - 1).to(NOBODY);

  // Of an entity: who held it last.
  static final PlayerRef HOLDER = Field.player("holder").of(ENTITY).to(NOBODY);

  private PlaygroundFields() {}

  /** Returns all of them. */
  static List<Field<?>> all() {
    return List.of(
        HELD,
        GRABS,
        AT_X,
        AT_Y,
        REACH,
        DRIVE,
        THINGS,
        BASKETS,
        TOWER,
        STAR_SECONDS,
        CONTEST,
        STAR,
        KEEPER,
        SAFE,
        STAR_TICKS,
        MOTOR,
        MOTORS,
        LINK_A,
        LINK_B,
        LINKS,
        HOLDER);
  }
}
