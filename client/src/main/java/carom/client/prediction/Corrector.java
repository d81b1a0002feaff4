package carom.client.prediction;

import carom.client.field.OwnWords;
import carom.client.interpolation.Pose;
import carom.net.codec.Quantizer;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ContactRow;
import carom.physics.rows.FieldRow;
import carom.physics.rows.JointRow;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.JointTable;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * Writes the server's state into the predicted simulation: exact states from an update or, without
 * one, the own section and the quantised records. One prediction's; allocates only to grow.
 */
final class Corrector {
  /** Place of an entity that is dropped; contacts with it are dropped, too. */
  private static final int DROPPED = Integer.MAX_VALUE;

  private static final float POSITION_TOLERANCE = 1.0f / Quantizer.POSITION_STEPS;
  private static final float ANGLE_TOLERANCE = (float) (2 * Math.PI / Quantizer.ANGLE_STEPS);

  /** Largest error, about, of velocities that are derived from rounded poses, m/s and rad/s. */
  private static final float DERIVED_VELOCITY = 0.1f;

  private static final float DERIVED_OMEGA = 0.3f;

  private final SimulationHost simulation;
  private final SnapshotRecords records;
  private final OwnWords words;

  /** The predicted set before the correction. */
  private final Neighbourhood current;

  /** The predicted set after it. */
  private final Neighbourhood next;

  private final int[] bodyRow = new int[BodyRow.INTS];
  private final int[] contactRow = new int[ContactRow.INTS];
  private final int[] fieldRow = new int[FieldRow.INTS];
  private final int[] jointRow = new int[JointRow.INTS];

  /** By place in the update: the place in {@link #next}, or -1. */
  private final int[] placeOf = new int[NearState.MAX_ENTITIES];

  /** By place in {@link #current}: the place in {@link #next}, or {@link #DROPPED}. */
  private int[] newPlace = new int[16];

  private final Pose target = new Pose();
  private final JointTies ties = new JointTies();
  private final OwnAssembly assembly;

  Corrector(SimulationHost simulation, HostPlayer player, SnapshotRecords records, OwnWords words) {
    this.simulation = simulation;
    this.records = records;
    this.words = words;
    current = new Neighbourhood(player.id());
    next = new Neighbourhood(player.id());
    assembly = new OwnAssembly(records);
  }

  /** Returns what makes the own assembly without exact state. */
  OwnAssembly assembly() {
    return assembly;
  }

  /** Removes all entities from the simulation. */
  void clear() {
    next.clear();
    next.write(simulation, records);
  }

  /**
   * Applies an update of exact states. The simulation must stand at its base tick.
   *
   * @param ownKey key of the own body
   * @return whether the update contains the own body; if not, nothing has changed
   */
  boolean apply(NearUpdate update, int ownKey) {
    update.use();
    current.readAll(simulation);
    next.clear();
    reserve();
    Arrays.fill(newPlace, 0, current.count(), DROPPED);
    int from = 0;
    for (int i = 0; i < update.count(); i++) {
      int key = update.key(i);
      int mine = current.find(key, from);
      from = mine < 0 ? from : mine + 1; // both lists are in the order of the world
      placeOf[i] = -1;
      boolean hasState = update.hasState(i) && isBody(update.rows(), update.rowOf(i));
      if ((!hasState && mine < 0) || next.find(key, 0) >= 0) {
        continue;
      }
      placeOf[i] = next.count();
      if (mine >= 0 && !update.hasState(i)) {
        newPlace[mine] = placeOf[i]; // an entity with a state comes with its contacts
      }
      if (hasState) {
        add(update.rows(), update.rowOf(i));
      } else {
        add(current.rows().bodies(), mine);
      }
    }
    if (next.find(ownKey, 0) < 0) {
      return false; // the update is for another body
    }
    addJoints(update);
    keepJoints();
    addContacts(update);
    keepContacts();
    addFields(update);
    keepFields();
    next.write(simulation, records);
    return true;
  }

  /**
   * Removes the entities that a list of the server lacks, and what joints and contacts they have.
   *
   * @param near lists some of the simulation's entities, in the order of the world
   */
  void dropUnlisted(NearState near) {
    current.readAll(simulation);
    next.clear();
    reserve();
    for (int i = 0; i < current.count(); i++) {
      int place = next.count();
      boolean listed = place < near.count() && near.key(place) == current.key(i);
      newPlace[i] = listed ? place : DROPPED;
      if (listed) {
        add(current.rows().bodies(), i);
      }
    }
    keepJoints();
    keepContacts();
    keepFields();
    next.write(simulation, records);
  }

