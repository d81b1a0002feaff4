package carom.client.desktop.menu;

import carom.client.link.LanSearch;
import carom.client.link.LanServer;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.client.settings.PlayerSettings;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage.RoomEntry;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Joins a server: by its address, or from those on this network, the favourites and those played on
 * lately, with what each tells of itself. Render thread only.
 */
final class JoinPage implements Page {
  private static final int MAX_ADDRESS_LENGTH = 280;
  private static final int MAX_NAME_LENGTH = 32;
  private static final float STAR_WIDTH = 90;

  private final Widgets widgets;
  private final SettingsHost host;
  private final StartTarget target;
  private final Runnable rebuild;
  private final List<KnownServer> known = new ArrayList<>();
  private final List<Label> lanLabels = new ArrayList<>();
  private LanSearch search;
  private List<LanServer> lan = List.of();
  private List<RoomEntry> rooms = List.of();
  private RoomBrowser browser;
  private TextField name;
  private TextField party;
  private TextField address;
  private String entered;
  private TextField password; // null until a server has asked for one
  private String message = "";
  private boolean asksPassword;
  private ServerAddress asking; // the server that was joined last
  private Runnable instead;
  private String progress = "";

  /**
   * Creates a page.
   *
   * @param server address that stands in the field
   * @param rebuild asks for the page to be built anew
   */
  JoinPage(
      Widgets widgets, SettingsHost host, StartTarget target, String server, Runnable rebuild) {
    this.widgets = widgets;
    this.host = host;
    this.target = target;
    this.rebuild = rebuild;
    entered = server;
  }

  /** Shows why the player is here again; an empty text shows nothing. */
  void message(String text) {
    message = text;
    asksPassword |= text.startsWith(RefusalReason.PASSWORD_WRONG.playerText());
    progress = "";
    instead = null;
  }

  /** Offers to play on this machine, beside the message. */
  void offer(Runnable playHere) {
    instead = playHere;
  }

  /** Returns the address after a failure, as it may be what was wrong. */
  @Override
  public Actor entrance() {
    return message.isEmpty() ? null : asksPassword ? password : address;
  }

  @Override
  public void build(Table into) {
    PlayerSettings s = host.settings();
    if (known.isEmpty()) {
      ask(s);
    }
    if (search == null) {
      search = target.searchLan();
    }
    into.defaults().space(8).left();
    into.add(widgets.heading("Join a server")).colspan(2).row();
    name = widgets.field(name == null ? host.playerName() : name.getText(), MAX_NAME_LENGTH);
    into.add(widgets.label("Your name"));
    Table you = new Table();
    you.add(name).height(Widgets.HEIGHT).growX();
    you.add(ColourChooser.of(widgets, host, rebuild)).padLeft(8);
    into.add(you).growX().row();
    party =
        widgets.field(
            party == null ? host.party() : party.getText(), ProtocolLimits.MAX_PARTY_NAME_BYTES);
    party.setName("party");
    into.add(widgets.label("Party"));
    Table friends = new Table();
    friends.add(party).height(Widgets.HEIGHT).growX();
    friends.add(widgets.small("friends who type the same meet")).padLeft(8);
    into.add(friends).growX().row();
    address = widgets.field(address == null ? entered : address.getText(), MAX_ADDRESS_LENGTH);
    address.setName("address");
    into.add(widgets.label("Server")).padRight(14);
    into.add(address).height(Widgets.HEIGHT).growX().row();
    into.add();
    into.add(widgets.small("host or host:port")).row();
    if (asksPassword) {
      String typed = password == null ? "" : password.getText();
      password = widgets.field(typed, ProtocolLimits.MAX_PASSWORD_BYTES / 4);
      password.setPasswordMode(true);
      password.setPasswordCharacter('*');
      into.add(widgets.label("Password")).padRight(14);
      into.add(password).height(Widgets.HEIGHT).growX().row();
    }
    Table buttons = new Table();
    buttons.defaults().height(Widgets.HEIGHT + 4).space(8);
    buttons.add(widgets.primary("Join", () -> join(""))).growX();
    buttons.add(widgets.button("Show rooms", this::browse)).width(150);
    buttons.add(widgets.button("Watch", this::watch)).width(110);
    into.add(buttons).colspan(2).growX().row();
    if (!progress.isEmpty()) {
      into.add(widgets.muted(progress)).colspan(2).row();
    }
    if (!message.isEmpty()) {
      into.add(widgets.problem(message)).colspan(2).growX().row();
      if (instead != null) {
        into.add(widgets.button("Play here instead", instead))
            .colspan(2)
            .height(Widgets.HEIGHT)
            .growX()
            .row();
      }
    }
    rooms(into);
    lan(into, s);
    for (int i = 0; i < known.size(); i++) {
      KnownServer server = known.get(i);
      boolean favourite = i < s.get(PlayerSettings.FAVOURITES).size();
      if (i == 0 || i == s.get(PlayerSettings.FAVOURITES).size()) {
        String heading = favourite ? "Favourites" : "Played lately";
        into.add(widgets.muted(heading)).colspan(2).padTop(8).row();
      }
      line(into, server.text(), server.text(), widgets.muted(server.about()), s);
    }
  }

