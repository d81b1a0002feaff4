package carom.server.jmx;

import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import java.lang.management.ManagementFactory;
import javax.management.JMException;
import javax.management.MBeanServer;
import javax.management.ObjectName;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Exposes the commands to JMX tools. */
public final class CommandInspector implements CommandMXBean {
  private static final Logger LOG = LoggerFactory.getLogger(CommandInspector.class);
  private static final String NAME = "carom:type=Server";

  private final CommandRegistry registry;

  private CommandInspector(CommandRegistry registry) {
    this.registry = registry;
  }

  /**
   * Registers the commands with JMX, in the place of those of an earlier server of this process. If
   * JMX refuses, the server logs a warning and goes on.
   */
  public static void show(CommandRegistry registry) {
    try {
      MBeanServer tools = ManagementFactory.getPlatformMBeanServer();
      ObjectName name = new ObjectName(NAME);
      if (tools.isRegistered(name)) {
        tools.unregisterMBean(name);
      }
      tools.registerMBean(new CommandInspector(registry), name);
    } catch (JMException e) {
      LOG.warn("the commands can't be shown to JMX tools: {}", e.toString());
    }
  }

  @Override
  public String run(String line) {
    return registry.run(line == null ? "" : line, Caller.JMX).text();
  }

  @Override
  public String[] getCommands() {
    return registry.names().toArray(new String[0]);
  }
}
