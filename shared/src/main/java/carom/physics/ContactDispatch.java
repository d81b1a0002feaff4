package carom.physics;

import carom.physics.dynamics.contact.ContactEvents;

/** Passes the rows of a world's contact table on to its listener and its event lists. */
final class ContactDispatch<T> implements ContactEvents {
  private final Collision<T> collision;

  /** Null for none. */
  private CollisionListener<T> listener;

  /** Null for none. */
  private EventLists<T> lists;

  ContactDispatch(Collision<T> collision) {
    this.collision = collision;
  }

  void listener(CollisionListener<T> newListener) {
    listener = newListener;
  }

  void lists(EventLists<T> newLists) {
    lists = newLists;
  }

  EventLists<T> lists() {
    return lists;
  }

  /** Returns this, or null if nobody wants to know. */
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
      listener.begin(collision);
    }
  }

  @Override
  public void end(int row) {
    collision.at(row);
    if (lists != null) {
      lists.end(collision);
    }
    if (listener != null) {
      listener.end(collision);
    }
  }

  @Override
  public boolean preSolve(int row) {
    return listener == null || listener.preSolve(collision.at(row));
  }

  @Override
  public void postSolve(int row) {
    if (listener != null) {
      listener.postSolve(collision.at(row));
    }
  }

  @Override
  public void hit(int row, float speed) {
    collision.at(row, speed);
    if (lists != null) {
      lists.hit(collision);
    }
    if (listener != null) {
      listener.hit(collision);
    }
  }
}
