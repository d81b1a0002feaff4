package carom.net.kryo;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.PoolChunk;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.Output;

/** Serializer of {@link PoolChunk}. */
final class PoolChunkSerializer extends MessageSerializer<PoolChunk> {
  /** Creates a serializer. */
  public PoolChunkSerializer() {}

  @Override
  protected void write(Output out, PoolChunk m) {
    writeInt(out, "size", m.size(), 1, ProtocolLimits.MAX_POOL_STATE_BYTES);
    writeInt(out, "offset", m.offset(), 0, m.size() - 1);
    writeBlock(out, m.bytes(), 1, mostBytes(m.size(), m.offset()));
  }

  /** Returns how many bytes a piece may have: none lies beyond the state's end. */
  private static int mostBytes(int size, int offset) {
    return Math.min(ProtocolLimits.MAX_LEVEL_CHUNK_BYTES, size - offset);
  }

  @Override
  protected PoolChunk read(Input in) {
    int size = readInt(in, "size", 1, ProtocolLimits.MAX_POOL_STATE_BYTES);
    int offset = readInt(in, "offset", 0, size - 1);
    return new PoolChunk(size, offset, readBlock(in, 1, mostBytes(size, offset)));
  }
}
