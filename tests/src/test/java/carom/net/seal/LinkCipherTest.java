package carom.net.seal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ProtocolLimits;
import java.security.GeneralSecurityException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Goal: only what one side sent reaches the other, once. Method: both sides without sockets. */
final class LinkCipherTest {
  private static final int LINK = 0x1020304;
  private static final byte[] GREETING = {1, 2, 3};
  private static final byte TAG = 6;

  private final ExchangeKey serverKey = ExchangeKey.random();

  /** Both ends of one link. */
  private record Ends(LinkKeys client, LinkKeys server) {}

  private Ends ends(Encryption encryption) throws GeneralSecurityException {
    KeyExchange.Offer offer = new KeyExchange.Offer(encryption, serverKey.publicKey(), GREETING);
    KeyExchange.Answer answer =
        KeyExchange.answer(encryption, serverKey, GREETING, offer.bytes(), LINK, 1_200);
    return new Ends(offer.finish(answer.bytes(), LINK, 1_200), answer.keys());
  }

  private static byte[] sealed(DatagramSealer sealer, byte[] fields) {
    int length = sealer.seal(TAG, fields, 0, fields.length);
    return Arrays.copyOf(sealer.bytes(), length);
  }

  @Test
  void sealsAsTheTestCasesOfGcm() { // test case 14 of its authors: 256 bits of key, all zero
    LinkCipher seal = LinkCipher.of(Encryption.ON, new byte[LinkCipher.KEY_BYTES], 0);
    byte[] frame = new byte[32];
    seal.seal(0, frame, 0, 0, 16);
    assertEquals(
        "cea7403d4d606b6e074ec5d3baf39d18d0d1c8a799996bf0265b98b5d48ab919",
        HexFormat.of().formatHex(frame));
    assertTrue(
        LinkCipher.of(Encryption.ON, new byte[LinkCipher.KEY_BYTES], 0).open(0, frame, 0, 0, 16));
    assertArrayEquals(new byte[16], Arrays.copyOf(frame, 16));
  }

  @Test
  void aDatagramArrivesInEitherMode() throws GeneralSecurityException {
    for (Encryption encryption : Encryption.values()) {
      Ends ends = ends(encryption);
      for (int length : new int[] {0, 1, 36, 1_200}) {
        byte[] fields = new byte[length];
        Arrays.fill(fields, (byte) 7);
        byte[] there = sealed(ends.client().datagramsOut(), fields);
        byte[] back = sealed(ends.server().datagramsOut(), fields);
        assertEquals(1 + length + DatagramSealer.EXTRA_BYTES, there.length);
        int ipAndUdp = 20 + 8;
        assertEquals(ProtocolLimits.DATAGRAM_OVERHEAD_BYTES, ipAndUdp + there.length - length);
        assertEquals(LINK, DatagramOpener.link(there, there.length));
        assertEquals(length, ends.server().datagramsIn().open(there, there.length));
        assertEquals(length, ends.client().datagramsIn().open(back, back.length));
        int head = DatagramSealer.HEAD_BYTES;
        assertArrayEquals(fields, Arrays.copyOfRange(there, head, head + length));
      }
    }
  }

  @Test
  void noSingleBitMayChange() throws GeneralSecurityException {
    Ends ends = ends(Encryption.ON);
    byte[] good = sealed(ends.client().datagramsOut(), new byte[36]);
    for (int bit = 0; bit < 8 * good.length; bit++) {
      byte[] bad = good.clone();
      bad[bit / 8] ^= (byte) (1 << bit % 8);
      assertEquals(
          DatagramOpener.FORGED, ends.server().datagramsIn().open(bad, bad.length), "bit=" + bit);
    }
    for (int length = 0; length < good.length; length++) {
      byte[] bad = good.clone();
      assertEquals(DatagramOpener.FORGED, ends.server().datagramsIn().open(bad, length));
    }
    assertEquals(36, ends.server().datagramsIn().open(good, good.length), "and then the genuine");
  }