  private void add(Rows from, int row) {
    next.rows().add(RowKind.BODY, from.ints(), from.at(row));
  }

  private void addJoints(NearUpdate update) {
    for (int row = 0; row < update.rows().count(); row++) {
      if (update.kind(row) == RowKind.JOINT) {
        copy(update.rows(), row, jointRow);
        jointRow[JointRow.END_A] = translate(update, jointRow[JointRow.END_A]);
        jointRow[JointRow.END_B] = translate(update, jointRow[JointRow.END_B]);
        addJoint();
      }
    }
  }

  /** Keeps the present joints between entities that stay as they are. */
  private void keepJoints() {
    Rows joints = current.rows().joints();
    for (int row = 0; row < joints.count(); row++) {
      copy(joints, row, jointRow);
      jointRow[JointRow.END_A] = newPlace(jointRow[JointRow.END_A]);
      jointRow[JointRow.END_B] = newPlace(jointRow[JointRow.END_B]);
      addJoint();
    }
  }

  /** Adds a joint in the order of keys, which is the order in which the server solves joints. */
  private void addJoint() {
    if (jointRow[JointRow.END_A] == DROPPED || jointRow[JointRow.END_B] == DROPPED) {
      return;
    }
    Rows joints = next.rows().joints();
    int index = JointTable.index(jointRow[JointRow.KEY]);
    int at = joints.count();
    while (at > 0 && JointTable.index(joints.get(at - 1, JointRow.KEY)) > index) {
      at--;
    }
    if (at > 0 && JointTable.index(joints.get(at - 1, JointRow.KEY)) == index) {
      return; // told twice
    }
    next.rows().add(RowKind.JOINT, jointRow, 0);
    for (int i = joints.count() - 1; i > at; i--) {
      joints.set(i, joints, i - 1);
    }
    System.arraycopy(jointRow, 0, joints.ints(), joints.at(at), JointRow.INTS);
  }

  private static void copy(Rows from, int row, int[] to) {
    System.arraycopy(from.ints(), from.at(row), to, 0, to.length);
  }

  private void addContacts(NearUpdate update) {
    for (int row = 0; row < update.rows().count(); row++) {
      if (update.kind(row) == RowKind.CONTACT) {
        read(update.rows(), row);
        contactRow[ContactRow.END_A] = translate(update, contactRow[ContactRow.END_A]);
        contactRow[ContactRow.END_B] = translate(update, contactRow[ContactRow.END_B]);
        if (isFinite(contactRow, ContactRow.FLOATS, ContactRow.INTS)) {
          addContact();
        }
      }
    }
  }

  private void read(Rows from, int row) {
    System.arraycopy(from.ints(), from.at(row), contactRow, 0, ContactRow.INTS);
  }

  private void reserve() {
    if (newPlace.length < current.count()) {
      newPlace = new int[Math.max(2 * newPlace.length, current.count())];
    }
  }

  /** Translates a place in the update into one in {@link #next}. */
  private int translate(NearUpdate update, int end) {
    if (end < 0) {
      return end;
    }
    return end < update.count() && placeOf[end] >= 0 ? placeOf[end] : DROPPED;
  }

  /** Keeps the present contacts between entities that stay as they are. */
  private void keepContacts() {
    Rows contacts = current.rows().contacts();
    for (int row = 0; row < contacts.count(); row++) {
      read(contacts, row);
      contactRow[ContactRow.END_A] = newPlace(contactRow[ContactRow.END_A]);
      contactRow[ContactRow.END_B] = newPlace(contactRow[ContactRow.END_B]);
      addContact();
    }
  }

  private void addFields(NearUpdate update) {
    for (int row = 0; row < update.rows().count(); row++) {
      if (update.kind(row) == RowKind.FIELDS) {
        int place = update.rows().get(row, FieldRow.PLACE);
        if (place < update.count() && update.hasState(place)) {
          addFields(update.rows(), row, translate(update, place));
        }
      }
    }
  }

  /** Keeps the present fields of entities that stay as they are. */
  private void keepFields() {
    Rows fields = current.rows().of(RowKind.FIELDS);
    for (int row = 0; row < fields.count(); row++) {
      addFields(fields, row, newPlace[fields.get(row, FieldRow.PLACE)]);
    }
  }

