import carom.plain.Alive;
import carom.plain.Chat;
import carom.plain.Choose;
import carom.plain.Controls;
import carom.plain.Custom;
import carom.plain.Emote;
import carom.plain.Input;
import carom.plain.Join;
import carom.plain.Leave;
import carom.plain.ListRooms;
import carom.plain.Plain;
import carom.plain.Rate;
import carom.plain.Value;
import carom.plain.View;
import com.esotericsoftware.kryo.Kryo;
import com.esotericsoftware.kryo.io.Output;
import com.esotericsoftware.kryonet.Client;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/**
 * Reads and writes messages by the real Kryo 2.24. {@code read}: takes frames from standard input,
 * and prints what is in each. {@code write SEED COUNT}: prints random messages, as bytes and as
 * what is in them.
 */
public final class Echo {
  private static final Class<?>[] TO_SERVER = {
    Join.class,
    Input.class,
    Chat.class,
    Emote.class,
    Choose.class,
    Rate.class,
    View.class,
    ListRooms.class,
    Custom.class,
    Alive.class,
    Leave.class
  };

  private Echo() {}

  public static void main(String[] args) throws Exception {
    Kryo kryo = new Client().getKryo();
    Plain.register(kryo);
    PrintStream out = new PrintStream(System.out, false, "US-ASCII");
    if (args[0].equals("read")) {
      read(kryo, out);
    } else {
      Random random = new Random(Long.parseLong(args[1]));
      for (int i = 0; i < Integer.parseInt(args[2]); i++) {
        Object message = random(random, TO_SERVER[i % TO_SERVER.length]);
        Output bytes = new Output(1 << 16);
        kryo.writeClassAndObject(bytes, message);
        for (byte b : bytes.toBytes()) {
          out.printf("%02x", b & 0xff);
        }
        out.println("\t" + dump(message));
      }
    }
    out.flush();
  }

  private static void read(Kryo kryo, PrintStream out) throws IOException {
    DataInputStream in = new DataInputStream(System.in);
    while (true) {
      int length;
      try {
        length = in.readInt();
      } catch (EOFException e) {
        return;
      }
      byte[] bytes = new byte[length];
      in.readFully(bytes);
      com.esotericsoftware.kryo.io.Input input = new com.esotericsoftware.kryo.io.Input(bytes);
      Object message = kryo.readClassAndObject(input);
      out.println(dump(message) + (input.position() == length ? "" : " of " + input.position()));
    }
  }

  private static Object random(Random random, Class<?> type) throws Exception {
    Object made = type.getDeclaredConstructor().newInstance();
    for (Field field : type.getFields()) {
      if (Modifier.isStatic(field.getModifiers())) {
        continue;
      }
      boolean optional = type == Choose.class || field.getType() == Object.class;
      Object value =
          optional && random.nextInt(3) == 0 ? null : value(random, field.getType(), field);
      field.set(made, value);
    }
    return made;
  }

  private static Object value(Random random, Class<?> type, Field field) throws Exception {
    if (type == int.class || type == Integer.class) {
      return field.getName().equals("buttons") ? random.nextInt(1 << 16) : whole(random);
    } else if (type == long.class) {
      return random.nextLong() >> random.nextInt(64);
    } else if (type == float.class) {
      return field.getName().equals("aim")
          ? (float) (random.nextInt(65_536) * 2 * Math.PI / 65_536)
          : (random.nextInt(255) - 127) / 127f;
    } else if (type == boolean.class || type == Boolean.class) {
      return random.nextBoolean();
    } else if (type == String.class) {
      return text(random, 60);
    } else if (type == Object.class) {
      Object[] all = {
        whole(random), random.nextFloat(), random.nextBoolean(), text(random, 300),
      };
      return all[random.nextInt(all.length)];
    }
    int length = type == Controls[].class ? 1 + random.nextInt(3) : random.nextInt(4);
    Object array = Array.newInstance(type.getComponentType(), length);
    for (int i = 0; i < length; i++) {
      Object element = random(random, type.getComponentType());
      if (element instanceof Value) {
        ((Value) element).name += i; // names differ
      }
      Array.set(array, i, element);
    }
    return array;
  }

  private static int whole(Random random) {
    return random.nextInt() >> random.nextInt(32);
  }

  private static String text(Random random, int most) {
    StringBuilder text = new StringBuilder();
    int length = random.nextInt(4) == 0 ? random.nextInt(3) : random.nextInt(most);
    int highest = random.nextBoolean() ? 0x7f : random.nextBoolean() ? 0x7ff : 0xffff;
    for (int i = 0; i < length; i++) {
      text.append((char) random.nextInt(highest + 1));
    }
    return text.toString();
  }

  /** Returns what is in a message: fields by name, floats by their bits, texts in ASCII. */
  static String dump(Object value) throws IOException {
    StringBuilder out = new StringBuilder();
    if (value == null || value instanceof Boolean || value instanceof Number) {
      return value instanceof Float
          ? "f" + Integer.toHexString(Float.floatToIntBits((Float) value))
          : String.valueOf(value);
    } else if (value instanceof String) {
      out.append('"');
      for (char c : ((String) value).toCharArray()) {
        out.append(c > ' ' && c < 0x7f && c != '"' ? "" + c : String.format("\\%04x", (int) c));
      }
      return out.append('"').toString();
    } else if (value.getClass().isArray()) {
      out.append('[');
      for (int i = 0; i < Array.getLength(value); i++) {
        out.append(i == 0 ? "" : ",").append(dump(Array.get(value, i)));
      }
      return out.append(']').toString();
    }
    Map<String, Object> fields = new TreeMap<>();
    try {
      for (Field field : value.getClass().getFields()) {
        if (!Modifier.isStatic(field.getModifiers())) {
          fields.put(field.getName(), field.get(value));
        }
      }
    } catch (IllegalAccessException e) {
      throw new IOException(e);
    }
    if (value instanceof Controls) { // as the server keeps them
      Controls c = (Controls) value;
      fields.put("aim", Math.round(c.aim * 65_536 / (2 * Math.PI)) & 0xffff);
      fields.put("moveX", Math.round(c.moveX * 127));
      fields.put("moveY", Math.round(c.moveY * 127));
    }
    out.append(value.getClass().getSimpleName()).append('{');
    for (Map.Entry<String, Object> field : fields.entrySet()) {
      out.append(field.getKey()).append('=').append(dump(field.getValue())).append(';');
    }
    return out.append('}').toString();
  }
}
