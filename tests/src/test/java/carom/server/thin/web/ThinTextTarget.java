package carom.server.thin.web;

import carom.fuzz.FuzzTarget;
import carom.server.thin.ThinClientMessage;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * What a thin client says by WebSocket, as JSON and as bytes: it is a message, or it is refused
 * with a text that people may see.
 */
public final class ThinTextTarget implements FuzzTarget {
  private final JsonReader reader = new JsonReader();

  @Override
  public void take(byte[] data) {
    try {
      reader.read(data);
    } catch (BadMessage e) {
      FuzzTarget.requirePrintable(e.getMessage());
    }
    try {
      ThinClientMessage.Input input = BinaryForm.readInput(data);
      if (input.inputs().length < 1 || input.inputs().length > ThinClientMessage.MAX_INPUTS) {
        throw new AssertionError("inputs=" + input.inputs().length);
      }
    } catch (BadMessage e) {
      FuzzTarget.requirePrintable(e.getMessage());
    }
  }

  @Override
  public List<byte[]> seeds() {
    List<byte[]> seeds = new ArrayList<>();
    for (String text :
        List.of(
            "{\"join\": {\"version\": 1, \"name\": \"Ann\", \"room\": \"cup\", \"binary\": true,"
                + " \"secret\": \"00ff00ff00ff00ff\", \"token\": \"\", \"more\": [[{}]]}}",
            "{\"input\": {\"count\": 9, \"seen\": 7, \"inputs\": [[1, 0.5, -1, 3.14], [0,0,0,0]]}}",
            "{\"chat\": {\"text\": \"\\ud83d\\ude00 \\u202e\", \"team\": false}}",
            "{\"emote\": {\"emote\": \"HELLO\"}}",
            "{\"choose\": {\"team\": 1, \"role\": \"SPECTATOR\", \"ready\": true, \"room\": null}}",
            "{\"rate\": {\"perSecond\": 20}}",
            "{\"view\": {\"x\": 1, \"y\": -2e3, \"halfWidth\": 16, \"halfHeight\": 9}}",
            "{\"custom\": {\"kind\": \"buy\", \"values\": {\"item\": 3, \"all\": true, \"s\":"
                + " \"\"}}}",
            "{\"rooms\": {}}",
            "{\"alive\": {}}",
            "{\"leave\": {}}")) {
      seeds.add(text.getBytes(StandardCharsets.UTF_8));
    }
    seeds.add(new byte[] {2, 5, 4, 1, 0, 127, -127, 0, 64});
    return seeds;
  }
}