  private void lan(Table into, PlayerSettings s) {
    into.add(widgets.muted("On this network")).colspan(2).padTop(8).row();
    lanLabels.clear();
    for (LanServer server : lan) {
      String address = server.address().toText();
      Label about = widgets.muted(KnownServer.describe(server));
      lanLabels.add(about);
      String name = server.status().name();
      line(into, address, name.isEmpty() ? address : name + "  (" + address + ")", about, s);
    }
    if (lan.isEmpty()) {
      String none = search == null ? "the network can't be searched" : "no server has answered yet";
      into.add(widgets.small(none)).colspan(2).row();
    }
  }

  private void rooms(Table into) {
    for (RoomEntry room : rooms) {
      String text =
          String.format(
              Locale.ROOT,
              "%s     %s, %s     %d/%d     %s",
              room.name(),
              room.game(),
              room.level(),
              room.players(),
              room.places(),
              room.phase());
      into.add(widgets.row(text.stripTrailing(), () -> join(room.name())))
          .colspan(2)
          .height(Widgets.HEIGHT)
          .growX()
          .row();
    }
  }

  /** Adds a server that can be joined, kept among the favourites and taken from them. */
  private void line(Table into, String server, String shown, Label about, PlayerSettings s) {
    Table line = new Table();
    line.defaults().height(Widgets.HEIGHT).space(6);
    TextButton row = widgets.row(shown, about, () -> joinAt(server));
    row.setName(server); // keeps the focus when other servers come and go
    line.add(row).growX().minWidth(0);
    String verb = s.get(PlayerSettings.FAVOURITES).contains(server) ? "forget" : "keep";
    TextButton toggle = widgets.button(verb, () -> toggle(server));
    toggle.setName(verb + server);
    line.add(toggle).width(STAR_WIDTH);
    into.add(line).colspan(2).growX().row();
  }

  /** Asks all servers of the lists what they play. */
  private void ask(PlayerSettings s) {
    List<String> servers = new ArrayList<>(s.get(PlayerSettings.FAVOURITES));
    s.get(PlayerSettings.RECENT).stream()
        .filter(server -> !servers.contains(server))
        .forEach(servers::add);
    servers.forEach(server -> known.add(new KnownServer(server, target::browse)));
  }

  private void joinAt(String server) {
    address.setText(server);
    join("");
  }

  private void toggle(String server) {
    host.change(host.settings().withFavouriteToggled(server));
    known.forEach(KnownServer::close);
    known.clear();
    rebuild.run();
  }

  @Override
  public void submit() {
    join("");
  }

  /** Joins a room, or any if its name is empty. */
  private void join(String room) {
    ServerAddress server = server();
    if (server != null) {
      target.password(server, typedPassword(server));
      target.play(server, room);
    }
  }

  private void watch() {
    ServerAddress server = server();
    if (server != null) {
      progress = "Asking " + server + " for its game ...";
      rebuild.run();
      target.password(server, typedPassword(server));
      target.watch(server, 1);
    }
  }

  /** Returns what the player typed for this server; a password is shown to no other one. */
  private String typedPassword(ServerAddress server) {
    if (password == null || !server.equals(asking)) {
      asking = server;
      asksPassword = false;
      password = null;
      return "";
    }
    return password.getText().strip();
  }

  /** Asks the server for its rooms; they show when they arrive. */
  private void browse() {
    ServerAddress server = server();
    if (server != null && browser == null) {
      progress = "Asking " + server + " ...";
      rooms = List.of();
      browser = target.browse(server);
      rebuild.run();
    }
  }

  /** Keeps name and party, and returns the server, or null after saying what is wrong. */
  private ServerAddress server() {
    try {
      host.playerName(name.getText().strip());
      host.party(party.getText().strip());
      message = "";
      return ServerAddress.parse(address.getText());
    } catch (IllegalArgumentException e) {
      message = e.getMessage();
      rebuild.run();
      return null;
    }
  }

  @Override
  public boolean update(long nowNs) {
    boolean changed = updateLan();
    for (KnownServer server : known) {
      changed |= server.update(nowNs);
    }
    if (browser != null) {
      browser.update(nowNs);
      if (browser.isDone()) {
        message = browser.problem();
        progress = "";
        rooms = browser.rooms();
        browser = null;
        changed = true;
      }
    }
    return changed;
  }

  /** Takes in what was found. Returns whether other servers are to be shown than before. */
  private boolean updateLan() {
    List<LanServer> found = search == null ? lan : search.servers();
    if (found == lan) {
      return false;
    }
    boolean same = addresses(found).equals(addresses(lan)) && lanLabels.size() == found.size();
    lan = found;
    for (int i = 0; same && i < found.size(); i++) {
      lanLabels.get(i).setText(KnownServer.describe(found.get(i)));
    }
    return !same;
  }

  private static List<ServerAddress> addresses(List<LanServer> servers) {
    return servers.stream().map(LanServer::address).toList();
  }

  @Override
  public void close() {
    if (search != null) {
      search.close();
      search = null;
    }
    lan = List.of();
    known.forEach(KnownServer::close);
    known.clear();
    rooms = List.of();
    message = "";
    progress = "";
    if (browser != null) {
      browser.close();
      browser = null;
    }
  }
}
