package carom.plain;

/** Says where the room goes on if this server is lost: join there with your secret and the room. */
public final class Standby {
  /** Host, TCP port and perhaps UDP port, {@code host:tcp:udp}; empty for nowhere. */
  public String server;

  /** Creates one to be filled in. */
  public Standby() {}
}
