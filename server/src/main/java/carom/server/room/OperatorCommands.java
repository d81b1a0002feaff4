package carom.server.room;

import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.server.match.Match;
import carom.server.match.MatchInfo;
import carom.server.match.MatchLoader;
import carom.server.match.RoomContext;
import carom.server.match.SavedMatch;
import carom.server.recording.RecordingFile;
import carom.server.replication.SentReport;
import carom.server.session.PlayerInfo;
import carom.server.session.Session;
import carom.sim.SimulationHost;
import carom.sim.field.FieldHolder;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.outbox.NextMatch;
import carom.text.FileErrors;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.LongSupplier;

/**
 * The commands that an operator may give to a room. Each command may be called from any thread but
 * the room's. It waits for the room's next turn, in which the room's thread carries it out, and
 * answers in words.
 */
public final class OperatorCommands {
  /** Most commands that wait. */
  private static final int MAX_WAITING = 16;

  private static final long ANSWER_S = 2;
  private static final int MAX_FIELDS_TEXT = 4_096;
  private static final String PLAYER = "player ";
  private static final String ENTITY = "entity ";

  private final RoomContext room;
  private final String name;
  private final RoomSessions sessions;
  private final Departures departures;
  private final RoomRecording recording;
  private final MatchChange changes;
  private final LongSupplier clock;
  private final BooleanSupplier closed;
  private final Runnable wake;
  private final ArrayBlockingQueue<FutureTask<?>> waiting = new ArrayBlockingQueue<>(MAX_WAITING);

  /**
   * Creates an empty queue of commands.
   *
   * @param name name of the room
   * @param closed returns whether the room is closed
   * @param wake ends the nap of the room's thread, because a command waits
   */
  OperatorCommands(RoomParts parts, String name, BooleanSupplier closed, Runnable wake) {
    room = parts.context;
    this.name = name;
    sessions = parts.sessions;
    departures = parts.departures;
    recording = parts.recording;
    changes = parts.changes;
    clock = parts.clock;
    this.closed = closed;
    this.wake = wake;
  }

  /**
   * Carries something out on the room's thread.
   *
   * @return its answer, or why there is none
   */
  String run(Callable<String> what) {
    return ask(what);
  }

  /** Carries out the commands that wait; on the room's thread. */
  void serve() {
    for (FutureTask<?> command; (command = waiting.poll()) != null; ) {
      command.run();
    }
  }

  /**
   * Explains why a player was not sent an entity, or that it was.
   *
   * @param playerId a seat's number
   * @param entityId an entity's number
   * @param write returns the answer's text; runs on the room's thread
   * @return that text, or why there is no answer
   */
  public String why(int playerId, int entityId, Function<SentReport, String> write) {
    return ask(() -> explain(playerId, entityId, write));
  }

  /**
   * Returns the names and values of fields.
   *
   * @param of {@code match}, {@code player N} or {@code entity N}
   */
  public String fields(String of) {
    return ask(() -> describeFields(of));
  }

  /**
   * Removes a player, who is told so and may join again.
   *
   * @param playerId a seat's number
   * @param text for the player, may be empty
   * @return what was done
   */
  public String kick(int playerId, String text) {
    return ask(
        () -> {
          Session session = sessions.onSeat(playerId);
          if (session == null) {
            return noSuchPlayer(playerId);
          }
          departures.kick(session, text, clock.getAsLong());
          return "removed player=" + playerId + " name=" + session.seat().name();
        });
  }

  /**
   * Sends players to another server.
   *
   * @param playerId a seat's number, or -1 for all that have a link
   * @return the number of players that were sent; 0 if the room doesn't answer
   */
  public int redirect(int playerId, ServerMessage.Redirect redirect) {
    try {
      return await(
          () -> {
            int sent = 0;
            for (int i = sessions.count() - 1; i >= 0; i--) {
              Session session = sessions.get(i);
              boolean meant = playerId < 0 || session.seat().id() == playerId;
              if (meant && session.state() != SessionState.GRACE) {
                departures.redirect(session, redirect, clock.getAsLong());
                sent++;
              }
            }
            return sent;
          });
    } catch (NoAnswer e) {
      return 0;
    }
  }

