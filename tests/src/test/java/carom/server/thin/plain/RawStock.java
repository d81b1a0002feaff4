package carom.server.thin.plain;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** A peer of the door that writes its bytes by hand, right or wrong. */
final class RawStock implements AutoCloseable {
  static final byte[] KEEP_ALIVE = {PlainIds.KEEP_ALIVE};
  static final byte[] LIST_ROOMS = {PlainIds.LIST_ROOMS};
  static final byte[] LEAVE = {PlainIds.LEAVE};

  final Socket tcp;
  final DatagramSocket udp;
  final int id;
  private final PlainDoor door;
  private final DataInputStream in;

  /** Connects and takes its number. */
  RawStock(PlainDoor door) throws IOException {
    this.door = door;
    tcp = new Socket();
    tcp.setReceiveBufferSize(16 * 1_024);
    tcp.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), door.tcpPort()));
    tcp.setSoTimeout(30_000);
    in = new DataInputStream(tcp.getInputStream());
    udp = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    udp.setSoTimeout(300);
    byte[] first = frame();
    KryoInput input = new KryoInput();
    input.begin(first, 1, first.length);
    id = input.whole();
    if (first[0] != PlainIds.REGISTER_TCP || input.problem() != null) {
      throw new AssertionError(Arrays.toString(first));
    }
  }

  /** Connects and joins, with UDP if that is wanted. */
  static RawStock joined(PlainDoor door, String name, boolean withUdp) throws IOException {
    RawStock stock = new RawStock(door);
    if (withUdp) {
      stock.registerUdp();
    }
    stock.send(join(name));
    stock.await(PlainIds.WELCOME);
    return stock;
  }

  void registerUdp() throws IOException {
    datagram(registration(id));
    await(PlainIds.REGISTER_UDP);
  }

  static byte[] registration(int id) {
    KryoOutput out = new KryoOutput();
    out.count(PlainIds.REGISTER_UDP);
    out.whole(id);
    return Arrays.copyOf(out.bytes(), out.length());
  }

  static byte[] join(String name) {
    return join(name, "");
  }

  static byte[] join(String name, String token) {
    KryoOutput out = new KryoOutput();
    out.count(PlainIds.JOIN);
    for (String text : new String[] {"", "", name, "", "", ""}) {
      out.text(text);
    }
    out.whole(0L);
    out.text(token);
    out.whole(1);
    return Arrays.copyOf(out.bytes(), out.length());
  }

  static byte[] input(int count, int seen) {
    KryoOutput out = new KryoOutput();
    out.count(PlainIds.INPUT);
    out.whole(count);
    out.count(2);
    out.flag(true);
    out.real(0);
    out.whole(0);
    out.real(1);
    out.real(0);
    out.whole(seen);
    return Arrays.copyOf(out.bytes(), out.length());
  }

  static byte[] chat(String text) {
    KryoOutput out = new KryoOutput();
    out.count(PlainIds.CHAT);
    out.whole(-1);
    out.flag(false);
    out.text(text);
    return Arrays.copyOf(out.bytes(), out.length());
  }

  /** Sends a message with its length. */
  void send(byte[] message) throws IOException {
    raw(ByteBuffer.allocate(4 + message.length).putInt(message.length).put(message).array());
  }

  /** Sends bytes as they are. */
  synchronized void raw(byte[] bytes) throws IOException {
    OutputStream out = tcp.getOutputStream();
    out.write(bytes);
    out.flush();
  }

  void datagram(byte[] bytes) throws IOException {
    datagram(udp, bytes);
  }

  void datagram(DatagramSocket from, byte[] bytes) throws IOException {
    from.send(
        new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), door.udpPort()));
  }

  /** Returns the next datagram, or null if none comes soon. */
  static byte[] receive(DatagramSocket at) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[2_048], 2_048);
    try {
      at.receive(packet);
      return Arrays.copyOf(packet.getData(), packet.getLength());
    } catch (SocketTimeoutException e) {
      return null;
    }
  }

  /** Returns the count of the input that a snapshot says was used last. */
  static int inputOf(byte[] snapshot) {
    KryoInput in = new KryoInput();
    in.begin(snapshot, 1, snapshot.length);
    for (int bodies = in.count() - 1; bodies > 0; bodies--) {
      in.flag();
      in.real();
      in.whole();
      in.whole();
      in.whole();
      in.real();
      in.real();
    }
    for (int gone = in.count() - 1; gone > 0; gone--) {
      in.whole();
    }
    int input = in.whole();
    return in.problem() == null ? input : -2;
  }

  /** Returns the next message. */
  byte[] frame() throws IOException {
    byte[] message = new byte[in.readInt()];
    in.readFully(message);
    return message;
  }

  /** Reads on to a message of a class. */
  byte[] await(int classId) throws IOException {
    byte[] message = frame();
    while (message[0] != classId) {
      message = frame();
    }
    return message;
  }

  /** Reads on to the end, and returns all that the server said last, as text. */
  String lastWords() throws IOException {
    byte[] last = {};
    try {
      while (true) {
        last = frame();
      }
    } catch (EOFException | SocketException e) {
      return new String(last, StandardCharsets.ISO_8859_1);
    }
  }

  @Override
  public void close() throws IOException {
    tcp.close();
    udp.close();
  }
}
