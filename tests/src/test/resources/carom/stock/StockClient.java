import carom.plain.Body;
import carom.plain.Chat;
import carom.plain.Choose;
import carom.plain.Custom;
import carom.plain.Emote;
import carom.plain.FieldValue;
import carom.plain.Fields;
import carom.plain.Goodbye;
import carom.plain.Input;
import carom.plain.Join;
import carom.plain.Leave;
import carom.plain.ListRooms;
import carom.plain.Match;
import carom.plain.Plain;
import carom.plain.Player;
import carom.plain.Rate;
import carom.plain.Redirect;
import carom.plain.Refused;
import carom.plain.Room;
import carom.plain.Rooms;
import carom.plain.Roster;
import carom.plain.Snapshot;
import carom.plain.Welcome;
import com.esotericsoftware.kryonet.Client;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.KeepAlive;
import com.esotericsoftware.kryonet.FrameworkMessage.Ping;
import com.esotericsoftware.kryonet.Listener;
import com.esotericsoftware.minlog.Log;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A client with stock KryoNet that does what standard input says, a command a line, and says on
 * standard output what happens: {@code connect TCP [UDP]}, {@code join NAME [SECRET]}, {@code
 * version N}, {@code hold BUTTONS MOVEX MOVEY}, {@code chat TEXT}, {@code where}, {@code leave},
 * {@code break} and more.
 */
public final class StockClient {
  private static final Map<Integer, Body> BODIES = new ConcurrentHashMap<>();
  private static final Map<Integer, Player> PLAYERS = new ConcurrentHashMap<>();
  private static volatile Client client;
  private static volatile boolean udp;
  private static volatile boolean joined;
  private static volatile int player = -1;
  private static volatile int tick = -1;
  private static volatile int used = -1;
  private static volatile int snapshots;
  private static int match;
  private static volatile int parts;
  private static volatile int buttons;
  private static volatile float moveX;
  private static volatile float moveY;
  private static volatile int pings;

  private StockClient() {}

  private static synchronized void say(String text) {
    System.out.println(text);
    System.out.flush();
  }

  private static synchronized void show(Snapshot s) {
    snapshots++;
    if (s.match != match || s.tick < tick) {
      return; // of another match, or late
    }
    parts = s.tick == tick ? parts + 1 : 1;
    for (Body b : s.bodies) {
      Body old = BODIES.get(b.id);
      if (b.archetype < 0 && old == null) {
        say("nameless " + b.id);
        continue;
      }
      if (b.archetype < 0) {
        b.archetype = old.archetype;
        b.owner = old.owner;
      }
      BODIES.put(b.id, b);
    }
    for (int id : s.gone) {
      BODIES.remove(id);
    }
    used = s.input;
    if (tick < s.tick && parts == s.parts) {
      tick = s.tick;
    }
  }

  private static void hear(Object o) {
    if (o instanceof Snapshot) {
      show((Snapshot) o);
    } else if (o instanceof Welcome) {
      Welcome w = (Welcome) o;
      say("welcome secret=" + w.secret + " version=" + w.version + " tickRate=" + w.tickRate);
    } else if (o instanceof Match) {
      Match m = (Match) o;
      BODIES.clear();
      PLAYERS.clear();
      tick = -1;
      match = m.number;
      player = m.player;
      joined = true;
      say(
          "match player="
              + m.player
              + " room="
              + m.room
              + " game="
              + m.game
              + " level="
              + m.level
              + " archetypes="
              + m.archetypes.length
              + " ground="
              + m.ground.length
              + " messages="
              + m.messages.length);
    } else if (o instanceof Roster) {
      for (Player p : ((Roster) o).players) {
        PLAYERS.put(p.id, p);
        say("player " + p.id + " " + p.name);
      }
      for (int id : ((Roster) o).gone) {
        PLAYERS.remove(id);
        say("gone " + id);
      }
    } else if (o instanceof Chat) {
      say("chat " + ((Chat) o).player + " " + ((Chat) o).text);
    } else if (o instanceof Emote) {
      say("emote " + ((Emote) o).player + " " + ((Emote) o).emote);
    } else if (o instanceof Custom) {
      say("custom " + ((Custom) o).kind + " " + ((Custom) o).get("word"));
    } else if (o instanceof Fields) {
      for (FieldValue f : ((Fields) o).values) {
        say("field " + f.scope + " " + f.id + " " + f.name + "=" + f.value);
      }
    } else if (o instanceof Rooms) {
      for (Room r : ((Rooms) o).rooms) {
        say("room " + r.name + " " + r.game + " " + r.players + "/" + r.places);
      }
    } else if (o instanceof Redirect) {
      say("redirect " + ((Redirect) o).server);
    } else if (o instanceof Refused) {
      say("refused " + ((Refused) o).reason + " " + ((Refused) o).text);
    } else if (o instanceof Goodbye) {
      say("goodbye " + ((Goodbye) o).reason + " " + ((Goodbye) o).text);
    } else if (o instanceof Ping) {
      pings++;
    }
  }

