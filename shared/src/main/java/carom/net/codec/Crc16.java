package carom.net.codec;

/**
 * The 16-bit checksum of a datagram: CRC-16/CCITT (polynomial x^16 + x^12 + x^5 + 1) over a secret
 * key and the bytes. It finds every damage within 16 neighbouring bits and all but 1 in 65,536
 * others. It rejects datagrams of strangers, but not of an attacker who can read the traffic.
 */
public final class Crc16 {

  private static final char[] TABLE = new char[256];

  /** The table for a byte that is followed by one more byte. */
  private static final char[] BEFORE = new char[256];

  static {
    for (int i = 0; i < 256; i++) {
      int crc = i << 8;
      for (int bit = 0; bit < 8; bit++) {
        crc = (crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1;
      }
      TABLE[i] = (char) crc;
    }
    for (int i = 0; i < 256; i++) {
      BEFORE[i] = (char) next(TABLE[i], 0);
    }
  }

  private Crc16() {}

  /** Returns the checksum of {@code length} bytes from {@code offset} on, 0..65,535. */
  public static int of(int key, byte[] bytes, int offset, int length) {
    int crc = 0xffff;
    for (int shift = 24; shift >= 0; shift -= 8) {
      crc = next(crc, key >>> shift);
    }
    int i = offset;
    for (int end = offset + length - 1; i < end; i += 2) {
      crc = BEFORE[(crc >>> 8 ^ bytes[i]) & 0xff] ^ TABLE[(crc ^ bytes[i + 1]) & 0xff];
    }
    return i < offset + length ? next(crc, bytes[i]) : crc;
  }

  private static int next(int crc, int octet) {
    return (crc << 8 & 0xffff) ^ TABLE[(crc >>> 8 ^ octet) & 0xff];
  }
}
