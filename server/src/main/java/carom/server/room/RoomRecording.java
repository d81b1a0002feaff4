package carom.server.room;

import carom.net.protocol.Protocol;
import carom.replay.BlockSink;
import carom.replay.Recorder;
import carom.replay.RecordingHeader;
import carom.server.match.RoomContext;
import carom.server.metrics.Counter;
import carom.server.recording.DelayedRecording;
import carom.server.recording.RecordingFile;
import carom.server.recording.RecordingFiles;
import carom.server.recording.RotatingRecording;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SimulationHost;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import java.io.IOException;
import java.nio.file.Path;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The recording of a room, of which there is one at a time, and a second one beside a recording
 * that spectators watch, which no operator may end. It begins with the server, or when an operator
 * asks for it while the game goes on. It ends when an operator says so, or with the room. When the
 * disk is too slow, it goes on in another file as soon as the disk has written the last.
 *
 * <p>On the room's thread, between two ticks; {@link #awaitEnd} from any.
 */
public final class RoomRecording {
  private static final Logger LOG = LoggerFactory.getLogger(RoomRecording.class);

  private final RoomContext room;
  private Recorder recorder;
  private BlockSink sink;
  private RecordingFiles files;

  /** {@link #files} if they end by length or size, too; else null. */
  private RotatingRecording rotation;

  /** The file after which the recording goes on in another one; null if none is due. */
  private RecordingFile awaited;

  private int begunAt;
  private boolean toldLeftOut;

  /** The recording of an operator beside one that spectators watch; null before the first. */
  private volatile RoomRecording beside;

  /** The last file that was ended, perhaps still being written; null without. */
  private volatile RecordingFile ended;

  /** Records nothing yet. */
  public RoomRecording(RoomContext room) {
    this.room = room;
  }

  /** Returns whether the room is recorded, or will be when the disk has written the last file. */
  public boolean isOn() {
    return recorder != null || awaited != null || beside != null && beside.isOn();
  }

  /** Returns whether each tick must be recorded even without players. */
  public boolean needsTicks() {
    boolean unseen =
        sink instanceof DelayedRecording delayed
            && delayed.isOnlyShown()
            && room.counters().get(Counter.SPECTATORS) == 0;
    return unseen ? beside != null && beside.isOn() : isOn();
  }

  private boolean isWatched() {
    return sink instanceof DelayedRecording delayed && delayed.isShown();
  }

  /**
   * Begins to record the present match. The last block tells why it ended.
   *
   * @param newSink takes the blocks, on the room's thread; stays the caller's to close
   */
  public void begin(BlockSink newSink) {
    SimulationHost simulation = room.simulation();
    long seed = room.match().info().seed();
    Recorder before = recorder;
    recorder =
        new Recorder(
            simulation,
            RecordingHeader.of(simulation, seed, Protocol.physicsDigest()),
            newSink,
            this::isForTeamAlone);
    simulation.removeJournal(before);
    sink = newSink;
    holdSecrets();
    awaited = null;
    begunAt = simulation.tick();
    toldLeftOut = false;
    simulation.addJournal(recorder);
  }

  /**
   * Returns whether spectators, who watch the recording, may not have a message: a line of chat to
   * a team. A game that hears chat needs it; that match is held instead.
   */
  private boolean isForTeamAlone(Message message) {
    return isWatched()
        && message.is(BuiltInKinds.SAY)
        && message.flag("team")
        && !room.match().hearsChat();
  }

  /** Shows spectators nothing while the match has what a team alone may know and isn't over. */
  private void holdSecrets() {
    if (sink instanceof DelayedRecording delayed) {
      delayed.hold(room.match().hasTeamSecrets() && !isOver());
    }
  }

  private boolean isOver() {
    SimulationHost simulation = room.simulation();
    return simulation.game().clock() != null && MatchClock.phase(simulation) == MatchPhase.OVER;
  }

  /**
   * Begins to record each match to a file of its own.
   *
   * @param newFiles stay the caller's to close
   * @throws IOException when the first file can't be created
   */
  public void begin(RecordingFiles newFiles) throws IOException {
    begin(newFiles.next());
    files = newFiles;
  }

  /**
   * Begins to record to a sequence of files.
   *
   * @param newRotation stays the caller's to close
   * @throws IOException when the first file can't be created
   * @throws IllegalArgumentException when the game {@linkplain carom.sim.Game#keepsMore keeps more}
   *     than its state, so that only one file can begin
   */
  public void begin(RotatingRecording newRotation) throws IOException {
    if (room.simulation().game().keepsMore()) {
      throw new IllegalArgumentException(
          "game=" + room.simulation().game().name() + " can be recorded into one file only");
    }
    begin((RecordingFiles) newRotation);
    rotation = newRotation;
  }

  /** Ends the recording because the match ends; {@link #beginMatch} goes on with the next one. */
  public void endMatch() {
    if (sink instanceof DelayedRecording delayed) {
      delayed.hold(false);
    }
    if (beside != null) {
      beside.endMatch();
    }
    if (recorder != null) {
      recorder.end("NEXT MATCH");
      endFile();
    }
  }

