package carom.fuzz;

import carom.fixtures.Levels;
import carom.fixtures.Stranger;
import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.DatagramMark;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.transport.Link;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Stepper;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;

/**
 * A session's states, driven by what one peer sends: the pieces of an input are messages, datagrams
 * and time that passes. The server counts no error and stays able to play.
 */
final class SessionTarget implements FuzzTarget {
  private static final int MESSAGE = 0;
  private static final int DATAGRAM = 1;
  private static final int TIME = 2;
  private static final int HELLO = 3;
  private static final int READY = 4;
  private static final int LEVEL = 5;
  private static final int KINDS = 6;
  private static final int MOST_PIECES = 64;

  /** Slices of the stepper that pass at once, 10 ms: less than a tick. */
  private static final int SLICES = 5;

  private final KryoMessageCodec codec = new KryoMessageCodec();

  @Override
  public void take(byte[] data) {
    try (Stepper stepper = Stepper.of(Levels.emptyPlatformer(), ServerConfig.defaults())) {
      stepper.expectExpulsions();
      Pieces pieces = new Pieces(data);
      Stranger peer = new Stranger();
      Link link = stepper.transport().connect("localhost", 0, 0);
      int count = 0;
      for (byte[] piece = pieces.next();
          piece != null && count < MOST_PIECES;
          piece = pieces.next(), count++) {
        if (peer.closed()) {
          peer = new Stranger();
          link = stepper.transport().connect("localhost", 0, 0);
        }
        act(stepper, link, peer, pieces.kind() % KINDS, piece);
        stepper.step();
        link.poll(peer, ProtocolLimits.MAX_INPUTS);
      }
      for (int i = 0; i < 10; i++) {
        stepper.step(SLICES);
      }
      if (stepper.count(Counter.JOINS) > count) {
        throw new AssertionError("joins=" + stepper.count(Counter.JOINS) + " of pieces=" + count);
      }
    }
  }

  private void act(Stepper stepper, Link link, Stranger peer, int kind, byte[] piece) {
    int epoch = peer.welcome() == null ? 0 : peer.welcome().epoch();
    switch (kind) {
      case MESSAGE -> {
        if (codec.decode(piece, 0, piece.length) instanceof ClientMessage message) {
          link.send(message);
        }
      }
      case DATAGRAM -> {
        if (piece.length > 0 && piece.length <= ProtocolLimits.MAX_DATAGRAM_BYTES) {
          // Its lowest bit decides between inputs and messages.
          piece[0] =
              (byte) (piece[0] & (-1 << DatagramMark.BITS | 1) | DatagramMark.ofState(epoch));
          link.sendDatagram(piece, 0, piece.length);
        }
      }
      case TIME -> {
        for (int i = piece.length & 0x3f; i > 0; i--) {
          stepper.step(SLICES);
        }
      }
      case HELLO ->
          link.send(new ClientMessage.Hello(Protocol.VERSION, Protocol.physicsDigest(), "fuzz", 0));
      case READY ->
          link.send(new ClientMessage.Ready(epoch, stepper.room().match().declarations().digest()));
      default -> link.send(new ClientMessage.LevelRequest(epoch, piece.length));
    }
  }

  @Override
  public List<byte[]> seeds() {
    List<byte[]> seeds = new ArrayList<>();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Pieces.add(out, HELLO, new byte[0]);
    Pieces.add(out, TIME, new byte[3]);
    Pieces.add(out, LEVEL, new byte[0]);
    Pieces.add(out, TIME, new byte[3]);
    Pieces.add(out, READY, new byte[0]);
    Pieces.add(out, TIME, new byte[9]);
    InputDatagram datagram = new InputDatagram();
    datagram.count = 4;
    datagram.newestTick = 20;
    byte[] bytes = new byte[InputDatagram.MAX_BYTES];
    int length = datagram.encode(bytes, 0);
    Pieces.add(out, DATAGRAM, java.util.Arrays.copyOf(bytes, length));
    Pieces.add(out, TIME, new byte[9]);
    seeds.add(out.toByteArray());
    for (ClientMessage message :
        List.of(
            new ClientMessage.Look(1.5f, -2, 0, 3, ClientMessage.Look.NOBODY),
            new ClientMessage.Watch(Protocol.VERSION, Protocol.physicsDigest(), 1),
            new ClientMessage.RecordingRequest(0),
            new ClientMessage.Leave())) {
      ByteArrayOutputStream more = new ByteArrayOutputStream();
      more.writeBytes(seeds.get(0));
      Pieces.add(more, MESSAGE, codec.encode(message));
      Pieces.add(more, TIME, new byte[9]);
      seeds.add(more.toByteArray());
    }
    return seeds;
  }
}
