package carom.net.transport;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/**
 * Factory that wraps links in the same bad network, each with its own random numbers. Any thread
 * may use it.
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

  /**
   * Returns the size of a message, or 0 without a bandwidth limit, where the extra encoding isn't
   * worth its cost.
   */
  private int messageBytes(Object message) {
    return impairment.bandwidthKbit() == 0 ? 0 : Broadcast.encode(codec, message).length;
  }
}
