package carom.net.kryo;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.Fleet;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.Output;
import java.util.ArrayList;
import java.util.List;

/** Serializer of {@link Fleet}. */
final class FleetSerializer extends MessageSerializer<Fleet> {
  /** Creates a serializer. */
  public FleetSerializer() {}

  @Override
  protected void write(Output out, Fleet m) {
    writeInt(out, "servers", m.servers().size(), 0, ProtocolLimits.MAX_FLEET_SERVERS);
    for (String server : m.servers()) {
      writeText(out, "server", server, ProtocolLimits.MAX_ADDRESS_BYTES);
    }
    writeText(out, "standby", m.standby(), ProtocolLimits.MAX_ADDRESS_BYTES);
  }

  @Override
  protected Fleet read(Input in) {
    int count = readInt(in, "servers", 0, ProtocolLimits.MAX_FLEET_SERVERS);
    List<String> servers = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      servers.add(readText(in, "server", ProtocolLimits.MAX_ADDRESS_BYTES));
    }
    return new Fleet(servers, readText(in, "standby", ProtocolLimits.MAX_ADDRESS_BYTES));
  }
}
