package carom.server.query;

import carom.net.transport.AddressFamily;
import carom.server.threads.LastingThread;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolFamily;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Locale;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Answers A2S status queries (INFO, PLAYER, RULES) on a UDP port and a daemon thread of its own,
 * also those that are broadcast to a local network.
 *
 * <p>A sender can put another's address on a datagram. So a query is first answered with a
 * challenge, which is never larger than the query. Only a sender that returns the challenge, and so
 * has the address, gets the answer. Challenges are computed from the address and a secret of this
 * run, so that nothing is kept about strangers. Beyond their {@linkplain QueryBudgets budgets},
 * queries are dropped.
 */
public final class StatusQuery implements AutoCloseable {
  /** Port at which server lists look. */
  public static final int DEFAULT_PORT = 27_015;

  /** Asks for the server's name, level and number of players. */
  static final byte INFO = 'T';

  /** Asks for the players. */
  static final byte PLAYERS = 'U';

  /** Asks for the rules. */
  static final byte RULES = 'V';

  private static final Logger LOG = LoggerFactory.getLogger(StatusQuery.class);
  private static final byte CHALLENGE = 'A';
  private static final int SINGLE = -1;
  private static final int HEAD_BYTES = 5;
  private static final byte[] PAYLOAD = "Source Engine Query\0".getBytes(StandardCharsets.US_ASCII);
  private static final int MAX_QUERY_BYTES = 64;
  private static final int SECRET_BYTES = 32;
  private static final long PERIOD_NS = 30_000_000_000L;

  /** Bytes of queries that wait while another is answered. */
  private static final int WAITING_BYTES = 1 << 20;

  private final DatagramSocket socket;
  private final StatusAnswers answers;
  private final byte[] secret = new byte[SECRET_BYTES];
  private final QueryBudgets budgets;

  /**
   * Opens the port and begins to answer.
   *
   * @param address address of this machine, or null for all
   * @param port 0..65,535, 0 = any free one
   * @throws IOException if the port can't be opened; the message says what to do
   */
  public StatusQuery(InetAddress address, int port, StatusFacts facts) throws IOException {
    answers = new StatusAnswers(facts);
    SecureRandom random = new SecureRandom();
    random.nextBytes(secret);
    budgets = new QueryBudgets(random.nextInt());
    try {
      ProtocolFamily family = AddressFamily.of(address);
      DatagramChannel channel =
          family == null ? DatagramChannel.open() : DatagramChannel.open(family);
      socket = channel.socket();
      socket.setReceiveBufferSize(WAITING_BYTES);
      socket.bind(new InetSocketAddress(address, port));
    } catch (IOException e) {
      throw new IOException(
          String.format(
              Locale.ROOT,
              "query-port=%d can't be opened: %s; choose another with --query-port, or --no-query",
              port,
              e.getMessage()),
          e);
    }
    DatagramPacket packet = new DatagramPacket(new byte[MAX_QUERY_BYTES], MAX_QUERY_BYTES);
    LastingThread.start("carom-query", () -> !socket.isClosed(), () -> answerNext(packet));
  }

  /** Returns the port. */
  public int port() {
    return socket.getLocalPort();
  }

  private void answerNext(DatagramPacket packet) {
    try {
      packet.setLength(MAX_QUERY_BYTES);
      socket.receive(packet);
      byte[] query = Arrays.copyOf(packet.getData(), packet.getLength());
      byte[] answer = answer(query, (InetSocketAddress) packet.getSocketAddress());
      if (answer != null) {
        socket.send(new DatagramPacket(answer, answer.length, packet.getSocketAddress()));
      }
    } catch (IOException e) {
      LOG.debug("a query was not answered", e); // the next one may be
    }
  }

  /** Returns the answer to a datagram, or null if it gets none. */
  byte[] answer(byte[] query, InetSocketAddress from) {
    long nowNs = System.nanoTime();
    if (query.length < HEAD_BYTES || from.getPort() == 0 || !budgets.allow(from, nowNs)) {
      return null;
    }
    ByteBuffer in = ByteBuffer.wrap(query).order(ByteOrder.LITTLE_ENDIAN);
    if (in.getInt() != SINGLE) {
      return null;
    }
    byte kind = in.get();
    if (kind == INFO) {
      byte[] payload = new byte[Math.min(PAYLOAD.length, in.remaining())];
      in.get(payload);
      if (!Arrays.equals(payload, PAYLOAD)) {
        return null;
      }
    } else if ((kind != PLAYERS && kind != RULES) || in.remaining() < Integer.BYTES) {
      return null;
    }
    long period = nowNs / PERIOD_NS;
    int given = in.remaining() >= Integer.BYTES ? in.getInt() : SINGLE;
    boolean proven =
        given != SINGLE
            && (given == challenge(from, period) || given == challenge(from, period - 1));
    return proven
        ? answers.answer(kind, nowNs)
        : ByteBuffer.allocate(HEAD_BYTES + Integer.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(SINGLE)
            .put(CHALLENGE)
            .putInt(challenge(from, period))
            .array();
  }

  private int challenge(InetSocketAddress from, long period) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      digest.update(secret);
      digest.update(from.getAddress().getAddress());
      digest.update(
          ByteBuffer.allocate(Integer.BYTES + Long.BYTES)
              .putInt(from.getPort())
              .putLong(period)
              .array());
      int value = ByteBuffer.wrap(digest.digest()).getInt();
      return value == SINGLE ? 0 : value;
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  @Override
  public void close() {
    socket.close();
  }
}
