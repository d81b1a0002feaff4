package carom.net.seal;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures how long links take to seal, open or refuse a datagram, and to exchange keys. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class SealBenchmark {
  private static final int MAX_FIELDS = 1_200;
  private static final byte TAG = 6;

  /** Number of bytes of a datagram's fields: an input, a usual snapshot, the largest one. */
  @Param({"36", "300", "1200"})
  public int fields;

  /** Encryption of the links. */
  @Param({"ON", "OFF"})
  public Encryption encryption;

  private final ExchangeKey key = ExchangeKey.random();
  private final byte[] greeting = new byte[47];
  private final byte[] plain = new byte[MAX_FIELDS];
  private LinkKeys client;
  private LinkKeys server;
  private byte[] forged;
  private byte[] copy;

  /** Exchanges keys. */
  @Setup(Level.Iteration)
  public void exchange() throws GeneralSecurityException {
    KeyExchange.Offer offer = new KeyExchange.Offer(encryption, key.publicKey(), greeting);
    KeyExchange.Answer answer =
        KeyExchange.answer(encryption, key, greeting, offer.bytes(), 1, MAX_FIELDS);
    client = offer.finish(answer.bytes(), 1, MAX_FIELDS);
    server = answer.keys();
    int length = server.datagramsOut().seal(TAG, plain, 0, fields);
    forged = Arrays.copyOf(server.datagramsOut().bytes(), length);
    forged[length - 1] ^= 1;
    copy = new byte[length];
  }

  /** Seals one datagram. */
  @Benchmark
  public int sealed() {
    return server.datagramsOut().seal(TAG, plain, 0, fields);
  }

  /** Seals one datagram and opens it at the other end. */
  @Benchmark
  public int sealedAndOpened() {
    int length = server.datagramsOut().seal(TAG, plain, 0, fields);
    return client.datagramsIn().open(server.datagramsOut().bytes(), length);
  }

  /** Refuses a datagram that isn't genuine. */
  @Benchmark
  public int refused() {
    System.arraycopy(forged, 0, copy, 0, copy.length);
    return client.datagramsIn().open(copy, copy.length);
  }

  /** Answers one offer of keys, as the server does for each link. */
  @Benchmark
  public Object exchanged() throws GeneralSecurityException {
    KeyExchange.Offer offer = new KeyExchange.Offer(encryption, key.publicKey(), greeting);
    return KeyExchange.answer(encryption, key, greeting, offer.bytes(), 1, MAX_FIELDS);
  }
}
