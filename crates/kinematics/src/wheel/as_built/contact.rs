//! Which parts of a wheel and its driver meet.

/// Which parts stop the wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BuiltContact {
    /// A pin on a wall of its slot.
    PinOnWall,
    /// A pin at a corner of its slot's mouth.
    PinAtMouth,
    /// A pin on the face of a mouth that is not sharp: a chamfer, a rounding or a lead-in.
    PinOnFace,
    /// A pin at the round end of its slot.
    PinAtBottom,
    /// The rim of the locking disc in its arc, or at the arc's end.
    DiscInArc,
    /// An edge of a crescent's opening in a locking arc.
    OpeningEdge,
    /// A horn's tip in a crescent.
    Crescent,
    /// Nothing within a whole pitch.
    Nothing,
}
