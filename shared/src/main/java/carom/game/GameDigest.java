package carom.game;

import carom.sim.Game;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Digests of the code of games. Server and client compute the same only with the same code.
 *
 * <p>A digest covers the class file of the game and those of all classes that it names, directly or
 * through others, from whatever jar or folder. The same sources built by other compilers may
 * differ. The digest doesn't cover the JDK, {@code carom.sim} and {@code carom.physics}, which have
 * a version of their own ({@code Protocol.PHYSICS_VERSION}). Nor does it cover files that a game
 * reads, such as its level, which the server sends, or classes that it finds by a computed name.
 * Stateless but for a cache; any thread.
 */
public final class GameDigest {
  /** The digest of a game whose class has no file, such as one made at run time. */
  public static final long UNKNOWN = 0;

  /** Packages that aren't a game's own, as their names begin in class files. */
  private static final List<String> SHARED =
      List.of("java/", "javax/", "jdk/", "sun/", "carom/sim/", "carom/physics/");

  private static final ClassValue<Long> DIGESTS =
      new ClassValue<>() {
        @Override
        protected Long computeValue(Class<?> type) {
          return compute(type);
        }
      };

  private GameDigest() {}

  /**
   * Returns the digest of a game's code, or {@link #UNKNOWN}. The first call for a class reads the
   * class files.
   *
   * @throws UncheckedIOException when one can't be read
   */
  public static long of(Game game) {
    return DIGESTS.get(game.getClass());
  }

  private static long compute(Class<?> type) {
    ClassLoader loader = type.getClassLoader();
    Map<String, byte[]> files = new TreeMap<>();
    Deque<String> open = new ArrayDeque<>(List.of(type.getName().replace('.', '/')));
    while (!open.isEmpty()) {
      String name = open.pop();
      if (!files.containsKey(name)) {
        byte[] file = read(loader, name);
        files.put(name, file);
        for (String other : named(file)) {
          if (!isShared(other)) {
            open.push(other);
          }
        }
      }
    }
    if (files.get(type.getName().replace('.', '/')).length == 0) {
      return UNKNOWN;
    }
    MessageDigest digest = sha256();
    files.forEach(
        (name, file) -> {
          digest.update(name.getBytes(StandardCharsets.UTF_8));
          digest.update(ByteBuffer.allocate(1 + Integer.BYTES).putInt(1, file.length).array());
          digest.update(file);
        });
    return ByteBuffer.wrap(digest.digest()).getLong() | 1; // never UNKNOWN
  }

  private static boolean isShared(String name) {
    for (String shared : SHARED) {
      if (name.startsWith(shared)) {
        return true;
      }
    }
    return false;
  }

  /** Returns a class file; empty if there is none or it belongs to the JDK. */
  private static byte[] read(ClassLoader loader, String name) {
    URL file = loader.getResource(name + ".class");
    if (file == null || file.getProtocol().equals("jrt")) {
      return new byte[0];
    }
    try {
      URLConnection connection = file.openConnection();
      connection.setUseCaches(false); // a cached jar would stay open
      try (InputStream in = connection.getInputStream()) {
        return in.readAllBytes();
      }
    } catch (IOException e) {
      throw new UncheckedIOException("the class file " + file + " can't be read", e);
    }
  }

  /** Returns the names of the classes in the constant pool of a class file. */
  private static List<String> named(byte[] file) {
    List<String> names = new ArrayList<>();
    if (file.length == 0) {
      return names;
    }
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(file))) {
      in.skipNBytes(8); // magic number and version
      String[] texts = new String[in.readUnsignedShort()];
      List<Integer> classes = new ArrayList<>();
      for (int i = 1; i < texts.length; i++) {
        int tag = in.readUnsignedByte();
        switch (tag) {
          case 1 -> texts[i] = in.readUTF();
          case 7 -> classes.add(in.readUnsignedShort());
          case 8, 16, 19, 20 -> in.skipNBytes(2);
          case 15 -> in.skipNBytes(3);
          case 3, 4, 9, 10, 11, 12, 17, 18 -> in.skipNBytes(4);
          case 5, 6 -> {
            in.skipNBytes(8);
            i++; // long and double take two places
          }
          default -> throw new IOException("a class file has a constant of kind " + tag);
        }
      }
      for (int index : classes) {
        String name = texts[index];
        names.add(name.startsWith("[") ? element(name) : name);
      }
      names.removeIf(String::isEmpty);
      return names;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the class of an array's elements, or an empty text if they are primitive. */
  private static String element(String array) {
    return array.endsWith(";") ? array.substring(array.indexOf('L') + 1, array.length() - 1) : "";
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("each JDK has SHA-256", e);
    }
  }
}
