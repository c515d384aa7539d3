
// Circles with as many corners as the tolerance asks for: solid ones with their corners on the circle, hollow ones with their
// sides on it, so that chords take nothing of the play.
function corners(r) = r > tolerance ? max(12, ceil(180 / acos(1 - tolerance / r))) : 12;
module solid(r) { circle(r = r, $fn = corners(r)); }
module hollow(r) { circle(r = r / cos(180 / corners(r)), $fn = corners(r)); }

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

// Of a hole: how far its pocket reaches from its middle. A point at an angle; whether all tests hold; the deepest pocket.
function reach(hole) = max(hole[2] / 2, hole[3] / 2 / cos(30));
function at(radius, angle) = radius * [cos(angle), sin(angle)];
function all(tests) = len([for (test = tests) if (!test) test]) == 0;
function deepest_pocket(holes) = max([0, for (hole = holes) hole[4]]);
