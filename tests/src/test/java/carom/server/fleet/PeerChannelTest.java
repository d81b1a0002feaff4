package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.KeyExchange;
import carom.suite.Needs;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Goal: servers of a fleet talk to nobody else. Method: sockets, with wrong keys and garbage. */
@Needs("sockets")
class PeerChannelTest {
  private final ExchangeKey key = ExchangeKey.random();
  private ServerSocket port;

  @BeforeEach
  void open() throws IOException {
    port = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
  }

  @AfterEach
  void close() throws IOException {
    port.close();
  }

  private CompletableFuture<PeerChannel> accepted(ExchangeKey withKey) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return PeerChannel.accept(port.accept(), withKey);
          } catch (IOException e) {
            throw new IllegalStateException(e.getMessage(), e);
          }
        });
  }

  private PeerChannel opened(ExchangeKey withKey) throws IOException {
    return PeerChannel.open("127.0.0.1", port.getLocalPort(), withKey);
  }

  private static String failure(CompletableFuture<?> future) {
    ExecutionException e =
        assertThrows(ExecutionException.class, () -> future.get(10, TimeUnit.SECONDS));
    return e.getCause().getMessage();
  }

  @Test
  void framesOfAnySizeArriveInBothDirections() throws Exception {
    CompletableFuture<PeerChannel> there = accepted(key);
    try (PeerChannel here = opened(key);
        PeerChannel other = there.get(10, TimeUnit.SECONDS)) {
      Random random = new Random(1);
      for (int length : new int[] {1, 2, 4_000, 70_000, PeerChannel.MAX_FRAME}) {
        byte[] bytes = new byte[length];
        random.nextBytes(bytes);
        CompletableFuture<Void> sent =
            CompletableFuture.runAsync(
                () -> {
                  try {
                    here.write(bytes);
                  } catch (IOException e) {
                    throw new IllegalStateException(e);
                  }
                });
        assertArrayEquals(bytes, other.read());
        sent.get(10, TimeUnit.SECONDS);
      }
      other.write(new byte[] {7});
      assertArrayEquals(new byte[] {7}, here.read());
    }
  }

  @Test
  void aServerWithAnotherKeyIsRefusedByBothSides() throws Exception {
    CompletableFuture<PeerChannel> there = accepted(ExchangeKey.random());
    IOException e = assertThrows(IOException.class, () -> opened(key));
    assertEquals("the other end hasn't the fleet's key", e.getMessage());
    failure(there);
  }

  /** One that knows the public key, which all players know, but not the private one. */
  @Test
  void whoKnowsOnlyThePublicKeyGetsNoFurtherThanTheProof() throws Exception {
    CompletableFuture<PeerChannel> there = accepted(key);
    try (Socket socket = new Socket("127.0.0.1", port.getLocalPort())) {
      DataInputStream in = new DataInputStream(socket.getInputStream());
      DataOutputStream out = new DataOutputStream(socket.getOutputStream());
      byte[] greeting = in.readNBytes(in.readInt());
      byte[] offer = new KeyExchange.Offer(Encryption.ON, key.publicKey(), greeting).bytes();
      out.writeInt(offer.length);
      out.write(offer);
      in.readFully(new byte[in.readInt()]); // its proof
      out.writeInt(40); // a greeting that isn't sealed
      out.write(new byte[40]);
      assertEquals("a frame isn't genuine", failure(there));
    }
  }

  @Test
  void garbageEndsTheChannelAndNothingElse() throws Exception {
    Random random = new Random(5);
    for (int i = 0; i < 50; i++) {
      CompletableFuture<PeerChannel> there = accepted(key);
      try (Socket socket = new Socket("127.0.0.1", port.getLocalPort())) {
        byte[] bytes = new byte[1 + random.nextInt(300)];
        random.nextBytes(bytes);
        if (i % 2 == 0) { // a length that makes sense
          byte[] head = {0, 0, 0, (byte) Math.min(100, bytes.length)};
          System.arraycopy(head, 0, bytes, 0, Math.min(4, bytes.length));
        }
        socket.getOutputStream().write(bytes);
        socket.shutdownOutput();
        failure(there);
      }
    }
  }

  @Test
  void framesOfGarbageAreNone() {
    Random random = new Random(9);
    int refused = 0;
    for (int i = 0; i < 2_000; i++) {
      byte[] bytes = new byte[random.nextInt(60)];
      random.nextBytes(bytes);
      try {
        PeerFrame.parse(bytes);
      } catch (IOException expected) { // anything else fails the test
        refused++;
      }
    }
    assertTrue(refused > 1_500, "refused=" + refused);
  }

  @Test
  void aFrameSurvivesTheRoundTrip() throws IOException {
    byte[] bytes = "ä".getBytes(StandardCharsets.UTF_8);
    PeerFrame frame = new PeerFrame(PeerFrame.Kind.STEP, Long.MIN_VALUE, "cup", 3, 99, bytes);
    PeerFrame read = PeerFrame.parse(frame.toBytes());
    assertEquals(frame.kind(), read.kind());
    assertEquals(frame.number(), read.number());
    assertEquals(frame.room(), read.room());
    assertEquals(frame.step(), read.step());
    assertEquals(frame.slot(), read.slot());
    assertArrayEquals(frame.bytes(), read.bytes());
  }
}
