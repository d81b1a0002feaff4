package carom.server.query;

import carom.fuzz.FuzzTarget;
import carom.server.command.Caller;
import carom.server.command.Command;
import carom.server.command.CommandRegistry;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** A stream of RCON messages. Each has a bounded text, whose answer a terminal can show. */
public final class RemoteConsoleTarget implements FuzzTarget {
  private final CommandRegistry commands = new CommandRegistry();

  /** Makes a registry of a command that repeats its words. */
  public RemoteConsoleTarget() {
    commands.add(new Command("echo", "TEXT", "", words -> words.rest(0), Command.NONE));
  }

  @Override
  public void take(byte[] data) {
    DataInputStream in = new DataInputStream(new ByteArrayInputStream(data));
    try {
      while (true) {
        String body = RemoteConsole.read(in).body();
        if (body.length() > RemoteConsole.MAX_BODY_BYTES) {
          throw new AssertionError("a text of " + body.length() + " characters was read");
        }
        commands.run(body, Caller.CONSOLE).text().lines().forEach(FuzzTarget::requirePrintable);
      }
    } catch (IOException e) {
      // the stream ends, or isn't RCON
    }
  }

  @Override
  public List<byte[]> seeds() {
    return List.of(
        message(3, "a password"), message(2, "echo \"two words\" x=\\n"), message(2, "help ecko"));
  }

  private static byte[] message(int type, String text) {
    byte[] body = text.getBytes(StandardCharsets.UTF_8);
    return ByteBuffer.allocate(14 + body.length)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putInt(10 + body.length)
        .putInt(1)
        .putInt(type)
        .put(body)
        .array();
  }
}
