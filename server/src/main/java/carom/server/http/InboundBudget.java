package carom.server.http;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import org.xnio.channels.StreamSinkChannel;
import org.xnio.conduits.AbstractStreamSourceConduit;
import org.xnio.conduits.StreamSourceConduit;

/**
 * Reads from a connection until it has sent more bytes than it may, and then fails, so that the
 * connection ends. It counts all that arrives: requests, frames, and what is neither. The thread
 * that reads the connection.
 */
final class InboundBudget extends AbstractStreamSourceConduit<StreamSourceConduit> {
  private static final double NS_PER_S = 1e9;

  private final int perSecond;
  private final int burst;
  private double left;
  private long filledNs = System.nanoTime();

  /**
   * Creates a full budget.
   *
   * @param perSecond bytes a second in the long run
   * @param burst bytes at once
   */
  InboundBudget(StreamSourceConduit source, int perSecond, int burst) {
    super(source);
    this.perSecond = perSecond;
    this.burst = burst;
    left = burst;
  }

  private long spend(long bytes) throws IOException {
    if (bytes <= 0) {
      return bytes;
    }
    long nowNs = System.nanoTime();
    left = Math.min(burst, left + (nowNs - filledNs) / NS_PER_S * perSecond) - bytes;
    filledNs = nowNs;
    if (left < 0) {
      throw new IOException("more than " + perSecond + " bytes a second");
    }
    return bytes;
  }

  @Override
  public int read(ByteBuffer to) throws IOException {
    return (int) spend(next.read(to));
  }

  @Override
  public long read(ByteBuffer[] to, int offset, int length) throws IOException {
    return spend(next.read(to, offset, length));
  }

  @Override
  public long transferTo(long position, long count, FileChannel target) throws IOException {
    return spend(next.transferTo(position, count, target));
  }

  @Override
  public long transferTo(long count, ByteBuffer through, StreamSinkChannel target)
      throws IOException {
    return spend(next.transferTo(count, through, target));
  }
}
