package carom.client.app;

import picocli.CommandLine.IVersionProvider;

/** Provides the answer to {@code --version}: the version in the jar's manifest. */
public final class ProgramVersion implements IVersionProvider {
  /** Creates a provider; the command line calls this. */
  public ProgramVersion() {}

  @Override
  public String[] getVersion() {
    String version = ProgramVersion.class.getPackage().getImplementationVersion();
    return new String[] {"Carom " + (version == null ? "(development build)" : version)};
  }
}