  private void addFields(Rows from, int row, int place) {
    if (place != DROPPED) {
      System.arraycopy(from.ints(), from.at(row), fieldRow, 0, FieldRow.INTS);
      fieldRow[FieldRow.PLACE] = place;
      next.rows().add(RowKind.FIELDS, fieldRow, 0);
    }
  }

  /** Translates a place in {@link #current} into one in {@link #next}. */
  private int newPlace(int end) {
    return end < 0 ? end : newPlace[end];
  }

  private void addContact() {
    if (contactRow[ContactRow.END_A] != DROPPED && contactRow[ContactRow.END_B] != DROPPED) {
      next.rows().add(RowKind.CONTACT, contactRow, 0);
    }
  }

  /**
   * Corrects the simulation without an update. The own body gets the server's exact state, and what
   * joints tie to it moves along rigidly. Another body moves to its quantised record if it is
   * farther away than quantisation explains, unless joints hold it: then it waits for the update.
   *
   * @param own the own body after {@code stateTick}, as the server has it
   * @param ownOnly whether all other entities are removed
   */
  void correct(OwnState own, int stateTick, boolean ownOnly) {
    current.clear();
    if (!ownOnly) {
      current.readAll(simulation);
    }
    int ownKey = Neighbourhood.key(own.slot(), own.generation());
    next.clear();
    reserve();
    int ownPlace = current.find(ownKey, 0);
    ties.find(current, ownPlace);
    for (int i = 0; i < current.count(); i++) {
      int key = current.key(i);
      newPlace[i] = DROPPED;
      if (key == ownKey) {
        readOwn(own, ownKey);
      } else if (records.isKnown(key)) {
        Rows bodies = current.rows().bodies();
        System.arraycopy(bodies.ints(), bodies.at(i), bodyRow, 0, BodyRow.INTS);
        if (ties.isTiedToOwn(i)) {
          moveWithOwn(bodies, bodies.at(ownPlace), own);
        } else if (!ties.isTied(i)
            && records.readPose(key, stateTick, target)
            && !isAtTarget(key)) {
          moveBody();
        }
      } else {
        continue; // the server has removed it
      }
      newPlace[i] = next.count();
      next.rows().add(RowKind.BODY, bodyRow, 0);
    }
    if (ownPlace < 0) {
      next.clear();
      readOwn(own, ownKey);
      assembly.add(bodyRow, stateTick, next.rows());
    } else {
      keepJoints();
      keepContacts();
      keepFields();
    }
    next.write(simulation, records);
    if (ownPlace < 0) {
      assembly.place(simulation, ownKey, stateTick);
    }
    records.holdCut(simulation);
    words.write(own);
  }

  /**
   * Moves {@link #bodyRow} as the own body is moved, as if both were one rigid body.
   *
   * @param bodies rows of the present set
   * @param from where the own body's row begins
   * @param own where the own body is moved to
   */
  private void moveWithOwn(Rows bodies, int from, OwnState own) {
    boolean same = true;
    for (int i = 0; i < BodyRow.MOTION_INTS; i++) {
      same &= bodies.ints()[from + BodyRow.MOTION + i] == own.bits(i);
    }
    if (same) {
      return;
    }
    float cosBefore = Float.intBitsToFloat(bodies.ints()[from + BodyRow.COS]);
    float sinBefore = Float.intBitsToFloat(bodies.ints()[from + BodyRow.SIN]);
    float cosAfter = own(own, BodyRow.COS);
    float sinAfter = own(own, BodyRow.SIN);
    float c = cosAfter * cosBefore + sinAfter * sinBefore;
    float s = sinAfter * cosBefore - cosAfter * sinBefore;
    float dx = get(BodyRow.X) - Float.intBitsToFloat(bodies.ints()[from + BodyRow.X]);
    float dy = get(BodyRow.Y) - Float.intBitsToFloat(bodies.ints()[from + BodyRow.Y]);
    float cos = get(BodyRow.COS);
    float sin = get(BodyRow.SIN);
    set(BodyRow.X, own(own, BodyRow.X) + c * dx - s * dy);
    set(BodyRow.Y, own(own, BodyRow.Y) + s * dx + c * dy);
    set(BodyRow.COS, c * cos - s * sin);
    set(BodyRow.SIN, s * cos + c * sin);
    for (int i = BodyRow.VX; i <= BodyRow.OMEGA; i++) {
      set(i, get(i) + own(own, i) - Float.intBitsToFloat(bodies.ints()[from + i]));
    }
    clearLoads();
  }

