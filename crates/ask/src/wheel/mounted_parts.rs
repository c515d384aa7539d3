//! The parts of a design, mounted as it is asked for.

use super::arguments::ActsOn;
use super::design::WheelDesign;
use super::fitting::Fit;
use super::kind::AnyWheel;
use super::mounting::MountingQuestion;
use super::mounting_error::with_remedies_of_mounting;
use super::mouth::given_mouths;
use super::question::WheelQuestion;
use super::ranges::refuse_out_of_range;
use super::sized;
use crate::Error;
use crate::number_format::as_typed;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::as_built::Process;
use geneva_workshop::{
    Layer, Mounting, MountingError, Part, PartList, ShaftFit, internal_parts, parts, svg_parts, validate_joined,
    validate_solids,
};

impl WheelDesign {
    /// The parts with all their holes, of an external or an internal wheel; none without a size, or of a spherical wheel. All files are of
    /// these parts, so what one of them can't have, none has.
    ///
    /// # Errors
    ///
    /// What can't be mounted as it is asked for or is deeper than its part is thick, and sizes of an internal wheel that don't fit.
    pub fn part_list(&self) -> Result<Option<PartList>, Error> {
        self.refuse_mounting_out_of_range()?;
        let internal = self.internal_sizes()?;
        let Some(found) = self.listed_with(internal.as_ref(), &self.mounting()?) else { return Ok(None) };
        // Without a thickness, only outlines can be wrong.
        let validate = if self.made_thickness().is_some() { validate_solids } else { validate_joined };
        let found = found.and_then(|list| validate(&list.parts).map(|()| list));
        found.map(Some).map_err(|error| self.refused_mounting(error))
    }

    /// The parts of which no file is then refused; none as of [`part_list`](Self::part_list), and of an internal wheel
    /// whose usual parts don't fit while nothing of them is chosen.
    ///
    /// # Errors
    ///
    /// As of [`part_list`](Self::part_list), and a kerf that is too wide.
    pub(super) fn makeable_parts(&self) -> Result<Option<PartList>, Error> {
        if self.sizes.is_none() && self.reported_internal_sizes()?.is_none() {
            return self.mounting().map(|_| None);
        }
        let list = self.part_list()?;
        // Without a kerf nothing is moved.
        if list.is_some() && self.made_thickness().is_some() && self.kerf()? != 0.0 {
            self.svg_parts()?;
            self.test_piece_svg()?;
        }
        Ok(list)
    }

    /// The error about parts that can't be mounted, with the arguments that mend it.
    pub(super) fn refused_mounting(&self, error: MountingError) -> Error {
        let internal = self.internal_sizes().ok().flatten();
        with_remedies_of_mounting(error, &self.question, &|other| self.mounted_fit(internal.as_ref(), other))
    }

    /// Refuses numbers of the mounting that make no sense, with values with which these parts can be mounted.
    ///
    /// # Errors
    ///
    /// The argument, its value, and the values to give; and sizes of an internal wheel that don't fit.
    pub(super) fn refuse_mounting_out_of_range(&self) -> Result<(), Error> {
        let internal = self.internal_sizes()?;
        refuse_out_of_range(&self.question, true, &|other| self.mounted_fit(internal.as_ref(), other) != Fit::Not)
    }

    /// How the parts of this wheel fit that are mounted as another question asks, and cut out.
    pub(super) fn mounted_fit(&self, internal: Option<&InternalSizes>, other: &WheelQuestion) -> Fit {
        let asked = &other.mounting;
        let (mounting, kerf) = (self.mounting_of(asked), asked.kerf.map_or_else(|| self.kerf(), Ok));
        let list = mounting.ok().and_then(|mounting| self.listed_with(internal, &mounting)?.ok());
        let is_refused = |list: &PartList| self.made_thickness().is_some() && validate_solids(&list.parts).is_err();
        let list = list.filter(|list| kerf.is_ok_and(|kerf| svg_parts(&list.parts, kerf).is_ok()) && !is_refused(list));
        list.map_or(Fit::Not, |list| Fit::of(list.thin_walls.is_empty()))
    }

    /// The parts of this wheel, or of an internal one of these sizes, so mounted; none without a size.
    pub(super) fn listed_with(
        &self,
        internal: Option<&InternalSizes>,
        mounting: &Mounting,
    ) -> Option<Result<PartList, MountingError>> {
        // Drawings of outlines have nothing of the thickness.
        let thickness = |pin: f64| self.made_thickness().unwrap_or(pin);
        match (&self.sizes, internal) {
            (Some(sizes), _) => Some(parts(sizes, thickness(sizes.pin_diameter), mounting)),
            (None, Some(sizes)) => Some(internal_parts(sizes, thickness(sizes.pin_diameter), mounting)),
            (None, None) => None,
        }
    }

