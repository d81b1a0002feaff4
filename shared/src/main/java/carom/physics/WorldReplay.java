package carom.physics;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.math.Limits;
import java.util.Arrays;
import java.util.Locale;

/**
 * Computes the recording of a {@link WorldRecorder} again in a fresh world, and compares the
 * state's hash wherever the recording has one:
 *
 * <pre>
 *   WorldReplay replay = new WorldReplay(bytes);
 *   while (replay.step()) { ... look at replay.world() ... }
 *   System.out.println(replay.difference()); // null if all is the same, bit for bit
 * </pre>
 *
 * <p>A {@link CollisionFilter} isn't needed: the recording has its answers.
 *
 * <p>The bytes need not be trusted. What isn't a whole recording of this format and physics version
 * is refused with the reason; what is damaged otherwise ends in an exception of the same kind.
 */
public final class WorldReplay {
  private static final Call[] CALLS = Call.values();

  private final byte[] bytes;
  private final int end;
  private final World<Object> world;
  private final Listener listener = new Listener();
  private final PairAnswers answers = new PairAnswers();
  private final CollisionFilter<Object> filter =
      (self, i, other, j) -> !answers.refuses(ContactKey.of(self.index(), i, other.index(), j));
  private int at;
  private long calls;
  private long steps;
  private int callbacks;
  private String last = "the state at the beginning";
  private String difference;

  // The arguments of the call that was read last.
  private Call call = Call.END;
  private boolean nested;
  private int event;
  private final int[] ints = new int[4];
  private int intCount;
  private final float[] floats = new float[4];
  private int floatCount;
  private final int[] row = new int[Call.ROW];

  /** The contact about which a callback decides now, or null. */
  private Collision<Object> contact;

  private Object value;
  private WorldState state;

  /**
   * Makes the world with which a recording begins.
   *
   * @param recording what {@link WorldRecorder#finish} returned
   * @throws ArchiveException if the bytes are no whole recording, or of another version
   */
  public WorldReplay(byte[] recording) {
    bytes = Limits.notNull("recording", recording).clone();
    end = bytes.length - 9;
    require(
        bytes.length >= 16 && readLong() == WorldRecorder.MAGIC,
        "these bytes are no recording of calls");
    int format = readInt();
    require(
        format == WorldRecorder.FORMAT,
        "format=" + format + " of the recording, this build reads " + WorldRecorder.FORMAT);
    int version = readInt();
    require(
        version == World.PHYSICS_VERSION,
        "physics version=" + version + ", this build computes " + World.PHYSICS_VERSION);
    int body = at;
    at = Math.max(end, 0) + 1;
    require(
        end > body
            && bytes[end] == Call.END.ordinal()
            && readLong() == WorldRecorder.hashOf(bytes, end + 1),
        "the recording is torn or damaged: its "
            + bytes.length
            + " bytes don't end with the hash of what is before");
    at = body;
    ArchiveReader first = archive();
    try {
      world = new World<>(CallValues.passDef(first, null));
      world.restore(world.read(first, slot -> null));
    } catch (ArchiveException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw refused(e.getMessage());
    }
    int set = readInt();
    listen(set);
    if ((set & WorldRecorder.FILTERED) != 0) {
      world.askAbout(filter);
    }
    compare(readLong());
  }

  /**
   * Returns the world, whose bodies have no users.
   *
   * @return the live world; it goes on as recorded as long as nothing else changes it
   */
  public World<Object> world() {
    return world;
  }

  /** Returns how many calls were computed, those of callbacks not counted. */
  public long calls() {
    return calls;
  }

  /** Returns how many steps were computed. */
  public long steps() {
    return steps;
  }

  /**
   * Returns how the replay differs from the recording.
   *
   * @return the first call after which the hashes differ, with its number, the step and its
   *     arguments; null if none did so far
   */
  public String difference() {
    return difference;
  }