  private static float own(OwnState own, int field) {
    return Float.intBitsToFloat(own.bits(field - BodyRow.MOTION));
  }

  private float get(int field) {
    return Float.intBitsToFloat(bodyRow[field]);
  }

  private void set(int field, float value) {
    bodyRow[field] = Float.floatToRawIntBits(value);
  }

  /** Reads the own body, awake and without loads, into {@link #bodyRow}. */
  private void readOwn(OwnState own, int ownKey) {
    bodyRow[BodyRow.KEY] = ownKey;
    bodyRow[BodyRow.ARCHETYPE] =
        isArchetype(own.archetype())
            ? own.archetype()
            : records.archetype(Neighbourhood.id(ownKey)).index();
    for (int i = 0; i < BodyRow.MOTION_INTS; i++) {
      bodyRow[BodyRow.MOTION + i] = own.bits(i);
    }
    clearLoads();
  }

  /** Makes {@link #bodyRow} awake, with nothing acting on it. */
  private void clearLoads() {
    bodyRow[BodyRow.SLEEP_TIME] = 0;
    Arrays.fill(bodyRow, BodyRow.LOADS, BodyRow.LOADS + BodyRow.LOAD_INTS, 0);
  }

  private void turnTo(int field, float derived, float error) {
    if (!(Math.abs(get(field) - derived) <= error)) {
      set(field, derived);
    }
  }

  /** Returns whether a row is a valid body: a bad number would poison the simulation. */
  private boolean isBody(Rows rows, int row) {
    float cos = Float.intBitsToFloat(rows.get(row, BodyRow.COS));
    float sin = Float.intBitsToFloat(rows.get(row, BodyRow.SIN));
    int motion = rows.at(row) + BodyRow.MOTION;
    int loads = rows.at(row) + BodyRow.LOADS;
    return isArchetype(rows.get(row, BodyRow.ARCHETYPE))
        && isFinite(rows.ints(), motion, motion + BodyRow.MOTION_INTS)
        && isFinite(rows.ints(), loads, loads + BodyRow.LOAD_INTS)
        && Math.abs(cos * cos + sin * sin - 1) < 1e-3f;
  }

  private boolean isArchetype(int index) {
    return simulation.archetypes().get(index) != null;
  }

  private static boolean isFinite(int[] rows, int from, int to) {
    for (int i = from; i < to; i++) {
      if (!(Math.abs(Float.intBitsToFloat(rows[i])) < OwnState.LIMIT)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns whether an entity is at {@link #target}, as far as quantised records tell. Velocities
   * aren't compared: the received poses say them less exactly than the prediction, and a wrong one
   * shows in the next pose.
   */
  private boolean isAtTarget(int key) {
    HostEntity e = simulation.entity(Neighbourhood.id(key));
    Body<HostEntity> body = e.body();
    return Math.abs(body.x() - target.x) <= POSITION_TOLERANCE
        && Math.abs(body.y() - target.y) <= POSITION_TOLERANCE
        && Math.abs(Pose.wrap(body.angle() - target.angle)) <= ANGLE_TOLERANCE;
  }

  /**
   * Moves {@link #bodyRow} to {@link #target}. A velocity that agrees with the derived one stays,
   * as it is the more exact one.
   */
  private void moveBody() {
    float cos = (float) Math.cos(target.angle);
    float sin = (float) Math.sin(target.angle);
    HostEntity e = simulation.entity(Neighbourhood.id(bodyRow[BodyRow.KEY]));
    float localX = e == null ? 0 : e.body().localCenterX();
    float localY = e == null ? 0 : e.body().localCenterY();
    bodyRow[BodyRow.X] = Float.floatToRawIntBits(target.x + cos * localX - sin * localY);
    bodyRow[BodyRow.Y] = Float.floatToRawIntBits(target.y + sin * localX + cos * localY);
    bodyRow[BodyRow.COS] = Float.floatToRawIntBits(cos);
    bodyRow[BodyRow.SIN] = Float.floatToRawIntBits(sin);
    turnTo(BodyRow.VX, target.vx, DERIVED_VELOCITY);
    turnTo(BodyRow.VY, target.vy, DERIVED_VELOCITY);
    turnTo(BodyRow.OMEGA, target.omega, DERIVED_OMEGA);
    clearLoads();
  }
}
