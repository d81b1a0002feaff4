package carom.sim.ruling;

import carom.physics.BodyType;
import carom.physics.rows.BodyRow;
import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.PlayerTable;
import carom.sim.field.FieldStore;
import carom.sim.field.Scope;
import carom.sim.phase.Findings;
import carom.sim.phase.Phase;
import carom.sim.phase.Phases;
import carom.sim.phase.RecurrenceMeter;
import java.util.Arrays;
import java.util.function.IntSupplier;
import java.util.function.IntUnaryOperator;

/**
 * Records what the game itself does to bodies in its rules: it moves or pushes them, wakes them, or
 * changes fields of theirs or of their players that are told to clients. Clients don't run these
 * methods, so they can't predict the result; replication reads this log and tells them.
 *
 * <p>One tick of the simulation, and the calls in it:
 *
 * <pre>
 *   replication, after tick n - 1     watch(entity)
 *   tick n    Game.join, leave, message, beforeStep: noted before and after
 *             Game.input, noted if it read what others aren't told
 *             physics
 *             Game.afterStep: noted before and after; then the watched list is empty again
 *   replication, after tick n         lastTick(entity) == n: the game interfered in tick n
 * </pre>
 *
 * <p>What it did to a body that stays awake is a {@link Ruling}, which can be told as such. All
 * else needs the exact state of the entity: see {@link #lastUntoldTick}.
 *
 * <p>Only watched entities are compared, so the others cost nothing; the bodies of players are
 * always compared, see {@link #lastTick(HostPlayer)}. The log is no part of the simulation's state.
 * It is filled on {@code Role.AUTHORITY} only. One thread; allocates only to grow.
 */
public final class InterferenceLog implements Phases.Listener {
  /** Holds what is known of one entity or one player. */
  private static final class Mark {
    Object subject;
    boolean watched;
    long stamp;
    long ruled;
    int[] row;
    int lastTick;
    int lastUntoldTick;
    int lastHiddenTick;
    Scope hiddenScope;
    int hiddenWord;
    boolean beforeStep;
    JointNotes joints;
    final RecurrenceMeter meter = new RecurrenceMeter();
  }

  private static final int POSE = bits(BodyRow.X, 4);
  private static final int VELOCITY = bits(BodyRow.VX, 3);
  private static final int LOADS = bits(BodyRow.LOADS, BodyRow.LOAD_INTS);

  private final EntityTable entities;
  private final PlayerTable players;

  /** Marks of entities, by id. */
  private Mark[] ofEntities = new Mark[64];

  /** Marks of players, by id. */
  private Mark[] ofPlayers = new Mark[16];

  private final Findings findings;
  private final Definitions definitions = new Definitions();
  private final RulingLog rulings = new RulingLog();
  private final Ruling ruling = new Ruling();
  private final Phases<HostPlayer> phases;
  private final IntSupplier clock;
  private final FieldStore fields;
  private final IntUnaryOperator jointKey;
  private final JointNotes joints = new JointNotes();
  private final int[] row = new int[BodyRow.INTS];
  private HostEntity[] watched = new HostEntity[16];
  private int watchedCount;

  /** True while the state before the rules is noted, and that after them isn't. */
  private boolean rulesRun;

  /**
   * Creates an empty log.
   *
   * @param jointKey returns the key in the table of joints of a world's joint: its index there in
   *     the lower 16 bits
   */
  public InterferenceLog(
      EntityTable entities,
      Phases<HostPlayer> phases,
      IntUnaryOperator jointKey,
      Findings findings,
      IntSupplier clock) {
    this.jointKey = jointKey;
    this.findings = findings;
    this.entities = entities;
    this.phases = phases;
    this.clock = clock;
    players = entities.players();
    fields = entities.fields();
  }

  /** Begins to listen to the phases; a server's does. */
  public void listen() {
    phases.listen(
        this,
        Phase.JOIN,
        Phase.LEAVE,
        Phase.MESSAGE,
        Phase.BEFORE_STEP,
        Phase.INPUT,
        Phase.AFTER_STEP);
  }

  @Override
  public void began(Phase phase) {
    if (phase != Phase.INPUT) {
      beginRules();
    }
  }

  @Override
  public void ended(Phase phase) {
    int tick = clock.getAsInt();
    if (phase == Phase.BEFORE_STEP) {
      endRules(tick, tick, true);
      beginInputs();
    } else if (phase == Phase.INPUT && fields.hasReadHidden()) {
      endInput(phases.player(), tick);
    } else if (phase == Phase.AFTER_STEP) {
      endRules(tick, tick + 1, false);
      endWatch();
    }
  }