  /**
   * Computes all calls up to the end of the next step.
   *
   * @return false if there is no further step, or a difference was found
   * @throws ArchiveException if the recording is damaged
   */
  public boolean step() {
    long before = steps;
    while (difference == null && steps == before && at < end) {
      next();
    }
    while (difference == null && at < end && bytes[at] == WorldRecorder.HASH) {
      next();
    }
    return difference == null && steps > before;
  }

  /**
   * Computes all calls.
   *
   * @return {@link #difference}
   * @throws ArchiveException if the recording is damaged
   */
  public String run() {
    while (difference == null && at < end) {
      next();
    }
    return difference;
  }

  private void next() {
    if (bytes[at] == WorldRecorder.HASH) {
      at++;
      compare(readLong());
      return;
    }
    callbacks = 0;
    if (takeAnswer(0)) {
      return;
    }
    read();
    require(!nested, "a call of a callback outside of one");
    calls++;
    last = describe();
    boolean isStep = call == Call.STEP;
    perform();
    steps += isStep ? 1 : 0;
    if (at < end && bytes[at] != WorldRecorder.HASH && (bytes[at] & WorldRecorder.NESTED) != 0) {
      read();
      difference =
          last + ": no callback number " + event + ", in which " + describe() + " was made";
    }
  }

  private void compare(long expected) {
    long hash = world.stateHash();
    if (hash != expected) {
      difference =
          String.format(Locale.ROOT, "%s: state hash %016x, recorded %016x", last, hash, expected);
    }
  }

  private String describe() {
    StringBuilder text = new StringBuilder("call " + calls + " in step " + (steps + 1) + ", ");
    text.append(call.name().toLowerCase(java.util.Locale.ROOT).replace('_', ' '));
    for (int i = 0; i < intCount; i++) {
      text.append(i == 0 && call.layout.charAt(0) == 'b' ? " body=" : " ").append(ints[i]);
    }
    for (int i = 0; i < floatCount; i++) {
      text.append(' ').append(floats[i]);
    }
    return text.toString();
  }

  // ---------------------------------------------------------------- calls

  /** Makes the call that was read last. What was refused then is refused now. */
  private void perform() {
    while (takeAnswer(WorldRecorder.NESTED)) {}
    try {
      switch (call.layout.isEmpty() ? 'w' : call.layout.charAt(0)) {
        case 'b' -> perform(body(ints[0]));
        case 'j' -> perform(joint(ints[0]));
        default -> performOnWorld();
      }
    } catch (ArchiveException e) {
      throw e;
    } catch (IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException e) {
      // The recorded call was refused, too, or the next hash differs.
      last += " (refused: " + e.getMessage() + ")";
    }
  }

  private void performOnWorld() {
    switch (call) {
      case STEP -> world.step(floats[0]);
      case CREATE_BODY -> world.createBody(is(BodyDef.class), null);
      case CREATE_JOINT ->
          world.createJoint(ints[0] < 0 ? null : body(ints[0]), body(ints[1]), is(int[].class), 0);
      case EDIT -> world.edits().repeat((byte) ints[0], ints[1], value);
      case DESTROY_JOINTS -> world.destroyJoints();
      case SORT_FREE_BODIES -> world.sortFreeBodies();
      case REDEFINE -> world.redefine(is(WorldDef.class));
      case STATE -> world.restore(state);
      case LISTENERS -> listen(ints[0]);
      case COLLISION_FILTER -> world.collisionFilter(ints[0] == 0 ? null : filter);
      case SET_CONTACT -> {
        require(contact != null, "call=" + call + " outside of preSolve");
        contact.repeat(ints[0], floats[0]);
      }
      default -> throw refused("call=" + call + " where none is made");
    }
  }

