package carom.server.lobby;

import carom.net.admission.AddressGroup;
import carom.net.admission.Entrance;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.PlayerName;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.RoomName;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.LevelOutcome;
import carom.net.protocol.SessionState;
import carom.net.seal.PlayerKey;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.server.access.AddressRange;
import carom.server.access.EntryRule;
import carom.server.access.GamePassword;
import carom.server.access.JoinTokens;
import carom.server.account.AccountService;
import carom.server.account.PlayerSkill;
import carom.server.account.Stay;
import carom.server.config.ServerConfig;
import carom.server.match.MatchInfo;
import carom.server.room.FillUp;
import carom.server.room.FleetDoor;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.room.RoomOffer;
import carom.server.room.RoomSearch;
import carom.server.session.Admission;
import carom.server.session.LevelUpload;
import carom.server.session.PacedMessages;
import carom.server.session.Seats;
import carom.server.upload.Uploads;
import carom.text.Texts;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A link from its first message to its room: handshake, a seat, and the level. It ends by entering
 * a room, by watching, by a refusal, or when the client leaves.
 *
 * <p>On the lobby's thread.
 */
final class Visitor implements LinkHandler, Entrance.Guest {
  private static final Logger LOG = LoggerFactory.getLogger(Visitor.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final double NS_PER_S = 1e9;
  private static final int MAX_POLL = 32;
  private static final int FIRST_EPOCH = 0;

  /** Time after which a visitor of a full server asks for a seat again, ms. */
  private static final long ASK_AGAIN_MS = 400;

  /**
   * Time without a request after which a visitor that loads gives way where seats are short, ms.
   */
  private static final long STALL_MS = 2_000;

  /** Time for which a visitor waits for a seat before the lobby refuses it, ms. */
  private static final long ENTRANCE_WAIT_MS = 2_500;

  /** Longest time for which a visitor waits for what its account has. */
  private static final long ACCOUNT_WAIT_MS = 2_000;

  /**
   * Number of seats that visitors of one host may hold while they load the level, or half of the
   * free seats if that is more.
   */
  private static final int MIN_LOADING = 8;

  private static final String NO_DIRECTORY = "The fleet's directory doesn't answer.";

  /** Number of visitors that may send a level at a time. */
  private static final int MAX_INTAKES = 8;

  /** Number of times that a visitor may ask for the list of rooms. */
  private static final int MAX_LISTS = 8;

  /** The request of a player to join, and its account by a join token. */
  private record JoinRequest(
      String name,
      String account,
      String room,
      String game,
      String party,
      int skill,
      long resumeSecret,
      boolean anywhere) {

    /** Returns the same request for any room. */
    JoinRequest forAnyRoom() {
      return new JoinRequest(name, account, "", game, party, skill, resumeSecret, true);
    }

    /** Returns the same request for the room of the party. */
    JoinRequest forRoomOfParty(String room) {
      return new JoinRequest(name, account, room, game, party, skill, resumeSecret, false);
    }

    FillUp fillUp() {
      return new FillUp(game, !party.isEmpty());
    }
  }

  private final LobbyContext context;
  private final ServerConfig config;
  private final RoomChooser chooser;
  private final RoomDirectory directory;
  private final Link link;
  private SessionState state = SessionState.CONNECTED;
  private long deadlineNs;
  private Room room;
  private Seats.Seat seat;
  private final AddressGroup origin;
  private JoinRequest waiting;
  private int lists;
  private final PacedMessages roomList = new PacedMessages();
  private String password; // that the client has shown, or null
  private long waitsUntilNs;
  private long askAgainNs;
  private long askedNs; // when the client last asked for a part of the level

  /** The room whose seat is kept for this visitor, as another player gives it up, or null. */
  private Room promised;

  private MatchInfo match;
  private ServerMessage.Welcome welcome;
  private LevelUpload upload;
  private boolean done;

  /** The stay of the account, while the store is asked; or null. */
  private CompletableFuture<Stay> remembering;

  /** True if the player doesn't come back to the seat. */
  private boolean isNewcomer;

  /** True for a bot of the server. */
  private boolean isBot;

  /** Who a ticket belongs to, as soon as the fleet's directory has answered; or null. */
  private Future<FleetDoor.Guest> redeeming;

  private ClientMessage.Hello ticketHolder; // while that is asked

  /** The way to another server of the fleet, as soon as there is a ticket; or null. */
  private Future<ServerMessage> moving;

  /** The room of the visitor's party, as soon as the fleet's directory has answered; or null. */
  private Future<String> settling;

  /** The fleet's answer whether the join token counts; or null. */
  private Future<Boolean> spending;

  /** The fleet's answer whether the account may have its seat now; or null. */
  private Future<Boolean> seating;

  private boolean mayBeSeated;

  /** The look for players about as good, or null where skill doesn't count. */
  private SkillLook look;

  /** The level that the client sends instead of joining, or null. */
  private LevelIntake intake;

  /** The room that the client waits for, which this server follows; or null. */
  private ClientMessage.Standby standby;

  /** The greeting of a thin client that may be here before its room, and stands by; or null. */
  private ClientMessage.Hello early;

  Visitor(LobbyContext context, Link link) {
    this.context = context;
    this.config = context.config();
    this.chooser = context.chooser();
    this.directory = context.directory();
    this.link = link;
    this.origin = AddressGroup.ofRemote(link.remote());
    this.deadlineNs = context.nowNs() + config.get(ServerConfig.HANDSHAKE_TIMEOUT_MS) * NS_PER_MS;
    this.askAgainNs = context.nowNs();
  }

  @Override
  public AddressGroup origin() {
    return origin;
  }

  /**
   * Returns the stage; a visitor with a seat and one that asks for it never displace each other.
   */
  @Override
  public Entrance.Proof proof() {
    if (done || state == SessionState.LOADING || standby != null || intake != null) {
      return Entrance.Proof.IN;
    }
    return waiting == null ? Entrance.Proof.UNPROVEN : Entrance.Proof.PROVEN;
  }

  /** Returns whether others on the way can read what the visitor says. */
  boolean isPlainText() {
    return link.isPlainText();
  }

  /** Refuses the visitor because others need its place at the door. */
  void giveWay() {
    refuse(RefusalReason.TOO_MANY_CONNECTIONS, "Others wait to play.");
  }

  /**
   * Reads messages one by one. Messages behind Hello wait until it is answered, those behind a
   * request for the list of rooms until that is sent, and messages behind Ready are for the room.
   */
  int poll() {
    int work = sendList();
    while (!done
        && waiting == null
        && redeeming == null
        && remembering == null
        && roomList.isSent()
        && work < MAX_POLL) {
      if (link.poll(this, 1) == 0) {
        break;
      }
      work += 1 + sendList();
    }
    return work;
  }

  private int sendList() {
    int sent = 0;
    for (Broadcast part; (part = roomList.take(context.nowNs())) != null; sent++) {
      link.send(part);
    }
    return sent;
  }

  @Override
  public void message(Link from, Object message) {
    if (state == SessionState.CONNECTED && message instanceof ClientMessage.Hello hello) {
      hello(hello);
    } else if (state == SessionState.CONNECTED
        && message instanceof ClientMessage.Standby request) {
      standBy(request);
    } else if (state == SessionState.CONNECTED && message instanceof ClientMessage.Watch watch) {
      watch(watch);
    } else if (state == SessionState.CONNECTED
        && password == null
        && message instanceof ClientMessage.Password shown) {
      password = shown.text();
    } else if (state == SessionState.CONNECTED
        && message instanceof ClientMessage.OfferLevel offer) {
      offer(offer);
    } else if (intake != null && message instanceof ClientMessage.LevelPiece piece) {
      if (!intake.take(piece, link)) {
        refuse(RefusalReason.BAD_REQUEST, "A piece of the level is out of order.");
      }
    } else if (message instanceof ClientMessage.ListRooms list) {
      list(list);
    } else if (state == SessionState.LOADING
        && message instanceof ClientMessage.LevelRequest request) {
      askedNs = context.nowNs();
      String problem = upload.answer(request, link);
      if (problem != null) {
        refuse(RefusalReason.BAD_REQUEST, problem);
      }
    } else if (state == SessionState.LOADING && message instanceof ClientMessage.Ready ready) {
      if (!upload.isFinishedBy(ready)) {
        refuse(RefusalReason.BAD_REQUEST, "Ready has the key of another Welcome.");
      } else if (welcome.refusal(ready) != null) {
        refuse(RefusalReason.GAME_VERSION, welcome.refusal(ready));
      } else {
        String difference = welcome.codeDifference(ready.gameDigest());
        if (difference != null) {
          LOG.warn("{} plays with other code, as --dev allows: {}", seat.name(), difference);
        }
        enterRoom();
      }
    } else if (message instanceof ClientMessage.Leave) {
      end("left before playing");
    } else {
      String name = message == null ? "nothing" : message.getClass().getSimpleName();
      refuse(RefusalReason.BAD_REQUEST, name + " came while " + state + ".");
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    // A datagram means nothing before the player has a body.
  }

  @Override
  public void closed(Link from, String reason) {
    if (!done) {
      end(reason);
    }
  }

  private void watch(ClientMessage.Watch watch) {
    if (!requireThisBuild(watch.protocolVersion(), watch.physicsDigest())
        || !requirePassword()
        || !requireEntry(null, "")) {
      return;
    }
    ServerMessage.Refused refusal = context.spectators().add(link, watch.room(), context.nowNs());
    if (refusal != null) {
      refuse(refusal.reason(), refusal.text());
    }
    done = true;
  }

  private void list(ClientMessage.ListRooms list) {
    if (!requireProtocol(list.protocolVersion())) {
      return;
    }
    lists++;
    if (lists > MAX_LISTS) {
      refuse(RefusalReason.BAD_REQUEST, "The list of rooms was requested again and again.");
      return;
    }
    roomList.begin(directory.list(link.door(), context.nowNs()));
  }

  /** Refuses a client of another protocol, and returns whether the client may go on. */
  private boolean requireProtocol(int protocolVersion) {
    if (protocolVersion != Protocol.VERSION) {
      refuse(
          RefusalReason.PROTOCOL_VERSION,
          String.format(
              Locale.ROOT,
              "This server speaks protocol %d, your game %d.",
              Protocol.VERSION,
              protocolVersion));
      return false;
    }
    return true;
  }

  /** Refuses a client of another build, and returns whether the client may go on. */
  private boolean requireThisBuild(int protocolVersion, long physicsDigest) {
    if (!requireProtocol(protocolVersion)) {
      return false;
    }
    if (physicsDigest != Protocol.physicsDigest()) {
      refuse(
          RefusalReason.PHYSICS_VERSION,
          "This server computes with %s.".formatted(Protocol.PHYSICS_VERSION));
      return false;
    }
    return true;
  }

  /** Refuses a client that the operator doesn't let in, and returns whether it may go on. */
  private boolean requireEntry(String name, String account) {
    EntryRule.Refusal refusal = context.entryRule().refusal(name, account, link.remote());
    if (refusal != null) {
      refuse(refusal.reason(), refusal.text());
    }
    return refusal == null;
  }

  /** Refuses a client that doesn't know the password, and returns whether it may go on. */
  private boolean requirePassword() {
    GamePassword demanded = context.password();
    String problem = demanded == null ? null : demanded.problem(password, address());
    if (problem != null) {
      refuse(RefusalReason.PASSWORD_WRONG, problem);
    }
    return problem == null;
  }

  /** Returns the client's address; a client in this process is at the loopback address. */
  private InetAddress address() {
    try {
      byte[] bytes = AddressRange.addressIn(link.remote()).orElse(null);
      return bytes == null ? InetAddress.getLoopbackAddress() : InetAddress.getByAddress(bytes);
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e); // can't happen with 4 or 16 bytes
    }
  }

  private void hello(ClientMessage.Hello hello) {
    if (!requireThisBuild(hello.protocolVersion(), hello.physicsDigest())) {
      return;
    }
    if (standby != null || intake != null) {
      refuse(RefusalReason.BAD_REQUEST, "Hello came while the client stands by or sends a level.");
      return;
    }
    if (early == null
        && link.door() != Link.Door.OWN
        && directory.fleet().follows(hello.room(), hello.resumeSecret())) {
      early = hello;
      waitsUntilNs = context.nowNs() + ENTRANCE_WAIT_MS * NS_PER_MS;
      standBy(
          new ClientMessage.Standby(
              hello.protocolVersion(), hello.physicsDigest(), hello.resumeSecret(), hello.room()));
      return;
    }
    if (hello.token().startsWith(Seats.BOT)) {
      sitDown(hello.token());
      return;
    }
    if (!isAlone() && hello.token().startsWith(FleetDoor.TICKET)) {
      redeeming = directory.fleet().redeem(hello.token());
      ticketHolder = hello;
      waitsUntilNs = context.nowNs() + ENTRANCE_WAIT_MS * NS_PER_MS;
      return;
    }
    // A player with a session has shown the password.
    if (chooser.expecting(hello.resumeSecret()) == null && !requirePassword()) {
      return;
    }
    JoinRequest request = requestOf(hello);
    if (request != null) {
      begin(request);
    }
  }

  /** Lets a bot of the server to the seat for which it has a token. */
  private void sitDown(String token) {
    Map.Entry<Room, Seats.Seat> place = chooser.claimForBot(token);
    if (place == null) {
      refuse(RefusalReason.TOKEN_INVALID, "No bot is wanted at that seat.");
      return;
    }
    isBot = true;
    room = place.getKey();
    seat = place.getValue();
    welcome();
  }

  private void begin(JoinRequest request) {
    String problem = PlayerName.problem(request.name());
    if (problem != null) {
      refuse(RefusalReason.NAME_INVALID, "Sorry, " + problem + ".");
      return;
    }
    if (!requireEntry(request.name(), request.account())) {
      return;
    }
    waiting = request;
    waitsUntilNs = context.nowNs() + ENTRANCE_WAIT_MS * NS_PER_MS;
    tryToEnter();
  }

  /** Begins to take a level, if the server takes one of this player now. */
  private void offer(ClientMessage.OfferLevel offer) {
    if (!requireProtocol(offer.protocolVersion())) {
      return;
    }
    Uploads uploads = directory.uploads();
    if (intake != null || standby != null) {
      refuse(RefusalReason.BAD_REQUEST, "One level at a time.");
      return;
    }
    if (uploads == null) {
      endIntake(new Uploads.Outcome(false, "This server takes no levels of players."), 0);
      return;
    }
    if (!requirePassword()) {
      return;
    }
    JoinRequest by =
        requestOf(
            new ClientMessage.Hello(
                offer.protocolVersion(), 0, offer.name(), 0, "", "", "", offer.token()));
    if (by == null) {
      return;
    }
    String problem = PlayerName.problem(by.name());
    if (problem != null) {
      refuse(RefusalReason.NAME_INVALID, "Sorry, " + problem + ".");
      return;
    }
    if (!requireEntry(by.name(), by.account())) {
      return;
    }
    String refusal =
        context.visitors().stream().filter(Visitor::sendsLevel).count() >= MAX_INTAKES
            ? "The levels of others are on their way."
            : uploads.refusal(by.account(), origin.host());
    if (refusal != null) {
      endIntake(new Uploads.Outcome(false, refusal), 0);
      return;
    }
    intake = new LevelIntake(uploads, by.account(), by.name(), offer);
    deadlineNs = context.nowNs() + config.get(ServerConfig.LOAD_TIMEOUT_MS) * NS_PER_MS;
    intake.tell(link);
  }

  /** Tells the client what has come of its level, and parts. */
  private void endIntake(Uploads.Outcome outcome, int received) {
    done = true;
    String text = Texts.cut(outcome.text(), ProtocolLimits.MAX_TEXT_BYTES);
    link.send(
        new ServerMessage.LevelAnswer(
            received, outcome.taken() ? LevelOutcome.TAKEN : LevelOutcome.NOT_TAKEN, text));
    context.closeLater(link, "has sent a level");
  }

  /** Waits for the room of a session, which this server follows. */
  private void standBy(ClientMessage.Standby request) {
    if (!requireThisBuild(request.protocolVersion(), request.physicsDigest())) {
      return;
    }
    FleetDoor fleet = directory.fleet();
    boolean isFollowed = fleet.follows(request.room(), request.secret());
    if (!isFollowed && chooser.expecting(request.secret()) == null) { // it may be here by now
      refuse(RefusalReason.ROOM_UNKNOWN, "This server doesn't follow that session.");
      return;
    }
    context.standsBy(request.secret(), this);
    standby = request;
    if (isFollowed) {
      fleet.standsBy(request.room(), request.secret());
    }
  }

  /** Ends a visitor that stands by, because the client does so over another link. */
  void replaced() {
    end("stands by over another link");
  }

  /** Goes on with a visitor whose ticket has been looked up. */
  private void redeemed(FleetDoor.Guest guest) {
    ClientMessage.Hello hello = ticketHolder;
    redeeming = null;
    ticketHolder = null;
    if (guest == null) {
      refuse(RefusalReason.FLEET_UNSETTLED, "The ticket is used or too old.");
      return;
    }
    begin(
        new JoinRequest(
            guest.name(),
            guest.account(),
            guest.room(),
            guest.game(),
            guest.party(),
            guest.skill(),
            hello.resumeSecret(),
            guest.anywhere()));
  }

  /** Welcomes a visitor whose room this server owns by now. */
  private void lookForRoom() {
    FleetDoor fleet = directory.fleet();
    boolean isFollowed = fleet.follows(standby.room(), standby.secret());
    if (isFollowed && early == null && !fleet.mayComeBack(standby.room())) {
      return; // its owner lives; a look through all seats each turn was most of the lobby's work
    }
    if (chooser.expecting(standby.secret()) != null) {
      waiting =
          new JoinRequest(
              "", "", standby.room(), "", "", PlayerSkill.NO_CLAIM, standby.secret(), false);
      waitsUntilNs = context.nowNs() + ENTRANCE_WAIT_MS * NS_PER_MS;
      standby = null;
    } else if (early != null && context.nowNs() - waitsUntilNs >= 0) {
      standby = null;
      hello(early); // the room stays where it is
    } else if (!isFollowed
        && !fleet.mayComeBack(standby.room())
        && directory.find(standby.room()) == null) {
      standby = null;
      refuse(RefusalReason.ROOM_UNKNOWN, "This server follows that session no longer.");
    }
  }

  /**
   * Returns what the player wants and may want by its join token, or refuses and returns null. A
   * player who comes back proves by the session's secret that the token was good, and keeps the
   * account.
   */
  private JoinRequest requestOf(ClientMessage.Hello hello) {
    String name = hello.name().strip();
    String party = hello.party().toLowerCase(Locale.ROOT);
    String problem = party.isEmpty() ? null : RoomName.partyProblem(party);
    if (problem != null) {
      refuse(RefusalReason.BAD_REQUEST, "Sorry, " + problem + ".");
      return null;
    }
    JoinTokens joinTokens = context.entryRule().tokens();
    Room expecting = chooser.expecting(hello.resumeSecret());
    if (joinTokens == null || expecting != null) {
      String account =
          expecting == null
              ? accountOfKey(hello.token())
              : expecting.seats().accountOf(hello.resumeSecret());
      if (account == null) {
        refuse(RefusalReason.TOKEN_INVALID, "Your key's signature isn't for this link.");
        return null;
      }
      return new JoinRequest(
          name,
          account,
          hello.room(),
          hello.game(),
          party,
          PlayerSkill.NO_CLAIM,
          hello.resumeSecret(),
          hello.room().isEmpty() || hello.resumeSecret() != 0);
    }
    try {
      JoinTokens.Token token =
          link.isPlainText() ? joinTokens.spend(hello.token()) : joinTokens.check(hello.token());
      if (!isAlone()) {
        spending =
            directory
                .fleet()
                .spend(
                    JoinTokens.mark(hello.token()),
                    joinTokens.secondsLeft(hello.token()),
                    link.isPlainText());
      }
      return new JoinRequest(
          token.name().isEmpty() ? name : token.name(),
          token.account(),
          token.room().isEmpty() ? hello.room() : token.room(),
          hello.game(),
          party,
          token.skill(),
          0,
          token.room().isEmpty() && hello.room().isEmpty());
    } catch (JoinTokens.BadTokenException e) {
      refuse(RefusalReason.TOKEN_INVALID, e.getMessage());
      return null;
    }
  }

  /**
   * Returns the account that a player's own key proves, or an empty text without a key. Thin
   * clients have no such link: null, as for a wrong signature.
   */
  private String accountOfKey(String proof) {
    if (!proof.startsWith(PlayerKey.PROOF)) {
      return "";
    }
    byte[] binding = link.binding();
    return binding == null ? null : PlayerKey.account(proof, binding);
  }

  /**
   * Gives a visitor that has sent Hello a seat as soon as it may have one. A visitor waits while
   * its host joins too often or holds too many seats without playing, and while a full room gives
   * up the seat of a player who lost the connection.
   */
  void tryToEnter() {
    if (done) {
      return;
    }
    if (remembering != null) {
      enterRoom();
      return;
    }
    if (intake != null && intake.outcome() != null) {
      endIntake(intake.outcome(), intake.received());
      return;
    }
    if (standby != null) {
      lookForRoom();
    } else if (redeeming != null && redeeming.isDone()) {
      redeemed(FleetDoor.outcome(redeeming));
    } else if (redeeming != null && context.nowNs() - waitsUntilNs >= 0) {
      refuse(RefusalReason.FLEET_UNSETTLED, NO_DIRECTORY);
    }
    if (done || waiting == null) {
      return;
    }
    if (link.state() == Link.State.CLOSED) {
      end("left while waiting");
      return;
    }
    if (moving != null) {
      goThere();
      return;
    }
    if (spending != null && !isTokenGood()) {
      return;
    }
    Room expecting = chooser.expecting(waiting.resumeSecret());
    if (expecting == null
        && (askForSkill() || askForParty() || (waiting.room().isEmpty() && goOnLooking()))) {
      return;
    }
    Room requested = waiting.room().isEmpty() ? null : directory.find(waiting.room());
    boolean late = context.nowNs() - waitsUntilNs >= 0;
    if (expecting == null && isOwnedElsewhere(requested)) {
      return;
    }
    if (expecting == null && requested == null && !waiting.room().isEmpty()) {
      boolean mayComeBack = directory.fleet().mayComeBack(waiting.room());
      if (mayComeBack && late) {
        refuse(RefusalReason.FLEET_UNSETTLED, "The room isn't back yet.");
      } else if (!mayComeBack) {
        refuse(RefusalReason.ROOM_UNKNOWN, directory.describe(link.door()));
      }
      return;
    }
    String overload = expecting == null ? chooser.overload(requested) : null;
    if (overload != null) {
      refuse(RefusalReason.OVERLOADED, overload);
      return;
    }
    String used = expecting == null ? accountInUse() : null;
    if (expecting == null && used == null && !mayBeSeated()) {
      if (late) {
        refuse(RefusalReason.FLEET_UNSETTLED, "The fleet can't tell yet where your account plays.");
      }
      return;
    }
    boolean allowed = used == null && context.rate().allows(origin.host(), context.nowNs());
    boolean full = false;
    if (allowed && expecting != null) {
      room = expecting;
      seat = room.seats().claim(waiting.resumeSecret(), origin, context.nowNs());
    } else if (allowed) {
      full = !takeSeat(requested) && chooser.seatsLeft(requested) == 0 && !askForSeat(requested);
    }
    if (seat != null) {
      context.rate().count(origin.host(), context.nowNs());
      waiting = null;
      welcome();
    } else if (full && requested != null && waiting.anywhere() && !isAlone()) {
      waiting = waiting.forAnyRoom(); // the room has filled up while the client came here
    } else if (full || (allowed && chooser.seatsLeft(requested) == 0 && late)) {
      refuseFull(requested);
    } else if (late && used != null) {
      refuse(RefusalReason.TOKEN_INVALID, used);
    } else if (late) {
      refuse(RefusalReason.TOO_MANY_CONNECTIONS, "");
    }
  }

  /**
   * Asks for a ticket if the player's place is at another server of the fleet: that of the room, or
   * that of the fullest room.
   *
   * @param requested the room here that the player asks for, or null
   */
  private boolean isOwnedElsewhere(Room requested) {
    if (requested != null) {
      return false;
    }
    FleetDoor fleet = directory.fleet();
    if (fleet.mayComeBack(waiting.room())) {
      return false; // its former owner may still stand in the directory
    }
    FleetDoor.Place there =
        waiting.room().isEmpty()
            ? better(fleet.best(search(), link.door()), search())
            : fleet.find(waiting.room(), link.door());
    if (there == null) {
      return false;
    }
    moving =
        fleet.move(
            there,
            new FleetDoor.Guest(
                waiting.name(),
                waiting.account(),
                there.room(),
                waiting.game(),
                waiting.party(),
                waiting.skill(),
                waiting.anywhere()),
            link.door());
    return true;
  }

  /** Returns a place elsewhere if it is better than each one here, by the rules for rooms here. */
  private FleetDoor.Place better(FleetDoor.Place there, RoomSearch search) {
    Room here = bestHere(search);
    return there == null || here == null || search.fit(there.offer()) > search.fit(here.offer())
        ? there
        : null;
  }

  private Room bestHere(RoomSearch search) {
    return directory.best(search, room -> !chooser.isOverloaded(room));
  }

  /** Returns the best room of all by a rule, here or elsewhere; null if there is none. */
  private RoomOffer bestOffer(RoomSearch search) {
    FleetDoor.Place there = better(directory.fleet().best(search, link.door()), search);
    Room here = there == null ? bestHere(search) : null;
    return there != null ? there.offer() : here != null ? here.offer() : null;
  }

  /** Returns the rule by which the visitor gets a room. */
  private RoomSearch search() {
    return look == null
        ? waiting.fillUp()
        : look.search(
            waiting.fillUp(), !waiting.party().isEmpty() || isFirstOfTwo(), context.nowNs());
  }

  /** Returns whether another visitor suits this one and waits for it to begin in an empty room. */
  private boolean isFirstOfTwo() {
    boolean isBehind = false;
    for (Visitor visitor : context.visitors()) {
      if (isBehind && visitor.looker() != null && look.suits(visitor.look, context.nowNs())) {
        return true;
      }
      isBehind |= visitor == this;
    }
    return directory.fleet().lookersElsewhere().stream()
        .anyMatch(other -> look.suits(other, context.nowNs()));
  }

  /** Returns what others may know of a visitor who looks for players about as good, or null. */
  FleetDoor.Looker looker() {
    return done || waiting == null || look == null || look.isOver(context.nowNs())
        ? null
        : look.own();
  }

  /**
   * Asks the store of accounts how good the visitor is, where that counts.
   *
   * @return whether the answer is awaited
   */
  private boolean askForSkill() {
    if (look == null && config.get(ServerConfig.ROOM_RULE) == ServerConfig.RoomRule.SKILL) {
      look =
          new SkillLook(
              waiting.skill(),
              waiting.account(),
              directory.accounts(),
              (long) (config.get(ServerConfig.SKILL_WAIT) * NS_PER_S),
              context.nowNs());
    }
    return look != null && look.awaitSkill(context.nowNs());
  }

  /**
   * Looks for players about as good, and tells the visitor so.
   *
   * @return whether to go on
   */
  private boolean goOnLooking() {
    long nowNs = context.nowNs();
    if (look == null || look.isOver(nowNs)) {
      return false;
    }
    if (look.takeTurn(nowNs)) {
      RoomOffer otherwise = bestOffer(waiting.fillUp());
      if (otherwise != null) {
        look.otherwise(otherwise);
      }
      if (otherwise == null || look.isOver(nowNs)) {
        return false;
      }
      RoomOffer found = bestOffer(search());
      String game = waiting.game();
      if (found != null && (found.game().equals(game) || !otherwise.game().equals(game))) {
        return false;
      }
    }
    String news = look.takeNews(nowNs);
    if (news != null) {
      link.send(new ServerMessage.Notice(news));
    }
    waitsUntilNs = nowNs + ENTRANCE_WAIT_MS * NS_PER_MS;
    return true;
  }

  /**
   * Makes the request one for the room of the visitor's party, if it names no other. The first
   * member's room is the one that any player would get, unless another server of the fleet settles
   * it at the same moment.
   *
   * @return whether the fleet's directory is still asked
   */
  private boolean askForParty() {
    if (waiting.party().isEmpty() || !waiting.room().isEmpty()) {
      return false;
    }
    FleetDoor fleet = directory.fleet();
    Room here = directory.ofParty(waiting.party());
    String room = here != null ? here.name() : fleet.roomOfParty(waiting.party(), link.door());
    if (room == null && !isAlone()) {
      boolean late = context.nowNs() - waitsUntilNs >= 0;
      if (settling == null && !context.rate().allows(origin.host(), context.nowNs())) {
        if (late) {
          refuse(RefusalReason.TOO_MANY_CONNECTIONS, "");
        }
        return true;
      }
      if (settling == null) {
        RoomSearch search = search();
        FleetDoor.Place there = better(fleet.best(search, link.door()), search);
        Room best = bestHere(search);
        if (there == null && best == null) {
          return false; // all are full
        }
        context.rate().count(origin.host(), context.nowNs());
        settling = fleet.settle(waiting.party(), there == null ? best.name() : there.room());
      }
      if (!settling.isDone() && !late) {
        return true;
      }
      room = settling.isDone() ? FleetDoor.outcome(settling) : null;
      settling = null;
      if (room == null) {
        refuse(RefusalReason.FLEET_UNSETTLED, NO_DIRECTORY);
        return true;
      }
    }
    if (room != null) {
      waiting = waiting.forRoomOfParty(room);
    }
    return false;
  }

  /** Sends the client to the server for which it has a ticket by now. */
  private void goThere() {
    if (moving.isDone()) {
      ServerMessage move = FleetDoor.outcome(moving);
      if (move == null) {
        moving = null;
        refuse(RefusalReason.FLEET_UNSETTLED, NO_DIRECTORY);
        return;
      }
      done = true;
      LOG.info("visitor {} goes to another server: {}", link.remote(), move);
      link.send(move);
      context.closeLater(link, "moved");
    } else if (context.nowNs() - waitsUntilNs >= 0) {
      refuse(RefusalReason.FLEET_UNSETTLED, NO_DIRECTORY);
    }
  }

  private boolean isAlone() {
    return directory.fleet() == FleetDoor.NONE;
  }

  /** Returns whether the token counts in the whole fleet; refuses the visitor if it doesn't. */
  private boolean isTokenGood() {
    if (!spending.isDone() && context.nowNs() - waitsUntilNs < 0) {
      return false;
    }
    Boolean counts = spending.isDone() ? FleetDoor.outcome(spending) : null;
    if (counts == null) {
      refuse(RefusalReason.FLEET_UNSETTLED, NO_DIRECTORY);
    } else if (!counts) {
      refuse(RefusalReason.TOKEN_INVALID, JoinTokens.USED);
    }
    spending = null;
    return !done;
  }

  /** Returns why the account may have no further seat, or null if it may. */
  private String accountInUse() {
    JoinTokens tokens = context.entryRule().tokens();
    int elsewhere = tokens == null ? 0 : directory.fleet().roomsOf(waiting.account());
    return tokens == null ? null : tokens.refusal(chooser.seatsOf(waiting.account()) + elsewhere);
  }

  /** Returns whether no other server of the fleet gives a limited account a seat at this moment. */
  private boolean mayBeSeated() {
    JoinTokens tokens = context.entryRule().tokens();
    if (isAlone() || tokens == null || !tokens.limitsSeats() || mayBeSeated) {
      return true;
    }
    if (seating == null && context.nowNs() - askAgainNs >= 0) {
      askAgainNs = context.nowNs() + ASK_AGAIN_MS * NS_PER_MS;
      seating = directory.fleet().seats(waiting.account());
    }
    if (seating != null && seating.isDone()) {
      mayBeSeated = Boolean.TRUE.equals(FleetDoor.outcome(seating));
      seating = null;
      askAgainNs = mayBeSeated ? context.nowNs() : askAgainNs;
    }
    return mayBeSeated;
  }

  private void refuseFull(Room requested) {
    int count = requested == null ? context.places() : requested.seats().count();
    String text =
        (count == 1 ? "The only place is taken." : "All %d places are taken.").formatted(count);
    if (requested != null && requested == directory.ofParty(waiting.party())) {
      text = "Your party is in room " + requested.name() + ". " + text;
    }
    refuse(
        requested == null ? RefusalReason.SERVER_FULL : RefusalReason.ROOM_FULL,
        requested == null ? text : text + " " + directory.describe(link.door()));
  }

  /**
   * Takes a seat in the requested room, or the fullest that has one; returns whether it got one.
   */
  private boolean takeSeat(Room requested) {
    Room chosen = requested == null ? bestHere(search()) : requested;
    if (chosen != null
        && chooser.seatsLeft(chosen) > context.countPromised(chosen, this)
        && context.countLoading(origin.host())
            < Math.max(MIN_LOADING, chooser.seatsLeft(null) / 2)) {
      room = chosen;
      seat = room.seats().take(waiting.name(), waiting.account(), origin);
      seat.party(waiting.party());
      seat.skill(look == null ? new PlayerSkill(waiting.skill(), null) : look.skill());
      isNewcomer = true;
    }
    return seat != null;
  }

  /**
   * Asks a room to give up an idle seat, or one of a network that holds more than its share.
   * Without one, a visitor gives way that loads the level and crowds others out, or stalls. Returns
   * false if no seat gives way.
   */
  private boolean askForSeat(Room requested) {
    if (context.nowNs() - askAgainNs < 0) {
      return true; // the seat asked for is soon free
    }
    promised = chooser.askToGiveWay(waiting.account(), origin, requested);
    boolean asked = promised != null || chooser.hasReserved(requested);
    Visitor crowding = asked ? null : context.loaderToGiveWay(origin, requested);
    if (crowding != null) {
      asked = true;
      crowding.refuse(RefusalReason.TOO_SLOW, "Others wait for the place.");
    }
    askAgainNs = asked ? context.nowNs() + ASK_AGAIN_MS * NS_PER_MS : context.nowNs();
    return asked;
  }

  private void welcome() {
    match = room.match();
    upload = new LevelUpload(match.level(), FIRST_EPOCH);
    deadlineNs = context.nowNs() + config.get(ServerConfig.LOAD_TIMEOUT_MS) * NS_PER_MS;
    askedNs = context.nowNs();
    state = state.become(SessionState.LOADING);
    welcome =
        match.welcome(
            isBot ? 0 : seat.secret(),
            seat.id(),
            FIRST_EPOCH,
            config.get(ServerConfig.TICK_RATE),
            room.tick(),
            room.ownership().claim(),
            room.seats().incarnation(),
            seat.courseTick());
    link.send(welcome);
  }

  private void enterRoom() {
    // The operator may have banned the player while the level loaded.
    if (!isBot && !requireEntry(seat.wantedName(), seat.account())) {
      return;
    }
    AccountService accounts = directory.accounts();
    if (isNewcomer && accounts != null && !seat.account().isEmpty() && remembering == null) {
      remembering = accounts.begin(seat.account());
      waitsUntilNs = context.nowNs() + ACCOUNT_WAIT_MS * NS_PER_MS;
    }
    if (remembering != null) {
      if (!remembering.isDone() && context.nowNs() - waitsUntilNs < 0) {
        return; // tryToEnter asks again
      }
      Stay stay = remembering.getNow(null);
      seat.stay(stay);
      if (stay == null) {
        LOG.warn("{} of account={} plays without what it has", seat.name(), seat.account());
        forgetAccount(); // if the store answers after all
      }
    }
    done = true;
    if (!room.admit(new Admission(seat, link, FIRST_EPOCH, match.number(), isBot))) {
      LOG.warn("{} could not enter: too many enter at once, or the room failed", seat.name());
      link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_ERROR, "Try again in a moment."));
      context.closeLater(link, "room takes nobody");
      giveUpSeat();
    }
  }

  /** Refuses the visitor when its phase has taken too long. */
  void checkDeadline() {
    if (!done
        && waiting == null
        && redeeming == null
        && standby == null
        && (intake == null || !intake.isWhole())
        && context.nowNs() - deadlineNs >= 0) {
      refuse(
          RefusalReason.TOO_SLOW,
          state == SessionState.CONNECTED && intake == null
              ? String.format(
                  Locale.ROOT,
                  "No greeting came within %d ms.",
                  config.get(ServerConfig.HANDSHAKE_TIMEOUT_MS))
              : String.format(
                  Locale.ROOT,
                  intake == null
                      ? "The level was not loaded within %d ms."
                      : "The level has not arrived within %d ms.",
                  config.get(ServerConfig.LOAD_TIMEOUT_MS)));
    }
  }

  private void refuse(RefusalReason reason, String text) {
    done = true;
    context.sendRefusal(link, reason, text);
    giveUpSeat();
  }

  /** Sends the visitor to another server, unless it hasn't said yet what it wants. */
  void redirect(ServerMessage.Redirect to) {
    if (done || (waiting == null && state != SessionState.LOADING)) {
      return;
    }
    done = true;
    LOG.info("visitor {} goes to {}", link.remote(), to.server());
    link.send(to);
    context.closeLater(link, "sent to " + to.server());
    giveUpSeat();
  }

  /** Tells the visitor that the server stops, unless it has gone. */
  void turnAway() {
    if (done) {
      return; // sent to another server
    }
    if (state == SessionState.LOADING) {
      // After Welcome a client expects a Goodbye, not a Refused. The player sees the same.
      link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_STOPPING, ""));
      context.closeLater(link, "server stops");
    } else if (standby != null) {
      link.close("server stops");
    } else {
      context.sendRefusal(link, RefusalReason.SHUTTING_DOWN, "");
    }
    giveUpSeat();
  }

  /** Ends the visitor at once after an error of the server. */
  void fail() {
    giveUpSeat();
    done = true;
    context.partings().add(link, "server error", context.nowNs());
  }

  /** Returns whether the visitor has left the lobby, for a room or altogether. */
  boolean isDone() {
    return done;
  }

  /** Returns whether the visitor sends a level. */
  boolean sendsLevel() {
    return !done && intake != null;
  }

  /** Returns whether the visitor holds a seat and still loads the level. */
  boolean isLoading() {
    return !done && state == SessionState.LOADING;
  }

  /** Returns whether the visitor holds a seat, but hasn't asked for the level for two seconds. */
  boolean isStalled() {
    return isLoading() && context.nowNs() - askedNs >= STALL_MS * NS_PER_MS;
  }

  /** Returns whether the visitor waits for a seat of a room that is kept for it. */
  boolean isPromised(Room by) {
    return !done && waiting != null && promised == by;
  }

  /** Returns the room in which the visitor holds a seat; null before. */
  Room room() {
    return room;
  }

  private void end(String why) {
    done = true;
    LOG.debug("visitor {} gone: {}", link.remote(), why);
    link.close(why);
    giveUpSeat();
  }

  /** Ends a stay, or lets it not begin. */
  private void forgetAccount() {
    Stay stay = remembering.cancel(false) ? null : remembering.getNow(null);
    if (stay != null) {
      directory.accounts().ends(stay);
    }
  }

  private void giveUpSeat() {
    if (remembering != null) {
      forgetAccount();
    }
    if (seat != null) {
      room.seats().unclaim(seat);
      seat = null;
    }
  }
}
