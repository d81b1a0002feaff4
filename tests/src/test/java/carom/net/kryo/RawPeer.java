package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.Frame;
import carom.net.seal.DatagramSealer;
import carom.net.seal.Encryption;
import carom.net.seal.KeyExchange;
import carom.net.seal.LinkKeys;
import carom.net.seal.StreamSeal;
import carom.net.transport.Link;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.security.GeneralSecurityException;
import java.util.Arrays;

/** A peer that speaks bytes, not KryoNet. */
final class RawPeer implements AutoCloseable {
  private final Network network;
  final Socket tcp = new Socket();
  final DatagramChannel udp;
  final byte[] greeting;
  final int id;
  final long token;
  LinkKeys keys;

  RawPeer(Network network) throws IOException {
    this(network, DatagramChannel.open());
    udp.connect(new InetSocketAddress(Network.HOST, network.server.udpPort()));
  }

  RawPeer(Network network, DatagramChannel udp) throws IOException {
    this.network = network;
    this.udp = udp;
    tcp.connect(new InetSocketAddress(Network.HOST, network.server.tcpPort()), 2_000);
    tcp.setSoTimeout(3_000);
    byte[] frame = readFrame();
    assertEquals(Frame.REGISTER_TCP, frame[0]);
    greeting = Arrays.copyOfRange(frame, 1, frame.length);
    id = ByteBuffer.wrap(greeting).getInt();
    token = ByteBuffer.wrap(greeting).getLong(4);
  }

  byte[] readFrame() throws IOException {
    ByteBuffer length = ByteBuffer.wrap(tcp.getInputStream().readNBytes(4));
    if (length.remaining() < 4) {
      throw new SocketException("closed");
    }
    byte[] frame = tcp.getInputStream().readNBytes(length.getInt());
    if (keys == null) {
      return frame;
    }
    return Arrays.copyOf(frame, keys.streamIn().open(frame, 0, frame.length));
  }

  /** Sends bytes as they are. */
  void raw(int... bytes) throws IOException {
    udp.write(ByteBuffer.wrap(bytes(bytes)));
  }

  /** Sends a genuine datagram. */
  void datagram(int tag, int... fields) throws IOException {
    udp.write(ByteBuffer.wrap(sealed(tag, bytes(fields))));
  }

  byte[] sealed(int tag, byte[] fields) {
    int length = keys.datagramsOut().seal((byte) tag, fields, 0, fields.length);
    return Arrays.copyOf(keys.datagramsOut().bytes(), length);
  }

  /** Receives a datagram, and returns its tag and fields. */
  byte[] receive() throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate(2_000);
    udp.read(buffer);
    byte[] bytes = buffer.array();
    int fields = keys.datagramsIn().open(bytes, buffer.position());
    assertTrue(fields >= 0, "fields=" + fields);
    byte[] opened =
        Arrays.copyOfRange(
            bytes, DatagramSealer.HEAD_BYTES - 1, DatagramSealer.HEAD_BYTES + fields);
    opened[0] = bytes[0];
    return opened;
  }

  void register(int asId, long withToken) throws IOException {
    register(asId, withToken, 0);
  }

  /** Registers with the solution of the work that the greeting demands. */
  void register(int asId, long withToken, long solution) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(Frame.REGISTRATION_BYTES);
    bytes.put(Frame.REGISTER_UDP).putInt(asId).putLong(withToken).putLong(solution).clear();
    udp.write(bytes);
  }

  /** The handshake up to the keys. */
  void exchangeKeys() throws IOException {
    register(id, token);
    register(id, token); // a client repeats itself until it is answered
    assertEquals(Frame.REGISTER_UDP, readFrame()[0]);
    byte[] key = Arrays.copyOfRange(greeting, greeting.length - 32, greeting.length);
    try {
      KeyExchange.Offer offer = new KeyExchange.Offer(Encryption.ON, key, greeting);
      frame(frameOf(Frame.KEY_OFFER, offer.bytes()));
      byte[] answer = readFrame();
      assertEquals(Frame.KEY_ANSWER, answer[0]);
      keys =
          offer.finish(
              Arrays.copyOfRange(answer, 1, answer.length), id, Frame.SERVER_BUFFER_BYTES * 20);
    } catch (GeneralSecurityException x) {
      throw new AssertionError(x);
    }
  }

  /** The whole handshake, up to an open link at the server. */
  Link join() throws IOException {
    exchangeKeys();
    frame(new byte[] {Frame.KEY_CONFIRM});
    byte[] challenge = receive();
    assertEquals(Frame.CHALLENGE, challenge[0]);
    udp.write(ByteBuffer.wrap(sealed(Frame.ANSWER, Arrays.copyOfRange(challenge, 1, 1 + 8))));
    Link[] link = new Link[1];
    eventually(() -> (link[0] = network.server.accept()) != null, () -> "not accepted");
    return link[0];
  }

  void write(byte[] bytes) throws IOException {
    tcp.getOutputStream().write(bytes);
    tcp.getOutputStream().flush();
  }

  /** Sends a frame, sealed once there are keys. */
  void frame(byte[] content) throws IOException {
    byte[] frame = content;
    if (keys != null) {
      frame = Arrays.copyOf(content, content.length + StreamSeal.EXTRA_BYTES);
      keys.streamOut().seal(frame, 0, content.length);
    }
    write(ByteBuffer.allocate(4 + frame.length).putInt(frame.length).put(frame).array());
  }

  /** Whether the server closes this connection, its last words read away. */
  boolean closedByServer() throws IOException {
    try {
      tcp.getInputStream().transferTo(OutputStream.nullOutputStream());
      return true;
    } catch (SocketTimeoutException x) {
      return false;
    } catch (SocketException x) {
      return true;
    }
  }

  @Override
  public void close() throws IOException {
    tcp.close();
    udp.close();
  }

  /** Returns bytes. */
  static byte[] bytes(int... numbers) {
    byte[] bytes = new byte[numbers.length];
    for (int i = 0; i < numbers.length; i++) {
      bytes[i] = (byte) numbers[i];
    }
    return bytes;
  }

  /** Returns the content of a frame. */
  static byte[] frameOf(byte first, byte[] rest) {
    return ByteBuffer.allocate(1 + rest.length).put(first).put(rest).array();
  }
}
