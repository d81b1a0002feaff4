package carom.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/**
 * Reads files that people edit. They are UTF-8 in every locale, with or without the byte order mark
 * that some editors write.
 */
public final class TextFile {
  /** Most bytes of a list or a file of settings: 100,000 bans. */
  public static final int MAX_BYTES = 8_000_000;

  private static final String BYTE_ORDER_MARK = "\ufeff";

  private TextFile() {}

  /**
   * Returns the text of a file, without a byte order mark.
   *
   * @param most bytes that it may have
   * @throws NoSuchFileException if there is none
   * @throws IOException if it can't be read, is too large, or isn't UTF-8; the message says so in
   *     words that may stand behind the file's name and a colon
   */
  public static String read(Path file, int most) throws IOException {
    byte[] bytes;
    try (InputStream in = Files.newInputStream(file)) {
      bytes = in.readNBytes(most + 1);
    } catch (NoSuchFileException e) {
      throw e;
    } catch (IOException e) {
      throw new IOException(FileErrors.reason(e), e);
    }
    if (bytes.length > most) {
      throw new IOException("it has more than " + most + " bytes");
    }
    String text = Texts.ofUtf8(ByteBuffer.wrap(bytes));
    if (text == null) {
      throw new IOException("it isn't text in UTF-8");
    }
    return text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
  }
}
