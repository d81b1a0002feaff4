package carom.client.link;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;

/**
 * A question to a server, over a link of its own and without joining. It never waits; call {@link
 * #update} until {@link #isDone}. One thread.
 */
public abstract class ServerQuestion implements LinkHandler, AutoCloseable {
  /** Longest time in which a link opens; links have deadlines of their own for each step. */
  private static final long TIMEOUT_NS = 120_000_000_000L;

  private final ServerAddress address;
  private final ClientTransport transport;
  private final long answerNs;
  private Link link;
  private boolean asked;
  private boolean done;
  private String outcome = "";
  private long nowNs;
  private long heardNs;

  /**
   * Creates a question that is asked at the first {@link #update}.
   *
   * @param transport opens the link; stays the caller's
   * @param answerNs longest silence of the server once it was asked
   */
  protected ServerQuestion(ServerAddress address, ClientTransport transport, long answerNs) {
    this.address = address;
    this.transport = transport;
    this.answerNs = answerNs;
  }

  /** Sends the question over the open link. */
  protected abstract void ask(Link open);

  /** Takes a message; returns whether it is an answer. */
  protected abstract boolean answered(Object message);

  /** Sends what is due after messages of the server. */
  protected void goOn(Link open) {}

  /** Does what is due. */
  public final void update(long timeNs) {
    nowNs = timeNs;
    if (done) {
      return;
    }
    if (link == null) {
      heardNs = nowNs;
      link = transport.connect(address.host(), address.tcpPort(), address.udpPort());
    }
    if (!asked && link.state() == Link.State.OPEN) {
      asked = true;
      heardNs = nowNs;
      ask(link);
    }
    link.poll(this, 64);
    if (!done) {
      goOn(link);
      if (nowNs - heardNs > (asked ? answerNs : TIMEOUT_NS)) {
        end("No answer from " + address + ". Check the address; is the server running?");
      }
    }
  }

  /** Ends with what has come of the question, in words for the player or empty. */
  protected final void end(String words) {
    done = true;
    outcome = words;
    if (link != null) {
      if (link.state() == Link.State.OPEN) {
        link.send(new ClientMessage.Leave());
      }
      link.close("has its answer");
    }
  }

  @Override
  public final void message(Link from, Object message) {
    if (done) {
      return;
    }
    if (message instanceof ServerMessage.Refused refused) {
      end(refused.playerText());
    } else if (message instanceof ServerMessage.Goodbye goodbye) {
      end(goodbye.playerText());
    } else if (!answered(message)) {
      end(address + " answers something else. Is it a Carom server?");
    }
  }

  @Override
  public final void datagram(Link from, byte[] bytes, int length) {
    // The server sends none before a game is joined.
  }

  @Override
  public final void closed(Link from, String reason) {
    if (!done) {
      end((asked ? "The link to " : "Can't reach ") + address + ": " + reason);
    }
  }

  /** Returns whether the answer is here, or none will come. */
  public final boolean isDone() {
    return done;
  }

  /** Returns the server. */
  protected final ServerAddress address() {
    return address;
  }

  /** Returns the time of the latest {@link #update}, ns. */
  protected final long nowNs() {
    return nowNs;
  }

  /** Begins the server's silence anew, because it goes on. */
  protected final void heard() {
    heardNs = nowNs;
  }

  /** Returns with which words it ended. */
  protected final String outcome() {
    return outcome;
  }

  /** Leaves the server if it hasn't answered yet. */
  @Override
  public void close() {
    if (link != null && !done) {
      end("");
    }
  }
}
