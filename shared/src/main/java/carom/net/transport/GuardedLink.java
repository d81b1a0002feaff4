package carom.net.transport;

import java.util.function.BooleanSupplier;

/** Sends over another link while a condition holds, and drops everything else. */
final class GuardedLink implements Link {
  private final Link link;
  private final BooleanSupplier maySend;

  // used by the owner's thread
  private LinkHandler served;
  private LinkHandler renamed;

  GuardedLink(Link link, BooleanSupplier maySend) {
    this.link = link;
    this.maySend = maySend;
  }

  @Override
  public Link sendingWhile(BooleanSupplier condition) {
    return link.sendingWhile(condition); // in place of this one
  }

  @Override
  public State state() {
    return link.state();
  }

  @Override
  public boolean send(Object message) {
    return maySend.getAsBoolean() && link.send(message);
  }

  @Override
  public boolean sendDatagram(byte[] bytes, int offset, int length) {
    return maySend.getAsBoolean() && link.sendDatagram(bytes, offset, length);
  }

  @Override
  @SuppressWarnings("ReferenceEquality") // the same handler, not an equal one
  public int poll(LinkHandler handler, int max) {
    if (served != handler) {
      served = handler;
      renamed = handler.as(this);
    }
    return link.poll(renamed, max);
  }

  @Override
  public long waitedNs() {
    return link.waitedNs();
  }

  @Override
  public void close(String reason) {
    link.close(reason);
  }

  @Override
  public boolean isOverTcp() {
    return link.isOverTcp();
  }

  @Override
  public boolean mayPass() {
    return link.mayPass();
  }

  @Override
  public boolean isPlainText() {
    return link.isPlainText();
  }

  @Override
  public Door door() {
    return link.door();
  }

  @Override
  public byte[] binding() {
    return link.binding();
  }

  @Override
  public String serverFingerprint() {
    return link.serverFingerprint();
  }

  @Override
  public String remote() {
    return link.remote();
  }

  @Override
  public String closeReason() {
    return link.closeReason();
  }

  @Override
  public LinkCounters counters() {
    return link.counters();
  }
}
