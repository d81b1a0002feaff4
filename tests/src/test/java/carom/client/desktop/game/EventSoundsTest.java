package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.EventReconciler;
import carom.client.look.GameView;
import carom.client.look.GameViews;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.look.ViewSetup;
import carom.game.arena.ArenaGame;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.level.Level;
import carom.sim.outbox.Event;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: events are heard once, by how hard and near they are. Method: a speaker that writes down
 * what it would play.
 */
class EventSoundsTest {
  private static final float LOUDEST = 0.5f;

  /** A sound that was asked for. */
  private record Played(String sound, float volume, float pan, float pitch) {}

  /** A sound that is written down instead of played. */
  private final class Noted extends Clip {
    final String name;

    Noted(String name) {
      this.name = name;
    }

    @Override
    float seconds() {
      return 0.5f;
    }

    @Override
    long play(float volume, float pan, float pitch) {
      played.add(new Played(name, volume, pan, pitch));
      return played.size() - 1L;
    }

    @Override
    void stop(long id) {
      stopped.add(id);
    }
  }

  private final Map<String, Clip> clips = new HashMap<>();
  private String music = "";
  private float musicVolume;

  private final List<Played> played = new ArrayList<>();
  private final List<Long> stopped = new ArrayList<>();
  private boolean works = true;
  private final Speaker speaker =
      new Speaker() {
        @Override
        public boolean works() {
          return works;
        }

        @Override
        public Clip clip(Sound sound) {
          return clips.computeIfAbsent(sound.name(), Noted::new);
        }

        @Override
        public Clip clip(String name, byte[] bytes) throws IOException {
          if (bytes[0] != 'R' && bytes[0] != 'O') {
            throw new IOException(name + " can't be decoded");
          }
          return new Noted(name);
        }

        @Override
        public void music(String name, byte[] bytes) {
          music = bytes == null ? "" : name;
        }

        @Override
        public void musicVolume(float volume) {
          musicVolume = volume;
        }
      };
  private final EventSounds sounds = new EventSounds(speaker, LOUDEST);
  private SimulationHost arena;

  @BeforeEach
  void setUp() throws Exception {
    arena = new SimulationHost(new ArenaGame(), Level.builtIn("arena"), 1, 60, Role.PREDICTION);
  }

  private EventKind kind(Sound sound) {
    for (int i = 0; i < arena.eventKinds().size(); i++) {
      if (arena.eventKinds().get(i).sound() == sound) {
        return arena.eventKinds().get(i);
      }
    }
    throw new AssertionError("the arena has no " + sound);
  }

  private Event event(Sound sound, int tick, float x, float y, float strength) {
    return new Event().set(kind(sound), tick, 1, Event.NONE, Event.NONE, x, y, strength, 0);
  }

  private float volume(Event event) {
    int before = played.size();
    sounds.listen(0, 0, 10);
    sounds.happened(event, false);
    return played.size() == before ? 0 : played.get(before).volume();
  }

  @Test
  void whatHappensHereAndIsHardIsAsLoudAsAsked() {
    assertEquals(LOUDEST, volume(event(Sound.WHOOSH, 1, 0, 0, 0)), 1e-6f);
    float full = kind(Sound.KNOCK).fullStrength();
    assertEquals(LOUDEST, volume(event(Sound.KNOCK, 2, 0, 0, full)), 1e-6f);
    assertEquals(LOUDEST, volume(event(Sound.KNOCK, 3, 0, 0, 100 * full)), 1e-6f);
  }

  @Test
  void harderIsLouderAndFartherIsFainter() {
    float full = kind(Sound.KNOCK).fullStrength();
    float before = 0;
    for (int i = 1; i <= 10; i++) {
      float now = volume(event(Sound.KNOCK, i, 0, 0, full * i / 10));
      assertTrue(now > before, "strength " + full * i / 10);
      before = now;
    }
    for (int metres = 5; metres <= 40; metres += 5) {
      float now = volume(event(Sound.KNOCK, 100 + metres, 0, metres, full));
      assertTrue(now < before, metres + " m");
      before = now;
    }
    assertEquals(0, volume(event(Sound.KNOCK, 200, 500, 0, full)), "not even asked for");
    assertTrue(volume(event(Sound.FANFARE, 201, 25, 0, 0)) > 0.2f * LOUDEST, "a goal is for all");
  }

  @Test
  void aWindowMayStayOpenForMonths() {
    sounds.listen(0, 0, 10_000_000);
    sounds.happened(event(Sound.WHOOSH, 1, 0, 0, 0), false);
    sounds.happened(event(Sound.WHOOSH, 1, 0, 0, 0), false);
    assertEquals(1, played.size(), "two of a kind at once");
    for (int frame = 0; frame < 20; frame++) {
      sounds.listen(0, 0, 1 / 60f);
    }
    sounds.happened(event(Sound.WHOOSH, 2, 0, 0, 0), false);
    assertEquals(2, played.size());
  }

  @Test
  void soundsComeFromTheirSide() {
    sounds.listen(100, 0, 1);
    sounds.happened(event(Sound.WHOOSH, 1, 100, 5, 0), false);
    sounds.listen(100, 0, 1);
    sounds.happened(event(Sound.WHOOSH, 2, 94, 0, 0), false);
    sounds.listen(100, 0, 1);
    sounds.happened(event(Sound.WHOOSH, 3, 106, 0, 0), false);
    assertEquals(0, played.get(0).pan());
    assertTrue(played.get(1).pan() < -0.2f && played.get(2).pan() > 0.2f, played.toString());
  }

