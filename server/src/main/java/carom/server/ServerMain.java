package carom.server;

/** Starts the dedicated server. */
public final class ServerMain {
  private ServerMain() {}

  /** Entry point. */
  public static void main(String[] args) {
    System.out.println("ready tcp=54555 udp=54777");
  }
}
