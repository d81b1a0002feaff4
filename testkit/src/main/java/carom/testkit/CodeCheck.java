package carom.testkit;

import carom.sim.Game;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Reads the compiled code of a game, and finds what can't be the same on two machines or twice on
 * one: clocks, dice, the order of hashes, functions whose last bit depends on the machine, static
 * variables that change, files, threads. It follows calls from the game's callbacks into the game's
 * own classes, which are those of its package and below.
 *
 * <p>Each finding has the callback, the call, the class and the line. One thread; used once.
 */
final class CodeCheck {
  private static final int API = Opcodes.ASM9;
  private static final String RANDOM = "use Match.random() in the server's callbacks";
  private static final String CLOCK = "count ticks by tick(), or use a Countdown";
  private static final String ORDER =
      "its order may differ from process to process; use a list, an array or a TreeMap";
  private static final String OUTSIDE = "a game may know only its fields, the world and the level";
  private static final String BITS =
      "its last bits depend on the machine; use carom.physics.math.Trig or StrictMath";
  private static final Set<String> INEXACT =
      Set.of(
          "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "expm1", "log", "log10",
          "log1p", "pow", "cbrt", "sinh", "cosh", "tanh", "hypot");
  private static final Set<String> SEEDED =
      Set.of("java/util/Random", "java/util/SplittableRandom");
  private static final Set<String> HASHES =
      Set.of("java/util/HashMap", "java/util/HashSet", "java/util/IdentityHashMap");
  private static final Set<String> SORTED =
      Set.of(
          "java/util/TreeMap",
          "java/util/TreeSet",
          "java/util/EnumMap",
          "java/util/LinkedHashMap",
          "java/util/LinkedHashSet");
  private static final Set<String> ORDERED =
      Set.of("iterator", "keySet", "values", "entrySet", "forEach", "toArray", "stream");

  /**
   * Methods that run before the first tick; what they write into variables is the game's set-up.
   */
  private static final Set<String> SET_UP =
      Set.of(
          "<init>",
          "<clinit>",
          "setUp",
          "begin",
          "name",
          "defaultLevel",
          "description",
          "world",
          "fields",
          "clock",
          "gauges");

  private record Call(String owner, String name, String descriptor, String line) {}

  /** Holds what one method of the game calls and writes. */
  private static final class Code {
    final List<Call> calls = new ArrayList<>();
    final Map<String, String> writes = new TreeMap<>();
    final Map<String, String> staticWrites = new TreeMap<>();
  }

  private final GameCode code;
  private final Map<String, Map<String, Code>> classes = new TreeMap<>();
  private final Map<String, List<String>> parents = new TreeMap<>();
  private final Deque<String> unread = new ArrayDeque<>();

  /** All classes that the code makes objects of. */
  private final Set<String> made = new TreeSet<>();

  private final Set<String> findings = new LinkedHashSet<>();
  private final Set<String> variables = new LinkedHashSet<>();

  /** Checks the class of a game, and all that its callbacks reach. */
  CodeCheck(GameCode code) {
    this.code = code;
    unread.add(code.game().getName().replace('.', '/'));
    while (!unread.isEmpty()) {
      String type = unread.remove();
      if (isOwn(type) && !classes.containsKey(type)) {
        classes.put(type, read(type));
      }
    }
    Set<String> callbacks = new TreeSet<>();
    callbacks.add("<init>");
    for (Method method : Game.class.getMethods()) {
      callbacks.add(method.getName());
    }
    for (String callback : callbacks) {
      follow(callback);
    }
  }

  /** Returns what is wrong, in words, each with callback and line. */
  List<String> findings() {
    return List.copyOf(findings);
  }

  /**
   * Returns the variables of the game's objects that callbacks write while playing, in words, each
   * with callback and line. Scratch is no fault; what is remembered belongs in a field.
   */
  List<String> variables() {
    return List.copyOf(variables);
  }

