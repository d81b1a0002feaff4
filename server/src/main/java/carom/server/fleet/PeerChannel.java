package carom.server.fleet;

import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.KeyExchange;
import carom.net.seal.LinkKeys;
import carom.net.seal.StreamSeal;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.util.Arrays;

/**
 * A sealed TCP connection between two servers of a fleet. Each proves to the other that it has the
 * fleet's key, by the exchange of keys that links of clients begin with, once in each direction:
 *
 * <pre>
 * opener                                     acceptor
 *    |  &lt;-- greeting: 1, random ------------ |
 *    |  -- offer -------------------------&gt;  |
 *    |  &lt;------------------ answer: proof -- |   the acceptor has the key; from here on sealed
 *    |  == greeting: 2, random ===========&gt;  |
 *    |  &lt;============================ offer = |
 *    |  == answer: proof =================&gt;  |   the opener has the key
 * </pre>
 *
 * <p>The first byte of a greeting keeps the two directions apart, so that no answer of one serves
 * the other. The opener answers within a channel whose other end has proven the key already, so
 * nobody in between can have an offer answered that isn't its own.
 *
 * <p>One thread reads; any thread writes.
 */
final class PeerChannel implements AutoCloseable {
  /** Most bytes of a frame. */
  static final int MAX_FRAME = 1 << 22;

  private static final int TIMEOUT_MS = 2_000;
  private static final int GREETING_BYTES = 33;
  private static final byte ACCEPTS = 1;
  private static final byte OPENS = 2;

  private final Socket socket;
  private final DataInputStream in;
  private final OutputStream out;
  private StreamSeal seal; // guarded by out
  private StreamSeal open;
  private byte[] frame = new byte[1 << 12];

  private PeerChannel(Socket socket) throws IOException {
    this.socket = socket;
    socket.setTcpNoDelay(true);
    socket.setKeepAlive(true); // so that a machine that is gone leaves no thread behind
    socket.setSoTimeout(TIMEOUT_MS);
    in = new DataInputStream(new BufferedInputStream(socket.getInputStream(), 1 << 16));
    out = socket.getOutputStream();
  }

  /**
   * Opens a channel.
   *
   * @throws IOException if nobody answers there, or somebody without the key
   */
  static PeerChannel open(String host, int port, ExchangeKey key) throws IOException {
    Socket socket = new Socket();
    try {
      socket.connect(new InetSocketAddress(host, port), TIMEOUT_MS);
      PeerChannel channel = new PeerChannel(socket);
      channel.sealedBy(channel.prove(key, false));
      channel.answer(key, OPENS);
      channel.begin();
      return channel;
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw e;
    }
  }

  /**
   * Accepts a channel on a socket.
   *
   * @throws IOException if the other end hasn't the key, or is slow
   */
  static PeerChannel accept(Socket socket, ExchangeKey key) throws IOException {
    try {
      PeerChannel channel = new PeerChannel(socket);
      channel.answer(key, ACCEPTS);
      channel.prove(key, true);
      channel.begin();
      return channel;
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw e;
    }
  }

  private void begin() throws IOException {
    socket.setSoTimeout(0);
  }

  /** Sets how long {@link #read} waits before it throws, ms; otherwise it waits for ever. */
  void waitAtMost(int ms) throws IOException {
    socket.setSoTimeout(ms);
  }

  /** Demands a proof of the other end, and returns the keys that the exchange leads to. */
  private LinkKeys prove(ExchangeKey key, boolean ofOpener) throws IOException {
    byte[] greeting = read();
    if (greeting.length != GREETING_BYTES || greeting[0] != (ofOpener ? OPENS : ACCEPTS)) {
      throw new IOException("the other end is no server of a fleet");
    }
    try {
      KeyExchange.Offer offer = new KeyExchange.Offer(Encryption.ON, key.publicKey(), greeting);
      write(offer.bytes());
      byte[] answer = read();
      if (answer.length != KeyExchange.ANSWER_BYTES) {
        throw new IOException("the other end is no server of a fleet");
      }
      return offer.finish(answer, 1, 1);
    } catch (GeneralSecurityException | EOFException e) { // it couldn't open the offer
      throw new IOException("the other end hasn't the fleet's key", e);
    }
  }

  private void sealedBy(LinkKeys keys) {
    seal = keys.streamOut();
    open = keys.streamIn();
  }

  /** Proves to the other end that this one has the key; the acceptor's proof begins the seal. */
  private void answer(ExchangeKey key, byte role) throws IOException {
    byte[] greeting = new byte[GREETING_BYTES];
    new SecureRandom().nextBytes(greeting);
    greeting[0] = role;
    write(greeting);
    byte[] offer = read();
    if (offer.length != KeyExchange.OFFER_BYTES) {
      throw new IOException("the other end is no server of a fleet");
    }
    try {
      KeyExchange.Answer answer = KeyExchange.answer(Encryption.ON, key, greeting, offer, 1, 1);
      write(answer.bytes());
      if (role == ACCEPTS) {
        sealedBy(answer.keys());
      }
    } catch (GeneralSecurityException e) {
      throw new IOException("the other end hasn't the fleet's key", e);
    }
  }

  /** Sends a frame of at most {@value #MAX_FRAME} bytes. Any thread. */
  void write(byte[] bytes) throws IOException {
    synchronized (out) {
      int sealed = bytes.length + (seal == null ? 0 : StreamSeal.EXTRA_BYTES);
      byte[] buffer =
          ByteBuffer.allocate(Integer.BYTES + bytes.length + StreamSeal.EXTRA_BYTES)
              .putInt(sealed)
              .put(bytes)
              .array();
      if (seal != null) {
        seal.seal(buffer, Integer.BYTES, bytes.length);
      }
      out.write(buffer, 0, Integer.BYTES + sealed);
    }
  }

  /**
   * Waits for the next frame.
   *
   * @throws EOFException when the other end has closed the channel
   * @throws IOException if it isn't genuine
   */
  byte[] read() throws IOException {
    int length = in.readInt();
    if (length < 1 || length > MAX_FRAME + StreamSeal.EXTRA_BYTES) {
      throw new IOException("length=" + length + " of a frame is outside 1.." + MAX_FRAME);
    }
    if (frame.length < length) {
      frame = new byte[length];
    }
    in.readFully(frame, 0, length);
    int opened = open == null ? length : open.open(frame, 0, length);
    if (opened < 0) {
      throw new IOException("a frame isn't genuine");
    }
    return Arrays.copyOf(frame, opened);
  }

  /** Closes the socket. Any thread. */
  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      return; // it is closed then, too
    }
  }
}
