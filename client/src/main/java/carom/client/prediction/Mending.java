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
 * Puts the predicted simulation right: with an update of exact states, or, without one, from the
 * own section and the quantised records. One prediction's; allocates only to grow.
 */
final class Mending {
  private static final int BODY = 1;
  private static final int REST = BODY + Excerpt.REST;
  private static final int PUSHES = REST + 1;
  private static final int MEMORY = BODY + Excerpt.BODY_INTS;

  /** Where the floats of a contact begin; they go on to its end. */
  private static final int CONTACT_FLOATS = 6;

  /** End of a contact that isn't taken over. */
  private static final int NOWHERE = Integer.MAX_VALUE;

  private static final float POSITION_TOLERANCE = 1.0f / Quantizer.POSITION_STEPS;
  private static final float VELOCITY_TOLERANCE = 1.0f / Quantizer.VELOCITY_STEPS;
  private static final float ANGLE_TOLERANCE = (float) (2 * Math.PI / Quantizer.ANGLE_STEPS);
  private static final float OMEGA_TOLERANCE = 1.0f / Quantizer.OMEGA_STEPS;

  private final Simulation simulation;
  private final Records records;
  private final Neighbourhood here = new Neighbourhood();
  private final Neighbourhood right = new Neighbourhood();
  private final int[] row = new int[Neighbourhood.ENTITY_INTS];
  private final int[] contact = new int[Neighbourhood.CONTACT_INTS];

  /** By place in the update: the place in {@link #right}. */
  private final int[] placeOf = new int[NearState.MAX_ENTITIES];

  /** By place in {@link #here}: the place in {@link #right}, or {@link #NOWHERE}. */
  private int[] newPlace = new int[16];

  private final Pose target = new Pose();

  Mending(Simulation simulation, Records records) {
    this.simulation = simulation;
    this.records = records;
  }

  /** Takes nobody along: the simulation is left without entities. */
  void empty() {
    right.clear();
    right.write(simulation, records);
  }

  /**
   * Takes an update over, at its base tick.
   *
   * @return whether it has an own body; if not, nothing has changed
   */
  boolean take(NearUpdate update, int ownKey) {
    update.use();
    here.readAll(simulation);
    right.clear();
    reserve();
    Arrays.fill(newPlace, 0, here.count(), NOWHERE);
    int from = 0;
    for (int i = 0; i < update.count(); i++) {
      int key = update.key(i);
      int mine = here.find(key, from);
      from = mine < 0 ? from : mine + 1; // both follow the order of the world
      placeOf[i] = -1;
      boolean told = update.isTold(i) && isBody(update.rows(), update.entityAt(i));
      if ((!told && mine < 0) || right.find(key, 0) >= 0) {
        continue;
      }
      placeOf[i] = right.count();
      if (mine >= 0 && !update.isTold(i)) {
        newPlace[mine] = placeOf[i]; // the contacts of those told are told, too
      }
      right.add(
          told ? update.rows() : here.entities(), told ? update.entityAt(i) : mine * row.length);
    }
    if (right.find(ownKey, 0) < 0) {
      return false; // it is of another body's
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
    right.write(simulation, records);
    return true;
  }

  private void reserve() {
    if (newPlace.length < here.count()) {
      newPlace = new int[Math.max(2 * newPlace.length, here.count())];
    }
  }

  /** A place in the server's list, in ours. */
  private int translate(NearUpdate update, int end) {
    if (end < 0) {
      return end;
    }
    return end < update.count() && placeOf[end] >= 0 ? placeOf[end] : NOWHERE;
  }

  /** Takes over the contacts that were here, between those who stay. */
  private void keepContacts() {
    for (int i = 0; i < here.contactCount(); i++) {
      System.arraycopy(here.contacts(), i * contact.length, contact, 0, contact.length);
      contact[0] = contact[0] < 0 ? contact[0] : newPlace[contact[0]];
      contact[1] = contact[1] < 0 ? contact[1] : newPlace[contact[1]];
      addContact();
    }
  }

  private void addContact() {
    if (contact[0] != NOWHERE && contact[1] != NOWHERE) {
      right.addContact(contact, 0);
    }
  }

  /**
   * Without an update: the own body becomes what the server had after a tick, and others go where
   * their records have them, if those disagree.
   *
   * @param own the own body as the server has it
   * @param fresh whether nobody else is taken along
   */
  void putRight(OwnState own, int stateTick, boolean fresh) {
    here.clear();
    if (!fresh) {
      here.readAll(simulation);
    }
    int ownKey = Neighbourhood.key(own.slot(), own.generation());
    right.clear();
    reserve();
    boolean ownListed = false;
    for (int i = 0; i < here.count(); i++) {
      int at = i * row.length;
      int key = here.entities()[at];
      newPlace[i] = NOWHERE;
      if (key == ownKey) {
        ownRow(own, ownKey);
        ownListed = true;
      } else if (records.know(key)) {
        System.arraycopy(here.entities(), at, row, 0, row.length);
        if (!agrees(key, stateTick)) {
          moveRow();
        }
      } else {
        continue; // it is gone
      }
      newPlace[i] = right.count();
      right.add(row, 0);
    }
    if (!ownListed) {
      right.clear();
      ownRow(own, ownKey);
      right.add(row, 0);
    } else {
      keepContacts();
    }
    right.write(simulation, records);
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
    row[REST] = 0; // players' bodies never rest
    Arrays.fill(row, PUSHES, MEMORY, 0);
    for (int i = 0; i < OwnState.MEMORY; i++) {
      row[MEMORY + i] = own.memory(i);
    }
  }

  /** What comes from the network must not poison the simulation. */
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

  /** Whether an entity of {@link #row} is where its record has it, as far as that tells. */
  private boolean agrees(int key, int stateTick) {
    if (!records.pose(key, stateTick, target)) {
      return true;
    }
    Entity e = simulation.entity(Neighbourhood.id(key));
    Body<Entity> body = e.body();
    return Math.abs(body.x() - target.x) <= POSITION_TOLERANCE
        && Math.abs(body.y() - target.y) <= POSITION_TOLERANCE
        && Math.abs(body.velocityX() - target.vx) <= VELOCITY_TOLERANCE
        && Math.abs(body.velocityY() - target.vy) <= VELOCITY_TOLERANCE
        && Math.abs(body.angularVelocity() - target.omega) <= OMEGA_TOLERANCE
        && Math.abs(Pose.wrap(body.angle() - target.angle)) <= ANGLE_TOLERANCE;
  }

  /** Puts {@link #row} where {@link #target} is. */
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
