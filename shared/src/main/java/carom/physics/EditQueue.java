package carom.physics;

import carom.physics.dynamics.BodyEditor;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.BodyStore;
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
public final class EditQueue<T> {
  private static final byte DESTROY_BODY = 0;
  private static final byte DESTROY_JOINT = 1;
  private static final byte ENABLE = 2;
  private static final byte DISABLE = 3;

  /** Changes the type; the code of the new type is added to this. */
  private static final byte CHANGE_TYPE = 4;

  private static final byte CHANGE_SHAPE = 7;
  private static final byte CHANGE_MASS = 8;
  private static final byte FIX_ROTATION = 9;
  private static final byte FREE_ROTATION = 10;
  private static final byte REFILTER = 11;

  /** A change of material, filter or sensor flag of one of a body's shapes. */
  private record ShapeChange(int shape, UnaryOperator<ShapeDef> how) {
    ShapeDef[] of(ShapeDef[] shapes) {
      ShapeDef[] changed = shapes.clone();
      changed[shape] = how.apply(shapes[shape]);
      return changed;
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

  void changeShape(Body<T> body, int shape, UnaryOperator<ShapeDef> how) {
    world.refuseDuringQuery("changing a shape");
    if (shape < 0 || shape >= body.shapeCount()) {
      throw new IndexOutOfBoundsException(
          "shape=" + shape + " is outside 0.." + (body.shapeCount() - 1) + "; see shapeCount()");
    }
    ShapeChange change = new ShapeChange(shape, how);
    ShapeDef[] changed = change.of(handles.shapes(body.index()));
    if (body.type() == BodyType.DYNAMIC) {
      BodyEditor.checkMass(World.specs(changed), handles.ownMass(body.index()));
    }
    request(CHANGE_SHAPE, body.index(), body.generation(), change);
  }

  void changeMass(Body<T> body, MassData ownOrNull) {
    world.refuseDuringQuery("setMass");
    if (body.type() == BodyType.DYNAMIC) {
      BodyEditor.checkMass(body.specs(), ownOrNull);
    }
    request(CHANGE_MASS, body.index(), body.generation(), ownOrNull);
  }

  void fixRotation(Body<T> body, boolean fixed) {
    world.refuseDuringQuery("setFixedRotation");
    request(fixed ? FIX_ROTATION : FREE_ROTATION, body.index(), body.generation(), null);
  }

  void refilter(Body<T> body) {
    world.refuseDuringQuery("refilter");
    request(REFILTER, body.index(), body.generation(), null);
  }

  /** Carries out an edit now, or queues it until the end of the step. */
  private void request(byte what, int slot, int generation, Object value) {
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
      case CHANGE_SHAPE -> changeShape(slot, (ShapeChange) value);
      case CHANGE_MASS -> {
        editor.change(slot, World.specs(handles.shapes(slot)), (MassData) value);
        handles.ownMass(slot, (MassData) value);
      }
      case FIX_ROTATION, FREE_ROTATION -> {
        editor.setFixedRotation(
            slot, what == FIX_ROTATION, World.specs(handles.shapes(slot)), handles.ownMass(slot));
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

  private void changeShape(int slot, ShapeChange change) {
    ShapeDef[] changed = change.of(handles.shapes(slot));
    if (changed[change.shape].sensor() != handles.shapes(slot)[change.shape].sensor()) {
      editor.endContacts(slot, world.contactEvents());
    }
    editor.change(slot, World.specs(changed), handles.ownMass(slot));
    handles.shapes(slot, changed);
  }

  /** Clears the edits that were requested in a step that failed. */
  void forget() {
    pendingCount = 0;
  }
}
