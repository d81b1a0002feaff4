package carom.net.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ProtocolLimits;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.message.MessageKind;
import carom.sim.message.MessageKinds;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A difference of fields is named, with both declarations. */
class DeclarationsTest {
  private static final Schema SERVER =
      Schema.of(List.of(Field.flag("armed"), Field.count("health", 0, 100)));

  private static String difference(Field<?>... fields) {
    return difference(
        Declarations.of(SERVER, new MessageKinds()),
        Declarations.of(Schema.of(List.of(fields)), new MessageKinds()));
  }

  private static String difference(Declarations server, Declarations client) {
    return client.difference("arena", server.digest(), server.lines());
  }

  private static Declarations messages(MessageKind... kinds) {
    MessageKinds all = new MessageKinds();
    for (MessageKind kind : kinds) {
      all.add(kind);
    }
    return Declarations.of(SERVER, all);
  }

  @Test
  void aMessageThatDiffersIsNamedWithItsArgument() {
    MessageKind buy = MessageKind.named("buy").fromClient();
    Declarations server = messages(buy.count("item", 0, 31).text("note", 60));
    assertNull(difference(server, messages(buy.count("item", 0, 31).text("note", 60))));
    assertEquals(
        "message buy.item differs: server \"count 0..31\", client \"count 0..63\"; use the same"
            + " build of game arena",
        difference(server, messages(buy.count("item", 0, 63).text("note", 60))));
    assertEquals(
        "message buy.note differs: server \"message.buy.note text 60\", client none; use the same"
            + " build of game arena",
        difference(server, messages(buy.count("item", 0, 31))));
    assertEquals(
        "message buy differs: server \"FROM_CLIENT reliable\", client \"FROM_CLIENT unreliable\";"
            + " use the same build of game arena",
        difference(server, messages(buy.count("item", 0, 31).text("note", 60).unreliable())));
  }

  @Test
  void equalFieldsDoNotDiffer() {
    assertNull(difference(Field.flag("armed"), Field.count("health", 0, 100)));
  }

  @Test
  void aDifferenceNamesTheFieldAndBothDeclarations() {
    assertEquals(
        "field player.health differs: server \"count 0..100 to NEAR\", client \"count 0..200 to"
            + " NEAR\"; use the same build of game arena",
        difference(Field.flag("armed"), Field.count("health", 0, 200)));
  }

  @Test
  void aFieldThatOneSideLacksIsNamed() {
    assertEquals(
        "field player.health differs: server \"player.health count 0..100 to NEAR\", client none;"
            + " use the same build of game arena",
        difference(Field.flag("armed")));
    assertTrue(
        difference(Field.flag("armed"), Field.count("health", 0, 100), Field.flag("late"))
            .startsWith("field player.late differs: server none"));
  }

  @Test
  void whatIsToldIsBounded() {
    List<Field<?>> fields = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      fields.add(Field.flag("aVeryLongNameOfAFieldWithNo" + i).times(1));
    }
    List<String> told = Declarations.of(Schema.of(fields), new MessageKinds()).lines();
    assertEquals(ProtocolLimits.MAX_DECLARATIONS, told.size());
    for (String line : told) {
      assertTrue(line.length() <= ProtocolLimits.MAX_DECLARATION_BYTES, line);
    }
  }
}
