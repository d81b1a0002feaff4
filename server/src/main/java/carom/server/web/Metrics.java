package carom.server.web;

import carom.net.protocol.Protocol;
import carom.net.transport.NetworkCounter;
import carom.server.access.LoginThrottle;
import carom.server.fleet.FleetFigures;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.Figure;
import carom.server.metrics.TurnStage;
import carom.server.room.Room;
import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.Meter;
import io.micrometer.core.instrument.Tag;
import io.micrometer.core.instrument.Tags;
import io.micrometer.core.instrument.binder.jvm.JvmGcMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics;
import io.micrometer.core.instrument.binder.system.ProcessorMetrics;
import io.micrometer.core.instrument.binder.system.UptimeMetrics;
import io.micrometer.prometheusmetrics.PrometheusConfig;
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry;
import io.prometheus.metrics.model.registry.Collector;
import io.prometheus.metrics.model.snapshots.ClassicHistogramBuckets;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.HistogramSnapshot;
import io.prometheus.metrics.model.snapshots.InfoSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * All counters as metrics for Prometheus: each room's with the label {@code room}, the transport's,
 * tick times as a histogram, the fleet's, the build, failed logins, memory, garbage collection,
 * threads and processor. Values are read when they are asked for. Any thread.
 */
final class Metrics implements AutoCloseable {
  private static final String PREFIX = "carom.";
  private static final double NS_PER_S = 1e9;
  private static final long[] TICK_LIMITS_NS = {
    250_000,
    500_000,
    1_000_000,
    2_000_000,
    4_000_000,
    8_000_000,
    12_000_000,
    16_666_667,
    33_333_333,
    100_000_000,
    1_000_000_000
  };

  /** Kept here, because the registry doesn't keep what it reads. */
  private final WebSubject subject;

  /** Kept for the same reason. */
  private final List<Figure> figures = new ArrayList<>();

  /** The meters of each room. */
  private final Map<Room, List<Meter>> meters = new HashMap<>();

  private final JvmGcMetrics collections = new JvmGcMetrics();

