package carom.net.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.Limits;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A difference of fields is named, with both declarations. */
class FieldAgreementTest {
  private static final Schema SERVER =
      Schema.of(List.of(Field.flag("armed"), Field.count("health", 0, 100)));

  private static String difference(Field<?>... fields) {
    Schema client = Schema.of(List.of(fields));
    return FieldAgreement.difference(client, "arena", SERVER.digest(), FieldAgreement.tell(SERVER));
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
    List<String> told = FieldAgreement.tell(Schema.of(fields));
    assertEquals(Limits.MAX_FIELD_LINES, told.size());
    for (String line : told) {
      assertTrue(line.length() <= Limits.MAX_FIELD_LINE_BYTES, line);
    }
  }
}
