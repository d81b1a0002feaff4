package carom.physics;

import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;

/** Passes the rows of a world's contact table on to its listener and its event lists. */
final class ContactDispatch<T> implements ContactEvents {
  private final World<T> world;
  private final Collision<T> collision;

  /** Null for none. */
  private CollisionListener<T> listener;

  /** Null for none. */
  private EventLists<T> lists;

  ContactDispatch(World<T> world, Collision<T> collision) {
    this.world = world;
    this.collision = collision;
  }

  void listener(CollisionListener<T> newListener) {
    listener = newListener;
  }

  CollisionListener<T> listener() {
    return listener;
  }

  void lists(EventLists<T> newLists) {
    lists = newLists;
  }

  EventLists<T> lists() {
    return lists;
  }

  /** Returns this, or null if there is no listener. */
  ContactEvents orNull() {
    return listener == null && lists == null ? null : this;
  }

  @Override
  public void begin(int row) {
    collision.at(row);
    if (lists != null) {
      lists.begin(collision);
    }
    if (listener != null) {
      world.enterCallback();
      listener.begin(collision);
      world.leaveCallback();
    }
  }

  @Override
  public void end(int row) {
    collision.at(row);
    if (lists != null) {
      lists.end(collision);
    }
    if (listener != null) {
      world.enterCallback();
      listener.end(collision);
      world.leaveCallback();
    }
  }

  @Override
  public boolean preSolve(int row) {
    return listener == null || decide(collision.at(row));
  }

  @Override
  public boolean preSolveSwept(ContactTable table) {
    return listener == null || decide(collision.atSwept(table));
  }

  private boolean decide(Collision<T> question) {
    world.enterCallback();
    boolean accepts = listener.preSolve(question);
    if (!accepts) {
      world.note(Call.REFUSE_CONTACT);
    }
    world.leaveCallback();
    return accepts;
  }

  @Override
  public void postSolve(int row) {
    if (listener != null) {
      world.enterCallback();
      listener.postSolve(collision.at(row));
      world.leaveCallback();
    }
  }

  @Override
  public void hit(int row, float speed) {
    collision.at(row, speed);
    if (lists != null) {
      lists.hit(collision);
    }
    if (listener != null) {
      world.enterCallback();
      listener.hit(collision);
      world.leaveCallback();
    }
  }
}
