package carom.server.web;

import carom.server.recording.RecordingFile;
import io.undertow.io.IoCallback;
import io.undertow.io.Sender;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Recordings for those who know the secret. A browser downloads by an address alone, so it gets one
 * with a random ticket that is good for one download within {@value #TICKET_S} seconds. Any thread.
 */
final class Downloads {
  private static final Logger LOG = LoggerFactory.getLogger(Downloads.class);

  /** Begin of the addresses. */
  static final String PATH = "/recordings/";

  private static final int TICKET_S = 30;
  private static final int TICKET_BYTES = 24;
  private static final int MAX_TICKETS = 64;
  private static final int MAX_FILES = 500;
  private static final long NS_PER_S = 1_000_000_000L;

  private final List<Path> folders;
  private final LongSupplier clock;
  private final SecureRandom random = new SecureRandom();
  private final Map<String, Ticket> tickets = new LinkedHashMap<>();

  private record Ticket(Path file, long endNs) {}

  /**
   * A recording.
   *
   * @param name name of the file
   * @param bytes its size
   * @param changedMs when it was written last, ms since 1970
   */
  record Recording(String name, long bytes, long changedMs) {}

  /**
   * Creates the downloads of some folders.
   *
   * @param folders may name one folder twice: {@code --record} often names that of the data folder
   * @param clock monotonic nanoseconds
   */
  Downloads(List<Path> folders, LongSupplier clock) {
    this.folders =
        folders.stream().map(folder -> folder.toAbsolutePath().normalize()).distinct().toList();
    this.clock = clock;
  }

  /** Returns the recordings, the youngest first. */
  List<Recording> list() {
    List<Recording> found = new ArrayList<>();
    for (Path folder : folders) {
      try (Stream<Path> files = Files.isDirectory(folder) ? Files.list(folder) : Stream.empty()) {
        for (Path file : (Iterable<Path>) files.filter(Downloads::isRecording)::iterator) {
          found.add(
              new Recording(
                  file.getFileName().toString(),
                  Files.size(file),
                  Files.getLastModifiedTime(file).toMillis()));
        }
      } catch (IOException e) {
        LOG.debug("{} can't be listed: {}", folder, e.toString());
      }
    }
    found.sort(Comparator.comparingLong(Recording::changedMs).reversed());
    return List.copyOf(found.subList(0, Math.min(MAX_FILES, found.size())));
  }

  private static boolean isRecording(Path file) {
    return file.getFileName().toString().endsWith(RecordingFile.SUFFIX)
        && Files.isRegularFile(file);
  }

  /** Returns the address of one download, or null if there is no such recording. */
  synchronized String ticket(String name) {
    for (Path folder : folders) {
      // The name is looked for in the folder, so that it can't lead out of it.
      try (Stream<Path> files = Files.isDirectory(folder) ? Files.list(folder) : Stream.empty()) {
        Path file =
            files
                .filter(path -> isRecording(path) && path.getFileName().toString().equals(name))
                .findFirst()
                .orElse(null);
        if (file != null) {
          byte[] bytes = new byte[TICKET_BYTES];
          random.nextBytes(bytes);
          String ticket = Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
          tickets.values().removeIf(other -> other.endNs - clock.getAsLong() < 0);
          if (tickets.size() >= MAX_TICKETS) {
            tickets.remove(tickets.keySet().iterator().next());
          }
          tickets.put(ticket, new Ticket(file, clock.getAsLong() + TICKET_S * NS_PER_S));
          return PATH + "?ticket=" + ticket;
        }
      } catch (IOException e) {
        LOG.debug("{} can't be listed: {}", folder, e.toString());
      }
    }
    return null;
  }

  private synchronized Path redeem(String text) {
    Ticket ticket = text == null ? null : tickets.remove(text);
    return ticket == null || ticket.endNs - clock.getAsLong() < 0 ? null : ticket.file;
  }

  /** Sends the file of a ticket, on the thread that reads and writes sockets. */
  void send(HttpServerExchange exchange) {
    Deque<String> given = exchange.getQueryParameters().get("ticket");
    Path file = redeem(given == null ? null : given.peekFirst());
    if (file == null) {
      exchange.setStatusCode(StatusCodes.FORBIDDEN);
      exchange.getResponseSender().send("the ticket is used or too old\n");
      return;
    }
    try {
      FileChannel channel = FileChannel.open(file);
      exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, "application/octet-stream");
      exchange.getResponseHeaders().put(Headers.CONTENT_DISPOSITION, disposition(file));
      exchange.setResponseContentLength(channel.size());
      exchange.addExchangeCompleteListener(
          (done, next) -> {
            close(channel);
            next.proceed();
          });
      exchange.getResponseSender().transferFrom(channel, IoCallback.END_EXCHANGE);
    } catch (IOException e) {
      exchange.setStatusCode(StatusCodes.NOT_FOUND);
      Sender sender = exchange.getResponseSender();
      sender.send("the recording can't be read\n");
    }
  }

  private static String disposition(Path file) {
    String name = file.getFileName().toString().replaceAll("[^A-Za-z0-9._-]", "_");
    return "attachment; filename=\"" + name + '"';
  }

  private static void close(FileChannel channel) {
    try {
      channel.close();
    } catch (IOException e) {
      LOG.debug("a recording can't be closed", e);
    }
  }
}
