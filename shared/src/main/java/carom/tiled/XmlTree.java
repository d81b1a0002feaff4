package carom.tiled;

import carom.sim.level.LevelException;
import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Reads Tiled's XML into the form of its JSON. It knows no document types and no entities but XML's
 * own, so that a file can name no other file and can't grow while it is read.
 */
final class XmlTree {
  private static final int MAX_ELEMENTS = 500_000;
  private static final int MAX_DEPTH = 32;

  /** Elements that Tiled's JSON has in a list of another name. */
  private static final Map<String, String> LAYERS =
      Map.of(
          "layer", "tilelayer",
          "objectgroup", "objectgroup",
          "imagelayer", "imagelayer",
          "group", "group");

  private static final Map<String, String> LISTS =
      Map.of("tileset", "tilesets", "tile", "tiles", "object", "objects", "chunk", "chunks");

  private final String file;
  private final XMLStreamReader in;
  private int elements;

  private XmlTree(String file, XMLStreamReader in) {
    this.file = file;
    this.in = in;
  }

  static TiledNode read(String file, byte[] bytes) throws LevelException {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_COALESCING, true);
    factory.setXMLResolver(
        (publicId, systemId, base, namespace) -> {
          throw new XMLStreamException("no other file is read");
        });
    XMLStreamReader in = null;
    try {
      in = factory.createXMLStreamReader(new ByteArrayInputStream(bytes));
      return new XmlTree(file, in).root();
    } catch (XMLStreamException | RuntimeException e) { // the JDK's parser has both
      int line = in == null ? 1 : Math.max(1, in.getLocation().getLineNumber());
      int column = in == null ? 1 : Math.max(1, in.getLocation().getColumnNumber());
      throw new LevelException(file, line, column, "", "it isn't well-formed XML");
    }
  }

  private TiledNode root() throws XMLStreamException, LevelException {
    while (in.next() != XMLStreamConstants.START_ELEMENT) {
      if (in.getEventType() == XMLStreamConstants.DTD) {
        throw wrong("a document type isn't allowed; remove the line <!DOCTYPE ...>");
      }
    }
    return element(1);
  }

  /** Reads the element that begins here, and leaves the reader at its end. */
  private TiledNode element(int depth) throws XMLStreamException, LevelException {
    if (++elements > MAX_ELEMENTS || depth > MAX_DEPTH) {
      throw wrong(
          depth > MAX_DEPTH
              ? "more than " + MAX_DEPTH + " levels of elements"
              : "more than " + MAX_ELEMENTS + " elements");
    }
    TiledNode node = new TiledNode(file);
    String own = in.getLocalName();
    for (int i = 0; i < in.getAttributeCount(); i++) {
      node.fields.put(in.getAttributeLocalName(i), in.getAttributeValue(i));
    }
    StringBuilder text = new StringBuilder();
    for (int event = in.next(); event != XMLStreamConstants.END_ELEMENT; event = in.next()) {
      if (event == XMLStreamConstants.START_ELEMENT) {
        String name = in.getLocalName();
        child(own, node, name, element(depth + 1));
      } else if (event == XMLStreamConstants.CHARACTERS || event == XMLStreamConstants.CDATA) {
        text.append(in.getText());
      } else if (event == XMLStreamConstants.ENTITY_REFERENCE) {
        throw wrong("entity &" + in.getLocalName() + "; isn't known");
      }
    }
    if (!text.toString().isBlank()) {
      String field = own.equals("property") ? "value" : "data";
      node.fields.putIfAbsent(field, text.toString());
    }
    return node;
  }

  private void child(String parent, TiledNode node, String name, TiledNode child)
      throws LevelException {
    if (name.equals("objectgroup") && parent.equals("tile")) {
      node.fields.put(name, child);
    } else if (LAYERS.containsKey(name)) {
      child.fields.put("type", LAYERS.get(name));
      node.add("layers", child);
    } else if (name.equals("properties")) {
      node.fields.put("properties", child.nodes("property"));
    } else if (name.equals("property")) {
      node.add("property", child);
    } else if (name.equals("polygon") || name.equals("polyline")) {
      node.fields.put(name, points(child.text("points", "")));
    } else if (name.equals("ellipse") || name.equals("point") || name.equals("capsule")) {
      node.fields.put(name, true);
    } else if (name.equals("data")) {
      child.fields.forEach(node.fields::putIfAbsent);
    } else if (name.equals("tile") && (parent.equals("data") || parent.equals("chunk"))) {
      node.add("data", child.number("gid", 0));
    } else if (LISTS.containsKey(name)) {
      node.add(LISTS.get(name), child);
    } else {
      node.fields.putIfAbsent(name, child); // a picture, a grid, a text
    }
  }

  private List<Object> points(String text) throws LevelException {
    List<Object> points = new ArrayList<>();
    for (String pair : text.strip().split("\\s+")) {
      String[] xy = pair.split(",", -1);
      TiledNode point = new TiledNode(file);
      if (xy.length == 2) {
        point.fields.put("x", xy[0]);
        point.fields.put("y", xy[1]);
      }
      points.add(point);
    }
    return points;
  }

  private LevelException wrong(String problem) {
    return new LevelException(
        file,
        Math.max(1, in.getLocation().getLineNumber()),
        Math.max(1, in.getLocation().getColumnNumber()),
        "",
        problem);
  }
}
