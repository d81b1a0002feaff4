package carom.server.query;

import carom.fuzz.FuzzTarget;
import carom.testkit.Stepper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * Status queries, once as they are and once with the right challenge behind them. A sender that
 * hasn't proven its address never gets more bytes than it sent.
 */
public final class StatusQueryTarget implements FuzzTarget {
  private static final byte[] INFO =
      "\u00ff\u00ff\u00ff\u00ffTSource Engine Query\0".getBytes(StandardCharsets.ISO_8859_1);
  private static final int CHALLENGE_AT = 5;
  private static final int CHALLENGE_BYTES = 9;

  private final Stepper stepper = Stepper.of("arena");
  private StatusQuery server = open();

  /** Another sender for each input: a fuzzer sees challenges, and would return them later. */
  private InetSocketAddress from = sender();

  private int senders;

  /** Returns a sender of another host, so that no budget but that of all is used up. */
  private InetSocketAddress sender() {
    int n = ++senders;
    try {
      byte[] address = {10, (byte) (n >> 16), (byte) (n >> 8), (byte) n};
      return new InetSocketAddress(InetAddress.getByAddress(address), 1 + (n & 0x7fff));
    } catch (UnknownHostException e) {
      throw new UncheckedIOException(e);
    }
  }

  private StatusQuery open() {
    try {
      return new StatusQuery(
          InetAddress.getLoopbackAddress(),
          0,
          new StatusFacts("A server", "1.2", 54_555, 54_777, stepper.server().rooms()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the answer to a plain question, also when the budget of this second is spent. */
  private byte[] challenge() {
    byte[] answer = server.answer(INFO, from);
    if (answer == null) {
      server.close();
      server = open();
      answer = server.answer(INFO, from);
    }
    return answer;
  }

  @Override
  public void take(byte[] data) {
    from = sender();
    byte[] challenge = challenge();
    byte[] answer = server.answer(data, from);
    if (answer != null && answer.length > Math.min(CHALLENGE_BYTES, data.length)) {
      throw new AssertionError(
          "a stranger got bytes=" + answer.length + " for a query of bytes=" + data.length);
    }
    if (data.length < CHALLENGE_AT || data[CHALLENGE_AT - 1] == StatusQuery.PLAYERS) {
      return; // the players are asked of a room's thread, and this room stands still
    }
    byte[] proven = Arrays.copyOf(data, data.length + Integer.BYTES);
    System.arraycopy(challenge, CHALLENGE_AT, proven, data.length, Integer.BYTES);
    answer = server.answer(proven, from);
    if (answer != null && answer.length > StatusAnswers.MAX_BYTES) {
      throw new AssertionError("an answer has bytes=" + answer.length);
    }
  }

  @Override
  public void close() {
    server.close();
    stepper.close();
  }

  @Override
  public List<byte[]> seeds() {
    byte[] players = Arrays.copyOf(INFO, CHALLENGE_BYTES);
    players[CHALLENGE_AT - 1] = StatusQuery.PLAYERS;
    byte[] rules = Arrays.copyOf(INFO, CHALLENGE_AT);
    rules[CHALLENGE_AT - 1] = StatusQuery.RULES;
    return List.of(INFO, players, rules);
  }
}
