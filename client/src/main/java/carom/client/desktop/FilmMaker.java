package carom.client.desktop;

import carom.client.app.RenderJob;
import carom.client.desktop.game.AudioDevice;
import carom.client.desktop.game.EventSounds;
import carom.client.desktop.game.GamePicture;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.replay.ReplayClient;
import carom.net.protocol.ServerMessage.RosterEntry;
import com.badlogic.gdx.Application;
import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.glutils.FrameBuffer;
import java.io.IOException;
import java.util.List;
import java.util.Locale;

/**
 * Draws a clip of a recording to files, one picture after the other, each at its moment of the game
 * however long it takes. Its window stays hidden. Render thread only.
 */
final class FilmMaker extends ApplicationAdapter {
  private static final long NS_PER_S = 1_000_000_000L;

  private final RenderJob job;
  private Fonts fonts;
  private Canvas canvas;
  private AudioDevice silence;
  private GamePicture picture;
  private FrameBuffer frame;
  private ReplayClient client;
  private String problem = "";
  private int frames;
  private boolean atBeginning;

  FilmMaker(RenderJob job) {
    this.job = job;
  }

  /** Returns why the clip isn't whole, in words for the user; empty if it is. */
  String problem() {
    return problem;
  }

  @Override
  public void create() {
    Gdx.app.setLogLevel(Application.LOG_ERROR);
    fonts = new Fonts(1);
    fonts.fit(job.width(), job.height());
    canvas = new Canvas();
    silence = new AudioDevice(false);
    picture = new GamePicture(canvas, fonts, new EventSounds(silence, 0));
    frame = new FrameBuffer(Pixmap.Format.RGBA8888, job.width(), job.height(), false);
    try {
      client = new ReplayClient(job.recording());
    } catch (IOException e) {
      end(String.valueOf(e.getMessage()));
      return;
    }
    client.patient(true);
    client.events(picture.events(client.view()));
    client.speedUp(job.speedSteps());
    client.seek((int) Math.round(job.fromSeconds() * client.view().tickRate()));
  }

  private void end(String why) {
    problem = why;
    if (!why.isEmpty()) {
      System.err.println("carom render: " + why);
    }
    Gdx.app.exit();
  }

  /** Finds the player to follow; returns whether there is one of that name, or no name is given. */
  private boolean follow() {
    if (job.follow().isEmpty()) {
      return true;
    }
    List<RosterEntry> players = client.view().players();
    for (RosterEntry player : players) {
      if (player.name().equalsIgnoreCase(job.follow())) {
        client.follow(player.playerId());
        return true;
      }
    }
    List<String> names = players.stream().map(RosterEntry::name).toList();
    end("nobody is called " + job.follow() + " at the clip's beginning; there are " + names);
    return false;
  }

  @Override
  public void render() {
    if (client == null || !problem.isEmpty()) {
      return;
    }
    if (client.seeking()) {
      client.update(0);
      return;
    }
    if (!atBeginning) {
      atBeginning = true;
      if (!follow()) {
        return;
      }
    }
    client.update(frames * NS_PER_S / job.framesPerSecond());
    boolean over = job.seconds() > 0 && frames >= job.seconds() * job.framesPerSecond();
    if (over || client.ended() || client.waiting() || !client.problem().isEmpty()) {
      finish();
      return;
    }
    frame.begin();
    picture.draw(
        client.view(),
        false,
        frames * NS_PER_S / job.framesPerSecond(),
        1f / job.framesPerSecond());
    String name = String.format(Locale.ROOT, "frame-%05d.png", frames);
    Pictures.save(job.folder().resolve(name).toString(), job.width(), job.height());
    frame.end();
    frames++;
    if (frames % job.framesPerSecond() == 0) {
      System.err.printf(Locale.ROOT, "%d s%n", frames / job.framesPerSecond());
    }
  }

  private void finish() {
    System.out.printf(
        Locale.ROOT,
        "%d pictures in %s. A film: ffmpeg -framerate %d -i %s/frame-%%05d.png -pix_fmt yuv420p"
            + " clip.mp4%n",
        frames,
        job.folder(),
        job.framesPerSecond(),
        job.folder());
    end(client.problem());
  }

  @Override
  public void dispose() {
    try {
      if (client != null) {
        client.close();
      }
    } catch (IOException e) {
      System.err.println("carom render: " + e);
    }
    frame.dispose();
    picture.dispose();
    silence.dispose();
    canvas.dispose();
    fonts.dispose();
  }
}
