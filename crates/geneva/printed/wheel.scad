// Geneva wheel and driver; lengths in millimetres, angles in degrees. All else follows from these numbers.

/* [Wheel and driver] */
stations = 4; // slots of the wheel, from 3 on
pins = 1; // pins of the driver
crank_radius = 25; // driver's axis to a pin's centre
pin_diameter = 6; // of a pin, or of the bush on its screw
horn_thickness = 6; // least thickness between a slot and a locking arc
bottom_clearance = 0.30000000000000004; // how much deeper the slots are than the pins need
thickness = 6; // of wheel, locking disc and plate

/* [Play] */
slot_play = 0.8; // width of a slot less the pin's diameter
locking_play = 0.8; // diameter of the locking arcs less that of the disc
axial_play = 0.4; // between wheel and plate
tolerance = 0.08000000000000002; // greatest distance of a chord from its arc

/* [Shafts and pins] */
wheel_bore = 0; // diameter; 0 for none
driver_bore = 0; // diameter in the locking disc; 0 for none
plate_bore = 0; // diameter in the plate; 0 for none
pin_hole = 3.4; // diameter of the holes for pins; 0: pins are in one piece with the plate
bush_hole = 3.4; // diameter of the hole in a bush that is the pin; 0 for none
nut_width = 0; // across the flats of a nut below each pin; 0 for none
nut_depth = 0; // of the nut's pocket

/* [Base plate] */
base_thickness = 0; // 0 for none
base_hole = 0; // for screws; 0 for none
base_margin = 0; // from its screws to its edge
shoulder_diameter = 0; // wider hole from above at each axis; 0 for none
shoulder_depth = 0; // of that hole

/* [Holes] */
// Each as [x, y, diameter, width of a nut's pocket from below, its depth, direction of a corner].
wheel_holes = [[7.0710678118654755, 7.071067811865475, 3.4, 0, 0, 0], [-7.071067811865475, 7.0710678118654755, 3.4, 0, 0, 0], [-7.071067811865477, -7.071067811865475, 3.4, 0, 0, 0], [7.071067811865474, -7.071067811865477, 3.4, 0, 0, 0]];
plate_holes = [];
disc_holes = [];
// Keyway of a bore as [width, axis to its bottom], or axis to the flat; 0 for none.
wheel_key = [0, 0];
wheel_flat = 0;
wheel_key_direction = 45;
driver_key = [0, 0];
driver_flat = 0;
driver_key_direction = 180;
// One side of a slot's mouth, from its wall to the rim: along the slot from wheel_radius, and from the wall; none for a sharp one.
mouth = [];

/* [Hidden] */
assert(stations >= 3 && stations == floor(stations), "stations must be a whole number from 3 on");
assert(pins >= 1 && pins == floor(pins), "pins must be a whole number from 1 on");
assert(pins * (180 - 360 / stations) <= 360 + 1e-9, "two pins would be in slots at once: make pins smaller");
assert(crank_radius > 0, "crank_radius must be above 0");
assert(pin_diameter > 0, "pin_diameter must be above 0");
assert(horn_thickness > 0, "horn_thickness must be above 0");
assert(bottom_clearance >= 0, "bottom_clearance must be 0 or more");
assert(slot_play >= 0 && locking_play >= 0 && axial_play >= 0, "no play must be below 0");
assert(thickness > 0, "thickness must be above 0");
assert(tolerance > 0, "tolerance must be above 0");
assert(min(wheel_bore, driver_bore, plate_bore, pin_hole) >= 0, "a diameter must be 0 or more");

half_pitch = 180 / stations;
engagement = 90 - half_pitch;
centre_distance = crank_radius / sin(half_pitch);
wheel_radius = centre_distance * cos(half_pitch);
deepest = centre_distance - crank_radius;
pin_radius = pin_diameter / 2;
slot_width = pin_diameter + slot_play;
slot_end = deepest - bottom_clearance;
tip_radius = norm([wheel_radius, slot_width / 2]);
locking_arc_radius = crank_radius - slot_width / 2 - horn_thickness;
plate_radius = crank_radius + pin_radius + min(pin_radius, (deepest - pin_radius) / 2);

