package carom.server.command;

import java.io.IOException;

/** Brings saved matches of other servers. */
public interface SaveSource {
  /** The source of a server without a fleet. */
  SaveSource NONE = name -> "";

  /**
   * Brings the newest save of a name to this server's own, if another server has it. It may take
   * seconds.
   *
   * @return the server that had it; empty if this server's own save, or none, is the newest
   * @throws IOException if it can't be brought; the message says why
   */
  String bring(String name) throws IOException;
}
