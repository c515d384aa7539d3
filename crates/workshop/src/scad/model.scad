
/* [Show] */
part = "assembly"; // [assembly, wheel, driver, pin, base, overlap]

/* [Hidden] */
// Crank angle from the line of centres at a moment of the turn, and the wheel's angle with it.
function crank(t) = 360 / pins * (t - floor(t + 0.5));
function turn(theta) = abs(theta) < engagement
  ? atan2(crank_radius * sin(theta), centre_distance - crank_radius * cos(theta))
  : sign(theta) * half_pitch;

module around() { for (k = [0 : pins - 1]) rotate(360 / pins * k) children(); }

module wheel_outline() {
  difference() {
    solid(tip_radius);
    for (k = [0 : stations - 1]) rotate(2 * half_pitch * k) {
      translate([slot_end, 0]) hollow(slot_width / 2);
      translate([slot_end, -slot_width / 2]) square([tip_radius, slot_width]);
      rotate(half_pitch) translate([centre_distance, 0]) hollow(locking_arc_radius);
      if (len(mouth) > 0) for (side = [1, -1]) polygon(concat(
        [for (p = mouth) [wheel_radius + p[0], side * (slot_width / 2 + p[1])]],
        [[2 * tip_radius, side * (slot_width / 2 + mouth[len(mouth) - 1][1])], [2 * tip_radius, 0], [slot_end, 0]]
      ));
    }
    bore(wheel_bore, wheel_key, wheel_flat, wheel_key_direction);
    holes(wheel_holes);
  }
}

module disc_outline() {
  if (locking_disc_radius > 0) difference() {
    solid(locking_disc_radius);
    around() translate([crescent_centre, 0]) hollow(crescent_radius);
    bore(driver_bore, driver_key, driver_flat, driver_key_direction);
    holes(disc_holes);
  }
}

module pin_outlines() { around() translate([crank_radius, 0]) solid(pin_radius); }

module wheel() {
  difference() {
    linear_extrude(height = thickness) wheel_outline();
    pockets(wheel_holes);
  }
}

module driver() {
  translate([0, 0, -thickness - axial_play]) {
    difference() {
      linear_extrude(height = thickness) difference() {
        solid(plate_radius);
        bore(plate_bore, driver_key, driver_flat, driver_key_direction);
        holes(plate_holes);
        if (pin_hole > 0) around() translate([crank_radius, 0]) hole(pin_hole);
      }
      pockets(plate_holes);
      around() translate([crank_radius, 0]) nut_pocket(nut_width, nut_depth);
    }
    translate([0, 0, thickness]) linear_extrude(height = thickness + axial_play) {
      disc_outline();
      if (pin_hole == 0) pin_outlines();
    }
  }
}

// Pins that are not in one piece with the plate: dowels, or bushes on screws.
module pin_pieces() {
  if (pin_hole > 0) translate([0, 0, -axial_play])
    linear_extrude(height = thickness + (bush_hole > 0 ? 2 : 1) * axial_play) difference() {
      pin_outlines();
      if (bush_hole > 0) around() translate([crank_radius, 0]) hole(bush_hole);
    }
}

module base() {
  if (base_thickness > 0) {
    half = max(tip_radius, plate_radius);
    at_corners = [for (x = [-tip_radius, centre_distance + plate_radius], y = [-half, half]) [x, y]];
    axes = [[0, wheel_bore], [centre_distance, plate_bore]];
    translate([0, 0, -2 * axial_play - thickness - base_thickness]) difference() {
      linear_extrude(height = base_thickness) difference() {
        hull() for (corner = at_corners) translate(corner) solid(base_margin);
        if (base_hole > 0) for (corner = at_corners) translate(corner) hole(base_hole);
        for (axis = axes) if (axis[1] > 0) translate([axis[0], 0]) hole(axis[1]);
      }
      if (shoulder_diameter > 0) for (axis = axes) if (axis[1] > 0)
        translate([axis[0], 0, base_thickness - shoulder_depth])
          linear_extrude(height = shoulder_depth + 1) hole(shoulder_diameter);
    }
  }
}

// What wheel and driver have in common at moments of a turn: nothing, or they jam.
module overlap() {
  moments = 48;
  for (k = [0 : moments - 1]) let (theta = crank(k / moments)) intersection() {
    rotate(turn(theta)) wheel_outline();
    translate([centre_distance, 0]) rotate(180 - theta) { disc_outline(); pin_outlines(); }
  }
}

if (part == "wheel") wheel();
else if (part == "driver") driver();
else if (part == "pin") pin_pieces();
else if (part == "base") base();
else if (part == "overlap") overlap();
else {
  color("steelblue") rotate(turn(crank($t))) wheel();
  color("goldenrod") translate([centre_distance, 0, 0]) rotate(180 - crank($t)) driver();
  color("silver") translate([centre_distance, 0, 0]) rotate(180 - crank($t)) pin_pieces();
  color("gainsboro") base();
}
