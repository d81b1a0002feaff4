package carom.sim.level;

import carom.text.Suggestion;
import java.util.List;

/**
 * A trigger of a level: a condition and what happens when it comes true. Names of sensors and
 * bodies are checked when the file is read, those of fields, archetypes and events when the level
 * meets its game. Immutable.
 *
 * @param name by which other triggers switch it; empty for none
 * @param when the condition
 * @param then what happens when the condition comes true
 * @param otherwise what happens when it ceases
 * @param after seconds from the condition to what happens
 * @param every seconds after which {@code then} happens again while the condition holds; 0 for
 *     never
 * @param once whether {@code then} happens only the first time
 * @param enabled whether it works from the beginning
 */
public record LevelTrigger(
    String name,
    Condition when,
    List<Action> then,
    List<Action> otherwise,
    float after,
    float every,
    boolean once,
    boolean enabled) {
  /** Longest time of an action or condition, s. */
  public static final float MAX_SECONDS = 3600;

  /** The most triggers of a level. */
  public static final int MAX = 256;

  /** The most bodies that triggers of a level move. */
  public static final int MAX_MOVED = 64;

  /**
   * Returns an exception that says that the level's game lacks what a trigger names.
   *
   * @param where file, line and place
   * @param name of what is lacking
   * @param what a noun for it
   * @param known the names that there are
   */
  public static IllegalArgumentException unknown(
      String where, String name, String what, List<String> known) {
    return new IllegalArgumentException(
        where
            + "=\""
            + name
            + "\" must be "
            + what
            + (known.isEmpty() ? ", which has none" : Suggestion.didYouMean(name, known)));
  }

  /** Says what a condition is about. */
  public enum Cause {
    /** An entity enters a sensor. */
    ENTER,
    /** An entity leaves a sensor. */
    LEAVE,
    /** Entities are inside a sensor. */
    INSIDE,
    /** An entity hits a body. */
    HIT,
    /** A time has passed. */
    TIMER,
    /** A field of the match is within limits. */
    FIELD,
    /** A player has so many points. */
    SCORE,
    /** All of several conditions hold. */
    ALL,
    /** One of several conditions holds. */
    ANY;

    /** Returns whether it happens at a moment, and doesn't last. */
    public boolean isEvent() {
      return this == ENTER || this == LEAVE || this == HIT;
    }

    /** Returns whether an entity sets it off. */
    public boolean hasVisitor() {
      return isEvent() || this == INSIDE || this == SCORE;
    }
  }

  /** Says which entities count for a condition. */
  public enum Who {
    /** All of them. */
    ANY,
    /** Those that belong to a player. */
    PLAYER,
    /** Those that belong to nobody. */
    BODY
  }

  /**
   * A condition.
   *
   * @param cause what it is about
   * @param where file, line and place, for error messages
   * @param name of the sensor, body or field; empty for none
   * @param who which entities count
   * @param least the lowest number that suffices: of entities inside, of the impulse in N s, of the
   *     timer in seconds, of the field, of points
   * @param most the highest value of a field
   * @param parts the conditions of {@link Cause#ALL} and {@link Cause#ANY}
   */
  public record Condition(
      Cause cause,
      String where,
      String name,
      Who who,
      double least,
      double most,
      List<Condition> parts) {
    /** Returns whether it happens at a moment, and doesn't last. */
    public boolean isEvent() {
      boolean isEvent = cause.isEvent();
      for (Condition part : parts) {
        isEvent |= part.isEvent();
      }
      return isEvent;
    }

    /** Returns whether an entity may set it off. */
    public boolean hasVisitor() {
      boolean hasVisitor = cause.hasVisitor();
      for (Condition part : parts) {
        hasVisitor |= part.hasVisitor();
      }
      return hasVisitor;
    }
  }

  /** Says what an action does. */
  public enum Verb {
    /** Moves a kinematic body to a place. */
    MOVE,
    /** Creates an entity. */
    SPAWN,
    /** Takes an entity away. */
    REMOVE,
    /** Pushes an entity. */
    IMPULSE,
    /** Sets an entity to another place. */
    TELEPORT,
    /** Gives points to the visitor's player. */
    SCORE,
    /** Says where the visitor's player comes back. */
    CHECKPOINT,
    /** Sets a field of the match or of the visitor's player. */
    SET,
    /** Adds to a field of the match or of the visitor's player. */
    ADD,
    /** Says a line to all. */
    NOTICE,
    /** Tells an event of the game, with its sound and flash. */
    EVENT,
    /** Lets another trigger work. */
    ENABLE,
    /** Stops another trigger. */
    DISABLE,
    /** Plays another level. */
    NEXT
  }

  /**
   * An action.
   *
   * @param verb what it does
   * @param where file, line and place, for error messages
   * @param name of the archetype, field, event, trigger or level, or the line that is said
   * @param body the number in {@link Level#bodies} of the entity it acts on; {@link #VISITOR} for
   *     the one that set it off
   * @param x place in metres, or impulse in N s
   * @param y place in metres, or impulse in N s
   * @param amount seconds, points, or what is added
   * @param value a {@code Double} or {@code Boolean} to set
   */
  public record Action(
      Verb verb,
      String where,
      String name,
      int body,
      float x,
      float y,
      float amount,
      Object value) {
    /** Stands for the entity that set the trigger off. */
    public static final int VISITOR = -1;

    /** Returns whether it acts on the entity that set the trigger off, or on its player. */
    public boolean needsVisitor() {
      return switch (verb) {
        case REMOVE, IMPULSE, TELEPORT -> body == VISITOR;
        case SCORE, CHECKPOINT -> true;
        case SET, ADD -> name.startsWith("player.");
        default -> false;
      };
    }
  }
}
