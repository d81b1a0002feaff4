package carom.server.web;

import carom.fuzz.FuzzTarget;
import carom.server.access.Logins;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.room.Room;
import carom.testkit.Stepper;
import ch.qos.logback.classic.LoggerContext;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * What a browser or anybody else sends to the web port, over a socket: HTTP requests and, behind a
 * handshake, messages of the live page. The server answers or hangs up, and never fails inside.
 */
public final class WebTarget implements FuzzTarget {
  private static final int PATIENCE_MS = 20_000;
  private static final String FAILED = " 500 ";

  private final Stepper stepper = Stepper.of("arena");
  private final WebServer web;
  private final int port;

  /** Starts a server with a page. Close it in the end. */
  public WebTarget() {
    Logins logins = Logins.begin(System::nanoTime);
    PageConfig config =
        new PageConfig(
            "Carom test",
            new CommandRegistry(),
            Secret.random(),
            logins.page(),
            LogTail.begin(new LoggerContext()),
            List.of(),
            true,
            List.of(),
            Set.of("carom.example"));
    try {
      InetAddress loopback = InetAddress.getLoopbackAddress();
      List<Room> rooms = stepper.server().rooms();
      WebSubject subject =
          new WebSubject("Carom", "test", rooms, List.of(), logins, null, List.of());
      web = new WebServer(loopback, 0, subject, new LivePage(config, subject));
      port = URI.create(web.url()).getPort();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void take(byte[] data) throws IOException {
    String answer = exchange(data);
    int end = answer.indexOf('\r');
    String status = end < 0 ? answer : answer.substring(0, end);
    if (!status.isEmpty() && (!status.startsWith("HTTP/1.") || status.contains(FAILED))) {
      throw new AssertionError("the web server answered: " + status);
    }
  }

  @Override
  public void close() {
    web.close();
    stepper.close();
  }

  private String exchange(byte[] request) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.setSoTimeout(PATIENCE_MS);
      try {
        socket.getOutputStream().write(request);
        socket.shutdownOutput();
        InputStream in = socket.getInputStream();
        return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
      } catch (SocketTimeoutException e) {
        throw new AssertionError("the web server neither answers nor hangs up", e);
      } catch (SocketException e) {
        return ""; // it hung up before it had read all
      }
    }
  }

  @Override
  public List<byte[]> seeds() {
    List<byte[]> seeds = new ArrayList<>();
    for (String path : List.of("/", "/healthz", "/metrics", "/recordings/?ticket=a", "/../a%2f")) {
      seeds.add(request(path, "Host: localhost\r\n"));
    }
    seeds.add(request("/", "Host: carom.example:80\r\nContent-Length: 3\r\n"));
    byte[] upgrade =
        request(
            "/live",
            "Host: localhost\r\nOrigin: http://localhost\r\nConnection: Upgrade\r\n"
                + "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                + "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n");
    for (String message :
        List.of(
            "{\"do\":\"alive\"}",
            "{\"do\":\"look\",\"room\":0,\"x\":1e9}",
            "{\"do\":\"login\",\"secret\":\"x\"}",
            "{\"do\":\"run\",\"line\":\"help\"}")) {
      byte[] text = message.getBytes(StandardCharsets.UTF_8);
      byte[] frame = {(byte) 0x81, (byte) (0x80 | text.length), 0, 0, 0, 0};
      seeds.add(
          ByteBuffer.allocate(upgrade.length + frame.length + text.length)
              .put(upgrade)
              .put(frame)
              .put(text)
              .array());
    }
    return seeds;
  }

  private static byte[] request(String path, String head) {
    String text = "GET " + path + " HTTP/1.1\r\n" + head + "\r\n";
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }
}
