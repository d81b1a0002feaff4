package carom.server.thin;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.MessageDatagram;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.BadLine;
import carom.net.transport.Broadcast;
import carom.net.transport.HandshakeLine;
import carom.net.transport.Link;
import carom.net.transport.LinkCounters;
import carom.net.transport.LinkHandler;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;

/**
 * The server's end of a connection to a thin client: one that is told what there is and sends
 * input. Lobby and rooms treat it as any other link; this class stands between their messages and
 * the few that a thin client needs.
 *
 * <pre>
 *   door's thread ──receive──► inbox ──poll──► lobby, then room
 *   door's thread ──input────► newest input ──takeInput──► tick
 *   lobby, room ──send──► tell ──► door        room ──show──► door
 * </pre>
 *
 * <p>Each door extends it by the bytes: {@link #write}, {@link #draw}, {@link #hangUp}. A door
 * calls {@link #receive}, {@link #heard} and {@link #lost} from its own thread.
 */
public abstract class ThinLink implements Link {
  /** The version of what thin clients and servers say to each other. */
  public static final int VERSION = 1;

  /** Snapshots a second unless the client asks for others. */
  public static final int DEFAULT_RATE = 30;

  /** Fewest snapshots a second that a client may ask for. */
  public static final int MIN_RATE = 5;

  /** Most snapshots a second that a client may ask for. */
  public static final int MAX_RATE = 60;

  /** Most messages that wait to be polled; one more closes the link. */
  static final int MAX_WAITING = 256;

  private final String remote;
  private final boolean stream;
  private final LinkCounters counters = new LinkCounters();
  private final Object lock = new Object();

  // Guarded by the lock.
  private final ArrayDeque<Object> inbox = new ArrayDeque<>();
  private String closeReason = "";
  private boolean closeReported;
  private boolean heard;
  private boolean anyInput;
  private int newestCount;
  private int seenTick = -1;
  private long newestInput;
  private long unseenButtons;

  // Set before the link is used.
  private BadLine up;
  private BadLine down;
  private int simulatedMs;

  private volatile State state = State.OPEN;
  private volatile int rate = DEFAULT_RATE;
  private volatile int roundTripMs;
  private volatile BooleanSupplier maySend = () -> true;

  // The polling thread only.
  private MessageKinds kinds;
  private String digest = "";
  private int gameMessages;
  private final List<Object> answers = new ArrayList<>();
  private final MessageDatagram pressing = new MessageDatagram();

  // The sending thread of the room only.
  private final MessageDatagram unreliable = new MessageDatagram();
  private final TreeMap<Integer, ServerMessage.RosterEntry> roster = new TreeMap<>();
  private long bytesTaken;
  private ServerMessage.Welcome welcome;
  private boolean welcomed;
  private String room = "";
  private boolean ownColours;

  /**
   * Creates an open link.
   *
   * @param remote the peer's address and port, such as {@code 10.0.0.5:4711}
   * @param stream whether what {@link #show} sends arrives in order or the link is lost, so that
   *     what was sent needn't be told again
   */
  protected ThinLink(String remote, boolean stream) {
    this.remote = remote;
    this.stream = stream;
  }

  // What a door does.

  /**
   * Sends messages, reliably and in order. Any thread; never blocks. If too much waits for the
   * peer, the door closes the link.
   *
   * @param news valid only during the call
   * @return false if the link is closed
   */
  protected abstract boolean write(List<ThinNews> news);

  /**
   * Returns whether the peer takes a snapshot now: nothing of an earlier one waits on this side. If
   * not, the next one replaces it. The room's thread.
   */
  public abstract boolean takesSnapshot();

  /**
   * Sends a snapshot, at once. One thread at a time.
   *
   * @param snapshot valid only during the call
   * @return bytes of payload that it takes
   */
  protected abstract int draw(ThinSnapshot snapshot);

