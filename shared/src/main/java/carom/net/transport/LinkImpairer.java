package carom.net.transport;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/**
 * Puts the same bad network around one link after the other, each with random numbers of its own.
 * Any thread.
 */
final class LinkImpairer {
  private final Impairment impairment;
  private final MessageCodec codec;
  private final LongSupplier nowNs;
  private final AtomicLong links = new AtomicLong();

  LinkImpairer(Impairment impairment, MessageCodec codec, LongSupplier nowNs) {
    this.impairment = impairment;
    this.codec = codec;
    this.nowNs = nowNs;
  }

  ImpairedLink impair(Link link) {
    long seed = impairment.seed() + 2 * links.getAndIncrement();
    return new ImpairedLink(
        link, impairment.withSeed(seed), impairment.withSeed(seed + 1), nowNs, this::messageBytes);
  }

  /** Encoding a message once more is only worth it where bytes matter. */
  private int messageBytes(Object message) {
    return impairment.bandwidthKbit() == 0 ? 0 : Broadcast.encode(codec, message).length;
  }
}
