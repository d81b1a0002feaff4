package carom.plain.bots;

import carom.plain.Body;
import carom.plain.Goodbye;
import carom.plain.Input;
import carom.plain.Join;
import carom.plain.Leave;
import carom.plain.Match;
import carom.plain.Plain;
import carom.plain.Player;
import carom.plain.Redirect;
import carom.plain.Refused;
import carom.plain.Roster;
import carom.plain.Scores;
import carom.plain.Snapshot;
import carom.plain.Standby;
import carom.plain.Welcome;
import com.esotericsoftware.kryo.Kryo;
import com.esotericsoftware.kryonet.Client;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.KryoSerialization;
import com.esotericsoftware.kryonet.Listener;
import com.esotericsoftware.minlog.Log;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.function.Consumer;

/**
 * A connection of a bot by stock KryoNet and Kryo. It shares no class path with Carom's Kryo 5, so
 * it speaks to {@code carom.client.bots} by types of the JDK alone: {@link #accept} takes {@code
 * {count, seen, buttons, moveX, moveY, aim}} as floats' bits, and what is told goes out as an array
 * whose first element is its name.
 */
public final class PlainBot implements Consumer<int[]>, Closeable {
  private static final int BUFFER_BYTES = 65536;
  private static final int PATIENCE_MS = 8000;

  private final Consumer<Object[]> told;
  private final Client client;
  private final boolean byUdp;
  private Input last;
  private int match; // its number

  /**
   * Connects and asks to join.
   *
   * @param udp 0 for TCP alone
   * @param secret of the seat to take again, 0 for none
   * @throws IOException if the server can't be reached
   */
  public PlainBot(
      String host,
      Integer tcp,
      Integer udp,
      String name,
      String room,
      Long secret,
      String token,
      Consumer<Object[]> told)
      throws IOException {
    Log.set(Log.LEVEL_NONE);
    this.told = told;
    byUdp = udp > 0;
    client = new Client(BUFFER_BYTES, BUFFER_BYTES, new Counting(new Kryo(), told));
    Plain.register(client.getKryo());
    client.addListener(
        new Listener() {
          @Override
          public void received(Connection link, Object o) {
            hear(o);
          }

          @Override
          public void disconnected(Connection link) {
            tell("end", "the connection ended");
          }
        });
    client.start();
    try {
      if (byUdp) {
        client.connect(PATIENCE_MS, host, tcp, udp);
      } else {
        client.connect(PATIENCE_MS, host, tcp);
      }
    } catch (IOException e) {
      client.stop();
      throw e;
    }
    Join join = new Join(name, secret);
    join.room = room;
    join.token = token;
    client.sendTCP(join);
  }

  /** Kryo as KryoNet has it, which counts the bytes that it reads. */
  private static final class Counting extends KryoSerialization {
    private final Consumer<Object[]> told;

    Counting(Kryo kryo, Consumer<Object[]> told) {
      super(kryo);
      kryo.setReferences(false); // as KryoNet sets it
      kryo.setRegistrationRequired(true);
      this.told = told;
    }

    @Override
    public synchronized Object read(Connection connection, ByteBuffer buffer) {
      told.accept(new Object[] {"bytes", buffer.remaining()});
      return super.read(connection, buffer);
    }
  }

  private void tell(Object... what) {
    told.accept(what);
  }

  private void hear(Object o) {
    if (o instanceof Snapshot) {
      Snapshot s = (Snapshot) o;
      if (s.match != match) {
        return; // of the match before, or it has overtaken its own
      }
      int[] ids = new int[3 * s.bodies.length];
      float[] poses = new float[ids.length];
      for (int i = 0; i < s.bodies.length; i++) {
        Body b = s.bodies[i];
        ids[3 * i] = b.id;
        ids[3 * i + 1] = b.archetype;
        ids[3 * i + 2] = b.owner;
        poses[3 * i] = b.x;
        poses[3 * i + 1] = b.y;
        poses[3 * i + 2] = b.angle;
      }
      tell("snapshot", s.tick, s.parts, s.input, ids, poses, s.gone);
    } else if (o instanceof Match) {
      match = ((Match) o).number;
      tell("match", ((Match) o).player, ((Match) o).room);
    } else if (o instanceof Roster) {
      for (Player p : ((Roster) o).players) {
        tell("ping", p.id, p.ping);
      }
    } else if (o instanceof Scores) {
      int[] all = ((Scores) o).scores;
      for (int i = 0; i + 2 < all.length; i += 3) {
        tell("ping", all[i], all[i + 2]);
      }
    } else if (o instanceof Redirect) {
      Redirect r = (Redirect) o;
      tell("redirect", r.server, r.room, r.token);
    } else if (o instanceof Welcome) {
      tell("welcome", ((Welcome) o).secret);
    } else if (o instanceof Standby) {
      tell("standby", ((Standby) o).server);
    } else if (o instanceof Refused) {
      tell("refused", ((Refused) o).reason);
    } else if (o instanceof Goodbye) {
      tell("refused", ((Goodbye) o).reason);
    }
  }

  @Override
  public void accept(int[] i) {
    last =
        new Input(
            last,
            i[1],
            i[2],
            Float.intBitsToFloat(i[3]),
            Float.intBitsToFloat(i[4]),
            Float.intBitsToFloat(i[5]));
    last.count = i[0];
    if (byUdp) {
      client.sendUDP(last);
    } else {
      client.sendTCP(last);
    }
  }

  /** Leaves the game and closes. */
  @Override
  public void close() {
    client.sendTCP(new Leave());
    client.stop();
  }
}