  /**
   * Begins to send the game's messages by classes that the client has, or by name. The room's
   * thread.
   *
   * @param classes of the present game; null by name
   */
  protected void useClasses(GameClasses classes) {}

  /** Closes the connection when what was sent before has gone out, or soon. Any thread, once. */
  protected abstract void hangUp(String reason);

  // What a door calls.

  /**
   * Makes the network bad on purpose: what comes and goes is late, and of datagrams some are lost.
   * Call it before anything else.
   */
  public final void simulate(HandshakeLine network) {
    up = new BadLine(network);
    down = new BadLine(network);
    simulatedMs = (int) (network.roundTripNanos() / 1_000_000);
  }

  /**
   * Takes a message from the peer. The door's thread.
   *
   * @return false if the link is closed, or closes now because too much waits
   */
  protected final boolean receive(ThinClientMessage message) {
    if (up == null) {
      return take(message);
    }
    if (stream || !(message instanceof ThinClientMessage.Input)) {
      up.reliable(() -> take(message));
    } else {
      up.datagram(() -> take(message));
    }
    return state == State.OPEN;
  }

  /** Tells the client something, reliably and in order; see {@link #write}. Any thread. */
  protected final boolean tell(ThinServerMessage message) {
    return tell(List.of(new ThinNews(message)));
  }

  private boolean tell(List<ThinNews> news) {
    if (down == null) {
      return write(news);
    }
    List<ThinNews> copy = List.copyOf(news);
    down.reliable(() -> write(copy));
    return state == State.OPEN;
  }

  /**
   * Shows the client a snapshot. The room's thread.
   *
   * @param snapshot valid only during the call
   * @return bytes of payload that it takes, or on a simulated network about as many
   */
  public final int show(ThinSnapshot snapshot) {
    if (down == null) {
      return draw(snapshot);
    }
    ThinSnapshot copy = snapshot.copy();
    if (stream) {
      down.reliable(() -> draw(copy));
    } else {
      down.datagram(() -> draw(copy));
    }
    return Integer.BYTES * (copy.goneCount + 4 * copy.count);
  }

  private boolean take(ThinClientMessage message) {
    counters.messagesIn.incrementAndGet();
    synchronized (lock) {
      heard = true;
      if (state == State.CLOSED) {
        return false;
      }
      if (message instanceof ThinClientMessage.Input input) {
        take(input);
        return true;
      }
      if (message instanceof ThinClientMessage.Rate asked) {
        rate = Math.max(MIN_RATE, Math.min(MAX_RATE, asked.perSecond()));
        return true;
      }
      if (message instanceof ThinClientMessage.Alive) {
        return true;
      }
      if (inbox.size() < MAX_WAITING) {
        inbox.add(message);
        return true;
      }
    }
    close("messages=" + MAX_WAITING + " wait, the limit");
    return false;
  }

  /** Notes that the peer is there. The door's thread. */
  protected final void heard() {
    synchronized (lock) {
      heard = true;
    }
  }

  /** Notes the round trip to the peer and back, ms. The door's thread. */
  protected final void roundTripMs(int ms) {
    roundTripMs = ms + simulatedMs;
  }

  /** Notes that the peer has gone or the connection broke. The door's thread. */
  protected final void lost(String reason) {
    synchronized (lock) {
      if (state != State.CLOSED) {
        closeReason = reason;
        state = State.CLOSED;
      }
    }
  }

  private void take(ThinClientMessage.Input input) {
    int fresh = anyInput ? input.count() - newestCount : 1; // wraps
    if (fresh <= 0) {
      return;
    }
    seenTick = input.seenTick();
    for (int i = Math.min(fresh, input.inputs().length) - 1; i >= 0; i--) {
      unseenButtons |= input.inputs()[i] & 0xffff;
    }
    anyInput = true;
    newestCount = input.count();
    newestInput = input.inputs()[0];
  }

  // What the room asks.

