package carom.fuzz;

import carom.net.protocol.InputDatagram;
import carom.net.protocol.ProtocolLimits;
import java.util.Arrays;
import java.util.List;

/** Input datagrams. What is read lies within its limits, and reads as the same when written. */
final class InputTarget implements FuzzTarget {
  private final InputDatagram read = new InputDatagram();
  private final InputDatagram again = new InputDatagram();

  @Override
  public void take(byte[] data) {
    if (!read.decode(data, 0, data.length)) {
      return;
    }
    if (read.count < 0
        || read.count > ProtocolLimits.MAX_INPUTS
        || read.viewDelay < 0
        || read.viewDelay > InputDatagram.MAX_VIEW_DELAY
        || read.holdTicks < 0
        || read.holdTicks > InputDatagram.MAX_HOLD_TICKS) {
      throw new AssertionError("a datagram beyond its limits was read");
    }
    byte[] written = written(read);
    if (!again.decode(written, 0, written.length) || !Arrays.equals(written, written(again))) {
      throw new AssertionError("a datagram changed when it was written and read");
    }
  }

  private static byte[] written(InputDatagram datagram) {
    byte[] bytes = new byte[InputDatagram.MAX_BYTES];
    return Arrays.copyOf(bytes, datagram.encode(bytes, 0));
  }

  @Override
  public List<byte[]> seeds() {
    InputDatagram datagram = new InputDatagram();
    byte[] empty = written(datagram);
    datagram.hasAck = true;
    datagram.ackBits = 0x5555;
    datagram.newestTick = 100;
    datagram.disagrees = true;
    datagram.disagreedTick = 90;
    datagram.count = ProtocolLimits.MAX_INPUTS;
    for (int i = 0; i < datagram.count; i++) {
      datagram.inputs[i] = i * 0x1234567L & (1L << 48) - 1;
    }
    return List.of(empty, written(datagram));
  }
}