assert(2 * slot_end * sin(half_pitch) > slot_width,
  "the slots run into one another: make pin_diameter, slot_play or bottom_clearance smaller");
assert(locking_arc_radius > 0 && locking_arc_radius + tip_radius > centre_distance,
  "the locking arcs miss the wheel: make pin_diameter or horn_thickness smaller");

// Where the tip of the horn is: from the slot's middle, seen from the wheel's axis.
tip_angle = half_pitch - 2 * asin(sqrt(min(1, max(0,
  (pow(locking_arc_radius, 2) - pow(centre_distance - tip_radius, 2)) / (4 * centre_distance * tip_radius)))));

has_dwell = pins * (180 - 2 * half_pitch) < 360 * (1 - 1e-9);
locking_disc_radius = has_dwell ? locking_arc_radius - locking_play / 2 : 0;
assert(!has_dwell || locking_disc_radius > 0, "the play leaves no locking disc: make locking_play smaller");

// The crescent: an arc through both edges of the opening. Its centre is as far out as lets the horn's tip pass with this gap at
// all crank angles; the tip is at (u, v) from the driver's axis, u along the pin's line.
gap = locking_play / 2 + slot_play / 2 * tip_radius / deepest + 1e-8 * centre_distance;
edge = locking_disc_radius * cos(engagement);

function tip(theta) =
  let (p = [centre_distance - crank_radius * cos(theta), crank_radius * sin(theta)], far = norm(p),
    x = tip_radius * (p[0] * cos(tip_angle) + p[1] * sin(tip_angle)) / far - centre_distance,
    y = tip_radius * (p[1] * cos(tip_angle) - p[0] * sin(tip_angle)) / far)
  [y * sin(theta) - x * cos(theta), x * x + y * y];

function centre_at(theta) =
  let (of = tip(theta), u = of[0], s = of[1], g = gap, z = locking_disc_radius,
    left = z * z - s - g * g, behind = 2 * (edge - u),
    middle = left * behind - 4 * g * g * u,
    product = (left * left - 4 * g * g * s) * (behind * behind - 4 * g * g),
    divisor = middle + sqrt(max(0, middle * middle - product)))
  behind <= 0 ? centre_distance
    : left <= 0 || divisor <= 0 ? 0
    : min(centre_distance, (left * left - 4 * g * g * s) / divisor);

// The least of them, by ever closer steps about the least so far.
function least_centre(from, to, rounds) =
  let (n = 24, step = (to - from) / n, all = [for (k = [0 : n]) centre_at(from + step * k)], least = min(all),
    at = [for (k = [0 : n]) if (all[k] == least) k][0])
  rounds == 0 ? least : min(least, least_centre(from + step * max(at - 1, 0), from + step * min(at + 1, n), rounds - 1));

crescent_centre = has_dwell ? least_centre(0, engagement, 3) : 0;
crescent_radius = has_dwell
  ? norm([crescent_centre - locking_disc_radius * cos(engagement), locking_disc_radius * sin(engagement)]) : 0;
crescent_bottom = crescent_centre - crescent_radius;

// How far the opening's edge passes beside the horn's tip as it comes out of the locking arc.
opening = has_dwell
  ? let (out = acos(max(-1, min(1, (pow(centre_distance, 2) + pow(locking_disc_radius, 2) - pow(tip_radius, 2))
      / (2 * centre_distance * locking_disc_radius)))),
      theta = engagement - out,
      phi = atan2(crank_radius * sin(theta), centre_distance - crank_radius * cos(theta)),
      beside = atan2(locking_disc_radius * sin(out), centre_distance - locking_disc_radius * cos(out)))
    tip_radius * sin(phi - tip_angle + beside)
  : 1 + locking_play;

