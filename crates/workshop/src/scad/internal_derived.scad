
/* [Hidden] */
assert(stations >= 3 && stations == floor(stations), "stations must be a whole number from 3 on");
assert(crank_radius > 0, "crank_radius must be above 0");
assert(pin_diameter > 0, "pin_diameter must be above 0");
assert(horn_thickness > 0, "horn_thickness must be above 0");
assert(bottom_clearance >= 0, "bottom_clearance must be 0 or more");
assert(slot_play >= 0 && locking_play >= 0 && axial_play >= 0, "no play must be below 0");
assert(thickness > 0, "thickness must be above 0");
assert(tolerance > 0, "tolerance must be above 0");
assert(min(wheel_bore, plate_bore, pin_hole) >= 0, "a diameter must be 0 or more");

half_pitch = 180 / stations;
engagement = 90 + half_pitch;
centre_distance = crank_radius / sin(half_pitch);
wheel_radius = centre_distance * cos(half_pitch);
pin_radius = pin_diameter / 2;
slot_width = pin_diameter + slot_play;
slot_end = centre_distance + crank_radius + bottom_clearance;
mouth_radius = norm([wheel_radius, slot_width / 2]);
outside_radius = slot_end + slot_width / 2 + pin_diameter;
locking_arc_radius = crank_radius - slot_width / 2 - horn_thickness;
plate_radius = crank_radius + pin_diameter;

assert(locking_arc_radius > 0 && locking_arc_radius + mouth_radius > centre_distance,
  "the locking arcs miss the wheel: make pin_diameter or horn_thickness smaller");

// Where the tip of a horn is: from the slot's middle, seen from the wheel's axis.
meeting = (pow(centre_distance, 2) + pow(mouth_radius, 2) - pow(locking_arc_radius, 2)) / (2 * centre_distance);
tip_angle = half_pitch - atan2(sqrt(max(0, pow(mouth_radius, 2) - pow(meeting, 2))), meeting);

segment_outer = locking_arc_radius - locking_play / 2;
segment_half = 90 - half_pitch;
assert(segment_outer > 0, "the play leaves no locking segment: make locking_play smaller");

// How far from the driver's axis the tips come that pass the segment within its outer radius; it is opposite to the pin.
angles = 2000;
passing = [for (k = [0 : angles])
  let (theta = engagement * k / angles,
    phi = atan2(crank_radius * sin(theta), centre_distance + crank_radius * cos(theta)))
  for (slot = [-1 : 1], side = [-1, 1])
    let (at = phi + 2 * half_pitch * slot + side * tip_angle,
      x = mouth_radius * cos(at) - centre_distance, y = mouth_radius * sin(at), far = norm([x, y]),
      angle = atan2(y, x) - theta, beside = 180 - (angle - 360 * floor(angle / 360)))
    if (far < segment_outer && abs(beside) < segment_half + 9 / PI) far];
swing = slot_play / 2 * mouth_radius / wheel_radius;
least_inner = max(concat([0], passing)) + locking_play / 2 + swing + 1e-5 * centre_distance;
assert(least_inner < segment_outer,
  "the horns of the wheel leave no locking segment: make pin_diameter or horn_thickness smaller");
segment_inner = max(least_inner, segment_outer - horn_thickness);

assert(wheel_bore < 2 * outside_radius, "the bore is wider than the ring plate: make wheel_bore smaller");
assert(crank_radius - max(pin_diameter, pin_hole) / 2 > plate_bore / 2,
  "the plate's bore meets the pin: make plate_bore smaller");
assert(pin_hole == 0 || pin_hole <= pin_diameter + slot_play, "pin_hole is wider than the pin: make it smaller");
assert(plate_radius - crank_radius > max(pin_hole, nut_width / cos(30)) / 2,
  "the pin's hole or nut breaks out of the plate: make pin_hole or nut_width smaller");
assert(nut_depth < thickness, "nut_depth must be less than thickness");

// Whether a hole keeps off the hollow of the ring, off bores and pin.
function beyond_slot(p, angle) =
  let (x = p[0] * cos(angle) + p[1] * sin(angle), y = p[1] * cos(angle) - p[0] * sin(angle))
  (x < 0 ? norm(p) : x < slot_end ? abs(y) : norm([x - slot_end, y])) - slot_width / 2;
function in_ring(hole) =
  let (p = [hole[0], hole[1]])
  min([outside_radius - norm(p), norm(p) - mouth_radius,
    for (k = [0 : stations - 1]) beyond_slot(p, 2 * half_pitch * k),
    for (k = [0 : stations - 1])
      norm(p - at(centre_distance, half_pitch * (2 * k + 1))) - locking_arc_radius]) > reach(hole);
function in_ring_plate(hole) =
  let (p = [hole[0], hole[1]])
  min(outside_radius - norm(p), norm(p) - max(wheel_bore / 2, wheel_key[1])) > reach(hole);
function in_plate(hole) =
  let (p = [hole[0], hole[1]])
  min(plate_radius - norm(p), norm(p) - max(plate_bore / 2, driver_key[1]),
    norm(p - [crank_radius, 0]) - max(pin_diameter / 2, pin_hole / 2, nut_width / 2 / cos(30))) > reach(hole);
assert(all([for (hole = ring_holes) in_ring(hole)]), "a hole breaks out of the ring: change ring_holes");
assert(all([for (hole = ring_plate_holes) in_ring_plate(hole)]), "a hole breaks out of the ring plate: change ring_plate_holes");
assert(all([for (hole = plate_holes) in_plate(hole)]), "a hole breaks out of the plate: change plate_holes");
assert(deepest_pocket(concat(ring_holes, ring_plate_holes, plate_holes)) < thickness,
  "thickness must be more than the pockets are deep");
assert(wheel_key[0] < wheel_bore || wheel_key[0] == 0, "the wheel's keyway is wider than its bore: change wheel_key");
assert(driver_key[0] < plate_bore || driver_key[0] == 0, "the driver's keyway is wider than its bore: change driver_key");
assert(outside_radius > norm([wheel_key[1], wheel_key[0] / 2]), "the wheel's keyway breaks out of the ring plate: change wheel_key");
assert(crank_radius - max(pin_diameter, pin_hole) / 2 > norm([driver_key[1], driver_key[0] / 2]),
  "the driver's keyway meets the pin: change driver_key");
