package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.Frame;
import carom.net.kryo.server.KryoLimits;
import carom.suite.Needs;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: no address that hasn't proven itself gets more bytes than came from it. Method: raw peers
 * that never answer a challenge count what they send and get, on each way to a datagram.
 */
@Needs("sockets")
@Timeout(60)
final class AmplificationTest {
  /** Long enough for what a server sends unasked, such as repeated challenges. */
  private static final long QUIET_MS = 700;

  private static int received(DatagramChannel udp) throws Exception {
    int bytes = 0;
    udp.configureBlocking(false);
    ByteBuffer in = ByteBuffer.allocate(2_000);
    for (long end = System.nanoTime() + QUIET_MS * 1_000_000; System.nanoTime() - end < 0; ) {
      if (udp.read(in.clear()) > 0) {
        bytes += in.position();
      } else {
        Thread.sleep(5);
      }
    }
    return bytes;
  }

  private static DatagramChannel another(Network network) throws IOException {
    DatagramChannel udp = DatagramChannel.open();
    udp.connect(new InetSocketAddress(Network.HOST, network.server.udpPort()));
    return udp;
  }

  @Test
  void aRegistrationWithAnothersAddressGetsNoMoreThanItIsLong() throws Exception {
    try (Network network = new Network(KryoLimits.DEFAULT);
        RawPeer peer = new RawPeer(network)) {
      peer.exchangeKeys(); // registers twice
      peer.frame(new byte[] {Frame.KEY_CONFIRM});
      int in = received(peer.udp);
      assertEquals(Frame.CHALLENGE_BYTES, in, "one challenge, and none unasked");
      int repeats = 1 + new Random().nextInt(9);
      for (int i = 0; i < repeats; i++) {
        peer.register(peer.id, peer.token);
      }
      int more = received(peer.udp);
      assertTrue(more > 0, "a lost challenge is asked for again");
      assertTrue(more <= repeats * Frame.REGISTRATION_BYTES, more + " for " + repeats);
      assertEquals(null, network.server.accept());
    }
  }

  @Test
  void aShortRegistrationIsNone() throws Exception {
    try (Network network = new Network(KryoLimits.DEFAULT);
        RawPeer peer = new RawPeer(network)) {
      ByteBuffer bytes = ByteBuffer.allocate(21);
      bytes.put(Frame.REGISTER_UDP).putInt(peer.id).putLong(peer.token).putLong(0).flip();
      peer.udp.write(bytes);
      eventually(() -> network.server.counters().strangeDatagrams.get() == 1, () -> "not counted");
      assertEquals(0, received(peer.udp));
    }
  }

  /** The kind: any genuine datagram from any new address, of any length and tag. */
  @Test
  void aMoveToAnothersAddressGetsNoMoreThanCameFromThere() throws Exception {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    try (Network network = new Network(KryoLimits.DEFAULT);
        RawPeer peer = new RawPeer(network)) {
      peer.join();
      for (int round = 0; round < 5; round++) {
        try (DatagramChannel elsewhere = another(network)) {
          int out = 0;
          for (int i = 1 + random.nextInt(6); i > 0; i--) {
            byte tag = random.nextBoolean() ? Frame.KEEP_ALIVE : Frame.DATAGRAM;
            byte[] sealed = peer.sealed(tag, new byte[round == 0 ? 0 : random.nextInt(24)]);
            out += elsewhere.write(ByteBuffer.wrap(sealed));
          }
          int in = received(elsewhere);
          assertTrue(in <= out, in + " bytes for " + out + ", seed=" + seed);
          assertTrue(round > 0 || in == 0, "27 bytes get no 35");
        }
      }
    }
  }

  @Test
  void aKeepAliveOfAClientThatMovedIsLongEnough() throws Exception {
    try (Network network = new Network(KryoLimits.DEFAULT);
        RawPeer peer = new RawPeer(network);
        DatagramChannel elsewhere = another(network)) {
      peer.join();
      byte[] sealed = peer.sealed(Frame.KEEP_ALIVE, new byte[Frame.NONCE_BYTES]);
      assertEquals(Frame.CHALLENGE_BYTES, elsewhere.write(ByteBuffer.wrap(sealed)));
      assertEquals(Frame.CHALLENGE_BYTES, received(elsewhere));
    }
  }

  @Test
  void strangersGetNothing() throws Exception {
    Random random = new Random();
    try (Network network = new Network(KryoLimits.DEFAULT);
        RawPeer peer = new RawPeer(network);
        DatagramChannel stranger = another(network)) {
      peer.join();
      for (int i = 0; i < 200; i++) {
        byte[] bytes = new byte[random.nextInt(1_200)];
        random.nextBytes(bytes);
        if (bytes.length > 5 && random.nextBoolean()) {
          ByteBuffer.wrap(bytes).put((byte) random.nextInt(14)).putInt(peer.id);
        }
        stranger.write(ByteBuffer.wrap(bytes));
      }
      assertEquals(0, received(stranger));
    }
  }
}