assert(opening > locking_play / 2,
  "the edges of the locking disc run into the horns: make pin_diameter, horn_thickness or the plays smaller");
assert(!has_dwell || crescent_centre > 0 && crescent_bottom > 0,
  "the crescent reaches beyond the driver's axis: make pin_diameter, horn_thickness or the plays smaller");
assert(deepest > pin_radius, "the plate meets the wheel's axis: make pin_diameter smaller");
assert(slot_end - slot_width / 2 > wheel_bore / 2, "the slots meet the bore of the wheel: make wheel_bore smaller");
assert(centre_distance - plate_radius > wheel_bore / 2, "the plate meets the wheel's shaft: make wheel_bore smaller");
assert(centre_distance - tip_radius > driver_bore / 2, "the wheel meets the driver's shaft: make driver_bore smaller");
assert(driver_bore == 0 || !has_dwell || crescent_bottom > driver_bore / 2,
  "the crescent meets the driver's bore: make driver_bore smaller");
assert(crank_radius - max(pin_diameter, pin_hole) / 2 > plate_bore / 2,
  "the plate's bore meets the pins: make plate_bore smaller");
assert(bush_hole >= 0 && bush_hole < pin_diameter, "bush_hole is as wide as the pin: make it smaller");
assert(pin_hole == 0 || pin_hole <= pin_diameter + slot_play, "pin_hole is wider than the pin: make it smaller");
assert(plate_radius - crank_radius > max(pin_hole, nut_width / cos(30)) / 2,
  "a pin's hole or nut breaks out of the plate: make pin_hole or nut_width smaller");
assert(nut_depth < thickness, "nut_depth must be less than thickness");

// Of a hole: how far its pocket reaches from its middle, and whether it keeps off slots, locking arcs, crescents and bores.
function reach(hole) = max(hole[2] / 2, hole[3] / 2 / cos(30));
function at(radius, angle) = radius * [cos(angle), sin(angle)];
function beyond_slot(p, angle) =
  let (x = p[0] * cos(angle) + p[1] * sin(angle), y = p[1] * cos(angle) - p[0] * sin(angle))
  (x > slot_end ? abs(y) : norm([x - slot_end, y])) - slot_width / 2;
function in_wheel(hole) =
  let (p = [hole[0], hole[1]])
  min([tip_radius - norm(p), norm(p) - max(wheel_bore / 2, wheel_key[1]),
    for (k = [0 : stations - 1]) beyond_slot(p, 2 * half_pitch * k),
    for (k = [0 : stations - 1])
      norm(p - at(centre_distance, half_pitch * (2 * k + 1))) - locking_arc_radius]) > reach(hole);
function in_disc(hole) =
  let (p = [hole[0], hole[1]])
  min([locking_disc_radius - norm(p), norm(p) - max(driver_bore / 2, driver_bore > 0 ? driver_key[1] : 0),
    for (k = [0 : pins - 1]) norm(p - at(crescent_centre, 360 / pins * k)) - crescent_radius]) > reach(hole);
function in_plate(hole) =
  let (p = [hole[0], hole[1]])
  min([plate_radius - norm(p), norm(p) - max(plate_bore / 2, driver_key[1]),
    for (k = [0 : pins - 1])
      norm(p - at(crank_radius, 360 / pins * k)) - max(pin_diameter / 2, pin_hole / 2, nut_width / 2 / cos(30))])
    > reach(hole);