  /**
   * Returns the input for the next tick: the newest, with every button that was pressed since the
   * last call, however short. The room's thread.
   */
  public final long takeInput() {
    synchronized (lock) {
      long input = newestInput | unseenButtons;
      unseenButtons = 0;
      return input;
    }
  }

  /** Returns the count of the newest input, or -1 before the first. */
  public final int inputCount() {
    synchronized (lock) {
      return anyInput ? newestCount : -1;
    }
  }

  /** Forgets the inputs; the next tick has none. */
  public final void releaseInput() {
    synchronized (lock) {
      newestInput = 0;
      unseenButtons = 0;
      seenTick = -1;
    }
  }

  /**
   * Returns the tick of the newest snapshot that the client has seen, as its newest input says,
   * perhaps of the match before; or -1.
   */
  public final int seenTick() {
    synchronized (lock) {
      return seenTick;
    }
  }

  /** Returns whether anything was heard since the last call. */
  public final boolean takeHeard() {
    synchronized (lock) {
      boolean was = heard;
      heard = false;
      return was;
    }
  }

  /** Returns the payload bytes that have come since the last call. The room's thread. */
  public final long takeBytesIn() {
    long all = counters.messageBytesIn.get() + counters.datagramBytesIn.get();
    long fresh = all - bytesTaken;
    bytesTaken = all;
    return fresh;
  }

  /** Returns the snapshots a second that the client wants. */
  public final int rate() {
    return rate;
  }

  /** Returns whether what is sent arrives in order, so that it needn't be told again. */
  public final boolean isStream() {
    return stream;
  }

  /** Returns the round trip to the client and back, ms; 0 while it isn't known. */
  public final int roundTripMs() {
    return roundTripMs;
  }

  /** Returns the name of the room that the client was welcomed to last. */
  public final String room() {
    return room;
  }

  /**
   * Begins a match. The room's thread.
   *
   * @param match tells the client of it
   * @param newKinds of the game's messages
   * @param coloursPlayers whether players who have chosen no colour get one each
   * @param epoch that of the link's last Welcome
   */
  public final void begin(
      ThinServerMessage.Match match, MessageKinds newKinds, boolean coloursPlayers, int epoch) {
    GameClasses classes = digest.isEmpty() ? null : new GameClasses(newKinds.own());
    boolean fits = classes != null && classes.digest().equals(digest);
    if (!welcomed && classes != null && !fits) {
      refuse(classes, match.game());
      return;
    }
    if (!welcomed) {
      welcomed = true;
      tell(
          new ThinServerMessage.Welcome(
              VERSION, welcome.sessionSecret(), welcome.tickRate(), rate));
    }
    useClasses(fits ? classes : null); // a later game may have others
    ownColours = coloursPlayers;
    kinds = newKinds;
    unreliable.begin(epoch);
    pressing.begin(epoch);
    roster.clear();
    releaseInput();
    tell(match);
  }

  private void refuse(GameClasses classes, String game) {
    String text =
        String.format(
            Locale.ROOT,
            "Your classes of the messages of game %s have digest=%s, the server's %s; write them"
                + " anew by carom plain.",
            game,
            digest,
            classes.digest());
    tell(new ThinServerMessage.Refused(RefusalReason.GAME_VERSION.name(), text));
    answer(new ClientMessage.Leave()); // nobody waits for this player
    close("refused: " + text);
  }

  /**
   * Tells the client several things; the room's thread.
   *
   * @param news valid only during the call
   */
  public final boolean news(List<ThinNews> news) {
    return state == State.OPEN && maySend() && tell(news);
  }

  // A link, as lobby and room see it.

  @Override
  public final State state() {
    return state;
  }

  @Override
  public final Link sendingWhile(BooleanSupplier condition) {
    maySend = condition;
    return this;
  }

  @Override
  public Door door() {
    return Door.PLAY;
  }

  /** Returns whether the link may send for its room now, see {@link #sendingWhile}. Any thread. */
  public final boolean maySend() {
    return maySend.getAsBoolean();
  }

