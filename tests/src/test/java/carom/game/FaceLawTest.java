package carom.game;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.WildCalls;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.Role;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.Skill;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityHit;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.EntityMover;
import carom.sim.entity.EntityQueries;
import carom.sim.entity.Ground;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Choice;
import carom.sim.field.Cooldown;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.FieldHolder;
import carom.sim.field.FieldReader;
import carom.sim.field.Flag;
import carom.sim.field.Gauge;
import carom.sim.field.PlayerRef;
import carom.sim.field.Ratio;
import carom.sim.field.Real;
import carom.sim.level.Appearance;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.level.ScriptedMotion;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import carom.sim.outbox.Delivery;
import carom.sim.outbox.Event;
import carom.sim.outbox.NextMatch;
import carom.sim.pool.Pool;
import carom.sim.pool.PoolDef;
import java.lang.reflect.Executable;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * The law of refused calls, for what games see: a call with arguments that nobody means is refused
 * at once, by name, and changes nothing; or the match goes on. Each call is drawn in a callback of
 * a game that has one of each thing. Once an event with the label null passed, and the picture of
 * each player's window failed at the first shot.
 */
class FaceLawTest {
  private static final List<Class<?>> TYPES =
      List.of(
          SetUp.class,
          Simulation.class,
          Match.class,
          Rules.class,
          MatchClock.class,
          NextMatch.class,
          Skill.class,
          Entity.class,
          EntityJoint.class,
          EntityMover.class,
          EntityQueries.class,
          EntityHit.class,
          Ground.class,
          Contact.class,
          Player.class,
          Input.class,
          AssemblyDef.class,
          ArchetypeDef.class,
          Appearance.class,
          Area.class,
          ScriptedMotion.class,
          Level.class,
          Field.class,
          FieldReader.class,
          FieldHolder.class,
          Count.class,
          Flag.class,
          Choice.class,
          Ratio.class,
          Real.class,
          Countdown.class,
          EntityRef.class,
          PlayerRef.class,
          Gauge.class,
          Cooldown.class,
          Event.class,
          Message.class,
          MessageKind.class,
          Delivery.class,
          Pool.class,
          PoolDef.class,
          PoolDef.Spout.class);

  /** Calls of the programs that run a game, with what they know. */
  private static final Set<String> OF_PROGRAMS =
      Set.of(
          "Area.effect(World)",
          "Choice.show(int)",
          "Choice.value(int)",
          "Contact.engineOf(Contact)",
          "Contact.of(Collision)",
          "EntityJoint.engineOf(EntityJoint)",
          "EntityQueries(Queries)",
          "Event.isLike(Event)",
          "Event.isLike(Event, IntUnaryOperator)",
          "Event.set(Event)",
          "Event.set(EventKind, int, int, int, int, float, float, float, int)",
          "Field.show(int)",
          "Field.value(int)",
          "Gauge.share(FieldReader)",
          "Gauge.value(FieldReader)",
          "Gauge.value(FieldReader, int)",
          "Input.unpack(long)",
          "Level.builtIn(String)",
          "Level.builtInsOf(ClassLoader)",
          "Level.isBuiltIn(String)",
          "Level.isMovable(int)",
          "Level.load(Path)",
          "Level.parse(String, (B)",
          "ScriptedMotion.drive(Body, int, int)",
          "MatchClock.beforeStep(FieldHolder, PlayerTable, int)",
          "MatchClock.isDone(FieldHolder, PlayerTable)",
          "MatchClock.setUp(FieldHolder, int)",
          "MessageKind.comesFrom(Direction)",
          "MessageKind.parse(Map)");

