package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.protocol.ClientMessage;
import carom.net.transport.Link;
import carom.suite.Needs;
import com.southernstorm.noise.protocol.CipherState;
import com.southernstorm.noise.protocol.CipherStatePair;
import com.southernstorm.noise.protocol.HandshakeState;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: docs/protocol/LINK.md is all that a client needs to open a link. Method: one that was
 * written from the page, with nothing of Carom's own code and another implementation of Noise,
 * joins a real server.
 */
@Needs("sockets")
@Timeout(30)
final class LinkSetupTest {
  /** First nonce of datagrams. */
  private static final long DATAGRAMS = 1L << 48;

  /** One direction's frames. */
  private static final class Direction {
    private final CipherState cipher;
    private long frames;
    private long datagrams;

    Direction(CipherState cipher) {
      this.cipher = cipher;
    }

    byte[] frame(byte... bytes) throws GeneralSecurityException {
      byte[] sealed = new byte[bytes.length + 16];
      cipher.setNonce(frames++);
      cipher.encryptWithAd(null, bytes, 0, sealed, 0, bytes.length);
      return ByteBuffer.allocate(4 + sealed.length).putInt(sealed.length).put(sealed).array();
    }

    byte[] datagram(byte tag, int link, byte... fields) throws GeneralSecurityException {
      ByteBuffer head = ByteBuffer.allocate(11).put(tag).putInt(link);
      head.putShort((short) (datagrams >>> 32)).putInt((int) datagrams);
      byte[] sealed = new byte[fields.length + 16];
      cipher.setNonce(DATAGRAMS + datagrams++);
      cipher.encryptWithAd(head.array(), fields, 0, sealed, 0, fields.length);
      return join(head.array(), sealed);
    }

    byte[] open(byte[] datagram, int length) throws GeneralSecurityException {
      ByteBuffer bytes = ByteBuffer.wrap(datagram);
      long number = (bytes.getShort(5) & 0xffffL) << 32 | bytes.getInt(7) & 0xffffffffL;
      byte[] fields = new byte[length - 11 - 16];
      cipher.setNonce(DATAGRAMS + number);
      cipher.decryptWithAd(Arrays.copyOf(datagram, 11), datagram, 11, fields, 0, length - 11);
      return fields;
    }
  }

  private static byte[] join(byte[]... parts) {
    ByteBuffer all = ByteBuffer.allocate(Arrays.stream(parts).mapToInt(p -> p.length).sum());
    for (byte[] part : parts) {
      all.put(part);
    }
    return all.array();
  }

  @Test
  void aClientWrittenFromTheDocumentGetsIn() throws IOException, GeneralSecurityException {
    try (Network network = new Network();
        Socket tcp = new Socket(Network.HOST, network.server.tcpPort());
        DatagramChannel udp = DatagramChannel.open()) {
      udp.connect(new InetSocketAddress(Network.HOST, network.server.udpPort()));
      byte[] first = tcp.getInputStream().readNBytes(4 + 1 + 48);
      assertArrayEquals(new byte[] {0, 0, 0, 49, 1}, Arrays.copyOf(first, 5));
      byte[] greeting = Arrays.copyOfRange(first, 5, 53);
      int link = ByteBuffer.wrap(greeting).getInt();
      assertEquals(network.server.udpPort(), ByteBuffer.wrap(greeting).getShort(12) & 0xffff);
      assertEquals(1, greeting[14], "encryption");
      assertEquals(0, greeting[15], "bits of work");
      byte[] lasting = Arrays.copyOfRange(greeting, 16, 48);
      udp.write(ByteBuffer.allocate(35).put((byte) 2).put(greeting, 0, 12).putLong(0).clear());
      assertArrayEquals(new byte[] {0, 0, 0, 1, 2}, tcp.getInputStream().readNBytes(5));

      HandshakeState handshake =
          new HandshakeState("Noise_NK_25519_AESGCM_SHA256", HandshakeState.INITIATOR);
      byte[] prologue =
          join("carom link 10".getBytes(StandardCharsets.US_ASCII), new byte[] {1}, greeting);
      handshake.setPrologue(prologue, 0, prologue.length);
      handshake.getRemotePublicKey().setPublicKey(lasting, 0);
      handshake.start();
      byte[] offer = new byte[48];
      assertEquals(48, handshake.writeMessage(offer, 0, null, 0, 0));
      tcp.getOutputStream().write(join(new byte[] {0, 0, 0, 50, 9, 1}, offer));
      byte[] answer = tcp.getInputStream().readNBytes(4 + 1 + 48);
      assertArrayEquals(new byte[] {0, 0, 0, 49, 10}, Arrays.copyOf(answer, 5));
      assertEquals(0, handshake.readMessage(answer, 5, 48, new byte[0], 0), "bytes of payload");

      CipherStatePair keys = handshake.split();
      Direction up = new Direction(keys.getSender());
      Direction down = new Direction(keys.getReceiver());
      tcp.getOutputStream().write(up.frame((byte) 11));
      ByteBuffer challenge = ByteBuffer.allocate(100);
      assertEquals(11 + 8 + 16, udp.read(challenge));
      assertEquals(7, challenge.get(0));
      assertEquals(link, challenge.getInt(1));
      byte[] nonce = down.open(challenge.array(), challenge.position());
      udp.write(ByteBuffer.wrap(up.datagram((byte) 8, link, nonce)));
      Link[] accepted = new Link[1];
      eventually(() -> (accepted[0] = network.server.accept()) != null, () -> "not accepted");

      udp.write(ByteBuffer.wrap(up.datagram((byte) 6, link, new byte[] {42, 43})));
      tcp.getOutputStream().write(up.frame((byte) 3));
      tcp.getOutputStream().write(up.frame((byte) 4, (byte) 4));
      Network.Inbox inbox = new Network.Inbox();
      eventually(
          () -> {
            accepted[0].poll(inbox, 10);
            return inbox.messages.size() == 1 && inbox.datagrams.size() == 1;
          },
          accepted[0]::toString);
      assertArrayEquals(new byte[] {42, 43}, inbox.datagrams.get(0));
      tcp.getOutputStream().write(up.frame((byte) 5));
      eventually(
          () -> {
            accepted[0].poll(inbox, 10);
            return inbox.closed == 1;
          },
          accepted[0]::toString);
      assertEquals(List.of(new ClientMessage.Leave()), inbox.messages);
      assertEquals("the client left", inbox.reason);
    }
  }
}