  private static void connect(String[] words) throws Exception {
    Client c = new Client(65536, 65536);
    Plain.register(c.getKryo());
    c.addListener(
        new Listener() {
          @Override
          public void received(Connection link, Object o) {
            hear(o);
          }

          @Override
          public void disconnected(Connection link) {
            joined = false;
            say("disconnected");
          }
        });
    c.start();
    client = c;
    udp = words.length > 2;
    if (udp) {
      c.connect(8000, "127.0.0.1", Integer.parseInt(words[1]), Integer.parseInt(words[2]));
    } else {
      c.connect(8000, "127.0.0.1", Integer.parseInt(words[1]));
    }
    say("connected " + c.getID());
  }

  private static void obey(String[] words) throws Exception {
    switch (words[0]) {
      case "connect":
        connect(words);
        break;
      case "join":
        client.sendTCP(new Join(words[1], words.length > 2 ? Long.parseLong(words[2]) : 0));
        break;
      case "token":
        Join join = new Join("Tom");
        join.token = words[1];
        client.sendTCP(join);
        break;
      case "version":
        Join other = new Join("Old");
        other.version = Integer.parseInt(words[1]);
        client.sendTCP(other);
        break;
      case "hold":
        buttons = Integer.parseInt(words[1]);
        moveX = Float.parseFloat(words[2]);
        moveY = Float.parseFloat(words[3]);
        break;
      case "chat":
        client.sendTCP(new Chat(words[1]));
        break;
      case "emote":
        client.sendTCP(new Emote(words[1]));
        break;
      case "rate":
        client.sendTCP(new Rate(Integer.parseInt(words[1])));
        break;
      case "watch":
        Choose choose = new Choose();
        choose.role = "SPECTATOR";
        client.sendTCP(choose);
        break;
      case "rooms":
        client.sendTCP(new ListRooms());
        break;
      case "ping":
        client.updateReturnTripTime();
        Thread.sleep(300);
        say("ping " + client.getReturnTripTime() + " " + pings);
        break;
      case "alive":
        client.sendTCP(new KeepAlive());
        if (udp) {
          client.sendUDP(new KeepAlive());
        }
        break;
      case "where":
        where();
        break;
      case "leave":
        client.sendTCP(new Leave());
        break;
      case "break":
        client.stop();
        break;
      default:
        throw new IllegalArgumentException(words[0]);
    }
  }

  private static synchronized void where() {
    Body own = null;
    for (Body b : BODIES.values()) {
      own = b.owner == player ? b : own;
    }
    say(
        String.format(
            Locale.ROOT,
            "where own=%d x=%.3f y=%.3f bodies=%d players=%d snapshots=%d tick=%d used=%d",
            own == null ? -1 : own.id,
            own == null ? 0 : own.x,
            own == null ? 0 : own.y,
            BODIES.size(),
            PLAYERS.size(),
            snapshots,
            tick,
            used));
  }

  private static void press() {
    Input last = null;
    try {
      while (true) {
        Thread.sleep(16);
        Client c = client;
        if (c == null || !joined) {
          continue;
        }
        last = new Input(last, tick, buttons, moveX, moveY, 0);
        if (udp) {
          c.sendUDP(last);
        } else {
          c.sendTCP(last);
        }
      }
    } catch (InterruptedException e) {
      say("interrupted");
    }
  }

  public static void main(String[] args) throws Exception {
    Log.set(Log.LEVEL_NONE);
    Thread hands = new Thread(StockClient::press);
    hands.setDaemon(true);
    hands.start();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in, "UTF-8"));
    for (String line; (line = in.readLine()) != null; ) {
      try {
        obey(line.split(" "));
      } catch (Exception e) {
        say("failed " + e);
      }
    }
    System.exit(0);
  }
}