  /** Drops a player's chat and emotes from now on, or ends that; returns what was done. */
  public String mute(String name, boolean on) {
    return ask(() -> Moderator.mute(sessions.bySeat(), name, on));
  }

  /** Makes a player a spectator; returns what was done. */
  public String spectate(String name) {
    return ask(() -> Moderator.spectate(room.simulation(), sessions.bySeat(), name));
  }

  /**
   * Begins to record the game.
   *
   * @param target a file that is not there yet, or a folder, which then gets a file with a name of
   *     its own
   * @return the file, or why there is none
   */
  public String record(Path target) {
    String own = room.label().isEmpty() ? "" : name;
    String game = room.match().info().game();
    Path file = RecordingFile.fileFor(target, game, own).toAbsolutePath();
    return ask(() -> closed.getAsBoolean() ? "room=" + name + " is closed" : recording.begin(file));
  }

  /**
   * Ends the recording, even if it began with the server, but not one that spectators watch. Waits
   * at most 5 s more until the file is written.
   *
   * @return the file, or why the recording goes on; says so if the disk takes longer
   */
  public String stopRecording() {
    String answer = ask(recording::stop);
    return recording.awaitEnd() ? answer : answer + "; the disk has not taken all of it yet";
  }

  /**
   * Goes on with another game or level, between two ticks. The calling thread waits while the match
   * is built, and the room goes on with the present one.
   *
   * @param game name of the game; empty for the one that the level is made for
   * @param level file or name of the level; empty for the default level of the game
   * @return what the room plays now, or why the match goes on
   */
  public String change(String game, String level) {
    NextMatch wanted = new NextMatch(game.strip(), level.strip(), false, false);
    if (wanted.isOfRotation()) {
      return "neither a game nor a level is given; name one of them";
    }
    Match next;
    try {
      next = changes.load(wanted);
    } catch (MatchLoader.Unplayable e) {
      return "not changed: " + e.getMessage();
    }
    return play(next, wanted);
  }

  private String play(Match next, NextMatch wanted) {
    return ask(
        () -> {
          if (closed.getAsBoolean()) {
            return "room=" + name + " is closed";
          }
          changes.begin(next, wanted, clock.getAsLong());
          MatchInfo match = next.info();
          return "playing game=" + match.game() + " level=" + match.level().level().name();
        });
  }

  /**
   * Writes the match to a file. The room's thread copies the state, and the calling thread writes.
   *
   * @return the file and the tick, or why there is none
   */
  public String save(Path file) {
    try {
      SavedMatch saved =
          await(
              () ->
                  room.simulation().game().keepsMore()
                      ? null
                      : SavedMatch.of(room.match().info(), room.simulation()));
      if (saved == null) {
        return "not saved: the game keeps more than its state";
      }
      saved.write(file);
      return "saved room=" + name + " to " + file;
    } catch (NoAnswer e) {
      return "not saved: " + e.getMessage();
    } catch (IOException e) {
      return "not saved: " + file + " can't be written: " + FileErrors.reason(e);
    }
  }

  /**
   * Goes on with a saved match. Players of the same id and name go on as they were; others join it
   * anew, and saved players who aren't here leave it.
   *
   * @return what the room plays now, or why the match goes on
   */
  public String load(Path file) {
    try {
      return play(changes.load(SavedMatch.read(file)), new NextMatch("", "", false, false));
    } catch (IOException | MatchLoader.Unplayable e) {
      return "not loaded: " + e.getMessage();
    }
  }

  /** Returns the players in the order of their ids; empty if the room doesn't answer. */
  public List<PlayerInfo> players() {
    try {
      return await(
          () ->
              Arrays.stream(sessions.bySeat())
                  .filter(Objects::nonNull)
                  .map(PlayerInfo::of)
                  .toList());
    } catch (NoAnswer e) {
      return List.of();
    }
  }

