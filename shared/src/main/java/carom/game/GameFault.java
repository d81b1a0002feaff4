package carom.game;

import carom.sim.Game;
import java.lang.reflect.Method;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** Words for people about what a game's code threw. Stateless; any thread. */
public final class GameFault {
  /** Packages that other code calls: the line that is to blame stands above these in a stack. */
  private static final List<String> LIBRARIES =
      List.of(
          "java.",
          "javax.",
          "jdk.",
          "sun.",
          "carom.physics.",
          "carom.sim.",
          "carom.text.",
          "carom.client.field.",
          "carom.client.view.",
          "carom.client.bots.Senses");

  /** Package of the classes that views call; packages below it have views. */
  private static final String LOOK = "carom.client.look.";

  private static final Set<String> CALLBACKS = new TreeSet<>();

  static {
    for (Method method : Game.class.getMethods()) {
      CALLBACKS.add(method.getName());
    }
  }

  private GameFault() {}

  /**
   * Returns what was thrown and where: its class and message, and class, method and line of the
   * innermost code that belongs neither to the JDK nor to what games and views call.
   */
  public static String describe(Throwable failure) {
    StackTraceElement[] stack = failure.getStackTrace();
    for (StackTraceElement frame : stack) {
      if (!isOfLibrary(frame.getClassName())) {
        return failure + ", at " + place(frame) + remedy(failure);
      }
    }
    return failure + (stack.length == 0 ? "" : ", at " + place(stack[0])) + remedy(failure);
  }

  /**
   * Returns what to do about classes or methods that aren't there, of Carom or of a library; empty
   * for any other failure.
   */
  public static String remedy(Throwable failure) {
    String missing = failure instanceof LinkageError ? failure.getMessage() : null;
    if (missing == null) {
      return "";
    }
    if (missing.contains("carom.") || missing.contains("carom/")) {
      return "; it was compiled against another Carom: compile it against this one";
    }
    if (!(failure instanceof NoClassDefFoundError) || missing.contains(" ")) {
      return ""; // a class that is there and can't be used
    }
    String library = missing.startsWith("kotlin/") ? " (kotlin-stdlib)" : "";
    return "; class="
        + missing.replace('/', '.')
        + " is in no jar here: put the jar of the library that has it"
        + library
        + " beside the game's";
  }

  /**
   * Returns why a game can't be set up: the message of what was thrown. If what the game called
   * threw it, it is about the game's code, so class, method and line of that follow.
   *
   * @param type class of the game
   */
  public static String refusal(Class<?> type, IllegalArgumentException refused) {
    StackTraceElement[] stack = refused.getStackTrace();
    int caller = 0;
    while (caller < stack.length && isOfLibrary(stack[caller].getClassName())) {
      caller++;
    }
    String home = type.getPackageName() + ".";
    boolean isGames =
        caller > 0 && caller < stack.length && stack[caller].getClassName().startsWith(home);
    return refused.getMessage() + (isGames ? ", at " + place(stack[caller]) : "");
  }

  private static boolean isOfLibrary(String name) {
    for (String library : LIBRARIES) {
      if (name.startsWith(library)) {
        return true;
      }
    }
    return name.startsWith(LOOK) && name.indexOf('.', LOOK.length()) < 0;
  }

  private static String place(StackTraceElement frame) {
    String where =
        frame.getLineNumber() > 0 ? ":" + frame.getLineNumber() : ", a line that it doesn't tell";
    return frame.getClassName() + "." + frame.getMethodName() + where;
  }

  /**
   * Returns the callback in which a game failed while it was set up.
   *
   * @param type class of the game, whose base classes count, too
   * @return name of the outermost method of {@link Game} in the stack that the game has, {@code
   *     constructor}, or {@code set-up} when neither is there
   */
  public static String callback(Class<?> type, Throwable failure) {
    StackTraceElement[] stack = failure.getStackTrace();
    for (int i = stack.length - 1; i >= 0; i--) {
      String method = stack[i].getMethodName();
      boolean creates = method.equals("<init>") || method.equals("<clinit>");
      if ((creates || CALLBACKS.contains(method)) && isOf(type, stack[i].getClassName())) {
        return creates ? "constructor" : method;
      }
    }
    return "set-up";
  }

  private static boolean isOf(Class<?> type, String name) {
    Class<?> c = type;
    while (c != null && !c.getName().equals(name)) {
      c = c.getSuperclass();
    }
    return c != null;
  }
}