  /** Begins to record the match that has begun, if the last one was recorded into files. */
  public void beginMatch() {
    if (beside != null) {
      beside.beginMatch();
    }
    if (files != null) {
      beginNextFile();
    }
  }

  /**
   * Begins for an operator and returns a line that says what happened. Creates the file, which
   * takes a disk about a millisecond.
   */
  public String begin(Path path) {
    if (isWatched()) {
      beside = beside == null ? new RoomRecording(room) : beside;
      return beside.begin(path);
    }
    if (recorder != null) {
      return "recorded already to " + sink + "; end that first: record stop";
    }
    if (room.simulation().game().keepsMore()) {
      return "game="
          + room.simulation().game().name()
          + " keeps more than its state: it can be recorded from its start on only, by --record";
    }
    RecordingFile created;
    try {
      created = RecordingFile.create(path);
    } catch (IOException e) {
      return e.getMessage();
    }
    forget();
    try {
      begin(created);
      files = () -> new RecordingFile(RecordingFile.free(path));
    } catch (IllegalArgumentException e) {
      created.discard();
      return "not recorded: " + e.getMessage();
    }
    LOG.info("{}recorded to {} from tick {} on", room.label(), path, begunAt);
    return "recording to " + path + " from tick=" + begunAt + " on";
  }

  /** Ends for an operator and returns a line that says what happened. */
  public String stop() {
    if (beside != null && beside.isOn()) {
      return beside.stop();
    }
    if (recorder == null) {
      forget();
      return "not recorded";
    }
    if (isWatched()) {
      return "spectators watch this recording (--spectator-delay); it ends with the room";
    }
    String to = sink.toString();
    end("STOPPED");
    LOG.info("{}recorded to {} up to tick {}", room.label(), to, room.simulation().tick());
    return "recorded to " + to + " up to tick=" + room.simulation().tick();
  }

  /** Ends the recording if its sink is cut, and begins another file if one is due; per tick. */
  public void tickEnds() {
    if (beside != null) {
      beside.tickEnds();
    }
    if (awaited != null && awaited.isDone()) {
      awaited = null;
      beginNextFile();
    }
    if (recorder == null) {
      return;
    }
    holdSecrets();
    if (recorder.isCut()) {
      cut();
      return;
    }
    if (recorder.leftOut() != null && !toldLeftOut) {
      toldLeftOut = true;
      LOG.warn("{}the recording leaves whole states out: {}", room.label(), recorder.leftOut());
    }
    SimulationHost simulation = room.simulation();
    double seconds = (simulation.tick() - begunAt) / (double) simulation.tickRate();
    if (rotation != null && rotation.isFull(seconds)) {
      recorder.end("ROTATED");
      beginNextFile();
    }
  }

  /** Ends a recording that its sink doesn't take, and lets another file go on if one can. */
  private void cut() {
    room.counters().add(Counter.RECORDINGS_CUT, 1);
    RecordingFile file = fileOf(sink);
    boolean goesOn = files != null && file != null && !file.hasFailed();
    if (file == null || !file.hasFailed()) { // that of the disk is logged by the file itself
      LOG.error(
          "{}the recording ends at tick {}: {}; the game goes on{}",
          room.label(),
          room.simulation().tick(),
          sink,
          goesOn ? ", and another file begins when the disk has written this one" : "");
    }
    if (goesOn) {
      endFile();
      awaited = file;
    } else {
      forget();
    }
  }

  private void beginNextFile() {
    try {
      begin(files.next());
      LOG.info("{}recorded to {} from tick {} on", room.label(), sink, begunAt);
    } catch (IOException | IllegalArgumentException e) {
      LOG.error(
          "{}no recording from tick {} on: {}",
          room.label(),
          room.simulation().tick(),
          e.toString());
      forget();
      room.counters().add(Counter.RECORDINGS_CUT, 1);
    }
  }

  /**
   * Ends the recording, if there is one.
   *
   * @param why in a few words, shown when the recording is played
   */
  public void end(String why) {
    if (beside != null) {
      beside.end(why);
    }
    if (recorder != null) {
      recorder.end(why);
    }
    forget();
  }

  private void forget() {
    endFile();
    files = null;
    rotation = null;
    awaited = null;
  }

  private void endFile() {
    RecordingFile file = fileOf(sink);
    if (file != null) {
      file.finish();
      ended = file;
    }
    room.simulation().removeJournal(recorder);
    recorder = null;
    sink = null;
  }

  /** Returns the file that a sink writes to; null if it writes to none. */
  private static RecordingFile fileOf(BlockSink sink) {
    if (sink instanceof DelayedRecording delayed) {
      return delayed.file();
    }
    return sink instanceof RecordingFile file ? file : null;
  }

  /**
   * Waits until the file that was ended last is written, for at most 5 s.
   *
   * @return whether nothing is left to write
   */
  public boolean awaitEnd() {
    boolean isWritten = beside == null || beside.awaitEnd();
    RecordingFile last = ended;
    if (last != null) {
      last.close();
    }
    return isWritten && (last == null || last.isDone());
  }
}
