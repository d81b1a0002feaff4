package carom.client.app;

import carom.client.replay.ReplayClient;
import carom.game.GamesOption;
import carom.options.BadFlag;
import carom.options.PictureSize;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code carom render}: draws a recorded game to PNG files, so that a clip is one command. */
@Command(
    name = "render",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    description = "Draws a recorded game to pictures, for a clip.",
    footer = {
      "",
      "It needs a display and OpenGL; on a server: xvfb-run carom render ...",
      "Exit codes: 0 done, 1 no display or the recording can't go on, 2 bad flag or file."
    })
final class RenderCommand implements Callable<Integer> {
  private static final int MAX_STEPS = 4;

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  @Parameters(paramLabel = "FILE", description = "What carom-server --record has written.")
  private Path file;

  @Option(
      names = "--frames",
      paramLabel = "DIR",
      required = true,
      description = "Folder for the pictures; made if it isn't there, and empty if it is.")
  private Path folder;

  @Option(
      names = "--from",
      paramLabel = "S",
      defaultValue = "0",
      description = "Begin at this second of the game (${DEFAULT-VALUE}).")
  private double from;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      defaultValue = "0",
      description = "Length of the clip; 0 = to the end (${DEFAULT-VALUE}).")
  private double seconds;

  @Option(
      names = "--fps",
      paramLabel = "N",
      defaultValue = "60",
      description = "Pictures a second, 1..240 (${DEFAULT-VALUE}).")
  private int fps;

  @Option(
      names = "--size",
      paramLabel = "WxH",
      defaultValue = "1280x720",
      description = "Size of the pictures, up to 7680x4320 (${DEFAULT-VALUE}).")
  private String size;

  @Option(
      names = "--speed",
      paramLabel = "FACTOR",
      defaultValue = "1",
      description =
          "A power of 2 from 0.0625 to 16; 0.25 is slow motion, four times as long"
              + " (${DEFAULT-VALUE}).")
  private double speed;

  @Option(
      names = "--follow",
      paramLabel = "NAME",
      defaultValue = "",
      description = "Keep this player in the middle.")
  private String follow;

  @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

  @Override
  public Integer call() {
    RenderJob job = job();
    for (Window window : ServiceLoader.load(Window.class)) {
      return window.render(job);
    }
    System.err.println("This build has no window.");
    return 1;
  }

  private RenderJob job() {
    PictureSize picture;
    try {
      picture = PictureSize.parse(size);
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
    if (fps < 1 || fps > 240) {
      throw bad("--fps=" + fps + " is outside 1..240");
    }
    if (!(from >= 0 && from <= 1e6)) {
      throw bad("--from=" + from + " is outside 0..1000000");
    }
    if (!(seconds >= 0 && seconds <= 1e5)) {
      throw bad("--seconds=" + seconds + " is outside 0..100000");
    }
    int steps = speed > 0 ? Math.getExponent(speed) : MAX_STEPS + 1;
    if (Math.abs(steps) > MAX_STEPS || Math.scalb(1.0, steps) != speed) {
      throw bad("--speed=" + speed + " is no power of 2 from 0.0625 to 16");
    }
    try {
      new ReplayClient(file).close();
      Files.createDirectories(folder);
      try (Stream<Path> present = Files.list(folder)) {
        if (present.findAny().isPresent()) {
          throw bad("--frames=" + folder + " isn't empty; name another folder");
        }
      }
    } catch (IOException e) {
      throw bad(e.getMessage());
    }
    return new RenderJob(
        file, folder, from, seconds, fps, picture.width(), picture.height(), steps, follow);
  }

  private BadFlag bad(String problem) {
    return new BadFlag(spec.commandLine(), problem);
  }
}
