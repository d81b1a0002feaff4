package carom.net.kryo;

import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * Failure to open a server's port. The message tells the operator which port, why, and which flag
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

  /** Returns the protocol, {@code TCP} or {@code UDP}. */
  public String protocol() {
    return protocol;
  }

  /** Returns the requested port, 1..65,535, or 0 when the system had no free one. */
  public int port() {
    return port;
  }
}