  private void perform(Body<Object> body) {
    switch (call) {
      case WAKE -> body.wake();
      case SLEEP -> body.sleep();
      case SET_SLEEP_ALLOWED -> body.setSleepAllowed(ints[1] != 0);
      case SET_SLEEP_SPEED -> body.setSleepSpeed(floats[0]);
      case SET_POSE -> body.setPose(floats[0], floats[1], floats[2], floats[3]);
      case SET_CENTER_POSE -> body.setCenterPose(floats[0], floats[1], floats[2], floats[3]);
      case SET_VELOCITY -> body.setVelocity(floats[0], floats[1]);
      case SET_ANGULAR_VELOCITY -> body.setAngularVelocity(floats[0]);
      case APPLY_FORCE -> body.applyForce(floats[0], floats[1]);
      case APPLY_FORCE_AT -> body.applyForce(floats[0], floats[1], floats[2], floats[3]);
      case APPLY_AMBIENT_FORCE -> body.applyAmbientForce(floats[0], floats[1], floats[2]);
      case APPLY_IMPULSE -> body.applyImpulse(floats[0], floats[1]);
      case APPLY_IMPULSE_AT -> body.applyImpulse(floats[0], floats[1], floats[2], floats[3]);
      case APPLY_TORQUE -> body.applyTorque(floats[0]);
      case APPLY_ANGULAR_IMPULSE -> body.applyAngularImpulse(floats[0]);
      case SET_BULLET -> body.setBullet(ints[1] != 0);
      case SET_GRAVITY_SCALE -> body.setGravityScale(floats[0]);
      case SET_LINEAR_DAMPING -> body.setLinearDamping(floats[0]);
      case SET_ANGULAR_DAMPING -> body.setAngularDamping(floats[0]);
      default -> body.writeRow(row, 0);
    }
  }

  private void perform(Joint<Object> joint) {
    switch (call) {
      case SET_MOTOR -> joint.setMotor(floats[0], floats[1]);
      case STOP_MOTOR -> joint.stopMotor();
      case SET_LIMITS -> joint.setLimits(floats[0], floats[1]);
      case REMOVE_LIMITS -> joint.removeLimits();
      case SET_SPRING -> joint.setSpring(floats[0], floats[1]);
      case REMOVE_SPRING -> joint.removeSpring();
      case SET_REST -> joint.setRest(floats[0]);
      case SET_TARGET -> joint.setTarget(floats[0], floats[1]);
      default -> joint.setTargetAngle(floats[0]);
    }
  }

  private Body<Object> body(int index) {
    Body<Object> body = index < 0 ? null : world.body(index);
    if (body == null) {
      throw new IllegalStateException("no body=" + index);
    }
    return body;
  }

  private Joint<Object> joint(int index) {
    Joint<Object> joint = index < 0 || index >= world.jointSlotCount() ? null : world.joint(index);
    if (joint == null) {
      throw new IllegalStateException("no joint=" + index);
    }
    return joint;
  }

  private <V> V is(Class<V> type) {
    require(type.isInstance(value), "value=" + value + " of call=" + call);
    return type.cast(value);
  }

  // ---------------------------------------------------------------- callbacks

  private void listen(int which) {
    world.listener((which & 1) == 0 ? null : listener);
    world.jointListener((which & 2) == 0 ? null : listener);
  }

  /** Makes the calls of the callback that runs now. Returns false if it refused its contact. */
  private boolean callback() {
    callbacks++;
    boolean accepts = true;
    while (takeAnswer(WorldRecorder.NESTED)) {}
    while (at < end && bytes[at] != WorldRecorder.HASH && (bytes[at] & WorldRecorder.NESTED) != 0) {
      int before = at;
      read();
      if (event != callbacks) {
        at = before;
        break;
      }
      if (call == Call.REFUSE_CONTACT) {
        accepts = false;
      } else {
        perform();
      }
      while (takeAnswer(WorldRecorder.NESTED)) {}
    }
    return accepts;
  }