  private void follow(String callback) {
    Deque<Call> waiting = new ArrayDeque<>();
    Set<String> seen = new TreeSet<>();
    String at = code.game().getName().replace('.', '/');
    for (Map.Entry<String, Map<String, Code>> type : classes.entrySet()) {
      for (String method : type.getValue().keySet()) {
        if (method.startsWith(callback + "(") && isKindOf(at, type.getKey())) {
          String descriptor = method.substring(callback.length());
          waiting.add(new Call(type.getKey(), callback, descriptor, ""));
        }
      }
    }
    while (!waiting.isEmpty()) {
      Call call = waiting.remove();
      if (seen.add(call.owner + "." + call.name + call.descriptor)) {
        follow(callback, call, waiting);
      }
    }
  }

  private void follow(String callback, Call call, Deque<Call> waiting) {
    for (Code found : targets(call)) {
      found.staticWrites.forEach(
          (variable, line) ->
              findings.add(
                  words(callback)
                      + " writes the static variable "
                      + variable
                      + line
                      + ", which all rooms of a process share; use a field of the match"));
      if (!SET_UP.contains(callback)) {
        found.writes.forEach(
            (variable, line) -> variables.add(variable + line + ", in " + callback));
      }
      for (Call inner : found.calls) {
        String why = wrong(inner);
        if (why != null) {
          String owner = inner.owner.replace('/', '.');
          boolean isNew = inner.name.equals("<init>");
          findings.add(
              words(callback)
                  + " calls "
                  + (isNew ? "new " + owner : owner + "." + inner.name)
                  + inner.line
                  + "; "
                  + why);
        }
        waiting.add(inner);
      }
    }
  }

  private static String words(String callback) {
    return callback.equals("<init>") ? "the constructor" : callback;
  }

  /** Returns why a call is wrong, with advice, or null. */
  private String wrong(Call call) {
    String owner = call.owner;
    String name = call.name;
    if (owner.equals("java/lang/System")) {
      return switch (name) {
        case "nanoTime", "currentTimeMillis" -> CLOCK;
        case "identityHashCode" -> ORDER;
        case "getProperty", "getenv" -> OUTSIDE;
        default -> null;
      };
    }
    if (owner.equals("java/lang/Math") || owner.equals("java/lang/StrictMath")) {
      boolean isStrict = owner.endsWith("StrictMath");
      return name.equals("random") ? RANDOM : !isStrict && INEXACT.contains(name) ? BITS : null;
    }
    boolean isSeeded = !call.descriptor.equals("()V"); // then its numbers are always the same
    if ((SEEDED.contains(owner) && name.equals("<init>") && !isSeeded)
        || owner.equals("java/util/concurrent/ThreadLocalRandom")
        || owner.equals("java/security/SecureRandom")
        || (owner.equals("java/util/UUID") && name.equals("randomUUID"))
        || (name.equals("shuffle") && call.descriptor.equals("(Ljava/util/List;)V"))) {
      return RANDOM;
    }
    if (owner.startsWith("java/time/") && (name.equals("now") || owner.endsWith("/Clock"))) {
      return CLOCK;
    }
    if (ORDERED.contains(name) && (HASHES.contains(owner) || isHash(owner))) {
      return ORDER;
    }
    if (owner.equals("java/lang/Object") && name.equals("hashCode")) {
      return ORDER;
    }
    boolean isOutside =
        owner.startsWith("java/io/File")
            || owner.startsWith("java/nio/file/")
            || owner.startsWith("java/net/")
            || owner.equals("java/lang/Thread")
            || owner.startsWith("java/util/concurrent/Exec");
    return isOutside ? OUTSIDE : null;
  }

  /** Returns whether what is declared as a map or a set can only be one of hashes. */
  private boolean isHash(String owner) {
    boolean isAny = owner.equals("java/util/Map") || owner.equals("java/util/Set");
    return isAny
        && made.stream().anyMatch(HASHES::contains)
        && made.stream().noneMatch(SORTED::contains);
  }

