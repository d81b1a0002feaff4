package carom.net.seal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.HexFormat;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Goal: the handshake is that of Noise, to the bit. Method: public test vectors (those of the Go
 * library {@code flynn/noise} 1.1.0): with and without prologue and payloads, up to the first frame
 * in each direction.
 */
final class NoiseHandshakeTest {
  private static final String SERVER =
      "0102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f20";
  private static final String CLIENT_FRESH =
      "202122232425262728292a2b2c2d2e2f303132333435363738393a3b3c3d3e3f";
  private static final String SERVER_FRESH =
      "4142434445464748494a4b4c4d4e4f505152535455565758595a5b5c5d5e5f60";
  private static final String FIRST =
      "358072d6365880d1aeea329adf9121383851ed21a28e3b75e965d0d2cd166254";
  private static final String SECOND =
      "64b101b1d0be5a8704bd078f9895001fc03e8e9f9522f188dd128d9846d48466";

  private static byte[] hex(String text) {
    return HexFormat.of().parseHex(text);
  }

  private static ExchangeKey key(String text) {
    return ExchangeKey.of(hex(text));
  }

  @ParameterizedTest
  @CsvSource({
    "'', '', 18e3e3b9a33b9d5f680ee08fbf20d03f, '', a2c11719e1aac7b6b2efc4871618f8bf",
    "'', 746573745f6d73675f30, 6cfcd5c91dd95543a236cd276e885b5c7a1c3890ca630f06543e,"
        + " 746573745f6d73675f31, b3f3dd3e34414275ad733b2a5593f9b31485eecd7c12413912a9",
    "6e6f74736563726574, '', f256569b87bb96d615490cfa4ca93b30,"
        + " '', 4918946d495163ba4efd4dfea52402eb",
    "6e6f74736563726574, 746573745f6d73675f30,"
        + " 6cfcd5c91dd95543a2363b9bd07c092d8fff14687e5f48b43afc,"
        + " 746573745f6d73675f31, b3f3dd3e34414275ad73c9d7e1d03e86e1580404241350ed9ab1"
  })
  void speaksNoise(String prologue, String payload, String sealed, String reply, String sealedReply)
      throws GeneralSecurityException {
    ExchangeKey lasting = key(SERVER);
    NoiseHandshake client =
        new NoiseHandshake(hex(prologue), lasting.publicKey(), key(CLIENT_FRESH));
    NoiseHandshake server =
        new NoiseHandshake(hex(prologue), lasting.publicKey(), key(SERVER_FRESH));
    byte[] first = client.writeFirst(lasting.publicKey(), hex(payload));
    assertEquals(FIRST + sealed, HexFormat.of().formatHex(first));
    assertArrayEquals(hex(payload), server.readFirst(lasting, first));
    byte[] second = server.writeSecond(first, hex(reply));
    assertEquals(SECOND + sealedReply, HexFormat.of().formatHex(second));
    assertArrayEquals(hex(reply), client.readSecond(second));

    LinkKeys ours = LinkKeys.of(Encryption.ON, client.split(), client.binding(), false, 1, 1);
    LinkKeys theirs = LinkKeys.of(Encryption.ON, server.split(), server.binding(), true, 1, 1);
    frame(
        ours,
        theirs,
        "79656c6c6f777375626d6172696e65",
        "95922788fcef822a17b42f450fa14d05d8e6a4377ca0aea3b4804f03db74a2");
    frame(
        theirs,
        ours,
        "7375626d6172696e6579656c6c6f77",
        "0976cd4a786c253b37489b6bc3867b2df0dddf9f939b218da54092c6d3eca4");
  }

  private static void frame(LinkKeys from, LinkKeys to, String content, String sealed) {
    byte[] bytes = hex(content);
    byte[] frame = Arrays.copyOf(bytes, bytes.length + StreamSeal.EXTRA_BYTES);
    from.streamOut().seal(frame, 0, bytes.length);
    assertEquals(sealed, HexFormat.of().formatHex(frame));
    assertEquals(bytes.length, to.streamIn().open(frame, 0, frame.length));
    assertArrayEquals(bytes, Arrays.copyOf(frame, bytes.length));
  }
}