  /**
   * Takes over what the filter answers from here on about a pair, if that is what comes next.
   *
   * @param mark {@link WorldRecorder#NESTED} if it came within a call, 0 if before one
   */
  private boolean takeAnswer(int mark) {
    int next = at < end ? bytes[at] & 0xff : WorldRecorder.HASH;
    boolean refused = next == (mark | Call.REFUSE_PAIR.ordinal());
    if (!refused && next != (mark | Call.ALLOW_PAIR.ordinal())) {
      return false;
    }
    int before = at++;
    if (mark != 0 && readVar() > callbacks) {
      at = before;
      return false;
    }
    int bodyA = readVar();
    int shapeA = readVar();
    int bodyB = readVar();
    int shapeB = readVar();
    require(
        bodyA >= 0 && bodyB > bodyA && bodyB < BodyStore.MAX_BODIES,
        "bodies=" + bodyA + " and " + bodyB + " of a pair");
    require(
        shapeA >= 0 && shapeB >= 0 && Math.max(shapeA, shapeB) < BodyStore.MAX_PARTS,
        "shapes=" + shapeA + " and " + shapeB + " of a pair");
    if (answers.set(ContactKey.of(bodyA, shapeA, bodyB, shapeB), refused) && world.isFiltered()) {
      world.askAbout(filter); // again: the broadphase may have found this pair sooner here
    }
    return true;
  }

  /** Makes what the recorded listeners made, callback by callback. */
  private final class Listener implements CollisionListener<Object>, JointListener<Object> {
    @Override
    public void begin(Collision<Object> collision) {
      callback();
    }

    @Override
    public void end(Collision<Object> collision) {
      callback();
    }

    @Override
    public boolean preSolve(Collision<Object> collision) {
      contact = collision;
      try {
        return callback();
      } finally {
        contact = null;
      }
    }

    @Override
    public void postSolve(Collision<Object> collision) {
      callback();
    }

    @Override
    public void hit(Collision<Object> collision) {
      callback();
    }

    @Override
    public void created(Joint<Object> joint) {
      callback();
    }

    @Override
    public void broke(Joint<Object> joint) {
      callback();
    }

    @Override
    public void destroyed(Joint<Object> joint) {
      callback();
    }
  }

  // ---------------------------------------------------------------- bytes

  private void read() {
    int code = readByte();
    nested = (code & WorldRecorder.NESTED) != 0;
    code &= ~WorldRecorder.NESTED & 0xff;
    require(code < Call.END.ordinal(), "call=" + code + " is none");
    call = CALLS[code];
    event = nested ? readVar() : 0;
    intCount = 0;
    floatCount = 0;
    value = null;
    for (int i = 0; i < call.layout.length(); i++) {
      switch (call.layout.charAt(i)) {
        case 'b', 'j', 'i' -> ints[intCount++] = readVar();
        case 'f' -> floats[floatCount++] = Float.intBitsToFloat(readInt());
        case 'r' -> Arrays.setAll(row, k -> readInt());
        default -> readValue();
      }
    }
  }

  private void readValue() {
    ArchiveReader archive = archive();
    try {
      value = CallValues.pass(archive, null);
      state = call == Call.STATE ? world.read(archive, slot -> null) : null;
    } catch (ArchiveException e) {
      throw e;
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw refused(e.getMessage());
    }
  }

  private ArchiveReader archive() {
    int length = readVar();
    require(length >= 0 && length <= end - at, "length=" + length + " of a value");
    ArchiveReader archive = new ArchiveReader(Arrays.copyOfRange(bytes, at, at + length));
    at += length;
    return archive;
  }

  private int readByte() {
    require(at < bytes.length, "the recording ends within a call");
    return bytes[at++] & 0xff;
  }

  private int readVar() {
    int rest = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      int next = readByte();
      rest |= (next & 0x7f) << shift;
      if (next < 0x80) {
        return rest >>> 1 ^ -(rest & 1);
      }
    }
    throw refused("a whole number is longer than 5 bytes");
  }

  private int readInt() {
    return readByte() << 24 | readByte() << 16 | readByte() << 8 | readByte();
  }

  private long readLong() {
    return (long) readInt() << 32 | readInt() & 0xffffffffL;
  }

  private void require(boolean holds, String what) {
    if (!holds) {
      throw refused(what);
    }
  }

  private ArchiveException refused(String what) {
    return new ArchiveException(what + ", at byte " + at + " of " + bytes.length);
  }
}
