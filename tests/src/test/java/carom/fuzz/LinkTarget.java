package carom.fuzz;

import carom.net.frame.ClientEnd;
import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.seal.DatagramSealer;
import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.KeyExchange;
import carom.net.seal.LinkKeys;
import carom.net.seal.StreamSeal;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.io.ByteArrayOutputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.List;

/**
 * The frames of a link's set-up and after it. The pieces of an input are what a hostile server
 * sends to a client, raw or sealed with the right keys, and what a hostile client offers to a
 * server. A link opens only after a right exchange of keys, takes nothing that isn't genuine, and
 * says why it closed.
 */
final class LinkTarget implements FuzzTarget {
  private static final int FRAME = 0;
  private static final int DATAGRAM = 1;
  private static final int OFFER = 2;
  private static final int GREETING = 3;
  private static final int REGISTERED = 4;
  private static final int KEY_ANSWER = 5;
  private static final int SEALED_FRAME = 6;
  private static final int SEALED_DATAGRAM = 7;
  private static final int KINDS = 8;
  private static final int MOST_PIECES = 32;
  private static final int LINK = 5;

  private final ExchangeKey key = ExchangeKey.random();
  private final byte[] greeting =
      Frame.greeting(LINK, 99, 54_777, Encryption.ON, 0, key.publicKey());

  /** A client's end without sockets. */
  private static final class Client extends ClientEnd {
    private byte[] offer;

    Client() {
      super(new KryoMessageCodec(), Trust.firstUse(), "localhost", 54_555, 0, 1_000);
    }

    void frame(byte[] bytes) {
      byte[] copy = bytes.clone(); // it is opened in place
      try {
        if (readFrame(ByteBuffer.wrap(copy)) == Frame.REGISTER_UDP) {
          udpRegistered();
        }
      } catch (BufferUnderflowException e) {
        lose("the server sent an invalid frame"); // as ClientLink does
      }
    }

    void datagram(byte[] bytes) {
      readDatagram(ByteBuffer.wrap(bytes));
    }

    @Override
    protected boolean transmit(Frame.Payload frame) {
      if (frame.tag() == Frame.KEY_OFFER) {
        ByteBuffer bytes = ByteBuffer.allocate(1 + KeyExchange.OFFER_BYTES);
        frame.write(bytes);
        offer = Arrays.copyOfRange(bytes.array(), 1, bytes.capacity());
      }
      return true;
    }

    @Override
    protected boolean isWritable() {
      return true;
    }

    @Override
    protected boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length) {
      return true;
    }

