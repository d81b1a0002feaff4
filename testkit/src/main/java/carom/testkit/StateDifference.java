package carom.testkit;

import carom.physics.Body;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.FieldValues;

/** Names the first thing in which two simulations of one game differ, with both values. */
final class StateDifference {
  private static final String[] MOTION = {"x", "y", "cos", "sin", "vx", "vy", "angular velocity"};

  private StateDifference() {}

  /**
   * Compares two simulations at one tick.
   *
   * @return words such as {@code player 2 has nitro=0.5 once and nitro=0.25 the other time}; empty
   *     if all that can be named is equal
   */
  static String between(SimulationHost a, SimulationHost b) {
    String found = fields("the match", a.fieldValues(), b.fieldValues());
    int players = Math.max(a.playerCapacity(), b.playerCapacity());
    for (int id = 0; id < players && found.isEmpty(); id++) {
      found = players(id, a.player(id), b.player(id));
    }
    int entities = Math.max(a.entityCapacity(), b.entityCapacity());
    for (int id = 0; id < entities && found.isEmpty(); id++) {
      found = entities(id, a.entity(id), b.entity(id));
    }
    if (found.isEmpty() && a.random().state() != b.random().state()) {
      found = "Match.random() was asked more often once than the other time";
    }
    return found;
  }

  private static String players(int id, HostPlayer a, HostPlayer b) {
    if (a == null || b == null) {
      return a == b ? "" : "player " + id + " plays in one of both only";
    }
    String who = "player " + id;
    if (a.score() != b.score()) {
      return both(who, "score", a.score(), b.score());
    }
    if (a.team() != b.team()) {
      return both(who, "team", a.team(), b.team());
    }
    if ((a.entity() == null) != (b.entity() == null)) {
      return who + " has a body in one of both only";
    }
    return fields(who, a.fieldValues(), b.fieldValues());
  }

  private static String entities(int id, HostEntity a, HostEntity b) {
    if (a == null || b == null) {
      HostEntity one = a == null ? b : a;
      return a == b ? "" : "entity " + id + " (" + one.archetype().name() + ") exists only once";
    }
    String who = "entity " + id + " (" + a.archetype().name() + ")";
    if (!a.archetype().name().equals(b.archetype().name())) {
      return both("entity " + id, "archetype", a.archetype().name(), b.archetype().name());
    }
    for (int i = 0; i < MOTION.length; i++) {
      float one = motion(a.body(), i);
      float other = motion(b.body(), i);
      if (Float.floatToRawIntBits(one) != Float.floatToRawIntBits(other)) {
        return both(who, MOTION[i], one, other);
      }
    }
    return fields(who, a.fieldValues(), b.fieldValues());
  }

  private static float motion(Body<HostEntity> body, int i) {
    return switch (i) {
      case 0 -> body.x();
      case 1 -> body.y();
      case 2 -> body.cos();
      case 3 -> body.sin();
      case 4 -> body.velocityX();
      case 5 -> body.velocityY();
      default -> body.angularVelocity();
    };
  }

  private static String fields(String who, FieldValues a, FieldValues b) {
    String[] one = a.toString().split(" ");
    String[] other = b.toString().split(" ");
    for (int i = 0; i < one.length; i++) {
      if (!one[i].equals(other[i])) {
        return who + " has " + one[i] + " once and " + other[i] + " the other time";
      }
    }
    return "";
  }

  private static String both(String who, String what, Object a, Object b) {
    return who + " has " + what + "=" + a + " once and " + what + "=" + b + " the other time";
  }
}
