package carom.server.access;

import carom.net.protocol.RefusalReason;
import carom.server.config.DataFolder;
import java.io.IOException;
import java.nio.file.Path;
import java.time.InstantSource;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * The bans, the list of players who alone may play if the operator wants that, and the admins. They
 * are files in the data folder, see {@link AccessFile}. Any thread may use this.
 */
public final class AccessLists implements EntryRule {
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm 'UTC'", Locale.ROOT).withZone(ZoneOffset.UTC);

  private final AccessFile bans;
  private final AccessFile allowed;
  private final AccessFile admins;
  private final AtomicBoolean changed = new AtomicBoolean();
  private volatile boolean onlyAllowed;
  private final InstantSource clock;
  private volatile JoinTokens tokens;

  /**
   * Reads the files.
   *
   * @param onlyAllowed whether only players of the second list may play
   * @param clock tells when bans end
   * @throws IOException if a file is there but can't be read; the message says what to do
   */
  public AccessLists(DataFolder data, boolean onlyAllowed, InstantSource clock) throws IOException {
    this.onlyAllowed = onlyAllowed;
    this.clock = clock;
    bans =
        new AccessFile(
            data.root().resolve("bans.txt"),
            "# Who may not play. The server reads this file again when it changes.",
            true);
    allowed =
        new AccessFile(
            data.root().resolve("allow.txt"),
            "# Who may play, if allow-list = true. The server reads this file again when it"
                + " changes.",
            true);
    admins =
        new AccessFile(
            data.root().resolve("admin.txt"),
            "# Who may give the server's commands in the chat. The server reads this file again"
                + " when it changes.",
            false);
  }

  AccessFile bans() {
    return bans;
  }

  AccessFile allowed() {
    return allowed;
  }

  AccessFile admins() {
    return admins;
  }

  /**
   * Returns whether a player may give commands in the chat.
   *
   * @param account the player's account by its join token, or empty
   * @param remote address and port, as the link tells them
   */
  boolean isAdmin(String account, String remote) {
    byte[] address = AddressRange.addressOf(remote).orElse(null);
    for (AccessEntry admin : admins.entries()) {
      if (admin.covers(null, account, address, clock.instant())) {
        return true;
      }
    }
    return false;
  }

  /** Returns the lists, to keep them the same on several servers. */
  public List<SharedList> shared() {
    return List.of(
        new Shared("bans", bans), new Shared("allow", allowed), new Shared("admin", admins));
  }

  /** A list that other servers change, too. */
  private final class Shared implements SharedList {
    private final String name;
    private final AccessFile file;

    Shared(String name, AccessFile file) {
      this.name = name;
      this.file = file;
    }

    @Override
    public String name() {
      return name;
    }

    @Override
    public Map<String, String> lines() {
      Map<String, String> lines = new HashMap<>();
      file.entries().forEach(entry -> lines.put(entry.subject(), entry.line()));
      return lines;
    }

    @Override
    public String subjectOf(String line) {
      return file.parse(line).subject();
    }

    @Override
    public void change(Map<String, String> lines) throws IOException {
      List<AccessEntry> added = new ArrayList<>();
      lines.values().stream().filter(Objects::nonNull).forEach(l -> added.add(file.parse(l)));
      file.change(entry -> lines.containsKey(entry.subject()), added);
      changed.set(true); // for the thread that removes players
    }
  }

  boolean onlyAllowed() {
    return onlyAllowed;
  }

  InstantSource clock() {
    return clock;
  }

  /** Reads the files that have changed again, and returns whether anything has. */
  boolean reloadIfChanged() {
    boolean bansChanged = bans.reloadIfChanged();
    boolean adminsChanged = admins.reloadIfChanged();
    boolean allowedChanged = allowed.reloadIfChanged();
    return changed.getAndSet(false) || allowedChanged || bansChanged || adminsChanged;
  }

  /** Sets whether only players of the list may play. Others are removed within a second. */
  public void onlyAllowed(boolean only) {
    if (only != onlyAllowed) {
      onlyAllowed = only;
      changed.set(true);
    }
  }

  /** Reads the files that have changed again, and returns how many entries they have. */
  public String reload() {
    if (reloadIfChanged()) {
      changed.set(true); // for the thread that removes players
    }
    return String.format(
        Locale.ROOT,
        "in force: bans %d, allowed %d, admins %d",
        bans.entries().size(),
        allowed.entries().size(),
        admins.entries().size());
  }

  /**
   * Demands join tokens from now on, or none if there is no key.
   *
   * @param key PEM file with the backend's public key, or null
   * @param fingerprint of this server's key
   * @param uses seats that one account may have at a time, 0 = any number
   * @throws IOException if the file has no such key; the message says how to make one
   */
  public void demandTokens(Path key, String fingerprint, int uses) throws IOException {
    tokens = key == null ? null : JoinTokens.load(key, fingerprint, uses, clock);
  }

  @Override
  public JoinTokens tokens() {
    return tokens;
  }

  @Override
  public Refusal refusal(String name, String account, String remote) {
    byte[] address = AddressRange.addressOf(remote).orElse(null);
    for (AccessEntry ban : bans.entries()) {
      if (ban.covers(name, account, address, clock.instant())) {
        return new Refusal(RefusalReason.BANNED, describe(ban));
      }
    }
    if (onlyAllowed
        && allowed.entries().stream()
            .noneMatch(entry -> entry.covers(name, account, address, clock.instant()))) {
      return new Refusal(RefusalReason.NOT_ALLOWED, "");
    }
    return null;
  }

  /** Returns reason and end of a ban, for the player. */
  private static String describe(AccessEntry ban) {
    String reason = ban.reason().isEmpty() ? "" : "Reason: " + ban.reason() + ". ";
    return (reason + (ban.until() == null ? "" : "Until " + TIME.format(ban.until()) + "."))
        .strip();
  }
}