function all(tests) = len([for (test = tests) if (!test) test]) == 0;
function deepest_pocket(holes) = max([0, for (hole = holes) hole[4]]);
assert(all([for (hole = wheel_holes) in_wheel(hole)]), "a hole breaks out of the wheel: change wheel_holes");
assert(all([for (hole = plate_holes) in_plate(hole)]), "a hole breaks out of the plate: change plate_holes");
assert(!has_dwell || all([for (hole = disc_holes) in_disc(hole)]), "a hole breaks out of the locking disc: change disc_holes");
assert(deepest_pocket(concat(wheel_holes, plate_holes, disc_holes)) < thickness, "thickness must be more than the pockets are deep");
assert(wheel_key[0] < wheel_bore || wheel_key[0] == 0, "the wheel's keyway is wider than its bore: change wheel_key");
assert(slot_end - slot_width / 2 > norm([wheel_key[1], wheel_key[0] / 2]) || wheel_key[0] == 0,
  "the wheel's keyway meets the slots: change wheel_key");
assert(driver_key[0] == 0 || driver_bore == 0 || !has_dwell || crescent_bottom > norm([driver_key[1], driver_key[0] / 2])
  || pins == 1 && locking_disc_radius > norm([driver_key[1], driver_key[0] / 2]),
  "the driver's keyway meets a crescent: change driver_key");
assert(base_thickness >= 0, "base_thickness must be 0 or more");
assert(base_thickness == 0 || shoulder_diameter == 0 || shoulder_depth < base_thickness,
  "shoulder_depth must be less than base_thickness");

/* [Show] */
part = "assembly"; // [assembly, wheel, driver, pin, base, overlap]

/* [Hidden] */
// Crank angle from the line of centres at a moment of the turn, and the wheel's angle with it.
function crank(t) = 360 / pins * (t - floor(t + 0.5));
function turn(theta) = abs(theta) < engagement
  ? atan2(crank_radius * sin(theta), centre_distance - crank_radius * cos(theta))
  : sign(theta) * half_pitch;

// Circles with as many corners as the tolerance asks for: solid ones with their corners on the circle, hollow ones with their
// sides on it, so that chords take nothing of the play.
function corners(r) = r > tolerance ? max(12, ceil(180 / acos(1 - tolerance / r))) : 12;
module solid(r) { circle(r = r, $fn = corners(r)); }
module hollow(r) { circle(r = r / cos(180 / corners(r)), $fn = corners(r)); }
module around() { for (k = [0 : pins - 1]) rotate(360 / pins * k) children(); }

module bore(diameter, key, flat, direction) {
  if (diameter > 0) rotate(direction) {
    intersection() {
      hollow(diameter / 2);
      if (flat > 0) translate([-diameter, -diameter]) square([diameter + flat, 2 * diameter]);
      else square(2 * diameter, center = true);
    }
    if (key[0] > 0) translate([0, -key[0] / 2]) square(key);
  }
}

module holes(all) { for (hole = all) translate([hole[0], hole[1]]) hollow(hole[2] / 2); }
module pockets(all) {
  for (hole = all) if (hole[3] > 0)
    translate([hole[0], hole[1], -1]) rotate(hole[5]) cylinder(r = hole[3] / 2 / cos(30), h = hole[4] + 1, $fn = 6);
}

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
        if (pin_hole > 0) around() translate([crank_radius, 0]) hollow(pin_hole / 2);
      }
      pockets(plate_holes);
      if (nut_width > 0) around() translate([crank_radius, 0, -1]) cylinder(r = nut_width / 2 / cos(30), h = nut_depth + 1, $fn = 6);
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
      if (bush_hole > 0) around() translate([crank_radius, 0]) hollow(bush_hole / 2);
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
        if (base_hole > 0) for (corner = at_corners) translate(corner) hollow(base_hole / 2);
        for (axis = axes) if (axis[1] > 0) translate([axis[0], 0]) hollow(axis[1] / 2);
      }
      if (shoulder_diameter > 0) for (axis = axes) if (axis[1] > 0)
        translate([axis[0], 0, base_thickness - shoulder_depth])
          linear_extrude(height = shoulder_depth + 1) hollow(shoulder_diameter / 2);
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
