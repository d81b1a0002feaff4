package carom.physics.dynamics.domain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import carom.physics.threads.WorkerThreads;
import carom.physics.threads.Workers;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each part runs once and in an order that domains allow, on any thread. */
final class DomainPhasesTest {
  /** One thread for all tasks, the last one first. */
  private record Backwards(int count) implements Workers {
    @Override
    public void run(int tasks, Task task) {
      for (int i = tasks - 1; i >= 0; i--) {
        task.run(i, 0);
      }
    }
  }

  /** Counts parts, and complains of those that come too early. */
  private static final class Watch {
    final int domains;
    final AtomicIntegerArray inner;
    final AtomicIntegerArray border;
    final AtomicInteger faults = new AtomicInteger();

    Watch(int domains) {
      this.domains = domains;
      inner = new AtomicIntegerArray(domains);
      border = new AtomicIntegerArray(domains);
    }

    void part(int phase, int domain, boolean isBorder) {
      AtomicIntegerArray mine = isBorder ? border : inner;
      boolean fault = mine.get(domain) != phase;
      fault |= border.get(domain) != phase || inner.get(domain) != (isBorder ? phase + 1 : phase);
      for (int other = 0; other < domains && isBorder; other++) {
        fault |= border.get(other) < phase;
      }
      if (fault) {
        faults.incrementAndGet();
      }
      mine.incrementAndGet(domain);
    }
  }

  private static void watch(Workers workers, int domains, int phases, Watch watch) {
    DomainPhases schedule = new DomainPhases();
    for (int round = 0; round < 200; round++) {
      schedule.divide(domains, workers);
      for (int i = 0; i < phases; i++) {
        schedule.add((n, d, border, worker) -> watch.part(n, d, border), round * phases + i);
      }
      schedule.run();
    }
    assertEquals(0, watch.faults.get());
    for (int d = 0; d < domains; d++) {
      assertEquals(200 * phases, watch.inner.get(d));
      assertEquals(200 * phases, watch.border.get(d));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5})
  void everyPartIsDoneOnceAndBordersWaitForThoseBefore(int domains) {
    for (int phases : new int[] {1, 2, 7, 100}) {
      watch(new Backwards(domains), domains, phases, new Watch(domains));
      try (WorkerThreads workers = new WorkerThreads(domains)) {
        watch(workers, domains, phases, new Watch(domains));
      }
    }
  }

  @Test
  void fewerThreadsThanDomainsDoAllOfThem() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      watch(workers, 6, 20, new Watch(6));
    }
  }

  /** One thread has the last domain done before it begins with the first one. */
  @Test
  void whoHasNoBorderWaitsForNobody() {
    DomainPhases schedule = new DomainPhases();
    schedule.divide(2, new Backwards(2));
    StringBuilder order = new StringBuilder();
    for (int i = 0; i < 3; i++) {
      schedule.add(
          new DomainPhases.Phase() {
            @Override
            public void run(int number, int domain, boolean border, int worker) {
              order.append(border ? (char) ('A' + domain) : (char) ('a' + domain));
            }

            @Override
            public boolean hasBorder(int number, int domain) {
              return domain == 0;
            }
          },
          i);
    }
    schedule.run();
    assertEquals("bBbBbBaAaAaA", order.toString());
  }

  @Test
  void nothingAddedIsNothingDone() {
    DomainPhases schedule = new DomainPhases();
    schedule.run();
    schedule.divide(3, new Backwards(3));
    schedule.run();
  }

  /**
   * A ring of cells, in plain memory, of which each domain has a stretch; cells at its ends look at
   * the neighbour's.
   */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void whatBordersWriteTheOthersRead(long seed) {
    Random random = new Random(seed);
    int domains = 2 + random.nextInt(3);
    int stretch = 3 + random.nextInt(40);
    long[][] cells = new long[2][domains * stretch];
    DomainPhases.Phase phase =
        (n, d, border, worker) -> {
          long[] from = cells[n & 1];
          long[] to = cells[1 - (n & 1)];
          int first = d * stretch;
          int last = first + stretch - 1;
          for (int i = border ? first : first + 1; i <= last; i += border ? stretch - 1 : 1) {
            if (border || i < last) {
              int before = (i + from.length - 1) % from.length;
              to[i] = from[i] * 31 + from[before] * 7 + from[(i + 1) % from.length];
            }
          }
        };
    long[] alone = mix(new Backwards(domains), domains, cells, phase);
    try (WorkerThreads workers = new WorkerThreads(domains)) {
      assertArrayEquals(alone, mix(workers, domains, cells, phase), "seed=" + seed);
    }
  }

  private static long[] mix(
      Workers workers, int domains, long[][] cells, DomainPhases.Phase phase) {
    for (int i = 0; i < cells[0].length; i++) {
      cells[0][i] = i;
      cells[1][i] = 0;
    }
    DomainPhases schedule = new DomainPhases();
    schedule.divide(domains, workers);
    for (int round = 0; round < 500; round++) {
      for (int n = 0; n < 20; n++) {
        schedule.add(phase, n);
      }
      schedule.run();
    }
    return cells[0].clone();
  }

  /** A thread stands still in the middle of a part: threads that wait leave, and all is done. */
  @Test
  void aThreadThatStandsStillHoldsNoOtherForEver() {
    try (WorkerThreads workers = new WorkerThreads(3)) {
      AtomicInteger parts = new AtomicInteger();
      DomainPhases schedule = new DomainPhases();
      schedule.divide(3, workers);
      for (int i = 0; i < 12; i++) {
        schedule.add(
            (n, d, border, worker) -> {
              if (border && n % 3 == d) {
                LockSupport.parkNanos(3_000_000);
              }
              parts.incrementAndGet();
            },
            i);
      }
      schedule.run();
      assertEquals(12 * 3 * 2, parts.get());
    }
  }

  @Test
  void anExceptionSurfacesAndTheNextRunIsSound() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      for (Workers each : new Workers[] {workers, new Backwards(2)}) {
        IllegalStateException thrown = new IllegalStateException("as planned");
        DomainPhases schedule = new DomainPhases();
        schedule.divide(2, each);
        for (int i = 0; i < 5; i++) {
          schedule.add(
              (n, d, border, worker) -> {
                if (n == 2 && d == 1 && border) {
                  throw thrown;
                }
              },
              i);
        }
        assertSame(thrown, assertThrows(IllegalStateException.class, schedule::run));
        AtomicInteger parts = new AtomicInteger();
        schedule.divide(2, each);
        schedule.add((n, d, border, worker) -> parts.incrementAndGet(), 0);
        schedule.run();
        assertEquals(4, parts.get());
      }
    }
  }
}
