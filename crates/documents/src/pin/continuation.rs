//! What the page that continues the problem prints of the drawing, which the copy lacks.
//!
//! The page is one of the pages elsewhere, where these characters are claims. The problem's own marks
//! rest on them as on an outside witness.

/// The arrow of the wheel's angular velocity.
pub(crate) const WHEEL_ARROW: &str = "an arrow that turns clockwise";

/// The arrow of the pin's velocity along the slot.
pub(crate) const SLIDING_ARROW: &str = "an arrow down and to the left, with the angle from the horizontal";