  /**
   * Says a line to all players, as the server.
   *
   * @param text at most {@link BuiltInKinds#MAX_CHAT} characters
   * @return the number of players that hear it; 0 if the room doesn't answer
   */
  public int say(String text) {
    try {
      return await(
          () -> {
            room.simulation().send(BuiltInKinds.SAID.of(BuiltInKinds.SERVER, false, text)).toAll();
            return sessions.count();
          });
    } catch (NoAnswer e) {
      return 0;
    }
  }

  /**
   * Says lines to one player, as the server, if the player is in this room.
   *
   * @param lines at most {@link BuiltInKinds#MAX_CHAT} characters each
   * @return what was done
   */
  public String tell(PlayerInfo player, List<String> lines) {
    return ask(
        () -> {
          Session session = sessions.onSeat(player.id());
          if (session == null || !session.remote().equals(player.remote())) {
            return player.name() + " isn't here";
          }
          for (String line : lines) {
            Message said = BuiltInKinds.SAID.of(BuiltInKinds.SERVER, false, line);
            room.simulation().send(said).to(session.player());
          }
          return "told " + player.name();
        });
  }

  private String ask(Callable<String> what) {
    try {
      return await(what);
    } catch (NoAnswer e) {
      return e.getMessage();
    }
  }

  /** Says why a room didn't carry out a command. */
  private static final class NoAnswer extends Exception {
    private static final long serialVersionUID = 1;

    NoAnswer(String message) {
      super(message);
    }
  }

  private <T> T await(Callable<T> what) throws NoAnswer {
    FutureTask<T> command = new FutureTask<>(what);
    if (!waiting.offer(command)) {
      throw new NoAnswer("too many questions at once; ask again");
    }
    wake.run();
    try {
      return command.get(ANSWER_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new NoAnswer("interrupted");
    } catch (ExecutionException | TimeoutException e) {
      waiting.remove(command);
      throw new NoAnswer("no answer from the room: " + e);
    }
  }

  private String explain(int playerId, int entityId, Function<SentReport, String> write) {
    Session session = sessions.onSeat(playerId);
    if (session == null) {
      return noSuchPlayer(playerId);
    }
    if (session.state() != SessionState.PLAYING) {
      return "player=" + playerId + " is away: nothing is sent to it";
    }
    int entityCapacity = room.match().capture().frames().capacity();
    if (entityId < 0 || entityId >= entityCapacity) {
      return "entity=" + entityId + " is outside 0.." + (entityCapacity - 1);
    }
    SentReport report = session.replication().explain(entityId);
    return report == null
        ? "player=" + playerId + " has a thin client, which is told of all that it sees"
        : write.apply(report);
  }

  private String describeFields(String of) {
    FieldHolder<?, ?> holder;
    try {
      holder = find(of == null ? "" : of.trim());
    } catch (NumberFormatException e) {
      return "of=" + of + " must be match, player N or entity N";
    }
    if (holder == null) {
      return "of=" + of + " isn't there";
    }
    String text = holder.fieldValues().toString();
    return text.length() <= MAX_FIELDS_TEXT ? text : text.substring(0, MAX_FIELDS_TEXT) + " ...";
  }

  private FieldHolder<?, ?> find(String of) {
    SimulationHost s = room.simulation();
    if (of.startsWith(PLAYER)) {
      return s.player(Integer.parseInt(of, PLAYER.length(), of.length(), 10));
    }
    if (of.startsWith(ENTITY)) {
      return s.entity(Integer.parseInt(of, ENTITY.length(), of.length(), 10));
    }
    if (of.equals("match")) {
      return s;
    }
    throw new NumberFormatException(of);
  }

  private String noSuchPlayer(int playerId) {
    int last = room.seats().count() - 1;
    return "player=" + playerId + " doesn't play here; players are 0.." + last;
  }
}
