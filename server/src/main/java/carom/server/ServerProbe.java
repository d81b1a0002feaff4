package carom.server;

import carom.net.frame.Frame;
import carom.net.protocol.ServerMessage;
import carom.net.seal.ExchangeKey;
import carom.net.seal.ServerKey;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;

/**
 * Asks whether a Carom server answers at an address, before players are sent there: it connects by
 * TCP to each address of the name and reads the greeting, whose key must be the one that is named.
 */
final class ServerProbe {
  private static final int CONNECT_MS = 2_000;
  private static final int MOST_ADDRESSES = 4;

  private ServerProbe() {}

  /** Returns what was tried and failed, or null if the server answers. Waits some seconds. */
  public static String problem(ServerMessage.Redirect to) {
    int colon = to.server().lastIndexOf(':');
    String host = to.server().substring(0, colon).replaceAll("[\\[\\]]", "");
    int port = Integer.parseInt(to.server().substring(colon + 1));
    List<String> tried = new ArrayList<>();
    try {
      for (InetAddress address : InetAddress.getAllByName(host)) {
        if (tried.size() < MOST_ADDRESSES) {
          String problem = problem(new InetSocketAddress(address, port), to.fingerprint());
          if (problem == null) {
            return null;
          }
          tried.add(address.getHostAddress() + " tcp " + port + ": " + problem);
        }
      }
    } catch (UnknownHostException e) {
      tried.add("the name " + host + " has no address");
    }
    return "server=" + to.server() + " doesn't answer; tried " + String.join("; ", tried);
  }

  private static String problem(InetSocketAddress address, String fingerprint) {
    try (Socket socket = new Socket()) {
      socket.connect(address, CONNECT_MS);
      socket.setSoTimeout(CONNECT_MS);
      DataInputStream in = new DataInputStream(socket.getInputStream());
      if (in.readInt() != 1 + Frame.GREETING_BYTES || in.readByte() != Frame.REGISTER_TCP) {
        return "it is no Carom server of this version, or it is full";
      }
      byte[] greeting = in.readNBytes(Frame.GREETING_BYTES);
      byte[] key = new byte[ExchangeKey.BYTES];
      System.arraycopy(greeting, greeting.length - key.length, key, 0, key.length);
      String found = ServerKey.fingerprint(key);
      return fingerprint.isEmpty() || fingerprint.equals(found)
          ? null
          : "its fingerprint is " + found;
    } catch (IOException e) {
      return e.getMessage() == null ? "the connection ended" : e.getMessage();
    }
  }
}
