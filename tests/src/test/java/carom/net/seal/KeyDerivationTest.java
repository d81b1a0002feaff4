package carom.net.seal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;

/** Goal: keys are those of the standards. Method: their own test vectors. */
final class KeyDerivationTest {

  private static byte[] hex(String text) {
    return HexFormat.of().parseHex(text);
  }

  private static byte[] range(int from, int to) {
    byte[] bytes = new byte[to - from];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) (from + i);
    }
    return bytes;
  }

  @Test
  void derivesTheKeysOfRfc5869() {
    byte[] secret = new byte[22];
    Arrays.fill(secret, (byte) 0x0b);
    byte[] key = Hkdf.extract(range(0, 13), secret);
    assertArrayEquals(hex("077709362c2e32df0ddc3f0dc47bba6390b6c73bb50f9c3122ec844ad7c2b3e5"), key);
    assertArrayEquals(
        hex(
            "3cb25f25faacd57a90434f64d0362f2a2d2d0a90cf1a5a4c5db02d56ecc4c5bf34007208d5b88718"
                + "5865"),
        Hkdf.expand(key, range(0xf0, 0xfa), 42));

    byte[] longKey = Hkdf.extract(range(0x60, 0xb0), range(0, 0x50));
    assertArrayEquals(
        hex("06a6b88c5853361a06104c9ceb35b45cef760014904671014a193f40c15fc244"), longKey);
    assertArrayEquals(
        hex(
            "b11e398dc80327a1c8e7f78c596a49344f012eda2d4efad8a050cc4c19afa97c"
                + "59045a99cac7827271cb41c65e590e09da3275600c2f09b8367793a9aca3db71"
                + "cc30c58179ec3e87c14c01d5c1f3434f1d87"),
        Hkdf.expand(longKey, range(0xb0, 0x100), 82));
  }

  @Test
  void derivesAtMostWhatOneKeyMayGive() {
    byte[] key = new byte[32];
    assertEquals(Hkdf.MAX_BYTES, Hkdf.expand(key, key, Hkdf.MAX_BYTES).length);
    assertThrows(IllegalArgumentException.class, () -> Hkdf.expand(key, key, Hkdf.MAX_BYTES + 1));
    assertThrows(IllegalArgumentException.class, () -> Hkdf.expand(key, key, 0));
  }

  @Test
  void agreesAsRfc7748() throws GeneralSecurityException {
    // section 5.2: scalar, coordinate, product
    ExchangeKey scalar =
        ExchangeKey.of(hex("a546e36bf0527c9d3b16154b82465edd62144c0ac1fc5a18506a2244ba449ac4"));
    assertArrayEquals(
        hex("c3da55379de9c6908e94ea4df28d084f32eccf03491c71f754b4075577a28552"),
        scalar.agree(hex("e6db6867583030db3594c1a424b15f7c726624ec26b3353b10a903a6d0ab1c4c")));
    // section 5.2, 1,000 rounds
    byte[] k = new byte[32];
    k[0] = 9;
    byte[] u = k.clone();
    for (int i = 0; i < 1_000; i++) {
      byte[] next = ExchangeKey.of(k).agree(u);
      u = k;
      k = next;
    }
    assertArrayEquals(hex("684cf59ba83309552800ef566f2f4d3c1c3887c49360e3875f2eb94d99532c51"), k);
  }

  @Test
  void computesThePublicKeyOfRfc7748() throws GeneralSecurityException {
    ExchangeKey bob =
        ExchangeKey.of(hex("5dab087e624a8a4b79e17f8b83800ee66f3bb1292618b6fd1c2f8b27ff88e0eb"));
    assertArrayEquals(
        hex("de9edb7d7b7dc1b4d35b61c2ece435373f8343c85b78674dadfc7e146f882b4f"), bob.publicKey());
    ExchangeKey alice =
        ExchangeKey.of(hex("77076d0a7318a57d3c16c17251b26645df4c2f87ebc0992ab177fba51db92c2a"));
    assertArrayEquals(
        hex("8520f0098930a754748b7ddcb43ef75a0dbf3a0d26381af4eba4a98eaa9b4e6a"), alice.publicKey());
    byte[] shared = hex("4a5d9d5ba4ce2de1728e3bf480350f25e07e21c947d19e3376f09b3c1e161742");
    assertArrayEquals(shared, alice.agree(bob.publicKey()));
    assertArrayEquals(shared, bob.agree(alice.publicKey()));
  }

  @Test
  void refusesKeysThatWouldMakeEverySecretZero() {
    ExchangeKey key = ExchangeKey.random();
    byte[] one = new byte[32];
    one[0] = 1;
    assertThrows(GeneralSecurityException.class, () -> key.agree(new byte[32]));
    assertThrows(GeneralSecurityException.class, () -> key.agree(one));
    assertThrows(
        GeneralSecurityException.class,
        () -> key.agree(hex("e0eb7a7c3b41b8ae1656e3faf19fc46ada098deb9c32b1fd866205165f49b800")));
    assertThrows(IllegalArgumentException.class, () -> ExchangeKey.of(new byte[31]));
  }
}