  /** Compares an entity in the next step, too. A second call before that step has no effect. */
  public void watch(HostEntity entity) {
    ofEntities = grown(ofEntities, entity.id());
    if (find(ofEntities, entity.id(), entity) == null) {
      findWhatClientsLack(entity);
    }
    Mark mark = claim(ofEntities, entity.id(), entity);
    if (mark.watched) {
      return;
    }
    mark.watched = true;
    mark.ruled = ruled(entity);
    if (rulesRun) {
      noteBefore(entity, mark);
    }
    if (watchedCount == watched.length) {
      watched = Arrays.copyOf(watched, 2 * watchedCount);
    }
    watched[watchedCount++] = entity;
  }

  /** Tells if a body was spawned with more than its archetype says. */
  private void findWhatClientsLack(HostEntity entity) {
    String what = definitions.difference(entity.archetype(), entity.body());
    if (what != null) {
      findings.add(
          "spawn " + what + " " + entity.archetype().index(),
          "spawn(archetype, def) gives entity "
              + entity.id()
              + " ("
              + entity.archetype().name()
              + ") another "
              + what
              + " than its archetype, so clients can't predict it; register an archetype that has"
              + " it.");
    }
  }

  /**
   * Returns the last tick in which the game interfered with an entity while it was watched, or -1.
   * Waking a body counts, even if the game did so by what it put beside it.
   */
  public int lastTick(HostEntity entity) {
    Mark mark = find(ofEntities, entity.id(), entity);
    return mark == null ? -1 : mark.lastTick;
  }

  /**
   * Returns the last tick in which the game did something to an entity that no {@link Ruling}
   * tells, while it was watched, or -1. Such things are to put it to sleep, to change fields of it
   * or of its player outside of {@code Game.input}, and to make, destroy or change one of its
   * joints.
   */
  public int lastUntoldTick(HostEntity entity) {
    Mark mark = find(ofEntities, entity.id(), entity);
    return mark == null ? -1 : mark.lastUntoldTick;
  }

  /**
   * Returns the last tick in which the input of an entity's owner read what not all players near
   * are told, while the entity was watched, or -1.
   */
  public int lastHiddenTick(HostEntity entity) {
    Mark mark = find(ofEntities, entity.id(), entity);
    return mark == null ? -1 : mark.lastHiddenTick;
  }

  /**
   * Notes that a client is told, or would have to be, what an input did to an entity because of
   * {@link #lastHiddenTick}.
   */
  public void toldInput(HostEntity entity) {
    Mark mark = find(ofEntities, entity.id(), entity);
    HostPlayer owner = players.get(entity.ownerId());
    if (mark != null && mark.hiddenScope != null && owner != null) {
      fields
          .use()
          .toldInput(mark.hiddenScope, mark.hiddenWord, owner.fieldValues(), mark.lastHiddenTick);
    }
  }

  /** Returns what the game did to watched bodies that stayed awake. For reading only. */
  public RulingLog rulings() {
    return rulings;
  }

  /**
   * Returns whether the game interfered before the physics of {@link #lastUntoldTick}. Then the
   * bodies that this one touches are affected in the same tick. Otherwise nothing but this entity
   * differs after that tick.
   */
  public boolean wasBeforeStep(HostEntity entity) {
    Mark mark = find(ofEntities, entity.id(), entity);
    return mark != null && mark.beforeStep;
  }

  /**
   * Returns the last tick whose state of a player's body doesn't follow from input and physics
   * alone, or -1. The game then moved, pushed or exchanged the body, or wrote the player's fields.
   * A push in {@code Game.afterStep} shows a tick later, so it counts for the tick after.
   */
  public int lastTick(HostPlayer player) {
    Mark mark = find(ofPlayers, player.id(), player);
    return mark == null ? -1 : mark.lastTick;
  }

  /**
   * Notes the state of all watched bodies before the game's rules run. A second call before they
   * end has no effect: {@code Game.join}, {@code Game.leave} and {@code Game.beforeStep} together
   * are the rules before a step, and a body is told one ruling of them.
   */
  private void beginRules() {
    if (rulesRun) {
      return;
    }
    rulesRun = true;
    ofPlayers = grown(ofPlayers, players.limit());
    for (int id = 0; id < players.limit(); id++) {
      HostPlayer player = players.get(id);
      if (player != null) {
        claim(ofPlayers, id, player).stamp = player.entity() == null ? 0 : bodyStamp(player);
      }
    }
    for (int i = 0; i < watchedCount; i++) {
      if (entities.holds(watched[i])) {
        noteBefore(watched[i], ofEntities[watched[i].id()]);
      }
    }
  }