  private final PrometheusMeterRegistry registry =
      new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);

  /** Creates the metrics of a server. */
  Metrics(WebSubject subject) {
    this.subject = subject;
    for (NetworkCounter counter : this.subject.network()) {
      FunctionCounter.builder(
              PREFIX + "network." + counter.name(), counter, c -> c.value().getAsLong())
          .description(counter.help())
          .register(registry);
    }
    addLogins("page", subject.logins().page());
    addLogins("rcon", subject.logins().rcon());
    Gauge.builder("process.resident.memory", ProcessFigures::resident)
        .baseUnit("bytes")
        .description("Memory of the machine that the process takes; NaN where unknown.")
        .register(registry);
    registry.getPrometheusRegistry().register((Collector) () -> tickTimes(subject.rooms()));
    registry.getPrometheusRegistry().register((Collector) () -> build(subject.version()));
    if (subject.fleet() != null) {
      add("fleet.", subject.fleet().all());
      registry.getPrometheusRegistry().register((Collector) () -> lags(subject.fleet()));
      registry
          .getPrometheusRegistry()
          .register((Collector) () -> takeovers(subject.fleet().takeovers()));
    }
    add("", subject.figures());
    new JvmMemoryMetrics().bindTo(registry);
    collections.bindTo(registry);
    new JvmThreadMetrics().bindTo(registry);
    new ProcessorMetrics().bindTo(registry);
    new UptimeMetrics().bindTo(registry);
  }

  /** Adds the meters of rooms that have come, and removes those of rooms that have gone. */
  private synchronized void followRooms() {
    List<Room> now = List.copyOf(subject.rooms());
    for (Iterator<Map.Entry<Room, List<Meter>>> i = meters.entrySet().iterator(); i.hasNext(); ) {
      Map.Entry<Room, List<Meter>> known = i.next();
      if (!now.contains(known.getKey())) {
        known.getValue().forEach(registry::remove);
        i.remove();
      }
    }
    for (Room room : now) {
      meters.computeIfAbsent(room, this::add);
    }
  }

  private List<Meter> add(Room room) {
    List<Meter> added = new ArrayList<>();
    Tags tags = Tags.of(Tag.of("room", room.name()));
    for (Counter counter : Counter.values()) {
      String name = PREFIX + counter.name().toLowerCase(Locale.ROOT).replace('_', '.');
      if (counter.isGauge()) {
        added.add(
            Gauge.builder(name, room.counters(), counters -> counters.get(counter))
                .tags(tags)
                .description(counter.help())
                .register(registry));
      } else {
        added.add(
            FunctionCounter.builder(name, room.counters(), counters -> counters.get(counter))
                .tags(tags)
                .description(counter.help())
                .register(registry));
      }
    }
    for (TurnStage stage : TurnStage.values()) {
      added.add(
          FunctionCounter.builder(
                  PREFIX + "stage.seconds", room.stages(), times -> times.totalNs(stage) / NS_PER_S)
              .tags(tags.and("stage", stage.name().toLowerCase(Locale.ROOT)))
              .description("Time that the stages of the room's turns have taken.")
              .register(registry));
    }
    added.add(
        Gauge.builder(PREFIX + "places", room, r -> r.seats().count())
            .tags(tags)
            .description("Seats of the room.")
            .register(registry));
    added.add(
        Gauge.builder(PREFIX + "room.failed", room, r -> r.hasFailed() ? 1 : 0)
            .tags(tags)
            .description("1 if the room has closed itself because of an error.")
            .register(registry));
    return added;
  }

  private void add(String prefix, List<Figure> added) {
    figures.addAll(added);
    for (Figure figure : added) {
      String name = PREFIX + prefix + figure.name();
      if (figure.isGauge()) {
        Gauge.builder(name, figure, f -> f.value().getAsDouble())
            .description(figure.help())
            .register(registry);
      } else {
        FunctionCounter.builder(name, figure, f -> f.value().getAsDouble())
            .description(figure.help())
            .register(registry);
      }
    }
  }

  private static GaugeSnapshot lags(FleetFigures figures) {
    GaugeSnapshot.Builder all =
        GaugeSnapshot.builder()
            .name("carom_fleet_follower_lag_ticks")
            .help("Ticks that the follower of a room may lack; nothing for rooms without one.");
    figures
        .lags()
        .forEach(
            (room, lag) ->
                all.dataPoint(
                    GaugeSnapshot.GaugeDataPointSnapshot.builder()
                        .labels(Labels.of("room", room))
                        .value(lag)
                        .build()));
    return all.build();
  }

  private static HistogramSnapshot takeovers(FleetFigures.Durations times) {
    ClassicHistogramBuckets.Builder buckets = ClassicHistogramBuckets.builder();
    for (int i = 0; i < times.limits().size(); i++) {
      buckets.bucket(times.limits().get(i), times.counts().get(i));
    }
    return HistogramSnapshot.builder()
        .name("carom_fleet_takeover_duration_seconds")
        .help("Time from the end of an owner's claim until its room went on at this server.")
        .dataPoint(
            HistogramSnapshot.HistogramDataPointSnapshot.builder()
                .classicHistogramBuckets(buckets.build())
                .sum(times.sum())
                .build())
        .build();
  }

  private void addLogins(String door, LoginThrottle throttle) {
    FunctionCounter.builder(PREFIX + "logins.failed", throttle, LoginThrottle::wrongTries)
        .tags(Tags.of("door", door))
        .description("Logins of operators with a wrong token or password.")
        .register(registry);
  }

  private static InfoSnapshot build(String version) {
    Labels labels =
        Labels.of(
            "version",
            version,
            "protocol",
            Integer.toString(Protocol.VERSION),
            "java",
            Runtime.version().toString());
    return InfoSnapshot.builder()
        .name("carom_build")
        .help("The build that runs, with the version of its network protocol and of Java.")
        .dataPoint(InfoSnapshot.InfoDataPointSnapshot.builder().labels(labels).build())
        .build();
  }

  private static HistogramSnapshot tickTimes(List<Room> rooms) {
    HistogramSnapshot.Builder all =
        HistogramSnapshot.builder()
            .name("carom_tick_duration_seconds")
            .help("Time that simulation steps took, with snapshots.");
    for (Room room : rooms) {
      Counters.TickHistogram times = room.counters().histogram(TICK_LIMITS_NS);
      ClassicHistogramBuckets.Builder buckets = ClassicHistogramBuckets.builder();
      long below = 0;
      for (int i = 0; i < TICK_LIMITS_NS.length; i++) {
        buckets.bucket(TICK_LIMITS_NS[i] / NS_PER_S, times.atMost().get(i) - below);
        below = times.atMost().get(i);
      }
      buckets.bucket(Double.POSITIVE_INFINITY, times.count() - below);
      all.dataPoint(
          HistogramSnapshot.HistogramDataPointSnapshot.builder()
              .labels(Labels.of("room", room.name()))
              .classicHistogramBuckets(buckets.build())
              .sum(times.sumNs() / NS_PER_S)
              .build());
    }
    return all.build();
  }

  /** Returns all metrics in Prometheus' text format. */
  String scrape() {
    followRooms();
    return registry.scrape();
  }

  /** Stops listening to the garbage collector. */
  @Override
  public void close() {
    collections.close();
  }
}
