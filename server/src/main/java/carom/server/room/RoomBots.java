package carom.server.room;

import carom.net.protocol.SessionState;
import carom.server.config.BotRule;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.SimulationHost;
import java.util.ArrayList;
import java.util.List;

/**
 * Decides when bots come into a room and go, as {@code --bots} says. While people are in the room,
 * bots make up the number of players. A bot first takes a seat whose player is away, with its body
 * and score, and otherwise a free one. Bots go when more people come, and when the last has gone.
 *
 * <pre>
 *   a player's link is lost ─► grace ─► bot stands in ─► grace is over: the bot has the seat
 *                                │            │
 *                                └────────────┴──► the player is back, and the bot goes
 * </pre>
 *
 * <p>The room's thread.
 */
final class RoomBots {
  private static final long NS_PER_MS = 1_000_000;

  /** Time between two looks, in each of which one bot may come. */
  private static final long LOOK_NS = 250 * NS_PER_MS;

  /** Bots that may go in a look. */
  private static final int MAX_PER_LOOK = 16;

  /** Time that a player who lost the connection has to come back before a bot stands in. */
  private static final long PATIENCE_NS = 1_500 * NS_PER_MS;

  /** Time in which a bot that was asked for must come. */
  static final long COMING_NS = 10_000 * NS_PER_MS;

  private static final String NAME = "bot";

  private record Order(Seats.Seat seat, long untilNs) {}

  private final RoomContext room;
  private final String name;
  private final RoomDirectory directory;
  private final RoomSessions sessions;
  private final List<Order> orders = new ArrayList<>();
  private List<BotRule> rules;
  private BotRule rule = BotRule.NONE;
  private long lookedNs;

  /**
   * Creates an object that has asked for no bot.
   *
   * @param name the room's name
   */
  RoomBots(RoomContext room, String name, RoomDirectory directory, RoomSessions sessions) {
    this.room = room;
    this.name = name;
    this.directory = directory;
    this.sessions = sessions;
  }

  /** Lets a bot come or go, if it is time. */
  void serve(long nowNs, Departures departures) {
    if (directory.bots() == null || nowNs - lookedNs < LOOK_NS) {
      return;
    }
    lookedNs = nowNs;
    for (int i = orders.size() - 1; i >= 0; i--) {
      Seats.Seat seat = orders.get(i).seat;
      if (!room.seats().isOrdered(seat)) {
        if (!room.seats().isClaimed(seat)) { // it isn't under way any longer
          orders.remove(i);
        }
      } else if (nowNs - orders.get(i).untilNs >= 0) {
        room.seats().withdraw(orders.remove(i).seat);
      }
    }
    int missing = people(null) == 0 ? -sessions.count() : target() - players() - underWay();
    if (missing > 0) {
      fill(nowNs);
    }
    for (int i = 0; i < Math.min(-missing, MAX_PER_LOOK); i++) {
      Session bot = cancelOne() ? null : newest();
      if (bot != null) {
        departures.remove(bot, "is a bot and not needed", " left", nowNs);
      }
    }
  }

  /** Returns the number of players up to which bots come. */
  private int target() {
    List<BotRule> present = room.config().get(ServerConfig.BOTS);
    if (!present.equals(rules)) {
      rules = present;
      rule = BotRule.of(present, name);
    }
    int most = Math.min(room.seats().count(), room.simulation().game().maxPlayers());
    return Math.min(rule.players(), most);
  }

  /** Returns how many people have seats, in their grace period or not. */
  private int people(Session except) {
    int count = 0;
    for (int i = 0; i < sessions.count(); i++) {
      Session session = sessions.get(i);
      count += session != except && !session.seat().isBots() ? 1 : 0;
    }
    return count;
  }

  /** Returns how many play: people with a link, and the bots that have seats for good. */
  private int players() {
    int count = 0;
    for (int i = 0; i < sessions.count(); i++) {
      Session session = sessions.get(i);
      boolean plays = session.state() != SessionState.GRACE || session.seat().isBots();
      count += plays && !session.player().isSpectator() ? 1 : 0;
    }
    return count;
  }

  /** Returns whether a bot that comes to a seat is one more player. */
  private boolean isOneMore(Seats.Seat seat) {
    Session session = sessions.onSeat(seat.id());
    return session == null || !seat.isBots();
  }

  private int underWay() {
    int count = 0;
    for (int i = 0; i < orders.size(); i++) {
      count += isOneMore(orders.get(i).seat) ? 1 : 0;
    }
    return count;
  }

  private void fill(long nowNs) {
    boolean waits = false;
    for (int i = 0; i < sessions.count(); i++) {
      Session session = sessions.get(i);
      if (isDeserted(session, nowNs)) {
        if (mayStandIn(session, nowNs)) {
          order(session.seat(), nowNs);
          return;
        }
        waits = true;
      }
    }
    Seats.Seat seat = waits ? null : room.seats().takeForBot(NAME);
    if (seat != null) {
      order(seat, nowNs);
    }
  }

  /** Cancels an order that nobody has followed yet, and returns whether there was one. */
  private boolean cancelOne() {
    for (int i = orders.size() - 1; i >= 0; i--) {
      Seats.Seat seat = orders.get(i).seat;
      if (room.seats().isOrdered(seat) && isOneMore(seat)) {
        room.seats().withdraw(orders.remove(i).seat);
        return true;
      }
    }
    return false;
  }

  private boolean isDeserted(Session session, long nowNs) {
    return session.state() == SessionState.GRACE
        && !session.seat().isBots()
        && !session.player().isSpectator()
        && !session.graceIsOver(nowNs)
        && !room.seats().isOrdered(session.seat());
  }

  private boolean mayStandIn(Session session, long nowNs) {
    Seats.Seat seat = session.seat();
    long lostNs = session.graceEndNs() - room.config().graceMs() * NS_PER_MS;
    return !room.seats().isClaimed(seat) && nowNs - lostNs >= PATIENCE_NS;
  }

  /** Asks for a bot to come to a seat. */
  void order(Seats.Seat seat, long nowNs) {
    orders.add(new Order(seat, nowNs + COMING_NS));
    directory.bots().play(room.seats().order(seat), rule.strength());
  }

  /**
   * Returns whether a bot takes the seat of a player who leaves: people alone must be too few, and
   * others must be there to play with.
   */
  boolean takesOver(Session session) {
    return directory.bots() != null
        && session.state() != SessionState.GRACE
        && !session.seat().isBots()
        && !session.player().isSpectator()
        && people(session) > 0
        && people(session) < target(); // a bot that is then too many goes
  }

  /**
   * Returns the bot that goes for a person who comes, if as many play as the game lets play; or
   * null.
   */
  Session inTheWay() {
    SimulationHost simulation = room.simulation();
    return simulation.playerCount() < simulation.game().maxPlayers() ? null : newest();
  }

  /** Returns the bot that came last and stands in for nobody, or null. */
  private Session newest() {
    for (int i = sessions.count() - 1; i >= 0; i--) {
      if (sessions.get(i).seat().isBots()) {
        return sessions.get(i);
      }
    }
    return null;
  }
}
