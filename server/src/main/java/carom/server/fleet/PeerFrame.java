package carom.server.fleet;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * A frame of a {@link PeerChannel}, in which one server of a fleet tells another something: a kind,
 * and its fields.
 *
 * @param kind what it says
 * @param number a lease, a claim, or the number of a question; 0 where the kind needs none
 * @param room name of a room, or empty
 * @param step what is done to a slot, see {@link carom.server.checkpoint.SlotLink.Step}
 * @param slot number of a slot
 * @param bytes the rest
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record PeerFrame(Kind kind, long number, String room, int step, int slot, byte[] bytes) {
  private static final byte[] NOTHING = {};

  /** The kinds of frames. */
  public enum Kind {
    /** Says who the sender is: number is its lease. The first frame of each side. */
    HELLO,
    /** Asks to follow a room: number is its claim, the bytes are its record. */
    FOLLOW,
    /** Brings a part of a room's journal. */
    STEP,
    /** Asks for {@link #DONE} when all before it is done. */
    AWAIT,
    /** Answers {@link #AWAIT} with the same number. */
    DONE,
    /** Says that a room isn't followed by the receiver any longer. */
    END,
    /** Tells a room's owner that the client of a session stands by: number is its secret. */
    STANDS_BY,
    /** Says that the sender gives up a room for the receiver, who has its whole journal. */
    HAND_OVER,
    /** A line of an operator, who has the key and no lease; {@link #ANSWER} follows. */
    COMMAND,
    /** Asks for the save named as the room, if it is newer than number; {@link #ANSWER} follows. */
    SAVED,
    /**
     * Answers {@link #COMMAND}: number is 0 if it was done. Or {@link #SAVED}: number is when it
     * was saved, 0 for none newer, -1 if the bytes say why not.
     */
    ANSWER;

    private static final Kind[] ALL = values();
  }

  static PeerFrame of(Kind kind, long number) {
    return new PeerFrame(kind, number, "", 0, 0, NOTHING);
  }

  static PeerFrame of(Kind kind, long number, String room, byte[] bytes) {
    return new PeerFrame(kind, number, room, 0, 0, bytes);
  }

  byte[] toBytes() {
    ByteArrayOutputStream bytesOut = new ByteArrayOutputStream(64 + bytes.length);
    try (DataOutputStream out = new DataOutputStream(bytesOut)) {
      out.writeByte(kind.ordinal());
      out.writeLong(number);
      out.writeUTF(room);
      out.writeByte(step);
      out.writeInt(slot);
      out.write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // memory takes everything
    }
    return bytesOut.toByteArray();
  }

  static PeerFrame parse(byte[] frame) throws IOException {
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(frame))) {
      int kind = in.readUnsignedByte();
      if (kind >= Kind.ALL.length) {
        throw new IOException("kind=" + kind + " of a frame is unknown; use the same build");
      }
      return new PeerFrame(
          Kind.ALL[kind],
          in.readLong(),
          in.readUTF(),
          in.readUnsignedByte(),
          in.readInt(),
          in.readAllBytes());
    }
  }
}
