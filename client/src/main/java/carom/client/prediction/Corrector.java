package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.net.codec.Quantizer;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.physics.dynamics.Excerpt;
import carom.sim.Entity;
import carom.sim.Neighbourhood;
import carom.sim.Simulation;
import java.util.Arrays;

/**
 * Writes the server's state into the predicted simulation: exact states from an update or, without
 * one, the own section and the quantised records. One prediction's; allocates only to grow.
 */
final class Corrector {
  private static final int BODY = 1;
  private static final int REST = BODY + Excerpt.REST;
  private static final int PUSHES = REST + 1;
  private static final int MEMORY = BODY + Excerpt.BODY_INTS;

  /** Index of the first float of a contact; floats fill the rest of its row. */
  private static final int CONTACT_FLOATS = 6;

  /** Place of an entity that is dropped; contacts with it are dropped, too. */
  private static final int DROPPED = Integer.MAX_VALUE;

  private static final float POSITION_TOLERANCE = 1.0f / Quantizer.POSITION_STEPS;
  private static final float VELOCITY_TOLERANCE = 1.0f / Quantizer.VELOCITY_STEPS;
  private static final float ANGLE_TOLERANCE = (float) (2 * Math.PI / Quantizer.ANGLE_STEPS);
  private static final float OMEGA_TOLERANCE = 1.0f / Quantizer.OMEGA_STEPS;

  private final Simulation simulation;
  private final SnapshotRecords records;

  /** The predicted set before the correction. */
  private final Neighbourhood current = new Neighbourhood();

  /** The predicted set after it. */
  private final Neighbourhood next = new Neighbourhood();

  private final int[] row = new int[Neighbourhood.ENTITY_INTS];
  private final int[] contact = new int[Neighbourhood.CONTACT_INTS];

  /** By place in the update: the place in {@link #next}, or -1. */
  private final int[] placeOf = new int[NearState.MAX_ENTITIES];

  /** By place in {@link #current}: the place in {@link #next}, or {@link #DROPPED}. */
  private int[] newPlace = new int[16];

  private final Pose target = new Pose();