  @Test
  void eachDatagramCountsOnceInAnyOrder() throws GeneralSecurityException {
    for (Encryption encryption : Encryption.values()) {
      Ends ends = ends(encryption);
      List<byte[]> sent = new ArrayList<>();
      for (int i = 0; i < 200; i++) {
        sent.add(sealed(ends.client().datagramsOut(), new byte[] {(byte) i}));
      }
      Collections.shuffle(sent, new Random(5));
      for (byte[] datagram : sent) {
        byte[] again = datagram.clone();
        assertEquals(1, ends.server().datagramsIn().open(datagram, datagram.length));
        assertEquals(
            DatagramOpener.REPLAYED, ends.server().datagramsIn().open(again, again.length));
      }
    }
  }

  @Test
  void noFrameOpensWhereItWasNotSentTo() throws GeneralSecurityException {
    Ends ends = ends(Encryption.ON);
    Ends other = ends(Encryption.ON);
    byte[] datagram = sealed(ends.client().datagramsOut(), new byte[5]);
    for (DatagramOpener opener :
        List.of(
            ends.client().datagramsIn(),
            other.server().datagramsIn(),
            other.client().datagramsIn())) {
      byte[] copy = datagram.clone();
      assertEquals(DatagramOpener.FORGED, opener.open(copy, copy.length));
    }
    byte[] frame = new byte[5 + StreamSeal.EXTRA_BYTES];
    ends.client().streamOut().seal(frame, 0, 5);
    assertEquals(-1, ends.client().streamIn().open(frame.clone(), 0, frame.length), "reflected");
    assertEquals(-1, other.server().streamIn().open(frame.clone(), 0, frame.length));
    assertEquals(5, ends.server().streamIn().open(frame, 0, frame.length));
  }

  @Test
  void noNonceOfAKeyServesTwice() throws GeneralSecurityException {
    Ends ends = ends(Encryption.ON);
    Set<String> sealed = new HashSet<>();
    for (LinkKeys keys : List.of(ends.client(), ends.server())) {
      for (int i = 0; i < 3; i++) {
        byte[] frame = new byte[16 + StreamSeal.EXTRA_BYTES];
        keys.streamOut().seal(frame, 0, 16);
        sealed.add(HexFormat.of().formatHex(frame, 0, 16));
        byte[] datagram = sealed(keys.datagramsOut(), new byte[16]);
        int fields = DatagramSealer.HEAD_BYTES;
        sealed.add(HexFormat.of().formatHex(datagram, fields, fields + 16));
      }
    }
    assertEquals(12, sealed.size(), "the same 16 bytes are sealed each time");
  }

