package carom.physics.simd;

import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Finds the classes that use the Vector API. That module incubates: a JVM has it only if it was
 * started with {@code --add-modules jdk.incubator.vector}.
 */
public final class VectorModule {
  /**
   * Number of constraints that are solved side by side: 16 if the processor's vectors hold that
   * many floats, else 8, also without vectors. All kernels use vectors of this one length, because
   * a JIT compiler that has seen several lengths boxes vectors, which costs ten times what they
   * gain. The number changes no bit of a result.
   */
  public static final int LANES = lanes();

  /** The length of this processor's vectors. Its implementation needs the Vector API. */
  interface Width {
    /** Returns how many floats a vector holds. */
    int floats();
  }

  /** The sets of kernels found so far. */
  private static final List<VectorKernels> SETS = new ArrayList<>();

  /** Is told the sets that it shall warm up; null if the steps that use them do. */
  private static Consumer<VectorKernels> warmer;

  /** Tells whether the calling thread is the one that warms up. */
  private static BooleanSupplier rehearsing;

  /** Is told when a world wants kernels that wait for their warm-up. */
  private static Runnable wanting;

  private VectorModule() {}

  /**
   * Leaves the warm-up of kernels to a program that has a thread for it. All sets, those found so
   * far and those found later, are granted no work of any world until the program {@linkplain
   * VectorKernels#trust trusts} them, except of the worlds that its thread steps.
   *
   * @param by told each set once, on the thread that calls this or that makes a world; must only
   *     note it
   * @param isRehearsal returns whether the thread that calls it is the program's; called from many
   *     threads, several times a step
   * @param whenWanted runs whenever a step would have been so large that kernels are worth their
   *     warm-up, and at once if they are warm; called from many threads, must return at once and
   *     allocate nothing
   */
  public static synchronized void leaveWarmUpTo(
      Consumer<VectorKernels> by, BooleanSupplier isRehearsal, Runnable whenWanted) {
    warmer = by;
    rehearsing = isRehearsal;
    wanting = whenWanted;
    SETS.forEach(VectorModule::leave);
  }

  private static synchronized void add(VectorKernels set) {
    SETS.add(set);
    if (warmer != null) {
      leave(set);
    }
  }

  private static void leave(VectorKernels set) {
    set.waitForTrust(rehearsing, wanting);
    warmer.accept(set);
  }

  /** Returns which kernels this JVM computes with, and why if it has no vectors, for a log. */
  public static String describe() {
    Width width = find("carom.physics.simd.VectorWidth", Width.class);
    if (width == null) {
      return "scalar kernels: the JVM has no module jdk.incubator.vector; start by the script in"
          + " bin, or add --add-modules jdk.incubator.vector";
    }
    if (width.floats() < LANES) {
      return "scalar kernels: vectors of this processor hold "
          + width.floats()
          + " floats, and "
          + LANES
          + " are needed";
    }
    return "vector kernels of " + LANES + " lanes";
  }

  private static int lanes() {
    Width width = find("carom.physics.simd.VectorWidth", Width.class);
    return width != null && width.floats() >= 16 ? 16 : 8;
  }

  /**
   * Makes an object of a class that is loaded by name.
   *
   * @param name the full name of a public class with a public constructor without parameters
   * @param type what the object is used as
   * @return null if the JVM lacks the module, or if its vectors are too short to be worth it
   */
  public static <T> T find(String name, Class<T> type) {
    try {
      T found = Class.forName(name).asSubclass(type).getDeclaredConstructor().newInstance();
      if (found instanceof VectorKernels set) {
        add(set);
      }
      return found;
    } catch (ClassNotFoundException | InvocationTargetException | LinkageError e) {
      return null;
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(name + " must be public, with a public constructor", e);
    }
  }
}
