package carom.lab.figures;

import carom.client.InputSource;
import carom.fixtures.BigWorlds;
import carom.lab.measure.Figure;
import carom.net.protocol.ProtocolLimits;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Stepper;
import java.util.List;

/** Measures the traffic of an idle player in a world at rest, headers included. Virtual time. */
final class RestFigures {
  private static final double REACH_KBIT = 3;

  private RestFigures() {}

  static List<Figure> measure(boolean quick) {
    double seconds = quick ? 5 : 30;
    try (Stepper stepper = Stepper.of(BigWorlds.crates(1_000, 60, 5), ServerConfig.defaults())) {
      stepper.join("idle", Impairment.NONE.withLatency(30, 0), InputSource.IDLE);
      stepper.run(4);
      long down = stepper.count(Counter.SNAPSHOT_BYTES);
      long downDatagrams = stepper.count(Counter.DATAGRAMS_OUT);
      long up = stepper.count(Counter.BYTES_IN);
      long upDatagrams = stepper.count(Counter.DATAGRAMS_IN);
      stepper.run(seconds);
      down = stepper.count(Counter.SNAPSHOT_BYTES) - down;
      downDatagrams = stepper.count(Counter.DATAGRAMS_OUT) - downDatagrams;
      up = stepper.count(Counter.BYTES_IN) - up;
      upDatagrams = stepper.count(Counter.DATAGRAMS_IN) - upDatagrams;
      return List.of(
          figure("to the client", down, downDatagrams, seconds),
          figure("to the server", up, upDatagrams, seconds));
    }
  }

  private static Figure figure(String direction, long bytes, long datagrams, double seconds) {
    double kbit =
        (bytes + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES * datagrams) * 8 / seconds / 1_000;
    return Figure.atMost(REACH_KBIT, "at rest, 1,000 bodies, " + direction, kbit, "kbit/s")
        .withNote("%.1f datagrams a second, IP, UDP and frame included", datagrams / seconds);
  }
}
