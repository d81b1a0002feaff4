package carom.server.thin;

import carom.net.transport.Link;
import carom.net.transport.ServerTransport;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/** A door to thin clients without bytes: what is told reaches the client as it is. */
final class ThinDoor implements ServerTransport {
  private final ArrayDeque<Link> waiting = new ArrayDeque<>();

  /** A client that draws what it is told, and nothing else. */
  static final class Client extends ThinLink {
    /** A pose as it is drawn. */
    record Shown(int x, int y, int angle, int archetype, int owner) {}

    final List<ThinServerMessage> heard = new ArrayList<>();
    final Map<Integer, Shown> bodies = new TreeMap<>();
    final Map<String, Object> fields = new TreeMap<>();
    final Map<Integer, ThinServerMessage.Participant> players = new TreeMap<>();
    private final Random random;
    private final double loss;
    ThinServerMessage.Welcome welcome;
    ThinServerMessage.Match match;
    boolean busy; // its line takes nothing now
    int tick = -1;
    int input = -1;
    int snapshots;
    int jumps;
    String ended;
    private int count;

    Client(boolean stream, double loss, long seed) {
      super("in-process:" + seed, stream);
      this.loss = loss;
      random = new Random(seed);
    }

    void say(ThinClientMessage message) {
      receive(message);
    }

    void press(long... newestFirst) {
      count += 1;
      receive(new ThinClientMessage.Input(count, tick, newestFirst));
    }

    /** Says what was on the way when a match ended: a tick of that match as seen. */
    void pressLate(int seenTick) {
      count += 1;
      receive(new ThinClientMessage.Input(count, seenTick, new long[] {0}));
    }

    void breakOff() {
      lost("pulled");
    }

    @Override
    protected boolean write(List<ThinNews> news) {
      news.forEach(one -> take(one.message()));
      return state() == State.OPEN;
    }

    private void take(ThinServerMessage message) {
      heard.add(message);
      if (message instanceof ThinServerMessage.Welcome w) {
        welcome = w;
      } else if (message instanceof ThinServerMessage.Match m) {
        match = m;
        bodies.clear();
        fields.clear();
        players.clear();
        tick = -1;
      } else if (message instanceof ThinServerMessage.Fields f) {
        f.values().forEach(v -> fields.put(v.scope() + v.id() + "." + v.name(), v.value() + ""));
      } else if (message instanceof ThinServerMessage.Roster r) {
        r.players().forEach(p -> players.put(p.id(), p));
        r.gone().forEach(players::remove);
      }
    }

    @Override
    public boolean takesSnapshot() {
      return !busy;
    }

    @Override
    protected int draw(ThinSnapshot s) {
      int bytes = 8 + 16 * s.count;
      if (random.nextDouble() < loss) {
        return bytes;
      }
      snapshots++;
      tick = s.tick;
      input = s.input;
      for (int i = 0; i < s.count; i++) {
        Shown old = bodies.get(s.id[i]);
        boolean named = s.archetype[i] >= 0;
        jumps += named ? 1 : 0;
        if (old == null && !named) {
          throw new AssertionError("body " + s.id[i] + " is told without a name");
        }
        bodies.put(
            s.id[i],
            new Shown(
                s.x[i],
                s.y[i],
                s.angle[i],
                named ? s.archetype[i] : old.archetype(),
                named ? s.owner[i] : old.owner()));
      }
      for (int i = 0; i < s.goneCount; i++) {
        bodies.remove(s.gone[i]);
      }
      return bytes;
    }

    @Override
    protected void hangUp(String reason) {
      ended = reason;
    }

    /** Returns the last message of a class. */
    <T> T last(Class<T> type) {
      for (int i = heard.size() - 1; i >= 0; i--) {
        if (type.isInstance(heard.get(i))) {
          return type.cast(heard.get(i));
        }
      }
      return null;
    }
  }

  /** Returns a client that has come in and asks for a seat. */
  Client join(String name, boolean stream, double loss, long seed) {
    Client client = new Client(stream, loss, seed);
    client.say(joining(name, 0));
    waiting.add(client);
    return client;
  }

  /** Lets a client in that has said what it wants. */
  void enter(Client client) {
    waiting.add(client);
  }

  static ThinClientMessage.Join joining(String name, long secret) {
    return new ThinClientMessage.Join(ThinLink.VERSION, name, "", "", "", "", "", secret, "");
  }

  @Override
  public Link accept() {
    return waiting.poll();
  }

  @Override
  public int tcpPort() {
    return 0;
  }

  @Override
  public int udpPort() {
    return 0;
  }

  @Override
  public void close() {}
}
