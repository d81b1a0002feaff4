package carom.server.config;

/**
 * Failure to read the settings of the file or the environment. The message alone tells the operator
 * which file or variable, what is wrong with it, and how to fix it.
 */
public final class BadSettingException extends Exception {
  private static final long serialVersionUID = 1;

  BadSettingException(String message, Throwable cause) {
    super(message, cause);
  }

  BadSettingException(String message) {
    this(message, null);
  }
}
