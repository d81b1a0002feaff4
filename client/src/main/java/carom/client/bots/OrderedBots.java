package carom.client.bots;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.link.ConnectionPhase;
import carom.net.transport.ClientTransport;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Bots that a server orders by lines of text, one for each: the token of a seat, and perhaps a
 * strength ({@code bot:1f3a strong}). A bot goes when the server says so; it never comes back.
 *
 * <p>One thread, but for {@link #order}.
 */
public final class OrderedBots implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(OrderedBots.class);

  private static final class Player {
    final GameClient client;

    /** The match in which the bot has said that it is ready. */
    int readyInMatch = -1;

    Player(GameClient client) {
      this.client = client;
    }
  }

  private final ClientConfig config;
  private final ClientTransport transport;
  private final ConcurrentLinkedQueue<String> orders = new ConcurrentLinkedQueue<>();
  private final List<Player> players = new ArrayList<>();
  private long seed;

  /**
   * Creates no bots yet.
   *
   * @param config of all bots
   * @param transport opens the links; stays the caller's
   * @param seed of what they do
   */
  public OrderedBots(ClientConfig config, ClientTransport transport, long seed) {
    this.config = config.with(ClientConfig.RECONNECT, false);
    this.transport = transport;
    this.seed = seed;
  }

  /** Orders a bot by its line; from any thread. */
  public void order(String line) {
    orders.add(line);
  }

  /** Updates all bots, and begins those that were ordered. */
  public void update(long nowNs) {
    for (String line; (line = orders.poll()) != null; ) {
      try {
        players.add(new Player(begin(line)));
      } catch (IllegalArgumentException e) {
        LOG.warn("an order can't be followed: {}", e.getMessage());
      }
    }
    for (int i = players.size() - 1; i >= 0; i--) {
      if (!plays(players.get(i), nowNs)) {
        players.remove(i).client.close();
      }
    }
  }

  private GameClient begin(String line) {
    String[] words = line.strip().split(" ", 2);
    Strength strength =
        words.length < 2 ? null : Strength.valueOf(words[1].toUpperCase(Locale.ROOT));
    return new GameClient(
        config.with(ClientConfig.TOKEN, words[0]), transport, Bot.skilled(++seed, strength));
  }

  private static boolean plays(Player p, long nowNs) {
    try {
      p.client.update(nowNs);
      int match = p.client.view().matchNumber();
      if (p.client.view().phase() == ConnectionPhase.PLAYING
          && p.readyInMatch != match
          && p.client.ready(true)) {
        p.readyInMatch = match;
      }
      return p.client.view().phase() != ConnectionPhase.ENDED;
    } catch (RuntimeException e) {
      LOG.error("a bot broke and is taken out", e);
      return false;
    }
  }

  /** Returns how many bots play or are on their way. */
  public int count() {
    return players.size();
  }

  /** Makes all bots leave. */
  @Override
  public void close() {
    players.forEach(p -> p.client.close());
  }
}
