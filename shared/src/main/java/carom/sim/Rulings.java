package carom.sim;

/**
 * What a predicted simulation knows of the server's rules, which it doesn't run: it is asked at the
 * moments at which the server calls {@link Game#beforeStep} and {@link Game#afterStep}.
 */
public interface Rulings {
  /** Applies what the rules of the tick being computed did before the inputs. */
  void beforeStep(Simulation s);

  /** Applies what the rules of the tick being computed did after the physics. */
  void afterStep(Simulation s);
}
