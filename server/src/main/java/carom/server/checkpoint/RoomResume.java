package carom.server.checkpoint;

import carom.net.protocol.ProtocolLimits;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.account.PlayerSkill;
import carom.server.config.ServerConfig;
import carom.server.match.Match;
import carom.server.match.MatchLoader;
import carom.server.metrics.Counter;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.outbox.NextMatch;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Brings a room back from one slot: builds the match in the state of the checkpoint, computes the
 * logged ticks again, and gives the players their seats back. Each tick is compared with its
 * recorded hash, and the room goes on from the last one that is equal. Who plays then, the log
 * says; who they are, the files of seats.
 *
 * <p>Before the room's first turn, on one thread.
 */
final class RoomResume {
  private static final Logger LOG = LoggerFactory.getLogger(RoomResume.class);
  private static final long NS_PER_MS = 1_000_000;

  private final SlotFolder folder;
  private final int slot;
  private final RoomCheckpoints.KeptRoom room;
  private final MatchLoader loader;
  private final long nowNs;

  private SavedRoom saved;
  private Match match;
  private NextMatch pending;

  /** The saved seats, those of the players who came last first. */
  private List<SavedSeat> seats;

  private Session[] bySeat;
  private long inputs;

  /** Reason why the log ends before its end, or null. */
  private String trouble;

  RoomResume(
      SlotFolder folder, int slot, RoomCheckpoints.KeptRoom room, MatchLoader loader, long nowNs) {
    this.folder = folder;
    this.slot = slot;
    this.room = room;
    this.loader = loader;
    this.nowNs = nowNs;
  }

