package carom.net.kryo;

import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * A server's port can't be opened. The message is for the operator: which port, why, and which flag
 * chooses another one.
 */
public final class PortUnavailableException extends UncheckedIOException {
  private static final long serialVersionUID = 1;

  private final String protocol;
  private final int port;

  PortUnavailableException(String protocol, int port, String message, IOException cause) {
    super(message, cause);
    this.protocol = protocol;
    this.port = port;
  }

  /** {@code TCP} or {@code UDP}. */
  public String protocol() {
    return protocol;
  }

  /** Returns the port that was asked for, 1..65,535; 0 when the system had no free one. */
  public int port() {
    return port;
  }
}
