package carom.server.thin.plain;

import carom.net.protocol.ProtocolLimits;
import carom.server.thin.GameClasses;
import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinLink;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinSnapshot;
import java.net.InetSocketAddress;
import java.util.List;

/** A thin client behind a connection of stock KryoNet that has asked to join. */
final class PlainLink extends ThinLink {
  /** Largest part of a snapshot by TCP. */
  private static final int MAX_STREAM_PART = 16 * 1_024;

  private final PlainConnection connection;
  private final InetSocketAddress udp;

  // The room's thread only.
  private final SnapshotCutter cutter = new SnapshotCutter();
  private final KryoOutput scratch = new KryoOutput();

  /**
   * Creates an open link.
   *
   * @param udp where datagrams go; null for snapshots by TCP
   */
  PlainLink(PlainConnection connection, String remote, InetSocketAddress udp) {
    super(remote, udp == null);
    this.connection = connection;
    this.udp = udp;
  }

  /** Passes on what the client says; the door's threads. */
  void take(ThinClientMessage message) {
    receive(message);
  }

  /** Notes that the client is there; the door's threads. */
  void alive() {
    heard();
  }

  /** Notes how long the way to the client and back is, ms; the door's thread. */
  void measured(int ms) {
    roundTripMs(ms);
  }

  /** Notes that the connection has ended; the door's thread. */
  void gone(String reason) {
    lost(reason);
  }

  @Override
  public Door door() {
    return Door.PLAIN;
  }

  @Override
  public boolean isPlainText() {
    return true;
  }

  @Override
  protected boolean write(List<ThinNews> news) {
    int bytes = connection.tell(news);
    if (bytes < 0) {
      close("the client doesn't read what it is sent");
      return false;
    }
    counters().messageBytesOut.addAndGet(bytes);
    return true;
  }

  @Override
  protected void useClasses(GameClasses classes) {
    connection.use(classes);
  }

  @Override
  public boolean takesSnapshot() {
    return udp != null || connection.hasSentAll();
  }

  @Override
  protected int draw(ThinSnapshot snapshot) {
    int bytes = 0;
    int parts =
        cutter.cut(snapshot, udp == null ? MAX_STREAM_PART : ProtocolLimits.MAX_DATAGRAM_BYTES);
    for (int i = 0; i < parts; i++) {
      scratch.truncate(0);
      cutter.write(scratch, connection.matches(), i);
      bytes += scratch.length();
      boolean sent =
          udp == null
              ? connection.send(scratch.bytes(), scratch.length())
              : connection.sendDatagram(udp, scratch.bytes(), scratch.length());
      if (!sent) {
        counters().datagramsDropped.incrementAndGet();
      }
    }
    counters().datagramsOut.addAndGet(parts);
    counters().datagramBytesOut.addAndGet(bytes);
    return bytes;
  }

  @Override
  protected void hangUp(String reason) {
    connection.requestClose(reason);
  }
}
