package carom.physics;

import carom.physics.dynamics.BodyEditor;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.geometry.MassData;
import java.util.Arrays;
import java.util.function.UnaryOperator;

/**
 * Carries out edits that change more than a body's motion: destroying bodies and joints, and
 * changing type, shapes, mass and rotation. An edit is carried out at once. If a callback asks for
 * it, it is carried out at the end of the step, in the order of the requests. Wrong arguments are
 * refused at the request.
 */
final class EditQueue<T> {
  private static final byte DESTROY_BODY = 0;
  private static final byte DESTROY_JOINT = 1;
  private static final byte ENABLE = 2;
  private static final byte DISABLE = 3;

  /** Changes the type; the code of the new type is added to this. */
  private static final byte CHANGE_TYPE = 4;

  private static final byte CHANGE_SHAPES = 7;
  private static final byte CHANGE_MASS = 8;
  private static final byte LOCK_MOTION = 9;
  private static final byte REFILTER = 10;

  /** A change of a body's shapes: from one number on, some go and others come in their place. */
  static final class ShapesChange {
    /** All shapes afterwards. */
    final ShapeDef[] after;

    final int at;
    final int removed;
    final int added;

    ShapesChange(ShapeDef[] after, int at, int removed, int added) {
      this.after = after;
      this.at = at;
      this.removed = removed;
      this.added = added;
    }
  }

  private final World<T> world;
  private final BodyEditor editor;
  private final BodyStore store;
  private final JointStore joints;
  private final Handles<T> handles;

  /** The requested edits. The arrays below hold their slots, generations and values. */
  private byte[] pending = new byte[8];

  private int[] pendingSlot = new int[8];
  private int[] pendingGeneration = new int[8];
  private Object[] pendingValue = new Object[8];
  private int pendingCount;

  EditQueue(World<T> world, Dynamics dynamics, Handles<T> handles) {
    this.world = world;
    editor = dynamics.editor();
    this.handles = handles;
    store = dynamics.bodies();
    joints = dynamics.joints();
  }

  void destroy(Body<T> body) {
    request(DESTROY_BODY, body.index(), body.generation(), null);
  }

  void destroy(Joint<T> joint) {
    request(DESTROY_JOINT, joint.index(), joint.generation(), null);
  }

  void enable(Body<T> body, boolean enabled) {
    world.refuseDuringQuery("setEnabled");
    request(enabled ? ENABLE : DISABLE, body.index(), body.generation(), null);
  }

  void changeType(Body<T> body, BodyType type) {
    world.refuseDuringQuery("setType");
    if (type == BodyType.DYNAMIC) {
      BodyEditor.checkMass(body.specs(), handles.ownMass(body.index()));
    }
    request((byte) (CHANGE_TYPE + World.code(type)), body.index(), body.generation(), null);
  }

  /** Changes the material, filter, sensor flag or user of a shape. */
  void changeShape(String call, Body<T> body, int shape, UnaryOperator<ShapeDef> how) {
    world.refuseDuringQuery(call);
    ShapeDef[] after = shapesToBe(body).clone();
    checkIndex(shape, after.length);
    ShapeDef before = after[shape];
    after[shape] = how.apply(before);
    request(body, new ShapesChange(after, shape, 0, 0), !isSame(after[shape], before));
  }

  void addShape(Body<T> body, ShapeDef added) {
    world.refuseDuringQuery("addShape");
    ShapeDef[] before = shapesToBe(body);
    request(body, spliced(before, before.length, 0, added));
  }

  void removeShape(Body<T> body, int shape) {
    world.refuseDuringQuery("removeShape");
    ShapeDef[] before = shapesToBe(body);
    checkIndex(shape, before.length);
    request(body, spliced(before, shape, 1));
  }

  void replaceShape(Body<T> body, int shape, ShapeDef by) {
    world.refuseDuringQuery("replaceShape");
    ShapeDef[] before = shapesToBe(body);
    checkIndex(shape, before.length);
    request(body, spliced(before, shape, 1, by));
  }

  /** Gives a body the type, shapes, mass and locks of a definition. */
  void become(Body<T> body, BodyDef def) {
    world.refuseDuringQuery("become");
    ShapeDef[] all = def.shapes.toArray(new ShapeDef[0]);
    ShapeSpec[] specs = World.specs(all);
    BodyEditor.checkShapes(World.code(def.type), specs, def.mass);
    if (body.type() == BodyType.DYNAMIC && def.type == BodyType.DYNAMIC) {
      BodyEditor.checkMass(specs, handles.ownMass(body.index())); // it has it for a moment
    }
    int slot = body.index();
    int generation = body.generation();
    byte type = (byte) (CHANGE_TYPE + World.code(def.type));
    if (def.type != BodyType.DYNAMIC) {
      request(type, slot, generation, null); // before shapes that have no mass
    }
    int before = shapesToBe(body).length;
    ShapesChange change = new ShapesChange(all, 0, before, all.length);
    request(CHANGE_SHAPES, slot, generation, change);
    if (def.mass != null || body.hasOwnMass()) {
      request(CHANGE_MASS, slot, generation, def.mass);
    }
    if (def.type == BodyType.DYNAMIC) {
      request(type, slot, generation, null);
    }
    if (!body.motionLocks().equals(def.locks)) {
      request(LOCK_MOTION, slot, generation, def.locks);
    }
  }

