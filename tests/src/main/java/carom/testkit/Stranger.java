package carom.testkit;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;

/** A peer that keeps what a hostile client needs to go on: its welcome, and the link's end. */
public class Stranger implements LinkHandler {
  private ServerMessage.Welcome welcome;
  private boolean closed;

  /** Returns the latest welcome, or null before one. */
  public final ServerMessage.Welcome welcome() {
    return welcome;
  }

  /** Returns whether the link has ended. */
  public final boolean closed() {
    return closed;
  }

  @Override
  public void message(Link from, Object message) {
    if (message instanceof ServerMessage.Welcome w) {
      welcome = w;
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {}

  @Override
  public void closed(Link from, String reason) {
    closed = true;
  }
}
