package carom.net.seal;

import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.MessageDigest;
import java.util.Arrays;
import javax.crypto.AEADBadTagException;
import javax.crypto.Cipher;
import javax.crypto.spec.GCMParameterSpec;
import javax.crypto.spec.SecretKeySpec;

/**
 * Seals or opens the frames of one kind in one direction. The sender seals a frame under a counter
 * that it never uses again, and the receiver opens it under the same counter. It works in place: a
 * frame is a readable head, a body and a tag of {@value #TAG_BYTES} bytes. The tag proves head,
 * body and counter. Use it from one thread at a time, and for one direction only.
 *
 * <p>The JDK's cipher allocates about 1 kB per frame, because it must be initialised anew for each.
 */
abstract class LinkCipher {
  /** Bytes of the tag behind a frame. */
  static final int TAG_BYTES = 16;

  /** Bytes of a key. */
  static final int KEY_BYTES = 32;

  /**
   * Number of frames that one cipher may seal. The link closes before the next one. It bounds what
   * an observer can learn by AES's block size: 2^36 frames of 1,200 bytes are 2^43 blocks. A client
   * that sends 240 datagrams a second takes nine years.
   */
  static final long MAX_FRAMES = 1L << 36;

  /**
   * Returns a seal.
   *
   * @param key {@value #KEY_BYTES} bytes
   * @param firstNonce nonce of the frame with the counter 0; no other cipher of this key may have
   *     one of the {@link #MAX_FRAMES} from here on
   */
  static LinkCipher of(Encryption encryption, byte[] key, long firstNonce) {
    return encryption == Encryption.ON ? new Gcm(key, firstNonce) : new Clear(key);
  }

  /**
   * Seals a frame in place and puts its tag behind it.
   *
   * @param counter number of the frame, never used before with this key
   * @param bytes head, then body, then {@value #TAG_BYTES} bytes of room
   */
  abstract void seal(long counter, byte[] bytes, int offset, int headLength, int bodyLength);

  /**
   * Opens a frame in place. Returns false, and leaves the body undefined, when the frame is not
   * exactly what was sealed with this key and counter.
   *
   * @param bytes head, then sealed body, then tag
   */
  abstract boolean open(long counter, byte[] bytes, int offset, int headLength, int bodyLength);

  /**
   * Authenticated encryption by AES-256-GCM, with nonces as Noise has them: four bytes of 0, then
   * the number in eight bytes, big-endian.
   */
  private static final class Gcm extends LinkCipher {
    private final Key key;
    private final long firstNonce;
    private final byte[] nonce = new byte[12];
    private final Cipher cipher;

    Gcm(byte[] key, long firstNonce) {
      this.key = new SecretKeySpec(key, "AES");
      this.firstNonce = firstNonce;
      try {
        cipher = Cipher.getInstance("AES/GCM/NoPadding");
      } catch (GeneralSecurityException e) {
        throw new IllegalStateException("this Java has no AES-GCM", e);
      }
    }

    private void begin(int mode, long counter) throws GeneralSecurityException {
      for (int i = 0; i < Long.BYTES; i++) {
        nonce[nonce.length - 1 - i] = (byte) (firstNonce + counter >>> 8 * i);
      }
      cipher.init(mode, key, new GCMParameterSpec(8 * TAG_BYTES, nonce));
    }

    @Override
    void seal(long counter, byte[] bytes, int offset, int headLength, int bodyLength) {
      try {
        begin(Cipher.ENCRYPT_MODE, counter);
        cipher.updateAAD(bytes, offset, headLength);
        int body = offset + headLength;
        cipher.doFinal(bytes, body, bodyLength, bytes, body);
      } catch (GeneralSecurityException e) {
        throw new IllegalStateException("counter=" + counter + " can't be sealed", e);
      }
    }

    @Override
    boolean open(long counter, byte[] bytes, int offset, int headLength, int bodyLength) {
      try {
        begin(Cipher.DECRYPT_MODE, counter);
        cipher.updateAAD(bytes, offset, headLength);
        int body = offset + headLength;
        cipher.doFinal(bytes, body, bodyLength + TAG_BYTES, bytes, body);
        return true;
      } catch (AEADBadTagException e) {
        return false;
      } catch (GeneralSecurityException e) {
        throw new IllegalStateException("counter=" + counter + " can't be opened", e);
      }
    }
  }

  /** The session's key as the tag: nothing is secret to a reader, and blind senders fail. */
  private static final class Clear extends LinkCipher {
    private final byte[] tag;

    Clear(byte[] key) {
      tag = Arrays.copyOf(key, TAG_BYTES);
    }

    @Override
    void seal(long counter, byte[] bytes, int offset, int headLength, int bodyLength) {
      System.arraycopy(tag, 0, bytes, offset + headLength + bodyLength, TAG_BYTES);
    }

    @Override
    boolean open(long counter, byte[] bytes, int offset, int headLength, int bodyLength) {
      int at = offset + headLength + bodyLength;
      return MessageDigest.isEqual(tag, Arrays.copyOfRange(bytes, at, at + TAG_BYTES));
    }
  }
}