  private static ShapesChange spliced(ShapeDef[] before, int at, int removed, ShapeDef... added) {
    int rest = before.length - at - removed;
    ShapeDef[] after = Arrays.copyOf(before, at + added.length + rest);
    System.arraycopy(added, 0, after, at, added.length);
    System.arraycopy(before, at + removed, after, at + added.length, rest);
    return new ShapesChange(after, at, removed, added.length);
  }

  private static void checkIndex(int shape, int count) {
    if (shape < 0 || shape >= count) {
      throw new IndexOutOfBoundsException(
          "shape=" + shape + " is outside 0.." + (count - 1) + "; see shapeCount()");
    }
  }

  /** Returns the shapes that a body has once all edits that were asked for are carried out. */
  private ShapeDef[] shapesToBe(Body<T> body) {
    for (int i = pendingCount - 1; i >= 0; i--) {
      if (pending[i] == CHANGE_SHAPES
          && pendingSlot[i] == body.index()
          && pendingGeneration[i] == body.generation()) {
        return ((ShapesChange) pendingValue[i]).after;
      }
    }
    return handles.shapes(body.index());
  }

  private void request(Body<T> body, ShapesChange change) {
    request(body, change, true);
  }

  private void request(Body<T> body, ShapesChange change, boolean recorded) {
    ShapeSpec[] specs = World.specs(change.after);
    BodyEditor.checkShapes(World.code(body.type()), specs, handles.ownMass(body.index()));
    if (recorded) {
      world.noteEdit(CHANGE_SHAPES, body.index(), change);
    }
    carryOutOrQueue(CHANGE_SHAPES, body.index(), body.generation(), change);
  }

  void changeMass(Body<T> body, MassData ownOrNull) {
    world.refuseDuringQuery(ownOrNull == null ? "computeMass" : "setMass");
    if (body.type() == BodyType.DYNAMIC) {
      BodyEditor.checkMass(body.specs(), ownOrNull);
    }
    request(CHANGE_MASS, body.index(), body.generation(), ownOrNull);
  }

  void lockMotion(Body<T> body, MotionLocks locks) {
    world.refuseDuringQuery("setMotionLocks");
    request(LOCK_MOTION, body.index(), body.generation(), locks);
  }

  /** Fixes or frees the rotation; the other locks are those that the body will have by then. */
  void fixRotation(Body<T> body, boolean fixed) {
    world.refuseDuringQuery("setFixedRotation");
    MotionLocks locks = body.motionLocks();
    for (int i = 0; i < pendingCount; i++) {
      if (pending[i] == LOCK_MOTION
          && pendingSlot[i] == body.index()
          && pendingGeneration[i] == body.generation()) {
        locks = (MotionLocks) pendingValue[i];
      }
    }
    lockMotion(body, locks.withAngularZ(fixed));
  }

  void refilter(Body<T> body) {
    world.refuseDuringQuery("refilter");
    request(REFILTER, body.index(), body.generation(), null);
  }

  /** Makes an edit again that was recorded. Shapes that it didn't change stay those they are. */
  void repeat(byte what, int slot, Object value) {
    if (what < DESTROY_BODY || what > REFILTER || slot < 0) {
      throw new IllegalArgumentException("edit=" + what + " of slot=" + slot);
    }
    Joint<T> joint = what == DESTROY_JOINT ? world.joint(slot) : null;
    Body<T> body = what == DESTROY_JOINT ? null : world.body(slot);
    if (body == null && joint == null) {
      throw new IllegalStateException("edit=" + what + " of slot=" + slot + ", which is free");
    }
    if (what == CHANGE_SHAPES) {
      request(body, withShapesOf(shapesToBe(body), (ShapesChange) value));
    } else if (what == CHANGE_MASS) {
      changeMass(body, (MassData) value);
    } else if (what == LOCK_MOTION) {
      lockMotion(body, (MotionLocks) value);
    } else if (what >= CHANGE_TYPE && what < CHANGE_SHAPES) {
      changeType(body, BodyType.values()[what - CHANGE_TYPE]);
    } else {
      request(what, slot, joint != null ? joint.generation() : body.generation(), null);
    }
  }

