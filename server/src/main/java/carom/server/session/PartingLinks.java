package carom.server.session;

import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.ArrayList;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Closes links a moment after their last message was sent, so that the message arrives. A TCP
 * connection that is closed with unread input is reset, and a reset may overtake the goodbye.
 *
 * <p>One thread.
 */
public final class PartingLinks {
  private static final Logger LOG = LoggerFactory.getLogger(PartingLinks.class);
  private static final int MAX_POLL = 64;
  private static final LinkHandler DEAF =
      new LinkHandler() {
        @Override
        public void message(Link link, Object message) {}

        @Override
        public void datagram(Link link, byte[] bytes, int length) {}

        @Override
        public void closed(Link link, String reason) {}
      };

  private final List<Parting> partings = new ArrayList<>();
  private final int capacity;

  private record Parting(Link link, String reason, long deadlineNs) {}

  /**
   * Creates an empty list.
   *
   * @param capacity how many links may linger; one more closes the oldest at once
   */
  public PartingLinks(int capacity) {
    this.capacity = capacity;
  }

  /** Takes over a link; closes it at the deadline, or earlier when the peer does. */
  public void add(Link link, String reason, long deadlineNs) {
    if (partings.size() >= capacity) {
      close(partings.remove(0));
    }
    partings.add(new Parting(link, reason, deadlineNs));
  }

  /** Closes what is due. Returns how many links were closed. */
  public int doWork(long nowNs) {
    int closed = 0;
    for (int i = partings.size() - 1; i >= 0; i--) {
      Parting parting = partings.get(i);
      if (nowNs - parting.deadlineNs >= 0 || drained(parting.link)) {
        close(parting);
        partings.remove(i);
        closed++;
      }
    }
    return closed;
  }

  /**
   * Throws away what has arrived, and returns whether the peer has closed the link or it failed.
   */
  private static boolean drained(Link link) {
    try {
      link.poll(DEAF, MAX_POLL);
      return link.state() == Link.State.CLOSED;
    } catch (RuntimeException e) {
      LOG.debug("a parting link failed", e);
      return true;
    }
  }

  /** Returns whether no link lingers. */
  public boolean isEmpty() {
    return partings.isEmpty();
  }

  /** Closes all at once. */
  public void closeAll() {
    partings.forEach(PartingLinks::close);
    partings.clear();
  }

  private static void close(Parting parting) {
    try {
      parting.link.close(parting.reason);
    } catch (RuntimeException e) {
      LOG.debug("a parting link could not be closed", e);
    }
  }
}
