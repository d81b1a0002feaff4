package carom.net.transport;

import java.util.ArrayList;
import java.util.List;

/** Remembers what a link hands over. */
final class Recorder implements LinkHandler {

  final List<Object> messages = new ArrayList<>();
  final List<byte[]> datagrams = new ArrayList<>();
  final List<String> order = new ArrayList<>();
  int closed;
  String reason = "";

  @Override
  public void message(Link link, Object message) {
    messages.add(message);
    order.add(message.toString());
  }

  @Override
  public void datagram(Link link, byte[] bytes, int length) {
    byte[] copy = new byte[length];
    System.arraycopy(bytes, 0, copy, 0, length);
    datagrams.add(copy);
    order.add("datagram " + copy[0]);
  }

  @Override
  public void closed(Link link, String why) {
    closed++;
    reason = why;
  }
}