  @Test
  void ofManyAtOnceTheLoudestAreHeard() {
    for (int i = 0; i < 3 * EventSounds.VOICES; i++) {
      Sound sound = i % 2 == 0 ? Sound.WHOOSH : Sound.ZAP;
      sounds.listen(0, 0, 0.001f * i); // a little later and nearer each time
      sounds.happened(event(sound, i, 0, 30 - i, 0), false);
    }
    assertTrue(played.size() - stopped.size() <= EventSounds.VOICES, played.size() + " played");
    assertTrue(!stopped.isEmpty(), "fainter ones make room");
    int before = played.size();
    sounds.happened(event(Sound.FANFARE, 99, 0, 100, 0), false);
    assertEquals(before, played.size(), "fainter than all that play");
  }

  @Test
  void aPileUpIsNotLouderThanABlow() {
    for (int i = 0; i < 20; i++) {
      sounds.happened(event(Sound.KNOCK, 7, 0, 0, 5), false);
    }
    assertEquals(1, played.size());
    sounds.listen(0, 0, 0.1f);
    sounds.happened(event(Sound.KNOCK, 13, 0, 0, 5), false);
    assertEquals(2, played.size());
  }

  @Test
  void whatIsPredictedComputedAgainAndToldIsHeardOnce() {
    EventReconciler reconciler = new EventReconciler(1, true, key -> 0, 60, sounds);
    HostPlayer me = arena.mirror().join(1, "me");
    arena.addJournal(reconciler);
    SimState start = arena.save(null);
    EventKind zap = kind(Sound.ZAP);
    for (int again = 0; again < 3; again++) {
      arena.restore(start);
      arena.emit(zap).by(me);
      arena.step();
      sounds.listen(0, 0, 1);
    }
    reconciler.receive(event(Sound.ZAP, 1, 0, 0, 0));
    reconciler.complete(60);
    reconciler.advance(60);
    assertEquals(1, played.size());
    assertEquals(1, reconciler.confirmed());
    assertTrue(stopped.isEmpty());
  }

  @Test
  void whatDidNotHappenFallsSilent() {
    Event event = event(Sound.FANFARE, 5, 0, 0, 0);
    sounds.happened(event, true);
    sounds.retracted(event(Sound.ZAP, 5, 0, 0, 0));
    assertTrue(stopped.isEmpty());
    sounds.retracted(event);
    assertEquals(List.of(0L), stopped);
    sounds.happened(event(Sound.FANFARE, 9, 0, 0, 0), true);
    sounds.listen(0, 0, 10);
    sounds.retracted(event(Sound.FANFARE, 9, 0, 0, 0));
    assertEquals(List.of(0L), stopped, "it was over");
  }

  @Test
  void mutedOrWithoutALoudspeakerNothingIsPlayed() {
    sounds.happened(event(Sound.FANFARE, 1, 0, 0, 0), false);
    sounds.mute(true);
    assertEquals(1, stopped.size());
    sounds.happened(event(Sound.ZAP, 2, 0, 0, 0), false);
    assertEquals(1, played.size());
    sounds.mute(false);
    sounds.happened(event(Sound.ZAP, 3, 0, 0, 0), false);
    assertEquals(2, played.size());
    works = false;
    assertFalse(sounds.audible());
    assertEquals(0, volume(event(Sound.ZAP, 4, 0, 0, 0)));
    EventSounds silent = new EventSounds(speaker, 0);
    works = true;
    silent.happened(event(Sound.ZAP, 5, 0, 0, 0), false);
    assertEquals(2, played.size());
  }

  private static final String FILES = "/carom/client/look/rockets/";

  /** The look of the arena with sounds of its own. */
  private static final class Heard implements GameView {
    @Override
    public String game() {
      return "heard";
    }

    @Override
    public void setUp(ViewSetup v) {
      v.event("dash", SoundFile.of(FILES + "shot1.wav").volume(0.5f).pitch(2, 2));
      v.event("goal", SoundFile.of(FILES + "gun.png.wav"), Shake.by(1));
      v.music(FILES + "boom1.wav");
    }
  }

  @Test
  void aLookHasSoundsAndMusicOfItsOwn() {
    List<String> told = new ArrayList<>();
    GameViews.add(Heard::new);
    ShownLook look = new ShownLook(told::add);
    look.show("heard");
    sounds.look(look);
    assertEquals(FILES + "boom1.wav", music);
    assertTrue(musicVolume > 0 && musicVolume < LOUDEST, "softer than the loudest event");

    assertEquals(LOUDEST / 2, volume(event(Sound.WHOOSH, 1, 0, 0, 0)), 1e-6f);
    assertEquals(new Played(FILES + "shot1.wav", LOUDEST / 2, 0, 2), played.get(0));
    assertEquals(LOUDEST, volume(event(Sound.ZAP, 2, 0, 0, 0)), 1e-6f);
    assertEquals("ZAP", played.get(1).sound(), "the usual one for what the look doesn't name");

    assertEquals(1, told.size(), "told once, before it is needed: " + told);
    assertTrue(told.get(0).contains("gun.png.wav"), told.get(0));

    assertEquals(LOUDEST, volume(event(Sound.FANFARE, 3, 0, 0, 0)), 1e-6f);
    assertEquals("FANFARE", played.get(2).sound(), "the usual one for a file that is missing");

    sounds.mute(true);
    assertEquals(0, musicVolume);
    sounds.mute(false);
    sounds.look(null);
    assertEquals("", music);
    assertEquals(LOUDEST, volume(event(Sound.WHOOSH, 5, 0, 0, 0)), 1e-6f);
  }
}