    /// The moment of inertia in kg m² of the wheel, of an internal one with the plate that closes it, with all their holes; none where
    /// they have no hole but round bores, whose outlines say the same, or can't be mounted as it is asked for.
    pub(super) fn inertia_with_holes(&self) -> Option<f64> {
        self.wheel_inertia?;
        let mounting = self.mounting().ok()?;
        let dowels = mounting.disc_dowels.filter(|_| self.sizes.is_none());
        let is_round = mounting.wheel_fit == ShaftFit::Round;
        if is_round && mounting.wheel_hub.is_none() && dowels.is_none() {
            return None;
        }
        let internal = self.internal_sizes().ok()?;
        let list = self.listed_with(internal.as_ref(), &mounting)?.ok()?.parts;
        let turns = |part: &&Part| matches!(part.layer, Layer::Wheel | Layer::RingPlate);
        Some(list.iter().filter(turns).map(|part| part.moment_of_inertia(self.materials.wheel.density)).sum())
    }

    /// Least thickness of an external wheel around its bore with its keyway or flat, in millimetres; none without a bore, and where the
    /// wheel can't be mounted as it is asked for.
    pub(super) fn bore_web(&self) -> Option<f64> {
        let sizes = self.sizes.filter(|sizes| sizes.wheel_bore() > 0.0)?;
        let mounting = Mounting { wheel_fit: self.mounting().ok()?.wheel_fit, ..Mounting::default() };
        if mounting.wheel_fit == ShaftFit::Round {
            return Some(sizes.bore_web());
        }
        self.listed_with(None, &mounting)?.ok()?.parts.iter().find(|part| part.layer == Layer::Wheel)?.bore_web()
    }

    /// The mounting of these parts.
    ///
    /// # Errors
    ///
    /// Arguments that need another one, or exclude one another.
    pub(super) fn mounting(&self) -> Result<Mounting, Error> {
        self.mounting_of(&self.question.mounting)
    }

    /// The mounting of these parts that is asked for.
    fn mounting_of(&self, asked: &MountingQuestion) -> Result<Mounting, Error> {
        // What is cut out of a sheet has one height.
        let is_of_sheet = matches!(self.question.process, Some(Process::Laser | Process::Router));
        if (self.question.process, asked.stacked) == (Some(Process::Laser), Some(false)) {
            return Err(refused!(
                "--driver-pieces one-piece: a laser cuts through its sheet, and leaves no disc standing on a plate; give --driver-pieces \
                 two-pieces, or another --process"
            ));
        }
        let of_process = self.process_numbers()?.map(|numbers| numbers.axial_play.value);
        Ok(Mounting {
            axial_play: self.axial_play().or(self.question.axial_play).or(of_process),
            is_stacked: asked.stacked.unwrap_or(is_of_sheet),
            ..asked.mounting()?
        })
    }

    /// The sizes of an internal wheel that are reported: none without a size, and none where nothing of the parts is chosen and the
    /// usual ones don't fit.
    ///
    /// # Errors
    ///
    /// Choices that fit no such wheel.
    pub(super) fn reported_internal_sizes(&self) -> Result<Option<InternalSizes>, Error> {
        let is_chosen = self.question.numbers().iter().any(|(argument, _)| argument.acts_on.contains(&ActsOn::Parts));
        self.internal_sizes().or_else(|refused| if is_chosen { Err(refused) } else { Ok(None) })
    }

    /// The gap between ring and plate of an internal wheel along the axes, in millimetres.
    pub(super) fn axial_play_of_internal(&self, sizes: &InternalSizes) -> f64 {
        self.mounting().ok().and_then(|mounting| mounting.axial_play).unwrap_or(sizes.play.slot)
    }

    /// The sizes of an internal wheel with a size.
    pub(super) fn internal_sizes(&self) -> Result<Option<InternalSizes>, Error> {
        let (AnyWheel::Internal(wheel), Some(radius)) = (&self.wheel, self.crank_radius) else { return Ok(None) };
        let question = &self.question;
        if let Some(shaft) = question.driver_shaft.filter(|shaft| *shaft > 0.0) {
            return Err(refused!(
                "--driver-shaft {0}: the ring of an internal wheel passes over the driver's axis, so its shaft ends in the plate; \
                 give --plate-shaft {0} instead",
                as_typed(shaft)
            ));
        }
        if let Some((name, size)) = given_mouths(question).next() {
            return Err(refused!(
                "--{name} {}: the slots of an internal wheel have sharp mouths; leave it out, or choose --type external",
                as_typed(size)
            ));
        }
        sized::internal_sizes(*wheel, radius, question).map(Some)
    }

    /// Width in millimetres that the cut takes away: what is given, or that of the process.
    pub(super) fn kerf(&self) -> Result<f64, Error> {
        let of_process = self.process_numbers()?.map_or(0.0, |numbers| numbers.kerf.value);
        Ok(self.question.mounting.kerf.unwrap_or(of_process))
    }

    /// The thickness of the parts; the program chooses none for an internal wheel.
    pub(super) fn made_thickness(&self) -> Option<f64> {
        self.thickness.or(self.question.thickness)
    }
}
