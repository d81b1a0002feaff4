package carom.testkit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.transport.Link;
import org.junit.jupiter.api.Test;

/** Lines that die. */
final class OutageLinkTest {
  @Test
  void aLinkThatNeverWasCanBeClosedTwice() {
    OutageLink link =
        new OutageLink(
            () -> {
              throw new AssertionError("connects although it was closed");
            },
            true);
    link.close("gives up");
    link.lineReturns();
    link.close("once more");
    assertEquals(Link.State.CLOSED, link.state());
    assertEquals("gives up", link.closeReason());
  }
}
