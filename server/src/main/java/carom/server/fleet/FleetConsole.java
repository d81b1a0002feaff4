package carom.server.fleet;

import carom.server.command.Command;
import carom.server.command.CommandException;
import carom.server.command.CommandRegistry;
import carom.server.command.CommandWords;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Adds the operator's command {@code fleet} to a server of a fleet. */
public final class FleetConsole {
  private static final int ROOM = 1;
  private static final int SERVER = 2;

  private FleetConsole() {}

  /** Adds the command. */
  public static void add(CommandRegistry commands, FleetMember member) {
    commands.add(
        new Command(
            "fleet",
            "[status | rooms | move ROOM [SERVER] | drain [SERVER] | undrain [SERVER]]",
            "Shows the fleet, moves a room, or moves all rooms of a server (this one) away; undrain"
                + " lets it take rooms again.",
            words -> run(member, words),
            place -> words(member, place)));
  }

  private static String run(FleetMember member, CommandWords words) throws CommandException {
    try {
      return member.run(words.all());
    } catch (IllegalArgumentException e) {
      throw new CommandException(e.getMessage());
    }
  }

  /** Returns what may stand at a place; behind the verb, rooms or servers. */
  private static List<String> words(FleetMember member, int place) {
    FleetFigures.Report report = member.figures().report();
    List<String> names = new ArrayList<>();
    if (place == 0) {
      return Arrays.stream(FleetVerb.values()).map(FleetVerb::word).toList();
    }
    if (place == ROOM) {
      report.rooms().forEach(room -> names.add(room.name()));
    }
    if (place <= SERVER) {
      report.servers().forEach(server -> names.add(server.name()));
    }
    return names;
  }
}