  @Override
  public final boolean send(Object message) {
    if (state != State.OPEN || !maySend()) {
      return false;
    }
    counters.messagesOut.incrementAndGet();
    if (Broadcast.messageOf(message) instanceof ServerMessage m) {
      translate(m);
    }
    return state == State.OPEN;
  }

  private void translate(ServerMessage message) {
    if (message instanceof ServerMessage.Welcome w) {
      room = w.room();
      welcome = w;
      answer(new ClientMessage.Ready(w.epoch(), w.declarationsDigest()));
    } else if (message instanceof ServerMessage.Refused r) {
      tell(new ThinServerMessage.Refused(r.reason().name(), r.playerText()));
    } else if (message instanceof ServerMessage.Goodbye g) {
      tell(new ThinServerMessage.Goodbye(g.reason().name(), g.playerText()));
    } else if (message instanceof ServerMessage.Redirect r) {
      tell(new ThinServerMessage.Redirect(r.server(), r.room(), r.token()));
    } else if (message instanceof ServerMessage.Fleet f) {
      tell(new ThinServerMessage.Standby(f.standby()));
    } else if (message instanceof ServerMessage.Notice n) {
      tell(new ThinServerMessage.Chat(BuiltInKinds.SERVER, n.text(), false));
    } else if (message instanceof ServerMessage.RoomList list) {
      tell(ThinTexts.rooms(list));
    } else if (message instanceof ServerMessage.BestLists best) {
      tell(ThinTexts.best(best));
    } else if (message instanceof ServerMessage.Roster changes) {
      ThinTexts.tellRoster(changes, roster, ownColours, this);
    } else if (message instanceof ServerMessage.Heard h) {
      gameMessages = h.number();
      answer(new ClientMessage.Heard(Integer.MAX_VALUE)); // all that was sent counts as heard
    } else if (message instanceof ServerMessage.GameMessage m) {
      tellGameMessage(m.bytes());
    }
  }

  private void tellGameMessage(byte[] bytes) {
    Message message = kinds.decode(bytes, 0, bytes.length, Direction.FROM_SERVER);
    if (message != null) {
      tell(ThinTexts.of(message));
    }
  }

  @Override
  public final boolean sendDatagram(byte[] bytes, int offset, int length) {
    if (state != State.OPEN || !maySend() || !takesSnapshot()) {
      return false;
    }
    if (unreliable.isOne(bytes, length) && unreliable.decode(bytes, length)) {
      for (byte[] next; (next = unreliable.next()) != null; ) {
        tellGameMessage(next);
      }
    }
    return true;
  }

  private void answer(ClientMessage message) {
    synchronized (lock) {
      inbox.addFirst(message);
    }
  }

  @Override
  public final int poll(LinkHandler handler, int max) {
    int count = 0;
    while (count < max) {
      Object next;
      synchronized (lock) {
        next = inbox.poll();
      }
      if (next == null) {
        break;
      }
      count++;
      if (next instanceof ThinClientMessage message) {
        translate(message);
        for (int i = 0; i < answers.size(); i++) {
          handler.message(this, answers.get(i));
        }
        answers.clear();
        if (!pressing.isEmpty()) {
          pressing.complete();
          handler.datagram(this, pressing.bytes(), pressing.length());
          pressing.clear();
        }
      } else {
        handler.message(this, next);
      }
    }
    reportClose(handler);
    return count;
  }

  private void reportClose(LinkHandler handler) {
    synchronized (lock) {
      if (state != State.CLOSED || closeReported || !inbox.isEmpty()) {
        return;
      }
      closeReported = true;
    }
    handler.closed(this, closeReason);
  }