  /** Parameters for which null means something, with their places. */
  private static final Set<String> MAY_BE_NULL =
      Set.of(
          "Contact.isSelf(Entity) 0",
          "Contact.other(Entity) 0",
          "Entity.isOfSameOwner(Entity) 0",
          "Event.by(Player) 0",
          "Event.of(Entity) 0",
          "Event.with(Entity) 0",
          "FieldHolder.set(EntityRef, FieldReader) 1",
          "FieldHolder.set(EntityRef, int, FieldReader) 2",
          "FieldHolder.set(PlayerRef, FieldReader) 1",
          "FieldHolder.set(PlayerRef, int, FieldReader) 2",
          "Match.connect(Entity, Entity, BiFunction) 0",
          "Match.spawn(Archetype, float, float, float, Player) 4",
          "Match.spawn(Assembly, float, float, float, Player) 4",
          "MatchClock.decide(FieldHolder, Player, int) 1",
          "MatchClock.finish(FieldHolder, Player) 1");

  private static final List<String> PLACES =
      List.of(
          "setUp",
          "join",
          "beforeStep",
          "input",
          "rules",
          "forces",
          "collision",
          "hit",
          "afterStep");

  private final long seed = Long.getLong("carom.seed", new Random().nextLong());
  private final Random random = new Random(seed);
  private final Set<String> faults = new TreeSet<>();
  private SimulationHost host;
  private WildCalls.Outcome outcome;

  @Test
  void aCallThatNobodyMeansIsRefusedByNameAndChangesNothing() throws Exception {
    Level level = WildGame.level();
    List<Executable> calls = WildCalls.of(TYPES);
    calls.removeIf(call -> OF_PROGRAMS.contains(WildCalls.name(call)));
    int made = 0;
    int refused = 0;
    for (int round = 0; round < Integer.getInteger("carom.face.rounds", 3); round++) {
      for (Executable call : calls) {
        attempt(call, PLACES.get(random.nextInt(PLACES.size())), level);
        made += outcome == null ? 0 : 1;
        refused += outcome == null || outcome.thrown() == null ? 0 : 1;
      }
    }
    assertTrue(faults.isEmpty(), () -> "seed=" + seed + "\n" + String.join("\n", faults));
    assertTrue(made > 2 * calls.size(), "too few calls found a receiver: " + made);
    assertTrue(refused > calls.size(), "too few calls were refused: " + refused);
  }

  private void attempt(Executable call, String place, Level level) {
    host = null;
    outcome = null;
    WildCalls wild = new WildCalls(random, "ball", "rod", "a", "plate", "door", "health", "lake");
    WildGame game =
        new WildGame(
            wild,
            here -> {
              if (outcome == null && here.equals(place)) {
                long before = host == null ? 0 : host.stateHash();
                outcome = wild.call(call);
                if (outcome != null) {
                  judge(place, host != null && before != host.stateHash());
                }
              }
            });
    try {
      host = new SimulationHost(game, level, 1, 60, Role.AUTHORITY);
      host.join("Ann");
      host.join("Bob");
      for (int tick = 0; tick < 12; tick++) {
        host.step();
      }
    } catch (RuntimeException e) {
      String complaint = WildCalls.complaint(e);
      if (complaint != null) {
        faults.add(outcome + " in " + place + ": later " + complaint);
      }
    }
  }

  private void judge(String place, boolean changed) {
    Throwable thrown = outcome.thrown();
    if (thrown == null) {
      for (int i = 0; i < outcome.arguments().length; i++) {
        String parameter = WildCalls.name(outcome.call()) + " " + i;
        boolean isFilter = parameter.contains("EntityFilter") && isFilter(i);
        if (outcome.hasNull(i) && !isFilter && !MAY_BE_NULL.contains(parameter)) {
          faults.add(outcome + " in " + place + " took the null at " + i);
        }
      }
      return;
    }
    String complaint = WildCalls.complaint(thrown);
    if (complaint != null) {
      faults.add(outcome + " in " + place + ": " + complaint);
    }
    if (changed) {
      faults.add(outcome + " in " + place + " changed the state, and threw " + thrown);
    }
  }

  private boolean isFilter(int parameter) {
    return outcome.call().getParameterTypes()[parameter].getSimpleName().equals("EntityFilter");
  }
}
