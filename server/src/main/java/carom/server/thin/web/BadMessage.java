package carom.server.thin.web;

/** Tells a client's author what is wrong with a message. */
final class BadMessage extends Exception {
  private static final long serialVersionUID = 1;

  BadMessage(String problem) {
    super(problem, null, false, false); // garbage may come often: no stack trace
  }
}
