package carom.server.thin.web;

import carom.text.Texts;

/** Tells a client's author what is wrong with a message. */
final class BadMessage extends Exception {
  private static final long serialVersionUID = 1;

  BadMessage(String problem) {
    super(Texts.clean(problem), null, false, false); // garbage may come often: no stack trace
  }
}