  /** Returns the code in the game's own classes that a call may run. */
  private List<Code> targets(Call call) {
    List<Code> targets = new ArrayList<>();
    for (Map.Entry<String, Map<String, Code>> type : classes.entrySet()) {
      Code found = type.getValue().get(call.name + call.descriptor);
      String at = type.getKey();
      if (found != null && (isKindOf(at, call.owner) || isKindOf(call.owner, at))) {
        targets.add(found);
      }
    }
    return targets;
  }

  private boolean isKindOf(String type, String other) {
    return type.equals(other)
        || parents.getOrDefault(type, List.of()).stream().anyMatch(p -> isKindOf(p, other));
  }

  private boolean isOwn(String type) {
    return code.isOfGame(type.replace('/', '.'));
  }

  private Map<String, Code> read(String type) {
    Map<String, Code> methods = new TreeMap<>();
    try (InputStream in = code.game().getClassLoader().getResourceAsStream(type + ".class")) {
      if (in != null) {
        new ClassReader(in).accept(new Reader(type, methods), ClassReader.SKIP_FRAMES);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (IllegalArgumentException e) {
      return methods; // of a newer Java than the reader knows; the runs find what they find
    }
    return methods;
  }

  private final class Reader extends ClassVisitor {
    private final String type;
    private final Map<String, Code> methods;
    private String file;

    Reader(String type, Map<String, Code> methods) {
      super(API);
      this.type = type;
      this.methods = methods;
    }

    @Override
    public void visit(int version, int access, String name, String s, String parent, String[] of) {
      List<String> kinds = new ArrayList<>(List.of(of));
      kinds.add(parent);
      parents.put(name, kinds);
      unread.addAll(kinds);
    }

    @Override
    public void visitSource(String source, String debug) {
      file = source;
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String descriptor, String signature, String[] exceptions) {
      Code code = new Code();
      methods.put(name + descriptor, code);
      return new MethodReader(type, file, name, code);
    }
  }

  private final class MethodReader extends MethodVisitor {
    private final String type;
    private final String file;
    private final String method;
    private final Code found;
    private int line;

    MethodReader(String type, String file, String method, Code found) {
      super(API);
      this.type = type;
      this.file = file;
      this.method = method;
      this.found = found;
    }

    private String here() {
      return " at " + code.line(type.replace('/', '.'), method, file, line);
    }

    @Override
    public void visitLineNumber(int number, Label start) {
      line = number;
    }

    @Override
    public void visitMethodInsn(int op, String owner, String name, String what, boolean inFace) {
      found.calls.add(new Call(owner, name, what, here()));
      unread.add(owner);
      if ((owner.equals("java/util/Map") || owner.equals("java/util/Set"))
          && (name.equals("of") || name.equals("copyOf") || name.equals("ofEntries"))) {
        made.add("java/util/HashMap"); // its order is another in each process
      }
    }

    @Override
    public void visitTypeInsn(int op, String made) {
      if (op == Opcodes.NEW) {
        unread.add(made);
        CodeCheck.this.made.add(made);
      }
    }

    @Override
    public void visitInvokeDynamicInsn(String name, String what, Handle maker, Object... args) {
      for (Object arg : args) {
        if (arg instanceof Handle h) { // a lambda, or a reference to a method
          found.calls.add(new Call(h.getOwner(), h.getName(), h.getDesc(), here()));
          unread.add(h.getOwner());
        }
      }
    }

    @Override
    public void visitFieldInsn(int op, String owner, String name, String descriptor) {
      String variable = owner.substring(owner.lastIndexOf('/') + 1).replace('$', '.') + "." + name;
      if (op == Opcodes.PUTSTATIC && !method.equals("<clinit>")) {
        found.staticWrites.putIfAbsent(variable, here());
      } else if (op == Opcodes.PUTFIELD && !method.equals("<init>")) {
        found.writes.putIfAbsent(variable, here());
      }
    }
  }
}
