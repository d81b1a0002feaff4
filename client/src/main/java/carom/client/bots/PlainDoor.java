package carom.client.bots;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Plays by the real KryoNet 2.22 with its Kryo 2.24. Their classes have the names of Carom's, so
 * {@code carom.plain.bots.PlainBot} and they have a class loader of their own, which shares nothing
 * with this one but the JDK.
 */
public final class PlainDoor implements ThinDoor {
  /** Property with a class path for programs that aren't installed. */
  private static final String PATH = "carom.plain.path";

  private static final Pattern ADDRESS = Pattern.compile("(.+?):(\\d{1,5})(?::(\\d{1,5}))?");

  private final ThinPicture told;
  private Consumer<int[]> bot;

  private PlainDoor(ThinPicture told) {
    this.told = told;
  }

  /**
   * Returns what opens connections.
   *
   * @param host of the server
   * @param udp 0 for TCP alone
   * @throws IOException if the libraries aren't there
   */
  public static Opener opener(String host, int tcp, int udp) throws IOException {
    List<URL> jars = new ArrayList<>();
    for (Path file : files()) {
      jars.add(file.toUri().toURL());
    }
    Constructor<?> maker;
    try {
      // Not closed: bots load classes until the program ends.
      maker =
          new URLClassLoader(jars.toArray(new URL[0]), ClassLoader.getPlatformClassLoader())
              .loadClass("carom.plain.bots.PlainBot")
              .getConstructors()[0];
    } catch (ClassNotFoundException e) {
      throw new IOException("stock KryoNet isn't in " + jars + "; use an installation", e);
    }
    String own = host + ":" + tcp + ":" + udp;
    return (name, goal, told) -> {
      PlainDoor door = new PlainDoor(told);
      Matcher at = ADDRESS.matcher(goal.server().isEmpty() ? own : goal.server());
      if (!at.matches()) {
        throw new IOException("server=" + goal.server() + " is no host:tcp or host:tcp:udp");
      }
      int there = Integer.parseInt(at.group(2));
      int datagrams = udp == 0 || at.group(3) == null ? 0 : Integer.parseInt(at.group(3));
      long secret = goal.secret().isEmpty() ? 0 : Long.parseLong(goal.secret());
      Consumer<Object[]> hear = door::hear;
      door.bot =
          make(maker, at.group(1), there, datagrams, name, goal.room(), secret, goal.token(), hear);
      return door;
    };
  }

  /** Returns the jars in {@code plain/lib} of the installation. */
  private static List<Path> files() throws IOException {
    String path = System.getProperty(PATH);
    if (path != null) {
      return Stream.of(path.split(File.pathSeparator)).map(Path::of).toList();
    }
    try {
      Path ours =
          Path.of(PlainDoor.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      Path folder = ours.resolveSibling(Path.of("..", "plain", "lib"));
      try (Stream<Path> all = Files.list(folder)) {
        return all.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
      }
    } catch (URISyntaxException | IOException e) {
      throw new IOException(
          "no folder plain/lib of an installation is there: " + e.getMessage(), e);
    }
  }

  @SuppressWarnings("unchecked") // it is a consumer of ints
  private static Consumer<int[]> make(Constructor<?> maker, Object... arguments)
      throws IOException {
    try {
      return (Consumer<int[]>) maker.newInstance(arguments);
    } catch (InvocationTargetException e) {
      throw new IOException(String.valueOf(e.getCause().getMessage()), e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  private void hear(Object[] what) {
    switch ((String) what[0]) {
      case "bytes" -> told.bytes((int) what[1]);
      case "welcome" -> told.welcome(String.valueOf(what[1]));
      case "match" -> told.match((int) what[1], (String) what[2]);
      case "standby" -> told.standby((String) what[1]);
      case "redirect" -> told.redirect((String) what[1], (String) what[2], (String) what[3]);
      case "refused" -> told.refuse((String) what[1]);
      case "end" -> told.end((String) what[1]);
      case "ping" -> {
        if ((int) what[1] == told.player()) {
          told.ping((int) what[2]);
        }
      }
      case "snapshot" -> {
        if (told.snapshot((int) what[1], (int) what[2], (int) what[3], System.nanoTime())) {
          bodies((int[]) what[4], (float[]) what[5], (int[]) what[6]);
        }
      }
      default -> throw new IllegalArgumentException(what[0] + " isn't known");
    }
  }

  private void bodies(int[] ids, float[] poses, int[] gone) {
    for (int i = 0; i < ids.length; i += 3) {
      told.body(ids[i], poses[i], poses[i + 1], poses[i + 2], ids[i + 1], ids[i + 2]);
    }
    for (int id : gone) {
      told.gone(id);
    }
  }

  @Override
  public void input(int count, int seen, int buttons, float moveX, float moveY, float aim) {
    bot.accept(
        new int[] {
          count,
          seen,
          buttons,
          Float.floatToIntBits(moveX),
          Float.floatToIntBits(moveY),
          Float.floatToIntBits(aim)
        });
  }

  /** Returns 0: KryoNet doesn't tell. */
  @Override
  public long bytesOut() {
    return 0;
  }

  @Override
  public void close() {
    try {
      ((Closeable) bot).close();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }
}