  private void translate(ThinClientMessage message) {
    if (message instanceof ThinClientMessage.Join join) {
      join(join);
    } else if (message instanceof ThinClientMessage.ListRooms) {
      answers.add(new ClientMessage.ListRooms(Protocol.VERSION));
    } else if (message instanceof ThinClientMessage.Leave) {
      answers.add(new ClientMessage.Leave());
    } else if (kinds == null) {
      return; // the rest means nothing before there is a match
    } else if (message instanceof ThinClientMessage.ListBest) {
      answers.add(new ClientMessage.ListBest());
    } else if (message instanceof ThinClientMessage.Chat chat) {
      say(BuiltInKinds.SAY, Map.of("team", chat.team(), "text", chat.text()));
    } else if (message instanceof ThinClientMessage.Emote emote) {
      say(BuiltInKinds.EMOTE, Map.of("emote", emote.emote()));
    } else if (message instanceof ThinClientMessage.Choose choose) {
      choose(choose);
    } else if (message instanceof ThinClientMessage.View view) {
      if (Float.isFinite(view.x() + view.y() + view.halfWidth() + view.halfHeight())) {
        answers.add(
            new ClientMessage.Look(
                view.x(),
                view.y(),
                view.halfWidth(),
                view.halfHeight(),
                ClientMessage.Look.NOBODY));
      }
    } else if (message instanceof ThinClientMessage.Custom custom) {
      MessageKind kind = kinds.find(custom.kind());
      if (kind != null) {
        say(kind, custom.values());
      }
    }
  }

  private void join(ThinClientMessage.Join join) {
    if (join.version() != VERSION) {
      tell(
          new ThinServerMessage.Refused(
              RefusalReason.PROTOCOL_VERSION.name(),
              String.format(
                  Locale.ROOT,
                  "This server speaks version %d to thin clients, yours %d.",
                  VERSION,
                  join.version())));
      close("refused: version=" + join.version());
      return;
    }
    digest = join.digest().replaceAll("[^0-9A-Za-z]", "?"); // it is told and logged
    if (!join.password().isEmpty()) {
      answers.add(new ClientMessage.Password(join.password()));
    }
    answers.add(
        new ClientMessage.Hello(
            Protocol.VERSION,
            Protocol.physicsDigest(),
            join.name(),
            join.secret(),
            join.room(),
            join.game(),
            join.party(),
            join.token()));
  }

  private void choose(ThinClientMessage.Choose choose) {
    if (choose.team() != null) {
      say(BuiltInKinds.TEAM, Map.of("team", choose.team()));
    }
    if (choose.role() != null) {
      say(BuiltInKinds.ROLE, Map.of("role", choose.role()));
    }
    if (choose.ready() != null) {
      say(BuiltInKinds.READY, Map.of("ready", choose.ready()));
    }
    if (choose.colour() != null) {
      say(BuiltInKinds.COLOUR, Map.of("colour", choose.colour()));
    }
    if (choose.room() != null) {
      answers.add(new ClientMessage.ChangeRoom(choose.room()));
    }
  }

  /** Passes a message of the game on; one whose values don't fit its kind is dropped. */
  private void say(MessageKind kind, Map<String, Object> values) {
    Message message = kind.parse(values);
    if (message == null || !kind.comesFrom(Direction.FROM_CLIENT)) {
      counters.malformed.incrementAndGet();
      return;
    }
    byte[] bytes = kinds.encode(message, Direction.FROM_CLIENT);
    if (kind.isReliable()) {
      answers.add(new ClientMessage.GameMessage(++gameMessages, bytes));
    } else {
      pressing.add(bytes);
    }
  }

  @Override
  public final void close(String reason) {
    synchronized (lock) {
      if (state == State.CLOSED) {
        return;
      }
      closeReason = reason;
      state = State.CLOSED;
    }
    if (down == null) {
      hangUp(reason);
    } else {
      down.reliable(() -> hangUp(reason));
    }
  }

  @Override
  public final String remote() {
    return remote;
  }

  @Override
  public final String closeReason() {
    synchronized (lock) {
      return closeReason;
    }
  }

  @Override
  public final LinkCounters counters() {
    return counters;
  }
}
