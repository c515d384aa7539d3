
// Circles with as many corners as the tolerance asks for: solid ones with their corners on the circle, hollow ones with their
// sides on it, so that chords take nothing of the play.
function corners(r) = r > tolerance ? max(12, ceil(180 / acos(1 - tolerance / r))) : 12;
module solid(r) { circle(r = r, $fn = corners(r)); }
module hollow(r) { circle(r = r / cos(180 / corners(r)), $fn = corners(r)); }

// Holes and pockets are drawn wider by hole_allowance than they should become; slots and locking arcs are not, for they have plays.
module hole(diameter) { hollow((diameter + hole_allowance) / 2); }
module widened() { offset(r = hole_allowance / 2, $fn = 48) children(); }
module nut_pocket(width, depth) {
  if (width > 0) translate([0, 0, -1]) linear_extrude(height = depth + 1) widened() circle(r = width / 2 / cos(30), $fn = 6);
}

module bore(diameter, key, flat, direction) {
  if (diameter > 0 && key[0] == 0 && flat == 0) hole(diameter);
  else if (diameter > 0) rotate(direction) widened() {
    intersection() {
      hollow(diameter / 2);
      if (flat > 0) translate([-diameter, -diameter]) square([diameter + flat, 2 * diameter]);
      else square(2 * diameter, center = true);
    }
    if (key[0] > 0) translate([0, -key[0] / 2]) square([key[1], key[0]]);
  }
}

module holes(all) { for (row = all) translate([row[0], row[1]]) hole(row[2]); }
module pockets(all) {
  for (row = all) translate([row[0], row[1]]) rotate(row[5]) nut_pocket(row[3], row[4]);
}

// Of a hole: how far its pocket reaches from its middle. A point at an angle; whether all tests hold; the deepest pocket.
function reach(hole) = max(hole[2] / 2, hole[3] / 2 / cos(30)) + hole_allowance / 2;
function at(radius, angle) = radius * [cos(angle), sin(angle)];
function all(tests) = len([for (test = tests) if (!test) test]) == 0;
function deepest_pocket(holes) = max([0, for (hole = holes) hole[4]]);
