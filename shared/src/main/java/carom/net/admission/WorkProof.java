package carom.net.admission;

import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;

/**
 * Proof that a client has computed for a while: a number that, hashed behind a given one, yields a
 * hash that begins with some zero bits. Finding it takes 2^bits hashes on average, checking it one.
 * Use an instance from one thread.
 */
public final class WorkProof {
  /** Most bits that a server may ask for, about half a second of work. */
  public static final int MAX_BITS = 20;

  private final MessageDigest sha256;
  private final ByteBuffer text = ByteBuffer.allocate(Integer.BYTES + 2 * Long.BYTES);
  private final byte[] hash = new byte[32];
  private final ByteBuffer hashed = ByteBuffer.wrap(hash);

  /** Creates a prover and checker. */
  public WorkProof() {
    try {
      sha256 = MessageDigest.getInstance("SHA-256");
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  /**
   * Returns a solution.
   *
   * @param link the connection that must prove its work
   * @param token of the connection, so that no client can work ahead
   * @param bits 0..{@value #MAX_BITS}
   * @throws IllegalArgumentException if the bits are out of their range
   */
  public long solve(int link, long token, int bits) {
    if (bits < 0 || bits > MAX_BITS) {
      throw new IllegalArgumentException("bits=" + bits + " must be in 0.." + MAX_BITS);
    }
    long solution = 0;
    while (!isSolved(link, token, bits, solution)) {
      solution++;
    }
    return solution;
  }

  /** Returns whether a solution is right. It costs half a microsecond and allocates nothing. */
  public boolean isSolved(int link, long token, int bits, long solution) {
    if (bits == 0) {
      return true;
    }
    text.clear();
    sha256.update(text.putInt(link).putLong(token).putLong(solution).flip());
    try {
      sha256.digest(hash, 0, hash.length);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e); // the array has the hash's length
    }
    return Long.numberOfLeadingZeros(hashed.getLong(0)) >= bits;
  }
}
