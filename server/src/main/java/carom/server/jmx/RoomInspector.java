package carom.server.jmx;

import carom.server.room.Room;
import carom.sim.message.BuiltInKinds;
import carom.text.Texts;
import java.lang.management.ManagementFactory;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import javax.management.JMException;
import javax.management.MBeanServer;
import javax.management.ObjectName;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Exposes a room to JMX tools. */
public final class RoomInspector implements RoomMXBean {
  private static final Logger LOG = LoggerFactory.getLogger(RoomInspector.class);

  private final Room room;

  private RoomInspector(Room room) {
    this.room = room;
  }

  /**
   * Registers a room with JMX. It replaces a registered room of the same number. If JMX refuses,
   * the server logs a warning and goes on.
   */
  public static void show(Room room) {
    try {
      MBeanServer tools = ManagementFactory.getPlatformMBeanServer();
      ObjectName name = new ObjectName("carom:type=Room,number=" + room.number());
      if (tools.isRegistered(name)) {
        tools.unregisterMBean(name);
      }
      tools.registerMBean(new RoomInspector(room), name);
    } catch (JMException e) {
      LOG.warn("room {} can't be shown to JMX tools: {}", room.number(), e.toString());
    }
  }

  /** Takes a room out of JMX again. */
  public static void hide(Room room) {
    try {
      ManagementFactory.getPlatformMBeanServer()
          .unregisterMBean(new ObjectName("carom:type=Room,number=" + room.number()));
    } catch (JMException e) {
      LOG.debug("room {} wasn't shown to JMX tools: {}", room.number(), e.toString());
    }
  }

  @Override
  public int getTick() {
    return room.tick();
  }

  @Override
  public String why(int player, int entity) {
    return room.operator().why(player, entity, Object::toString);
  }

  @Override
  public String fields(String of) {
    return room.operator().fields(of);
  }

  @Override
  public String kick(int player, String text) {
    return room.operator().kick(player, text);
  }

  @Override
  public String say(String text) {
    String line = text == null ? "" : Texts.clean(text).strip();
    if (line.isEmpty() || line.length() > BuiltInKinds.MAX_CHAT) {
      return "text has length=" + line.length() + ", allowed are 1.." + BuiltInKinds.MAX_CHAT;
    }
    return "said to players=" + room.operator().say(line);
  }

  @Override
  public String mute(String name) {
    return room.operator().mute(name, true);
  }

  @Override
  public String unmute(String name) {
    return room.operator().mute(name, false);
  }

  @Override
  public String spectate(String name) {
    return room.operator().spectate(name);
  }

  @Override
  public String change(String game, String level) {
    return room.operator().change(game == null ? "" : game, level == null ? "" : level);
  }

  @Override
  public String record(String target) {
    if (target == null || target.isBlank()) {
      return "target is empty; name a file that is not there yet, or a folder";
    }
    try {
      return room.operator().record(Path.of(target));
    } catch (InvalidPathException e) {
      return "target=" + target + " can't be the name of a file: " + e.getReason();
    }
  }

  @Override
  public String stopRecording() {
    return room.operator().stopRecording();
  }
}
