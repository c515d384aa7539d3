
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

// Whether a hole keeps off slots, locking arcs, crescents and bores.
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