  /**
   * Brings the room back.
   *
   * @throws IOException if the slot can't be used; the message says why. Nothing has changed then
   */
  ResumedRoom run() throws IOException {
    saved = readSeats();
    saved.requireFits(SavedRoom.config(room.room(), room.config().get(ServerConfig.TICK_RATE)));
    int proven = play(Integer.MAX_VALUE);
    int lost = trouble == null ? 0 : Math.max(1, match.simulation().tick() - proven);
    if (trouble != null) {
      LOG.warn(
          "{}checkpoint {}: {}; the room goes on from tick {}",
          room.label(),
          slot,
          trouble,
          proven);
      play(proven);
    }
    SimulationHost s = match.simulation();
    long provenHash = s.stateHash();
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer player = s.participant(id);
      if (player != null && bySeat[id] == null) {
        s.leave(player); // its seat is none of this room
      }
    }
    List<Session> sessions = Arrays.stream(bySeat).filter(Objects::nonNull).toList();
    sessions.forEach(session -> session.seat().returnsTo(s.tick()));
    reserveSeats();
    room.accounts().resumed(saved.accounts());
    loader.goOn(saved.match(), saved.roomSeed());
    LOG.info(
        "resumed room={} tick={} checkpoint={} inputs={} players={} hash={}",
        room.number(),
        s.tick(),
        saved.tick(),
        inputs,
        sessions.size(),
        String.format(Locale.ROOT, "%016x", provenHash));
    return new ResumedRoom(match, saved.rotation(), pending, sessions, lost);
  }

  private SavedRoom readSeats() throws IOException {
    Path latest = folder.latest(slot);
    if (Files.exists(latest)) {
      try {
        return SavedRoom.parse(Files.readAllBytes(latest));
      } catch (IOException e) {
        LOG.warn(
            "{}checkpoint {}: who came or went after it is lost: {}",
            room.label(),
            slot,
            e.getMessage());
      }
    }
    try {
      return SavedRoom.parse(Files.readAllBytes(folder.seats(slot)));
    } catch (NoSuchFileException e) {
      throw new SlotException("it has no seats: the server ended while it was written");
    }
  }

  /**
   * Builds the match and computes the log.
   *
   * @param last tick after which to end
   * @return the last tick whose hash is the recorded one
   */
  private int play(int last) throws IOException {
    forgetSeats();
    pending = saved.pending();
    seats = new ArrayList<>(saved.seats());
    seats.sort(Comparator.comparingInt(SavedSeat::sinceTick).reversed());
    inputs = 0;
    trouble = null;
    try (RecordingReader reader = RecordingReader.open(folder.log(slot))) {
      match = loader.again(reader.header(), saved.match());
      SimulationHost s = match.simulation();
      if (s.game().keepsMore()) {
        throw new SlotException("game=" + s.game().name() + " keeps more than its state");
      }
      Replay replay = null;
      if (saved.hasSamePhysics()) {
        replay = new Replay(reader, s);
      } else {
        Replay.restoreFirstState(reader, s);
        LOG.warn(
            "{}checkpoint {}: kept by a build with other physics; the room goes on without its log",
            room.label(),
            slot);
      }
      requireWhole(s);
      saved.events().restore(match.capture().frames().events());
      seatPlayers();
      match.capture().capture();
      int proven = replay == null ? s.tick() : replay(replay, last);
      seatPlayers(); // those who left behind the last tick
      return proven;
    } catch (MatchLoader.Unplayable e) {
      throw new SlotException(e.getMessage());
    }
  }

  private void requireWhole(SimulationHost s) throws SlotException {
    if (s.tick() != saved.tick()) {
      throw new SlotException(
          "its log has no whole state of tick=" + saved.tick() + ", to which its seats belong");
    }
    if (saved.hasSamePhysics() && s.stateHash() != saved.hash()) {
      throw new SlotException(
          String.format(
              Locale.ROOT,
              "its state has the hash %016x, but its seats belong to %016x",
              s.stateHash(),
              saved.hash()));
    }
  }

  private int replay(Replay replay, int last) {
    SimulationHost s = replay.simulation();
    int proven = s.tick();
    try {
      while (s.tick() < last && replay.step() == Replay.Progress.TICK) {
        if (replay.divergence() != null) {
          trouble = "its log computes otherwise here: " + replay.divergence();
          return proven;
        }
        proven = s.tick();
        room.counters().add(Counter.TICKS_REPLAYED, 1);
        tickEnds();
      }
    } catch (IOException e) {
      trouble = "its log is of no use after tick=" + proven + ": " + e.getMessage();
    }
    inputs = replay.inputs();
    return proven;
  }

  /** Does what the room does at the end of a tick, as far as it matters later. */
  private void tickEnds() {
    seatPlayers();
    match.capture().capture();
    for (Session session : bySeat) {
      if (session != null) {
        session.replication().listen();
      }
    }
    NextMatch wanted = match.simulation().outbox().takeNextMatch();
    pending = pending == null ? wanted : pending;
  }

  /** Gives seats back to the saved players that are in the match, and takes them from others. */
  private void seatPlayers() {
    SimulationHost s = match.simulation();
    for (int id = 0; id < bySeat.length; id++) {
      if (bySeat[id] != null && s.participant(id) != bySeat[id].player()) {
        vacate(id);
      }
    }
    for (SavedSeat seat : seats) {
      HostPlayer player = s.participant(seat.id());
      if (player != null
          && seat.id() < bySeat.length
          && bySeat[seat.id()] == null
          && s.tick() >= seat.sinceTick()
          && player.name().equals(seat.name())) {
        seat(seat, player);
      }
    }
  }

  /** Reserves the seats of players who have gone to other rooms, which may not know of them. */
  private void reserveSeats() {
    for (SavedSeat seat : seats) {
      if (seat.reserved() && seat.id() < bySeat.length && bySeat[seat.id()] == null) {
        Seats.Seat reserved = restore(seat);
        if (reserved != null) {
          room.seats().reserve(reserved, nowNs + room.config().graceMs() * NS_PER_MS);
        }
      }
    }
  }

  private Seats.Seat restore(SavedSeat saved) {
    Seats.Seat seat =
        room.seats()
            .restore(
                saved.id(),
                saved.wantedName(),
                saved.name(),
                saved.account(),
                saved.secret(),
                saved.courseTick(),
                saved.switches());
    if (seat != null) {
      seat.mute(saved.muted());
      seat.party(saved.party());
      seat.skill(new PlayerSkill(saved.skill(), null));
      seat.stay(saved.stay() == null ? null : saved.stay().resumed());
    }
    return seat;
  }

  private void seat(SavedSeat saved, HostPlayer player) {
    Seats.Seat seat = restore(saved);
    if (seat == null) {
      return; // the room has fewer seats now
    }
    Session session =
        new Session(
            seat,
            player,
            room.config(),
            match.replicationTo(player),
            match.messagesOf(player),
            room.counters());
    int graceMs = saved.graceMs() == SavedSeat.PLAYED ? room.config().graceMs() : saved.graceMs();
    session.await(nowNs + graceMs * NS_PER_MS);
    for (int event : saved.events()) {
      session.replication().offer(event);
    }
    bySeat[saved.id()] = session;
  }

  private void vacate(int id) {
    room.seats().vacate(bySeat[id].seat());
    bySeat[id] = null;
  }

  /** Takes all seats back, for another pass or because the slot is of no use. */
  void forgetSeats() {
    for (int id = 0; bySeat != null && id < bySeat.length; id++) {
      if (bySeat[id] != null) {
        vacate(id);
      }
    }
    bySeat = new Session[ProtocolLimits.MAX_PLAYERS];
  }
}