  private static void noteBefore(HostEntity entity, Mark mark) {
    mark.stamp = stamp(entity);
    mark.row = mark.row == null ? new int[BodyRow.INTS] : mark.row;
    Ruling.readRow(entity, mark.row);
  }

  private void endWatch() {
    for (int i = 0; i < watchedCount; i++) {
      ofEntities[watched[i].id()].watched = false;
    }
    Arrays.fill(watched, 0, watchedCount, null);
    watchedCount = 0;
  }

  /**
   * Notes what the rules changed in the tick that is being computed.
   *
   * @param shownTick the first tick that shows what they did to a player's body
   */
  private void endRules(int tick, int shownTick, boolean beforeStep) {
    rulesRun = false;
    ofPlayers = grown(ofPlayers, players.limit());
    for (int id = 0; id < players.limit(); id++) {
      HostPlayer player = players.get(id);
      if (player != null && player.entity() != null) {
        Mark mark = claim(ofPlayers, id, player);
        if (bodyStamp(player) != mark.stamp) {
          mark.lastTick = Math.max(mark.lastTick, shownTick);
        }
        if (ruled(player.entity()) != mark.ruled) {
          mark.ruled = ruled(player.entity());
          mark.lastTick = Math.max(mark.lastTick, tick);
        }
      }
    }
    for (int i = 0; i < watchedCount; i++) {
      if (entities.holds(watched[i])) {
        Mark mark = ofEntities[watched[i].id()];
        boolean told = noteRuling(watched[i], mark, tick, beforeStep);
        boolean wrote = ruled(watched[i]) != mark.ruled;
        mark.ruled = ruled(watched[i]);
        if (!told || wrote || stamp(watched[i]) != mark.stamp) {
          mark.beforeStep = beforeStep || (mark.lastUntoldTick == tick && mark.beforeStep);
          mark.lastUntoldTick = tick;
          mark.lastTick = tick;
        }
      }
    }
  }

  /**
   * Notes the state of the players' watched entities before the inputs. Needed only if one of these
   * may read what not all players near are told.
   */
  private void beginInputs() {
    if (!fields.schema().hasHidden()) {
      return;
    }
    for (int i = 0; i < watchedCount; i++) {
      HostEntity entity = watched[i];
      if (entity.ownerId() == HostEntity.NO_OWNER || !entities.holds(entity)) {
        continue;
      }
      Mark mark = ofEntities[entity.id()];
      noteBefore(entity, mark);
      if (entity.body().hasJoints() || mark.joints != null) {
        mark.joints = mark.joints == null ? new JointNotes() : mark.joints;
        mark.joints.read(entity);
      }
    }
  }

  /**
   * Notes what a player's input did to the player's watched entities, because it depended on what
   * not all players near are told. The body gets a ruling even if nothing was done to it: that is
   * how clients know that they need not guess.
   */
  private void endInput(HostPlayer player, int tick) {
    if (fields.hasReadUntold()) {
      ofPlayers = grown(ofPlayers, players.limit());
      claim(ofPlayers, player.id(), player).lastTick = tick; // its own client can't know it either
    }
    for (int i = 0; i < watchedCount; i++) {
      HostEntity entity = watched[i];
      if (entity.ownerId() != player.id() || !entities.holds(entity)) {
        continue;
      }
      Mark mark = ofEntities[entity.id()];
      boolean isBody = entity == player.entity();
      mark.lastHiddenTick = tick;
      mark.hiddenScope = fields.hiddenScope();
      mark.hiddenWord = fields.hiddenWord();
      boolean told = noteInput(entity, mark, tick, isBody) && noteJoints(entity, mark, tick);
      if (!told || (isBody && fields.hasWrittenShared())) {
        mark.beforeStep = true;
        mark.lastUntoldTick = tick;
        mark.lastTick = tick;
      }
    }
  }

  private boolean noteInput(HostEntity entity, Mark mark, int tick, boolean always) {
    Ruling.readRow(entity, row);
    ruling.setDifference(mark.row, row);
    if (row[BodyRow.SLEEP_TIME] == BodyRow.ASLEEP) {
      return ruling.mask == 0;
    }
    if (ruling.mask != 0 || always) {
      addInput(entity, tick);
    }
    return true;
  }