  Corrector(Simulation simulation, SnapshotRecords records) {
    this.simulation = simulation;
    this.records = records;
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
      boolean hasState = update.hasState(i) && isBody(update.rows(), update.entityAt(i));
      if ((!hasState && mine < 0) || next.find(key, 0) >= 0) {
        continue;
      }
      placeOf[i] = next.count();
      if (mine >= 0 && !update.hasState(i)) {
        newPlace[mine] = placeOf[i]; // an entity with a state comes with its contacts
      }
      next.add(
          hasState ? update.rows() : current.entities(),
          hasState ? update.entityAt(i) : mine * row.length);
    }
    if (next.find(ownKey, 0) < 0) {
      return false; // the update is for another body
    }
    for (int i = 0; i < update.contacts(); i++) {
      System.arraycopy(update.rows(), update.contactAt(i), contact, 0, contact.length);
      contact[0] = translate(update, contact[0]);
      contact[1] = translate(update, contact[1]);
      if (isFinite(contact, CONTACT_FLOATS, contact.length)) {
        addContact();
      }
    }
    keepContacts();
    next.write(simulation, records);
    return true;
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
    for (int i = 0; i < current.contactCount(); i++) {
      System.arraycopy(current.contacts(), i * contact.length, contact, 0, contact.length);
      contact[0] = contact[0] < 0 ? contact[0] : newPlace[contact[0]];
      contact[1] = contact[1] < 0 ? contact[1] : newPlace[contact[1]];
      addContact();
    }
  }

  private void addContact() {
    if (contact[0] != DROPPED && contact[1] != DROPPED) {
      next.addContact(contact, 0);
    }
  }

  /**
   * Corrects the simulation without an update. The own body gets the server's exact state; another
   * body moves to its quantised record if it is farther away than quantisation explains.
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
    boolean ownListed = false;
    for (int i = 0; i < current.count(); i++) {
      int at = i * row.length;
      int key = current.entities()[at];
      newPlace[i] = DROPPED;
      if (key == ownKey) {
        ownRow(own, ownKey);
        ownListed = true;
      } else if (records.isKnown(key)) {
        System.arraycopy(current.entities(), at, row, 0, row.length);
        if (records.readPose(key, stateTick, target) && !isAtTarget(key)) {
          moveRow();
        }
      } else {
        continue; // the server has removed it
      }
      newPlace[i] = next.count();
      next.add(row, 0);
    }
    if (!ownListed) {
      next.clear();
      ownRow(own, ownKey);
      next.add(row, 0);
    } else {
      keepContacts();
    }
    next.write(simulation, records);
  }

  private void ownRow(OwnState own, int ownKey) {
    row[0] = ownKey;
    row[BODY] = Float.floatToRawIntBits(own.x());
    row[BODY + 1] = Float.floatToRawIntBits(own.y());
    row[BODY + 2] = Float.floatToRawIntBits(own.cos());
    row[BODY + 3] = Float.floatToRawIntBits(own.sin());
    row[BODY + 4] = Float.floatToRawIntBits(own.vx());
    row[BODY + 5] = Float.floatToRawIntBits(own.vy());
    row[BODY + 6] = Float.floatToRawIntBits(own.omega());
    row[REST] = 0; // a player's body never sleeps
    Arrays.fill(row, PUSHES, MEMORY, 0);
    for (int i = 0; i < OwnState.MEMORY; i++) {
      row[MEMORY + i] = own.memory(i);
    }
  }

  /** Returns whether a row is a valid body: a bad number would poison the simulation. */
  private static boolean isBody(int[] rows, int at) {
    float cos = Float.intBitsToFloat(rows[at + BODY + 2]);
    float sin = Float.intBitsToFloat(rows[at + BODY + 3]);
    return isFinite(rows, at + BODY, at + REST)
        && isFinite(rows, at + PUSHES, at + MEMORY)
        && Math.abs(cos * cos + sin * sin - 1) < 1e-3f;
  }

  private static boolean isFinite(int[] rows, int from, int to) {
    for (int i = from; i < to; i++) {
      if (!(Math.abs(Float.intBitsToFloat(rows[i])) < 1e9f)) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether an entity is at {@link #target}, as far as quantised records tell. */
  private boolean isAtTarget(int key) {
    Entity e = simulation.entity(Neighbourhood.id(key));
    Body<Entity> body = e.body();
    return Math.abs(body.x() - target.x) <= POSITION_TOLERANCE
        && Math.abs(body.y() - target.y) <= POSITION_TOLERANCE
        && Math.abs(body.velocityX() - target.vx) <= VELOCITY_TOLERANCE
        && Math.abs(body.velocityY() - target.vy) <= VELOCITY_TOLERANCE
        && Math.abs(body.angularVelocity() - target.omega) <= OMEGA_TOLERANCE
        && Math.abs(Pose.wrap(body.angle() - target.angle)) <= ANGLE_TOLERANCE;
  }

  /** Moves {@link #row} to {@link #target}, without sleep and forces. */
  private void moveRow() {
    float cos = (float) Math.cos(target.angle);
    float sin = (float) Math.sin(target.angle);
    Entity e = simulation.entity(Neighbourhood.id(row[0]));
    float localX = e == null ? 0 : e.body().localCenterX();
    float localY = e == null ? 0 : e.body().localCenterY();
    row[BODY] = Float.floatToRawIntBits(target.x + cos * localX - sin * localY);
    row[BODY + 1] = Float.floatToRawIntBits(target.y + sin * localX + cos * localY);
    row[BODY + 2] = Float.floatToRawIntBits(cos);
    row[BODY + 3] = Float.floatToRawIntBits(sin);
    row[BODY + 4] = Float.floatToRawIntBits(target.vx);
    row[BODY + 5] = Float.floatToRawIntBits(target.vy);
    row[BODY + 6] = Float.floatToRawIntBits(target.omega);
    row[REST] = 0;
    Arrays.fill(row, PUSHES, MEMORY, 0);
  }
}
