
/* [Show] */
part = "assembly"; // [assembly, ring, ring_plate, driver, pin, overlap]

/* [Hidden] */
// Crank angle from mid-index at a moment of the turn, and the wheel's angle with it.
function crank(t) = 360 * (t - floor(t + 0.5));
function turn(theta) = abs(theta) < engagement
  ? atan2(crank_radius * sin(theta), centre_distance + crank_radius * cos(theta))
  : sign(theta) * half_pitch;

module ring_outline() {
  difference() {
    solid(outside_radius);
    hollow(mouth_radius);
    for (k = [0 : stations - 1]) rotate(2 * half_pitch * k) {
      translate([slot_end, 0]) hollow(slot_width / 2);
      translate([0, -slot_width / 2]) square([slot_end, slot_width]);
      rotate(half_pitch) translate([centre_distance, 0]) hollow(locking_arc_radius);
    }
    holes(ring_holes);
  }
}

module segment_outline() {
  intersection() {
    difference() {
      solid(segment_outer);
      hollow(segment_inner);
    }
    polygon(concat([[0, 0]], [for (turn = [-1 : 1]) at(2 * segment_outer, 180 + turn * segment_half)]));
  }
}

module pin_outline() { translate([crank_radius, 0]) solid(pin_radius); }

module ring() {
  difference() {
    linear_extrude(height = thickness) ring_outline();
    pockets(ring_holes);
  }
}

// The plate that closes the ring on the side away from the driver.
module ring_plate() {
  translate([0, 0, thickness]) difference() {
    linear_extrude(height = thickness) difference() {
      solid(outside_radius);
      bore(wheel_bore, wheel_key, wheel_flat, wheel_key_direction);
      holes(ring_plate_holes);
    }
    pockets(ring_plate_holes);
  }
}

module driver() {
  translate([0, 0, -thickness - axial_play]) {
    difference() {
      linear_extrude(height = thickness) difference() {
        solid(plate_radius);
        bore(plate_bore, driver_key, driver_flat, driver_key_direction);
        holes(plate_holes);
        if (pin_hole > 0) translate([crank_radius, 0]) hole(pin_hole);
      }
      pockets(plate_holes);
      translate([crank_radius, 0]) nut_pocket(nut_width, nut_depth);
    }
    translate([0, 0, thickness]) linear_extrude(height = thickness) {
      segment_outline();
      if (pin_hole == 0) pin_outline();
    }
  }
}

// A pin that is not in one piece with the plate: what stands on the plate of a dowel or a screw.
module pin_pieces() {
  if (pin_hole > 0) translate([0, 0, -axial_play]) linear_extrude(height = thickness) pin_outline();
}

// What ring and driver have in common at moments of a turn: nothing, or they jam.
module overlap() {
  moments = 96;
  for (k = [0 : moments - 1]) let (theta = crank(k / moments)) intersection() {
    rotate(turn(theta)) ring_outline();
    translate([centre_distance, 0]) rotate(theta) { segment_outline(); pin_outline(); }
  }
}

if (part == "ring") ring();
else if (part == "ring_plate") ring_plate();
else if (part == "driver") driver();
else if (part == "pin") pin_pieces();
else if (part == "overlap") overlap();
else {
  color("steelblue") rotate(turn(crank($t))) ring();
  // The ring plate is clear, so that the driver is seen.
  color("steelblue", 0.3) rotate(turn(crank($t))) ring_plate();
  color("goldenrod") translate([centre_distance, 0, 0]) rotate(crank($t)) driver();
  color("silver") translate([centre_distance, 0, 0]) rotate(crank($t)) pin_pieces();
}