  private boolean noteJoints(HostEntity entity, Mark mark, int tick) {
    if (stamp(entity) == mark.stamp) {
      return true;
    }
    joints.read(entity);
    boolean told = mark.joints != null && mark.joints.areOfSame(joints);
    boolean any = false;
    for (int i = 0; told && i < joints.count(); i++) {
      mark.joints.compare(i, joints, jointKey.applyAsInt(joints.slot(i)) & 0xffff, ruling);
      if (ruling.mask != 0) {
        any = true;
        addInput(entity, tick);
      }
    }
    return told && (any || joints.count() == 0);
  }

  private void addInput(HostEntity entity, int tick) {
    ruling.tick = tick;
    ruling.moment = Ruling.Moment.INPUT;
    ruling.key = entity.id() | entity.generation() << 16;
    rulings.add().set(ruling);
  }

  /**
   * Notes what the rules did to a body, if anything.
   *
   * @return false if they did something that a ruling can't say
   */
  private boolean noteRuling(HostEntity entity, Mark mark, int tick, boolean beforeStep) {
    Ruling.readRow(entity, row);
    ruling.setDifference(mark.row, row);
    if (ruling.mask == 0) {
      return true;
    }
    mark.lastTick = tick;
    if (row[BodyRow.SLEEP_TIME] == BodyRow.ASLEEP) {
      return false;
    }
    ruling.tick = tick;
    ruling.moment = beforeStep ? Ruling.Moment.BEFORE_STEP : Ruling.Moment.AFTER_STEP;
    ruling.key = entity.id() | entity.generation() << 16;
    rulings.add().set(ruling);
    if (mark.meter.note(tick)) {
      find(entity, mark.meter.firstTick());
    }
    return true;
  }

  /** Counts what the rules wrote to an entity's fields and to those of the player it is of. */
  private long ruled(HostEntity entity) {
    HostPlayer owner = players.get(entity.ownerId());
    boolean isBody = owner != null && owner.entity() == entity;
    return entity.fieldValues().ruled() + (isBody ? owner.fieldValues().ruled() : 0);
  }

  /** Tells that the rules change a body again and again. */
  private void find(HostEntity entity, int firstTick) {
    String callback = phases.now().callback();
    String deed = deed(ruling.mask);
    String advice;
    if (entity.archetype().type() != BodyType.DYNAMIC && (ruling.mask & Ruling.ARCHETYPE) == 0) {
      advice = "give its archetype a motion, which clients know, or call Rules.move";
    } else if ((ruling.mask & Ruling.ARCHETYPE) != 0) {
      advice = "let Game.input call become, or call it once";
    } else if ((ruling.mask & POSE) != 0) {
      advice = "let Game.input or Game.forces set its velocity";
    } else {
      advice = "use Game.forces";
    }
    findings.add(
        callback + " " + deed + " " + entity.archetype().index(),
        callback
            + " "
            + deed
            + " entity "
            + entity.id()
            + " ("
            + entity.archetype().name()
            + ") every tick, so clients can't predict it; "
            + advice
            + ". First seen at tick "
            + firstTick
            + ".");
  }

  private static String deed(int mask) {
    if ((mask & Ruling.ARCHETYPE) != 0) {
      return "changes the archetype of";
    }
    if ((mask & POSE) != 0) {
      return "moves";
    }
    if ((mask & VELOCITY) != 0) {
      return "sets the velocity of";
    }
    return (mask & LOADS) != 0 ? "pushes" : "wakes";
  }

  /** Returns the bits of a ruling's mask for some ints of a row. */
  private static int bits(int from, int count) {
    return ((1 << count) - 1) << from - BodyRow.MOTION;
  }

  private static long bodyStamp(HostPlayer player) {
    return player.entity().body().stamp();
  }

  private static long stamp(HostEntity entity) {
    return entity.body().jointStamp();
  }

  private static Mark find(Mark[] marks, int id, Object subject) {
    Mark mark = id >= 0 && id < marks.length ? marks[id] : null;
    return mark != null && mark.subject == subject ? mark : null;
  }

  /** Finds the mark of an id, empty if it was another subject's. */
  private static Mark claim(Mark[] marks, int id, Object subject) {
    Mark mark = marks[id];
    if (mark == null) {
      mark = new Mark();
      marks[id] = mark;
    }
    if (mark.subject != subject) {
      mark.subject = subject;
      mark.watched = false;
      mark.stamp = 0;
      mark.lastTick = -1;
      mark.lastUntoldTick = -1;
      mark.lastHiddenTick = -1;
      mark.hiddenScope = null;
      mark.beforeStep = false;
      mark.meter.clear();
    }
    return mark;
  }

  private static Mark[] grown(Mark[] marks, int id) {
    return id < marks.length ? marks : Arrays.copyOf(marks, Math.max(id + 1, 2 * marks.length));
  }
}
