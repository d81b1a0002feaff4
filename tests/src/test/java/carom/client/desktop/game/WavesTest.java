package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.event.Sound;
import java.io.ByteArrayInputStream;
import java.util.HashSet;
import java.util.Set;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Goal: computed sounds are well-formed, loud enough and without clicks. */
class WavesTest {
  @ParameterizedTest
  @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "NONE")
  void aSoundIsLoudAndBeginsAndEndsInSilence(Sound sound) {
    short[] samples = Waves.samples(sound);
    assertEquals(Math.round(Waves.seconds(sound) * Waves.RATE), samples.length);
    int most = 0;
    int steepest = 0;
    double power = 0;
    for (int i = 0; i < samples.length; i++) {
      most = Math.max(most, Math.abs(samples[i]));
      steepest = i == 0 ? 0 : Math.max(steepest, Math.abs(samples[i] - samples[i - 1]));
      power += (double) samples[i] * samples[i];
    }
    assertEquals(0.9 * Short.MAX_VALUE, most, 1);
    assertTrue(Math.sqrt(power / samples.length) > 1_500, "hardly anything is heard");
    assertTrue(steepest < 40_000, "a click of " + steepest);
    assertTrue(Math.abs(samples[0]) < 300 && Math.abs(samples[samples.length - 1]) < 300);
    assertArrayEquals(samples, Waves.samples(sound), "the same each time");
  }

  @ParameterizedTest
  @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "NONE")
  void othersReadTheFile(Sound sound) throws Exception {
    byte[] file = Waves.wav(sound);
    try (AudioInputStream in = AudioSystem.getAudioInputStream(new ByteArrayInputStream(file))) {
      assertEquals(Waves.RATE, in.getFormat().getSampleRate());
      assertEquals(1, in.getFormat().getChannels());
      assertEquals(16, in.getFormat().getSampleSizeInBits());
      short[] samples = Waves.samples(sound);
      assertEquals(samples.length, in.getFrameLength());
      byte[] bytes = in.readAllBytes();
      Set<Short> seen = new HashSet<>();
      for (int i = 0; i < samples.length; i++) {
        short read = (short) ((bytes[2 * i] & 0xff) | bytes[2 * i + 1] << 8);
        assertEquals(samples[i], read);
        seen.add(read);
      }
      assertTrue(seen.size() > 500, seen.size() + " levels");
    }
  }
}
