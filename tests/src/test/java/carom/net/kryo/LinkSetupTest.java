package carom.net.kryo;

import static carom.net.kryo.Network.eventually;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.protocol.ClientMessage;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.MessageDigest;
import java.security.PrivateKey;
import java.security.spec.X509EncodedKeySpec;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import javax.crypto.Cipher;
import javax.crypto.KeyAgreement;
import javax.crypto.Mac;
import javax.crypto.spec.GCMParameterSpec;
import javax.crypto.spec.SecretKeySpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: docs/protocol/LINK.md is all that a client needs to open a link. Method: one that was
 * written from the page, with nothing of Carom's own code, and joins a real server.
 */
@Needs("sockets")
@Timeout(30)
final class LinkSetupTest {
  private static final byte[] HEAD = HexFormat.of().parseHex("302a300506032b656e032100");

  /** One direction's key. */
  private static final class Direction {
    private final byte[] key;
    private final byte[] mask;
    private long counter;

    Direction(byte[] secret, String use) throws GeneralSecurityException {
      byte[] bytes = expand(secret, use, 28);
      key = Arrays.copyOf(bytes, 16);
      mask = Arrays.copyOfRange(bytes, 16, 28);
    }

    private byte[] crypt(int mode, long number, byte[] associated, byte[] bytes)
        throws GeneralSecurityException {
      ByteBuffer nonce = ByteBuffer.wrap(mask.clone());
      nonce.putLong(4, nonce.getLong(4) ^ number);
      Cipher cipher = Cipher.getInstance("AES/GCM/NoPadding");
      cipher.init(mode, new SecretKeySpec(key, "AES"), new GCMParameterSpec(128, nonce.array()));
      cipher.updateAAD(associated);
      return cipher.doFinal(bytes);
    }

    byte[] frame(byte... bytes) throws GeneralSecurityException {
      byte[] sealed = crypt(Cipher.ENCRYPT_MODE, counter++, new byte[0], bytes);
      return ByteBuffer.allocate(4 + sealed.length).putInt(sealed.length).put(sealed).array();
    }

    byte[] datagram(byte tag, int link, byte... fields) throws GeneralSecurityException {
      ByteBuffer head = ByteBuffer.allocate(11).put(tag).putInt(link);
      head.putShort((short) (counter >>> 32)).putInt((int) counter);
      byte[] sealed = crypt(Cipher.ENCRYPT_MODE, counter++, head.array(), fields);
      return ByteBuffer.allocate(11 + sealed.length).put(head.array()).put(sealed).array();
    }

    byte[] open(byte[] datagram, int length) throws GeneralSecurityException {
      ByteBuffer bytes = ByteBuffer.wrap(datagram);
      long number = (bytes.getShort(5) & 0xffffL) << 32 | bytes.getInt(7) & 0xffffffffL;
      byte[] head = Arrays.copyOf(datagram, 11);
      return crypt(Cipher.DECRYPT_MODE, number, head, Arrays.copyOfRange(datagram, 11, length));
    }
  }

  private static byte[] mac(byte[] key, byte[]... parts) throws GeneralSecurityException {
    Mac mac = Mac.getInstance("HmacSHA256");
    mac.init(new SecretKeySpec(key, "HmacSHA256"));
    for (byte[] part : parts) {
      mac.update(part);
    }
    return mac.doFinal();
  }

  private static byte[] expand(byte[] secret, String use, int bytes)
      throws GeneralSecurityException {
    return Arrays.copyOf(
        mac(secret, use.getBytes(StandardCharsets.US_ASCII), new byte[] {1}), bytes);
  }

  private static byte[] agree(PrivateKey own, byte[] other) throws GeneralSecurityException {
    byte[] encoded = ByteBuffer.allocate(44).put(HEAD).put(other).array();
    KeyAgreement agreement = KeyAgreement.getInstance("X25519");
    agreement.init(own);
    agreement.doPhase(
        KeyFactory.getInstance("X25519").generatePublic(new X509EncodedKeySpec(encoded)), true);
    return agreement.generateSecret();
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

      KeyPair fresh = KeyPairGenerator.getInstance("X25519").generateKeyPair();
      byte[] encoded = fresh.getPublic().getEncoded();
      byte[] offer = join(new byte[] {1}, Arrays.copyOfRange(encoded, 12, 44));
      tcp.getOutputStream().write(join(new byte[] {0, 0, 0, 34, 9}, offer));
      byte[] answer = tcp.getInputStream().readNBytes(4 + 1 + 64);
      assertArrayEquals(new byte[] {0, 0, 0, 65, 10}, Arrays.copyOf(answer, 5));
      byte[] theirs = Arrays.copyOfRange(answer, 5, 37);
      MessageDigest hash = MessageDigest.getInstance("SHA-256");
      hash.update("carom link 9".getBytes(StandardCharsets.US_ASCII));
      hash.update(new byte[] {0, 0, 0, 48});
      byte[] transcript = hash.digest(join(greeting, offer, theirs));
      byte[] secret =
          mac(transcript, agree(fresh.getPrivate(), theirs), agree(fresh.getPrivate(), lasting));
      assertArrayEquals(
          expand(secret, "server proof", 32), Arrays.copyOfRange(answer, 37, 69), "the proof");

      Direction stream = new Direction(secret, "client stream");
      Direction up = new Direction(secret, "client datagrams");
      Direction down = new Direction(secret, "server datagrams");
      tcp.getOutputStream().write(stream.frame((byte) 11));
      ByteBuffer challenge = ByteBuffer.allocate(100);
      assertEquals(11 + 8 + 16, udp.read(challenge));
      assertEquals(7, challenge.get(0));
      assertEquals(link, challenge.getInt(1));
      byte[] nonce = down.open(challenge.array(), challenge.position());
      udp.write(ByteBuffer.wrap(up.datagram((byte) 8, link, nonce)));
      Link[] accepted = new Link[1];
      eventually(() -> (accepted[0] = network.server.accept()) != null, () -> "not accepted");

      udp.write(ByteBuffer.wrap(up.datagram((byte) 6, link, new byte[] {42, 43})));
      tcp.getOutputStream().write(stream.frame((byte) 3));
      tcp.getOutputStream().write(stream.frame((byte) 4, (byte) 4));
      Network.Inbox inbox = new Network.Inbox();
      eventually(
          () -> {
            accepted[0].poll(inbox, 10);
            return inbox.messages.size() == 1 && inbox.datagrams.size() == 1;
          },
          accepted[0]::toString);
      assertArrayEquals(new byte[] {42, 43}, inbox.datagrams.get(0));
      tcp.getOutputStream().write(stream.frame((byte) 5));
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