    @Override
    protected void disconnect(State before, String reason) {
      lose(reason);
    }
  }

  /** Counts what comes out of a link. */
  private static final class Inbox implements LinkHandler {
    private int arrived;

    @Override
    public void message(Link link, Object message) {
      arrived++;
      if (!(message instanceof ServerMessage)) {
        throw new AssertionError("a client got " + message);
      }
    }

    @Override
    public void datagram(Link link, byte[] bytes, int length) {
      arrived++;
      if (length < 1 || length > ProtocolLimits.MAX_DATAGRAM_BYTES) {
        throw new AssertionError("a datagram of bytes=" + length);
      }
    }

    @Override
    public void closed(Link link, String reason) {
      if (reason.isEmpty()) {
        throw new AssertionError("a link closed without a reason");
      }
      FuzzTarget.requirePrintable(reason);
    }
  }

  @Override
  public void take(byte[] data) throws GeneralSecurityException {
    Client client = new Client();
    Inbox inbox = new Inbox();
    LinkKeys keys = null;
    int genuine = 0;
    Pieces pieces = new Pieces(data);
    byte[] piece = pieces.next();
    for (int count = 0; piece != null && count < MOST_PIECES; piece = pieces.next(), count++) {
      switch (pieces.kind() % KINDS) {
        case FRAME -> client.frame(piece);
        case DATAGRAM -> client.datagram(piece);
        case OFFER -> answer(piece);
        case GREETING -> client.frame(tagged(Frame.REGISTER_TCP, greeting));
        case REGISTERED -> client.frame(new byte[] {Frame.REGISTER_UDP});
        case KEY_ANSWER -> {
          if (client.offer != null && keys == null) {
            KeyExchange.Answer answer = answer(client.offer);
            client.frame(tagged(Frame.KEY_ANSWER, answer.bytes()));
            keys = answer.keys();
          }
        }
        default -> {
          if (keys != null && piece.length > 0) {
            genuine++;
            if (pieces.kind() % KINDS == SEALED_FRAME) {
              client.frame(sealed(keys.streamOut(), piece));
            } else {
              client.datagram(sealed(keys.datagramsOut(), piece));
            }
          }
        }
      }
      client.poll(inbox, ProtocolLimits.MAX_INPUTS);
      if (client.state() == Link.State.OPEN && genuine == 0) {
        throw new AssertionError("a link opened without a right exchange of keys");
      }
    }
    client.poll(inbox, ProtocolLimits.MAX_INPUTS);
    if (inbox.arrived > data.length) {
      throw new AssertionError("arrived=" + inbox.arrived + " of bytes=" + data.length);
    }
  }

  private KeyExchange.Answer answer(byte[] offer) throws GeneralSecurityException {
    byte[] whole = Arrays.copyOf(offer, KeyExchange.OFFER_BYTES); // a server takes no other length
    try {
      return KeyExchange.answer(Encryption.ON, key, greeting, whole, LINK, Frame.MAX_PAYLOAD_BYTES);
    } catch (GeneralSecurityException e) {
      return null; // it is no key
    }
  }

  private static byte[] tagged(byte tag, byte[] fields) {
    return ByteBuffer.allocate(1 + fields.length).put(tag).put(fields).array();
  }

  private static byte[] sealed(StreamSeal seal, byte[] frame) {
    byte[] bytes = Arrays.copyOf(frame, frame.length + StreamSeal.EXTRA_BYTES);
    seal.seal(bytes, 0, frame.length);
    return bytes;
  }

  private static byte[] sealed(DatagramSealer sealer, byte[] datagram) {
    int fields = Math.min(datagram.length - 1, Frame.MAX_PAYLOAD_BYTES);
    int length = sealer.seal(datagram[0], datagram, 1, fields);
    return Arrays.copyOf(sealer.bytes(), length);
  }

  @Override
  public List<byte[]> seeds() {
    KryoMessageCodec codec = new KryoMessageCodec();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Pieces.add(out, GREETING, Frame.NO_FIELDS);
    Pieces.add(out, REGISTERED, Frame.NO_FIELDS);
    Pieces.add(out, KEY_ANSWER, Frame.NO_FIELDS);
    Pieces.add(out, SEALED_DATAGRAM, tagged(Frame.CHALLENGE, Frame.nonce(7)));
    byte[] opening = out.toByteArray();
    Pieces.add(out, SEALED_DATAGRAM, tagged(Frame.DATAGRAM, new byte[] {1, 2, 3}));
    byte[] notice = codec.encode(new ServerMessage.Notice("the arena closes"));
    Pieces.add(out, SEALED_FRAME, tagged(Frame.MESSAGE, notice));
    Pieces.add(out, SEALED_FRAME, tagged(Frame.BYE, new byte[] {'e', 'n', 'd'}));
    ByteArrayOutputStream forged = new ByteArrayOutputStream();
    forged.writeBytes(opening);
    Pieces.add(forged, DATAGRAM, new byte[40]);
    Pieces.add(forged, FRAME, new byte[40]);
    ByteArrayOutputStream raw = new ByteArrayOutputStream();
    Pieces.add(raw, OFFER, new byte[KeyExchange.OFFER_BYTES]);
    Pieces.add(raw, FRAME, tagged(Frame.REGISTER_TCP, greeting));
    Pieces.add(raw, FRAME, new byte[] {Frame.KEEP_ALIVE});
    Pieces.add(raw, FRAME, new byte[] {Frame.REGISTER_UDP});
    Pieces.add(raw, FRAME, tagged(Frame.KEY_ANSWER, new byte[KeyExchange.ANSWER_BYTES]));
    ByteArrayOutputStream early = new ByteArrayOutputStream();
    Pieces.add(early, REGISTERED, Frame.NO_FIELDS); // before the greeting
    return List.of(out.toByteArray(), forged.toByteArray(), raw.toByteArray(), early.toByteArray());
  }
}
