package carom.physics;

/**
 * The events of a world's last step as lists, to be read after the step. They are an alternative to
 * {@link CollisionListener} and {@link JointListener} for programs that don't want to be called
 * back.
 *
 * <pre>
 *   EventLists&lt;T&gt; events = new EventLists&lt;&gt;();
 *   world.eventLists(events);
 *   ...
 *   world.step(dt);
 *   for (int i = 0; i &lt; events.hits().count(); i++) {
 *     play(events.hits().self(i), events.hits().speed(i));
 *   }
 * </pre>
 *
 * <p>The lists hold what a listener would hear, in the same order. Both may be used together. Lists
 * are no part of the world's state, and whether there are any changes no bit of it.
 *
 * <p><b>How long.</b> Each {@link World#step} begins with empty lists, so they are valid until the
 * next one; {@link World#restore} empties them. Contacts that end between steps, because a body is
 * destroyed or a shape becomes a sensor, are in the lists of the next step, as its first ends.
 *
 * <p><b>Handles.</b> The lists hold the handles of bodies and joints. A body may have been
 * destroyed since, for instance when a contact ended because of that: {@link Body#isValid} tells,
 * and {@link Body#user}, {@link Body#index} and {@link Body#type} still answer. A joint that broke
 * is always destroyed by the end of the step; its bodies and what broke it are in the list.
 *
 * <p>A steady step allocates nothing: lists grow to the largest number of events of a step, and
 * keep that size. One thread; each world needs lists of its own.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class EventLists<T> {
  private final ContactEventList<T> begins = new ContactEventList<>();
  private final ContactEventList<T> ends = new ContactEventList<>();
  private final ContactEventList<T> hits = new ContactEventList<>();
  private final ContactEventList<T> sensorBegins = new ContactEventList<>();
  private final ContactEventList<T> sensorEnds = new ContactEventList<>();
  private final JointEventList<T> breaks = new JointEventList<>();

  // What ended since the last step, for the lists of the next one.
  private final ContactEventList<T> endsBetween = new ContactEventList<>();
  private final ContactEventList<T> sensorEndsBetween = new ContactEventList<>();

  private boolean stepping;

  /** Makes empty lists; {@link World#eventLists} has them filled. */
  public EventLists() {}

  /** Returns the contacts of solid shapes that began to touch. */
  public ContactEventList<T> begins() {
    return begins;
  }

  /** Returns the contacts of solid shapes that ended. They have no points. */
  public ContactEventList<T> ends() {
    return ends;
  }

  /** Returns the impacts, with their speeds and impulses; see {@link CollisionListener#hit}. */
  public ContactEventList<T> hits() {
    return hits;
  }

  /** Returns the shapes that entered sensors. They have no points. */
  public ContactEventList<T> sensorBegins() {
    return sensorBegins;
  }

  /** Returns the shapes that left sensors. They have no points. */
  public ContactEventList<T> sensorEnds() {
    return sensorEnds;
  }

  /** Returns the joints that broke, with what broke them. */
  public JointEventList<T> breaks() {
    return breaks;
  }

  /** Empties the lists at the start of a step; what ended between steps comes first. */
  void beginStep() {
    clearStep();
    ends.takeAll(endsBetween);
    sensorEnds.takeAll(sensorEndsBetween);
    stepping = true;
  }

  /** Notes that the step is over: what ends from now on belongs to the next one. */
  void endStep() {
    stepping = false;
  }

  private void clearStep() {
    begins.clear();
    ends.clear();
    hits.clear();
    sensorBegins.clear();
    sensorEnds.clear();
    breaks.clear();
  }

  /** Empties all lists, because the world has another state. */
  void clear() {
    clearStep();
    endsBetween.clear();
    sensorEndsBetween.clear();
  }

  void begin(Collision<T> c) {
    if (c.isSensor()) {
      sensorBegins.add(c, false);
    } else {
      begins.add(c, true);
    }
  }

  void end(Collision<T> c) {
    if (c.isSensor()) {
      (stepping ? sensorEnds : sensorEndsBetween).add(c, false);
    } else {
      (stepping ? ends : endsBetween).add(c, false);
    }
  }

  void hit(Collision<T> c) {
    hits.add(c, true);
  }

  void broke(Joint<T> joint) {
    breaks.add(joint);
  }
}
