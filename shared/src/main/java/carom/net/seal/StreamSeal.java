package carom.net.seal;

/**
 * One direction of a TCP stream. Frames need no number of their own, because the stream keeps their
 * order: a frame that is missing, repeated, moved or changed doesn't open. Guard it by the lock of
 * the stream.
 */
public final class StreamSeal {
  /** Bytes that sealing adds to a frame. */
  public static final int EXTRA_BYTES = LinkCipher.TAG_BYTES;

  private final LinkCipher seal;
  private long frames;

  StreamSeal(LinkCipher seal, long frames) {
    this.seal = seal;
    this.frames = frames;
  }

  /** Returns whether the key has sealed as many frames as it may. The link must close then. */
  public boolean isUsedUp() {
    return frames >= LinkCipher.MAX_FRAMES;
  }

  /**
   * Seals the next frame in place.
   *
   * @param bytes the frame, then {@value #EXTRA_BYTES} bytes of room
   * @throws IllegalStateException when the key is used up
   */
  public void seal(byte[] bytes, int offset, int length) {
    requireFrames();
    seal.seal(frames++, bytes, offset, 0, length);
  }

  /**
   * Opens the next frame in place. Returns the length of the frame, or -1 when it isn't genuine;
   * the stream is worthless then.
   *
   * @param length bytes of the sealed frame
   */
  public int open(byte[] bytes, int offset, int length) {
    int body = length - EXTRA_BYTES;
    if (body < 0 || isUsedUp() || !seal.open(frames, bytes, offset, 0, body)) {
      return -1;
    }
    frames++;
    return body;
  }

  private void requireFrames() {
    if (isUsedUp()) {
      throw new IllegalStateException("frames=" + frames + " is all that one key may seal");
    }
  }
}
