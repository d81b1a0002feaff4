package carom.game.shooter;

import static carom.game.shooter.ShooterFields.AMMO;
import static carom.game.shooter.ShooterFields.HEALS;
import static carom.game.shooter.ShooterFields.PICKUP;
import static carom.game.shooter.ShooterFields.PICKUP_WAIT;
import static carom.game.shooter.ShooterFields.PLACE;
import static carom.game.shooter.ShooterFields.WEAPON;

import carom.sim.Match;
import carom.sim.Rules;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Level;
import java.util.function.Predicate;

/** Weapons and medkits: taken on both sides, so at once; brought back by the server. */
final class Pickups {
  private static final float BACK_SECONDS = 9;

  private final Stage stage;
  private final Predicate<Entity> visit = this::visit;
  private Weapon content; // scratch, as the next
  private Player taker;

  Pickups(Stage stage) {
    this.stage = stage;
  }

  /** Gives players what they touch. */
  void take(Rules r) {
    for (Entity e : r.entities()) {
      if (!stage.isPickup(e)) {
        continue;
      }
      int place = e.get(PLACE);
      content = stage.contents.get(place);
      taker = null;
      e.forEachOverlap(visit);
      if (taker == null) {
        continue;
      }
      if (content == null) {
        taker.set(HEALS, true); // damage is the server's word
      } else {
        taker.set(WEAPON, content);
        taker.set(AMMO, content.ammo);
      }
      r.set(PICKUP_WAIT, place, r.ticks(BACK_SECONDS));
      r.emit(stage.taken).at(e.x(), e.y()).of(taker.entity()).by(taker).data(place);
      e.despawn();
    }
  }

  /** Finds the first player who may take the content; full hands leave it there. */
  private boolean visit(Entity visitor) {
    Player p = visitor.owner();
    boolean isFighter = p != null && p.entity() == visitor;
    if (isFighter && !isFull(p)) {
      taker = p;
    }
    return taker == null;
  }

  private boolean isFull(Player p) {
    return content != null && p.get(WEAPON) == content && p.get(AMMO) == content.ammo;
  }

  /** Brings back what was taken long enough ago. */
  void bringBack(Match m) {
    for (int i = 0; i < stage.pickups.size(); i++) {
      if (m.get(PICKUP, i) == null && m.get(PICKUP_WAIT, i) == 0) {
        Level.Spawn spot = stage.pickups.get(i);
        Entity box = m.spawn(stage.box(stage.contents.get(i)), spot.x(), spot.y());
        box.set(PLACE, i);
        m.set(PICKUP, i, box);
      }
    }
  }
}
