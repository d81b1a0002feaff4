package carom.lab.attack;

import carom.client.bots.PlainDoor;
import carom.client.bots.ThinDoor;
import carom.client.bots.WebDoor;
import java.io.IOException;
import java.util.List;

/** A port of the server that is flooded; the names are those of the flag. */
enum AttackedDoor {
  own,
  plain,
  web;

  /** Adds the flag that opens the port. Returns the port, or 0 for that of Carom's own clients. */
  int open(List<String> flags) throws IOException {
    int port = this == own ? 0 : ServerProcess.freePort();
    if (this == plain) {
      flags.add("--plain-port=" + port);
    } else if (this == web) {
      flags.add("--play-port=" + port);
    }
    return port;
  }

  /** Returns what connects honest players to the port, which isn't that of own clients. */
  ThinDoor.Opener opener(int port) throws IOException {
    return this == plain
        ? PlainDoor.opener("127.0.0.1", port, 0)
        : WebDoor.opener("ws://127.0.0.1:" + port + "/thin", true);
  }
}
