import carom.plain.Body;
import carom.plain.Chat;
import carom.plain.Goodbye;
import carom.plain.Input;
import carom.plain.Join;
import carom.plain.Leave;
import carom.plain.Match;
import carom.plain.Plain;
import carom.plain.Refused;
import carom.plain.Snapshot;
import com.esotericsoftware.kryonet.Client;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.Listener;
import java.util.HashMap;
import java.util.Map;

/** A whole client with KryoNet as it is: joins, walks to the right, and prints where it is. */
public class FirstClient {
  static volatile int me = -1; // own player
  static int match; // its number
  static volatile int tick = -1; // newest snapshot
  static final Map<Integer, Integer> OWNERS = new HashMap<>(); // of bodies

  static void draw(Body b) {
    if (b.archetype >= 0) OWNERS.put(b.id, b.owner); // told when it is new
    if (OWNERS.getOrDefault(b.id, -1) == me && tick % 30 < 2)
      System.out.println("tick " + tick + ": I am at " + b.x + ", " + b.y);
  }

  public static void main(String[] args) throws Exception {
    Client c = new Client(65536, 65536);
    Plain.register(c.getKryo());
    c.addListener(
        new Listener() {
          @Override
          public void received(Connection link, Object o) {
            if (o instanceof Snapshot && ((Snapshot) o).match == match) {
              tick = ((Snapshot) o).tick;
              for (Body b : ((Snapshot) o).bodies) draw(b);
            } else if (o instanceof Match) {
              match = ((Match) o).number;
              me = ((Match) o).player;
            } else if (o instanceof Chat) System.out.println(((Chat) o).text);
            else if (o instanceof Refused) System.out.println(((Refused) o).text);
            else if (o instanceof Goodbye) System.out.println(((Goodbye) o).text);
          }
        });
    c.start();
    c.connect(5000, args[0], Integer.parseInt(args[1]), Integer.parseInt(args[2]));
    c.sendTCP(new Join("Ann"));
    Input input = null;
    for (int i = 0; i < 300 && c.isConnected(); i++) { // five seconds
      float moveX = i % 120 < 60 ? 1 : -1;
      input = new Input(input, tick, 0, moveX, 0, 0); // carries the two before, too
      c.sendUDP(input);
      if (i == 60) c.sendTCP(new Chat("hello"));
      Thread.sleep(16);
    }
    c.sendTCP(new Leave());
    Thread.sleep(500); // until the goodbye
    c.stop();
  }
}
