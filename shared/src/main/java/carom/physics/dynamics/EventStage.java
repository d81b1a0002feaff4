package carom.physics.dynamics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.store.IntList;
import carom.physics.settings.Settings;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * The stages of a step that call the owner back about its contacts, before and after they are
 * solved. Skipped without a listener. Callbacks run on the caller's thread.
 */
final class EventStage {
  private final Settings settings;
  private final BodyStore bodies;
  private final ContactTable contacts;
  private final ContactOverrides overrides;
  private final Sleeping sleeping;

  /** Tells whether a callback lets the parts of a row pass; made once. */
  final IntPredicate passing = this::passes;

  /** Hears what happens in this step, null for none. */
  private ContactEvents events;

  /** Per row: whether it was asked about before its turn. */
  private boolean[] asked = new boolean[0];

  /** The rows that were. */
  private final IntList early = new IntList();

  /** Per row: approach speed if this may be an impact worth telling, else 0. */
  private float[] hitSpeeds = new float[0];

  EventStage(
      Settings settings,
      BodyStore bodies,
      ShapeTable parts,
      ContactTable contacts,
      Sleeping sleeping) {
    this.settings = settings;
    this.bodies = bodies;
    this.contacts = contacts;
    this.sleeping = sleeping;
    overrides = new ContactOverrides(contacts, parts);
  }

  /**
   * Begins a step.
   *
   * @param listening hears what happens in it, null for none
   */
  void beginStep(ContactEvents listening) {
    events = listening;
    overrides.begin();
    forgetAnswers();
  }

  /** Forgets what was answered before its turn, because rows come in between and shift others. */
  void forgetAnswers() {
    overrides.end();
    for (int i = 0; i < early.count; i++) {
      asked[early.values[i]] = false;
    }
    early.count = 0;
  }

  /**
   * Returns whether a callback lets the parts of a row pass each other in this step. Asks before
   * the turn of the row, because something else depends on it. Bodies neither wake nor fall asleep.
   */
  private boolean passes(int row) {
    if (events != null && (row >= asked.length || !asked[row])) {
      if (row >= asked.length) {
        asked = Arrays.copyOf(asked, contacts.capacity());
      }
      asked[row] = true;
      early.add(row);
      sleeping.suspend();
      ask(row);
      overrides.decide(-1);
      sleeping.resume();
    }
    return events != null && (contacts.flags[row] & ContactTable.VETOED) != 0;
  }

  private void ask(int row) {
    overrides.decide(row);
    if (!events.preSolve(row)) {
      contacts.flags[row] |= ContactTable.VETOED;
    }
  }

  /** Reports what ended and began, asks which contacts respond, and notes possible impacts. */
  void beforeSolving() {
    announce();
    overrides.decide(-1);
    measureHits();
  }

  /** Reports what was solved and what hit. */
  void afterSolving() {
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.points[row] > 0
          && (contacts.flags[row] & (ContactTable.VETOED | ContactTable.DORMANT)) == 0) {
        if (!contacts.touches(row)) {
          if (!contacts.pushed(row)) {
            continue;
          }
          events.begin(row);
        }
        events.postSolve(row);
        if (hitSpeeds[row] > 0 && contacts.pushed(row)) {
          events.hit(row, hitSpeeds[row]);
        }
      }
    }
    overrides.end();
  }

  /** Returns the numbers that callbacks set for single contacts in this step. */
  ContactOverrides overrides() {
    return overrides;
  }

  private void announce() {
    for (int row = 0; row < contacts.count(); row++) {
      byte flags = contacts.flags[row];
      boolean now = (flags & ContactTable.TOUCHING) != 0;
      boolean before = (flags & ContactTable.WAS_TOUCHING) != 0;
      if (before && !now) {
        events.end(row);
      } else if (now && !before) {
        events.begin(row);
      }
      boolean isAsked = row < asked.length && asked[row];
      if (contacts.points[row] > 0 && (flags & ContactTable.DORMANT) == 0 && !isAsked) {
        ask(row);
      }
    }
  }

  /** Measures how fast the contacts approach that no impulse held in the step before. */
  private void measureHits() {
    if (hitSpeeds.length < contacts.count()) {
      hitSpeeds = new float[contacts.capacity()];
    }
    for (int row = 0; row < contacts.count(); row++) {
      hitSpeeds[row] = 0;
      if (contacts.points[row] > 0 && (contacts.flags[row] & ContactTable.WAS_PUSHED) == 0) {
        float speed = approach(row, contacts.pointX(row, 0), contacts.pointY(row, 0));
        if (contacts.points[row] > 1) {
          speed = Math.max(speed, approach(row, contacts.pointX(row, 1), contacts.pointY(row, 1)));
        }
        hitSpeeds[row] = speed > settings.hitSpeed() ? speed : 0;
      }
    }
  }

  /** Returns how fast the bodies of a row approach at a point relative to A, m/s. */
  private float approach(int row, float ax, float ay) {
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    float bx = ax - (bodies.x[b] - bodies.x[a]);
    float by = ay - (bodies.y[b] - bodies.y[a]);
    float partX = bodies.vx[b] - bodies.w[b] * by - (bodies.vx[a] - bodies.w[a] * ay);
    float partY = bodies.vy[b] + bodies.w[b] * bx - (bodies.vy[a] + bodies.w[a] * ax);
    return -(partX * contacts.normalX(row) + partY * contacts.normalY(row));
  }
}