  private static ShapesChange withShapesOf(ShapeDef[] before, ShapesChange change) {
    ShapeDef[] after = change.after.clone();
    int kept = change.added - change.removed;
    if (change.at < 0 || change.removed < 0 || after.length != before.length + kept) {
      throw new IllegalArgumentException("shapes=" + before.length + " before " + after.length);
    }
    for (int i = 0; i < after.length; i++) {
      int from = i < change.at ? i : i - kept;
      if (i < change.at || i >= change.at + change.added) {
        ShapeDef d = after[i];
        after[i] = new ShapeDef(before[from].shape(), d.material(), d.filter(), d.sensor());
      }
    }
    return new ShapesChange(after, change.at, change.removed, change.added);
  }

  private void request(byte what, int slot, int generation, Object value) {
    world.noteEdit(what, slot, value);
    carryOutOrQueue(what, slot, generation, value);
  }

  /** Carries out an edit now, or queues it until the end of the step. */
  private void carryOutOrQueue(byte what, int slot, int generation, Object value) {
    if (pendingCount == pending.length) {
      pending = Arrays.copyOf(pending, pendingCount * 2);
      pendingSlot = Arrays.copyOf(pendingSlot, pendingCount * 2);
      pendingGeneration = Arrays.copyOf(pendingGeneration, pendingCount * 2);
      pendingValue = Arrays.copyOf(pendingValue, pendingCount * 2);
    }
    pending[pendingCount] = what;
    pendingSlot[pendingCount] = slot;
    pendingValue[pendingCount] = value;
    pendingGeneration[pendingCount++] = generation;
    if (world.beginEdits()) {
      try {
        carryOut();
      } finally {
        world.endEdits();
      }
    }
  }

  /** Carries out all queued edits. Callbacks for ended contacts may queue more. */
  void carryOut() {
    try {
      for (int i = 0; i < pendingCount; i++) {
        int slot = pendingSlot[i];
        int generation = pendingGeneration[i];
        if (pending[i] == DESTROY_JOINT) {
          if (joints.alive(slot, generation)) {
            world.removeJoint(slot);
          }
        } else if (store.alive(slot, generation)) {
          carryOut(pending[i], slot, pendingValue[i]);
        }
      }
    } finally {
      Arrays.fill(pendingValue, 0, pendingCount, null);
      pendingCount = 0;
    }
  }

  private void carryOut(byte what, int slot, Object value) {
    switch (what) {
      case DESTROY_BODY -> world.removeBody(slot);
      case ENABLE, DISABLE -> editor.setEnabled(slot, what == ENABLE);
      case REFILTER -> {
        editor.refilter(slot);
        return;
      }
      case CHANGE_SHAPES -> changeShapes(slot, (ShapesChange) value);
      case CHANGE_MASS -> {
        editor.change(slot, World.specs(handles.shapes(slot)), (MassData) value);
        handles.ownMass(slot, (MassData) value);
      }
      case LOCK_MOTION -> {
        MotionLocks locks = (MotionLocks) value;
        editor.setLocks(
            slot,
            World.axes(locks),
            locks.angularZ(),
            World.specs(handles.shapes(slot)),
            handles.ownMass(slot));
      }
      default ->
          editor.setType(
              slot,
              (byte) (what - CHANGE_TYPE),
              World.specs(handles.shapes(slot)),
              handles.ownMass(slot));
    }
    handles.bodiesChanged();
  }

  private void changeShapes(int slot, ShapesChange change) {
    ShapeDef[] before = handles.shapes(slot);
    ShapeSpec[] specs = World.specs(change.after);
    if (change.removed != change.added || change.removed > 0) {
      int first = partsOf(before, 0, change.at);
      int removed = partsOf(before, change.at, change.removed);
      world.posesChanged();
      editor.reshape(slot, first, removed, specs, handles.ownMass(slot), world.contactEvents());
    } else if (!isSame(change.after[change.at], before[change.at])) {
      if (change.after[change.at].sensor() != before[change.at].sensor()) {
        editor.endContacts(slot, world.contactEvents());
      }
      editor.change(slot, specs, handles.ownMass(slot));
    }
    handles.shapes(slot, change.after);
  }

  /** Returns whether two shapes are the same for the world, which ignores their users. */
  private static boolean isSame(ShapeDef a, ShapeDef b) {
    return a.user() != b.user() && a.withUser(null).equals(b.withUser(null));
  }

  private static int partsOf(ShapeDef[] shapes, int from, int n) {
    int count = 0;
    for (int i = from; i < from + n; i++) {
      count += shapes[i].shape().parts().size();
    }
    return count;
  }

  /** Clears the edits that were requested in a step that failed. */
  void forget() {
    pendingCount = 0;
  }
}