  @Test
  void aStreamTakesItsFramesInOrderOnly() throws GeneralSecurityException {
    Ends ends = ends(Encryption.ON);
    List<byte[]> frames = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      byte[] frame = new byte[1 + StreamSeal.EXTRA_BYTES];
      frame[0] = (byte) i;
      ends.server().streamOut().seal(frame, 0, 1);
      frames.add(frame);
    }
    StreamSeal in = ends.client().streamIn();
    assertEquals(-1, in.open(frames.get(1).clone(), 0, 17), "one is missing");
    assertEquals(1, in.open(frames.get(0).clone(), 0, 17));
    assertEquals(-1, in.open(frames.get(0).clone(), 0, 17), "one comes again");
    byte[] second = frames.get(1).clone();
    assertEquals(1, in.open(second, 0, 17));
    assertEquals(1, second[0]);
    assertEquals(-1, in.open(new byte[3], 0, 3), "too short for a tag");
  }

  @Test
  void noCounterServesTwice() {
    byte[] material = new byte[LinkCipher.KEY_BYTES];
    StreamSeal stream =
        new StreamSeal(LinkCipher.of(Encryption.ON, material, 0), LinkCipher.MAX_FRAMES - 1);
    stream.seal(new byte[16], 0, 0);
    assertTrue(stream.isUsedUp());
    assertThrows(IllegalStateException.class, () -> stream.seal(new byte[16], 0, 0));
    DatagramSealer sealer =
        new DatagramSealer(
            LinkCipher.of(Encryption.ON, material, 0), 1, 10, LinkCipher.MAX_FRAMES - 1);
    assertFalse(sealer.isUsedUp());
    byte[] last = sealed(sealer, new byte[10]);
    assertTrue(sealer.isUsedUp());
    assertThrows(IllegalStateException.class, () -> sealer.seal(TAG, new byte[1], 0, 1));
    DatagramOpener opener = new DatagramOpener(LinkCipher.of(Encryption.ON, material, 0), 1);
    assertEquals(10, opener.open(last, last.length));
  }

  @Test
  void withoutEncryptionABlindSenderStillFails() throws GeneralSecurityException {
    Ends ends = ends(Encryption.OFF);
    byte[] good = sealed(ends.client().datagramsOut(), new byte[36]);
    for (int i = good.length - 16; i < good.length; i++) {
      byte[] bad = good.clone();
      bad[i] ^= 1;
      assertEquals(DatagramOpener.FORGED, ends.server().datagramsIn().open(bad, bad.length));
    }
    assertEquals(36, ends.server().datagramsIn().open(good, good.length));
  }

  private KeyExchange.Offer offer() throws GeneralSecurityException {
    return new KeyExchange.Offer(Encryption.ON, serverKey.publicKey(), GREETING);
  }

  private byte[] answer(byte[] greeting, byte[] offer) throws GeneralSecurityException {
    return KeyExchange.answer(Encryption.ON, serverKey, greeting, offer, LINK, 1_200).bytes();
  }

  @Test
  void everyByteOfTheExchangeCounts() throws GeneralSecurityException {
    byte[] bytes = offer().bytes();
    for (int i = 0; i < bytes.length; i++) {
      byte[] bad = bytes.clone();
      bad[i] ^= 1;
      assertThrows(GeneralSecurityException.class, () -> answer(GREETING, bad), "byte=" + i);
    }
    assertThrows(GeneralSecurityException.class, () -> answer(new byte[] {1, 2, 4}, bytes));
    for (int i = 0; i < KeyExchange.ANSWER_BYTES; i++) {
      KeyExchange.Offer offer = offer();
      byte[] bad = answer(GREETING, offer.bytes());
      bad[i] ^= 1;
      assertThrows(
          GeneralSecurityException.class, () -> offer.finish(bad, LINK, 1_200), "byte=" + i);
    }
    KeyExchange.Offer offer = offer();
    assertEquals(LINK, DatagramOpener.link(sealedBy(offer, answer(GREETING, offer.bytes())), 27));
  }

  private static byte[] sealedBy(KeyExchange.Offer offer, byte[] answer)
      throws GeneralSecurityException {
    return sealed(offer.finish(answer, LINK, 1_200).datagramsOut(), new byte[0]);
  }

  @Test
  void aThiefOfTheLastingKeyReadsNoOlderLink() throws GeneralSecurityException {
    KeyExchange.Offer offer = offer();
    byte[] first = answer(GREETING, offer.bytes());
    byte[] second = answer(GREETING, offer.bytes());
    assertNotEquals(
        Arrays.toString(first), Arrays.toString(second), "the server's part is new each time");
    byte[] datagram = sealedBy(offer, first);
    LinkKeys thief =
        KeyExchange.answer(Encryption.ON, serverKey, GREETING, offer.bytes(), LINK, 9).keys();
    assertEquals(DatagramOpener.FORGED, thief.datagramsIn().open(datagram, datagram.length));
  }

  @Test
  void onlyTheOwnerOfTheLastingKeyReadsAnOffer() throws GeneralSecurityException {
    byte[] offer = offer().bytes();
    ExchangeKey another = ExchangeKey.random();
    assertThrows(
        GeneralSecurityException.class,
        () -> KeyExchange.answer(Encryption.ON, another, GREETING, offer, LINK, 9));
  }
}
