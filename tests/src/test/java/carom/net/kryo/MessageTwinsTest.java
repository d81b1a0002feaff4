package carom.net.kryo;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Goal: what writes a message and what reads it, two hand-written methods for each kind, never
 * drift apart. Method: random messages of every kind, made from the components of its record, so
 * that a new kind or component is tested as soon as it exists. Each that the writer accepts comes
 * back equal and is written again as the same bytes: a writer refuses whatever its reader would.
 */
final class MessageTwinsTest {
  private static final int MESSAGES = 200;
  private static final int MOST_ATTEMPTS = 100_000;

  private final KryoMessageCodec codec = new KryoMessageCodec();
  private Random random = new Random();

  static Stream<Class<?>> kinds() {
    return Stream.of(ClientMessage.class, ServerMessage.class)
        .flatMap(all -> Arrays.stream(all.getPermittedSubclasses()));
  }

  @ParameterizedTest
  @MethodSource("kinds")
  void whatIsWrittenIsReadAsTheSame(Class<?> kind) throws ReflectiveOperationException {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println(kind.getSimpleName() + ": -Dcarom.seed=" + seed);
    random = new Random(seed);
    int wanted = kind.getRecordComponents().length == 0 ? 1 : MESSAGES;
    int written = 0;
    for (int attempt = 0; written < wanted && attempt < MOST_ATTEMPTS; attempt++) {
      Object message = message(kind);
      byte[] bytes = message == null ? null : bytes(message);
      if (bytes != null) {
        Object read = codec.decode(bytes, 0, bytes.length);
        assertEquals(message, read, () -> "seed=" + seed);
        assertArrayEquals(bytes, codec.encode(read), () -> "seed=" + seed + " " + message);
        written++;
      }
    }
    assertEquals(wanted, written, "the writer refuses nearly all random messages of this kind");
  }

  @Test
  void everyKindIsFound() {
    assertTrue(kinds().count() >= 25, "kinds=" + kinds().count());
    assertTrue(kinds().allMatch(Class::isRecord));
  }

  /** Returns the bytes of a message, or null if the writer refuses one of its values. */
  private byte[] bytes(Object message) {
    try {
      return codec.encode(message);
    } catch (IllegalArgumentException e) {
      return null;
    }
  }

  /** Returns a random record, or null if its constructor refuses the values. */
  private Object message(Class<?> kind) throws ReflectiveOperationException {
    if (kind == ClientMessage.Diverged.class) {
      return diverged();
    }
    RecordComponent[] components = kind.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    for (int i = 0; i < components.length; i++) {
      types[i] = components[i].getType();
      values[i] = value(components[i].getGenericType());
    }
    if (kind == ServerMessage.RosterEntry.class && Arrays.asList(values).indexOf("") >= 0) {
      return null; // an entry without a name says that the player left, and nothing else
    }
    try {
      var constructor = kind.getDeclaredConstructor(types);
      constructor.setAccessible(true);
      return constructor.newInstance(values);
    } catch (InvocationTargetException e) {
      return null;
    }
  }

  private Object value(Type type) throws ReflectiveOperationException {
    if (type == int.class || type == Integer.class) {
      return random.nextBoolean()
          ? random.nextInt(100)
          : random.nextInt() >>> random.nextInt(Integer.SIZE);
    } else if (type == long.class) {
      return random.nextLong() >>> random.nextInt(Long.SIZE);
    } else if (type == float.class) {
      return (random.nextFloat() - 0.5f) * (1 << random.nextInt(20));
    } else if (type == boolean.class) {
      return random.nextBoolean();
    } else if (type == String.class) {
      return text();
    } else if (type == byte[].class) {
      byte[] bytes = new byte[random.nextInt(40)];
      random.nextBytes(bytes);
      return bytes;
    } else if (type instanceof ParameterizedType generic) {
      return collection(generic);
    }
    Class<?> other = (Class<?>) type;
    return other.isEnum()
        ? other.getEnumConstants()[random.nextInt(other.getEnumConstants().length)]
        : message(other);
  }

  private Object collection(ParameterizedType type) throws ReflectiveOperationException {
    int size = random.nextInt(4);
    if (type.getRawType() == Map.class) {
      Map<String, String> map = new LinkedHashMap<>();
      for (int i = 0; i < size; i++) {
        map.put("k" + i + text(), "v" + text());
      }
      return map;
    }
    List<Object> list = new ArrayList<>();
    while (list.size() < size) {
      Object element = value(type.getActualTypeArguments()[0]);
      if (element != null) {
        list.add(element);
      }
    }
    return list;
  }

  private String text() {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(12); i > 0; i--) {
      text.append("abcxyz0189ÄßЖ".charAt(random.nextInt(random.nextInt(5) > 0 ? 10 : 13)));
    }
    return text.toString();
  }

  /** Returns a report, whose lists depend on each other. */
  private ClientMessage.Diverged diverged() {
    boolean ofSet = random.nextBoolean();
    int bodies = ofSet ? 1 + random.nextInt(ClientMessage.Diverged.MAX_BODIES) : 1;
    List<Integer> numbers = new ArrayList<>();
    for (int i = 0; i < bodies * ClientMessage.Diverged.BODY_INTS; i++) {
      numbers.add(i == 0 ? random.nextInt(1 << 24) : random.nextInt());
    }
    List<Integer> words = new ArrayList<>();
    int count = ofSet ? 0 : random.nextInt(ClientMessage.Diverged.MAX_WORDS + 1);
    for (int i = 0; i < count; i++) {
      words.add(random.nextInt());
    }
    int equalTick = random.nextInt(1 << 24);
    int tick = equalTick + 1 + random.nextInt(100);
    return new ClientMessage.Diverged(tick, equalTick, ofSet, numbers, words);
  }
}
