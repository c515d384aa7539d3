//! Files from which a wheel is made.

use super::design::WheelDesign;
use super::kind::WheelKind;
use crate::Error;
use crate::number_format::as_typed;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::as_built::Yield;
use geneva_kinematics::wheel::{Edge, Sizes};
use geneva_workshop::{
    Part, PartLayout, PartList, Sheet, SheetLimits, SheetMaterial, SheetText, dxf, internal_scad, internal_sheets,
    scad, sheets, sheets_html, sheets_svg, step, stl, svg_parts, test_piece, three_mf,
};

/// Chords leave their arcs by this part of the play at most; without play, by this part of the centre distance.
const OF_PLAY: f64 = 0.1;
const OF_CENTRE_DISTANCE: f64 = 1e-4;

/// Most corners of all outlines of a mesh, which has four triangles for each: more take more memory and time than a printer
/// has use for.
const MOST_CORNERS: f64 = 200_000.0;

/// Metals have a modulus of at least this, in Pa, and plastics and wood far less: our choice.
const METAL: f64 = 40e9;

/// A file from which a wheel is made.
#[derive(Clone, Copy, Debug)]
pub struct ShapeFile {
    /// Its name with its ending.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
    /// Of which wheels it can be made.
    pub of: MadeOf,
    /// Makes it.
    pub make: fn(&WheelDesign) -> Result<Vec<u8>, Error>,
}

/// Of which wheels a file can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MadeOf {
    /// Of all.
    Any,
    /// Of external and internal wheels with a size, whose parts are known.
    Parts,
    /// Of those, unless their play is so small that meshes would have more corners than a printer has use for.
    Meshes,
}

/// All files from which a wheel is made: what the command writes to a folder and the page offers.
pub const SHAPE_FILES: &[ShapeFile] = &[
    ShapeFile {
        name: "drawing.svg",
        label: "Drawing with sizes (SVG)",
        of: MadeOf::Any,
        make: |design| Ok(design.drawing().standalone().into_bytes()),
    },
    ShapeFile {
        name: "drawings.html",
        label: "Drawings for the workshop, to print (HTML)",
        of: MadeOf::Parts,
        make: |design| design.drawings_html().map(String::into_bytes),
    },
    ShapeFile {
        name: "drawings.svg",
        label: "Drawings for the workshop (SVG)",
        of: MadeOf::Parts,
        make: |design| design.drawings_svg().map(String::into_bytes),
    },
    ShapeFile {
        name: "wheel.dxf",
        label: "Outlines for the machine (DXF)",
        of: MadeOf::Parts,
        make: |design| design.dxf().map(String::into_bytes),
    },
    ShapeFile {
        name: "parts.svg",
        label: "Parts to cut (SVG)",
        of: MadeOf::Parts,
        make: |design| design.svg_parts().map(String::into_bytes),
    },
    ShapeFile {
        name: "wheel.step",
        label: "Solids (STEP)",
        of: MadeOf::Parts,
        make: |design| design.step().map(String::into_bytes),
    },
    ShapeFile {
        name: "wheel.3mf",
        label: "Meshes with names and units (3MF)",
        of: MadeOf::Meshes,
        make: |design| design.three_mf(),
    },
    ShapeFile {
        name: "wheel.stl",
        label: "Meshes for a printer (STL)",
        of: MadeOf::Meshes,
        make: |design| design.stl().map(String::into_bytes),
    },
    ShapeFile {
        name: "test-piece.svg",
        label: "Test piece for the play, to cut (SVG)",
        of: MadeOf::Parts,
        make: |design| design.test_piece_svg().map(String::into_bytes),
    },
    ShapeFile {
        name: "test-piece.stl",
        label: "Test piece for the play, to print (STL)",
        of: MadeOf::Parts,
        make: |design| design.test_piece_stl().map(String::into_bytes),
    },
    ShapeFile {
        name: "wheel.scad",
        label: "Moving model (OpenSCAD)",
        of: MadeOf::Parts,
        make: |design| design.scad().map(String::into_bytes),
    },
];

impl WheelDesign {
    /// Whether there is what a file needs.
    pub fn can_make(&self, file: &ShapeFile) -> bool {
        match file.of {
            MadeOf::Any => true,
            MadeOf::Parts => self.has_parts(),
            MadeOf::Meshes => self.has_parts() && !self.mesh_is_too_fine(),
        }
    }

    /// Whether the play is so small that meshes of the parts would have more corners than are written.
    fn mesh_is_too_fine(&self) -> bool {
        let made = self.solid_parts("stl").ok().zip(self.made_sizes("stl").ok());
        made.is_some_and(|(parts, sizes)| corners(&parts, sizes.chords()) > MOST_CORNERS)
    }

    /// Whether it has parts in millimetres with a thickness.
    fn has_parts(&self) -> bool {
        self.sizes.is_some() || (self.is_internal() && self.crank_radius.is_some() && self.question.thickness.is_some())
    }

    fn is_internal(&self) -> bool {
        self.wheel.kind() == WheelKind::Internal
    }

    /// Outlines of all parts side by side, in millimetres, with true arcs.
    ///
    /// # Errors
    ///
    /// A spherical wheel, one that has no size, or can't be mounted as it is asked for.
    pub fn dxf(&self) -> Result<String, Error> {
        Ok(dxf(&self.listed("dxf")?.parts, PartLayout::Apart))
    }

    /// Drawings for a workshop, of all parts in place and a sheet for each, with limits from standards, from the tolerance chains
    /// and from the process.
    ///
    /// # Errors
    ///
    /// A spherical wheel, one that has no size, or can't be mounted as it is asked for.
    pub fn drawings(&self) -> Result<Vec<Sheet>, Error> {
        let sizes = self.made_sizes("drawings")?;
        self.listed("drawings")?;
        let (thickness, mounting) = (self.thickness("drawings")?, self.mounting()?);
        let materials = [self.materials.pin, self.materials.wheel, self.materials.driver];
        let names = materials.map(|material| material.name.replace('-', " "));
        let hardness = materials.map(|material| (material.modulus >= METAL).then_some("not specified"));
        let [pin_material, wheel_material, driver_material] =
            [0, 1, 2].map(|k| SheetMaterial { name: names[k].as_str(), hardness: hardness[k] });
        let text = SheetText { project: &self.project(), wheel_material, driver_material, pin_material };
        let (process, yield_share) = (self.process_numbers()?, self.assemblies_that_turn()?.map(Yield::share));
        let drawn = match sizes {
            MadeSizes::External(sizes) => {
                let limits = SheetLimits { shared: self.shared_tolerance()?.flatten(), process, yield_share };
                sheets(sizes, thickness, &mounting, &limits, &text)
            }
            MadeSizes::Internal(sizes) => {
                let shared = sizes.shared_tolerance_within(self.question.effort.tolerance).ok().flatten();
                internal_sheets(&sizes, thickness, &mounting, &SheetLimits { shared, process, yield_share }, &text)
            }
        };
        drawn.map_err(|error| self.refused_mounting(error))
    }

    /// The [drawings](Self::drawings) one below the other, true to scale.
    ///
    /// # Errors
    ///
    /// As for [`drawings`](Self::drawings).
    pub fn drawings_svg(&self) -> Result<String, Error> {
        Ok(sheets_svg(&self.drawings()?))
    }

    /// The [drawings](Self::drawings) as a page that prints true to scale, each on paper of its own.
    ///
    /// # Errors
    ///
    /// As for [`drawings`](Self::drawings).
    pub fn drawings_html(&self) -> Result<String, Error> {
        Ok(sheets_html(&self.drawings()?, &self.project()))
    }

    /// What is made, in a few words.
    fn project(&self) -> String {
        let stations = self.wheel.indexing().stations();
        let crank = self.crank_radius.map(|radius| format!(", crank radius {} mm", as_typed(rounded(radius))));
        let kind = if self.is_internal() { "Internal Geneva" } else { "Geneva" };
        format!("{kind} wheel, {stations} stations{}", crank.unwrap_or_default())
    }

    /// The parts to be cut from sheets as SVG, true to scale, with a colour for each operation.
    ///
    /// # Errors
    ///
    /// As for [`dxf`](Self::dxf), and a kerf that is too wide for a hole.
    pub fn svg_parts(&self) -> Result<String, Error> {
        let (parts, kerf) = (self.listed("svg-parts")?.parts, self.kerf()?);
        svg_parts(&parts, kerf).map_err(|error| self.refused_mounting(error))
    }

    /// A moving model for OpenSCAD, in millimetres.
    ///
    /// # Errors
    ///
    /// A spherical wheel, one that has no size or no thickness, or can't be mounted as it is asked for.
    pub fn scad(&self) -> Result<String, Error> {
        let sizes = self.made_sizes("scad")?;
        self.listed("scad")?;
        let (thickness, mounting, chords) = (self.thickness("scad")?, self.mounting()?, sizes.chords());
        let model = match sizes {
            MadeSizes::External(sizes) => scad(sizes, thickness, chords, &mounting, self.hole_allowance()?),
            MadeSizes::Internal(sizes) => internal_scad(&sizes, thickness, chords, &mounting, self.hole_allowance()?),
        };
        model.map_err(|error| self.refused_mounting(error))
    }

    /// Meshes of the parts, in millimetres.
    ///
    /// # Errors
    ///
    /// A spherical wheel, one that has no size or no thickness, takes more corners than a printer has use for, or can't be
    /// mounted as it is asked for.
    pub fn stl(&self) -> Result<String, Error> {
        let (parts, tolerance) = self.printed("stl")?;
        stl(&parts, tolerance).map_err(|error| self.refused_mounting(error))
    }

    /// Meshes of the parts with names and units, as an archive for a printer.
    ///
    /// # Errors
    ///
    /// As for [`stl`](Self::stl).
    pub fn three_mf(&self) -> Result<Vec<u8>, Error> {
        let (parts, tolerance) = self.printed("3mf")?;
        three_mf(&parts, tolerance).map_err(|error| self.refused_mounting(error))
    }

    /// Solids of all parts in place, with true planes and cylinders.
    ///
    /// # Errors
    ///
    /// As for [`scad`](Self::scad).
    pub fn step(&self) -> Result<String, Error> {
        let parts = self.solid_parts("step")?;
        step(&parts).map_err(|error| self.refused_mounting(error))
    }

    /// A ladder of slots and pins of the wheel's diameter and thickness: the least play at which the pin runs is measured on it.
    fn test_piece(&self) -> Result<Vec<Part>, Error> {
        let pin = self.made_sizes("test-piece")?.pin_diameter();
        Ok(test_piece(pin, self.thickness("test-piece")?)?)
    }

    /// The test piece to be cut from a sheet, with the play of each slot below it in hundredths of a millimetre.
    ///
    /// # Errors
    ///
    /// A spherical wheel, one that has no size, and a kerf that is too wide.
    pub fn test_piece_svg(&self) -> Result<String, Error> {
        svg_parts(&self.test_piece()?, self.kerf()?).map_err(|error| self.refused_mounting(error))
    }

    /// The test piece as meshes for a printer; the narrowest slot is at the left.
    ///
    /// # Errors
    ///
    /// A spherical wheel, or one without a size.
    pub fn test_piece_stl(&self) -> Result<String, Error> {
        let chords = self.made_sizes("test-piece")?.chords();
        stl(&self.test_piece()?, chords).map_err(|error| self.refused_mounting(error))
    }

    /// The parts for a file with this ending.
    fn listed(&self, ending: &str) -> Result<PartList, Error> {
        self.require_parts(ending)?;
        self.part_list()?.ok_or_else(|| without_size(ending))
    }

    /// How much wider the files of solids have holes than they should become, in millimetres, since the process makes them narrower by
    /// so much; below zero narrower.
    fn hole_allowance(&self) -> Result<f64, Error> {
        Ok(self.process_numbers()?.map_or(0.0, |numbers| 0.0 - numbers.hole_growth.value))
    }

    /// The parts for a file of solids, with holes as wide as the process wants them drawn.
    fn solid_parts(&self, ending: &str) -> Result<Vec<Part>, Error> {
        let wider = self.hole_allowance()?;
        let parts = self.listed(ending)?.parts.into_iter().map(|part| part.with_wider_holes(wider)).collect();
        self.thickness(ending)?;
        Ok(parts)
    }

    /// The parts for a file of meshes, and how far its chords leave their arcs.
    fn printed(&self, ending: &str) -> Result<(Vec<Part>, f64), Error> {
        let parts = self.solid_parts(ending)?;
        let sizes = self.made_sizes(ending)?;
        let (play, tolerance) = (sizes.slot_play(), sizes.chords());
        let corners = corners(&parts, tolerance);
        if corners > MOST_CORNERS {
            return Err(refused!(
                "--format {ending}, --play {}: with chords of a tenth of the play the outlines would have {corners:.0} corners, \
                 but at most {MOST_CORNERS} are written; give a larger --play or fewer --stations, or choose --format scad",
                as_typed(play)
            ));
        }
        Ok((parts, tolerance))
    }

    /// Refuses a file with this ending of a spherical wheel, whose parts are not worked out.
    ///
    /// # Errors
    ///
    /// What to choose instead.
    pub fn require_parts(&self, ending: &str) -> Result<(), Error> {
        if self.wheel.kind() != WheelKind::Spherical {
            return Ok(());
        }
        Err(refused!(
            "--format {ending} is not available for {} wheels, whose parts are not worked out; choose --type external or --type internal, or \
             --format svg for a drawing",
            self.wheel.kind().name()
        ))
    }

    /// The sizes of an external or an internal wheel, for a file with this ending.
    fn made_sizes(&self, ending: &str) -> Result<MadeSizes<'_>, Error> {
        self.require_parts(ending)?;
        let made = match &self.sizes {
            Some(sizes) => Some(MadeSizes::External(sizes)),
            None => self.internal_sizes()?.map(MadeSizes::Internal),
        };
        made.ok_or_else(|| without_size(ending))
    }

    fn thickness(&self, ending: &str) -> Result<f64, Error> {
        self.made_thickness().ok_or_else(|| refused!("--format {ending} needs a thickness; add --thickness MM"))
    }
}

/// The sizes of a wheel whose parts are known.
enum MadeSizes<'a> {
    External(&'a Sizes),
    Internal(InternalSizes),
}

impl MadeSizes<'_> {
    fn pin_diameter(&self) -> f64 {
        match self {
            Self::External(sizes) => sizes.pin_diameter,
            Self::Internal(sizes) => sizes.pin_diameter,
        }
    }

    fn slot_play(&self) -> f64 {
        match self {
            Self::External(sizes) => sizes.play.slot,
            Self::Internal(sizes) => sizes.play.slot,
        }
    }

    /// How far a chord may leave its arc, in millimetres.
    fn chords(&self) -> f64 {
        let centres = match self {
            Self::External(sizes) => sizes.centre_distance,
            Self::Internal(sizes) => sizes.centre_distance,
        };
        tolerance(self.slot_play(), centres)
    }
}

/// A length in millimetres with three decimals.
fn rounded(length: f64) -> f64 {
    libm::round(length * 1000.0) / 1000.0
}

/// How many corners the outlines of all parts have as polygons: counted before any is made.
fn corners(parts: &[Part], tolerance: f64) -> f64 {
    let of = |edge: &Edge| match edge {
        Edge::Line { .. } => 1.0,
        // A chord of the angle x leaves its arc by r (1 − cos(x/2)).
        Edge::Arc { radius, sweep, .. } => (sweep.abs() / (8.0 * tolerance / radius).sqrt()).max(1.0),
    };
    let loops = |part: &Part| part.face().loops().flat_map(|line| &line.edges).map(of).sum::<f64>();
    parts.iter().map(|part| loops(part) * part.quantity() as f64).sum()
}

/// The error about a file of parts without a size.
fn without_size(ending: &str) -> Error {
    refused!("--format {ending} needs a size in mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM")
}

/// How far a chord may leave its arc, in millimetres.
fn tolerance(play: f64, centre_distance: f64) -> f64 {
    if play > 0.0 { OF_PLAY * play } else { OF_CENTRE_DISTANCE * centre_distance }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wheel::{ArgumentSlot, WheelQuestion, arguments};
    use geneva_kinematics::wheel::as_built::Process;

    #[test]
    fn corners_are_as_many_as_a_mesh_has() {
        for (stations, thickness) in [(4, 6.0), (6, 10.0), (11, 3.0)] {
            let question = WheelQuestion {
                stations: Some(stations),
                crank_radius: Some(40.0),
                thickness: Some(thickness),
                ..WheelQuestion::default()
            };
            let design = WheelDesign::new(question).expect("a wheel");
            let (parts, tolerance) = design.printed("stl").expect("parts");
            let triangles = design.stl().expect("meshes").matches("facet normal").count();
            // Four for each corner of a face: two on its wall, one on either side; the holes of pins are filled.
            let counted = 4.0 * corners(&parts, tolerance);
            assert!((counted / triangles as f64 - 1.0).abs() < 0.15, "{stations}: {counted} and {triangles}");
        }
    }

    #[test]
    fn an_internal_wheel_has_files_too_and_a_spherical_one_has_none() {
        let question = |kind| WheelQuestion {
            stations: Some(6),
            kind: Some(kind),
            crank_radius: Some(40.0),
            thickness: Some(6.0),
            ..WheelQuestion::default()
        };
        let internal = WheelDesign::new(question(WheelKind::Internal)).expect("a wheel");
        let drawings = internal.drawings_html();
        for file in [internal.dxf(), internal.svg_parts(), internal.stl(), internal.step(), internal.scad(), drawings] {
            assert!(file.expect("a file").len() > 1000);
        }
        assert!(internal.three_mf().is_ok());
        let text = "--stations 6 --type internal --crank-radius 40 --thickness 6 --process fdm";
        let printed = WheelDesign::new(WheelQuestion::parse(text).expect("a question")).expect("a wheel");
        assert!(printed.drawings_html().expect("sheets").contains("expect at least "));
        let refused = |more: &str| {
            let text = format!("--stations 6 --type internal --crank-radius 40 --thickness 6 {more}");
            let question = WheelQuestion::parse(&text).expect("a question");
            WheelDesign::new(question).expect("a wheel").dxf().expect_err("refused").to_string()
        };
        assert!(refused("--driver-shaft 8").contains("--plate-shaft 8"));
        assert!(
            refused("--mouth-radius 1")
                .starts_with("--mouth-radius 1: the slots of an internal wheel have sharp mouths")
        );
        // A bush's screw has its head where the ring plate is; the screw itself has room, and so has a dowel.
        let with_pin = |more: &str| {
            let text = format!("--stations 6 --type internal --crank-radius 40 --thickness 6 {more}");
            WheelDesign::new(WheelQuestion::parse(&text).expect("a question")).expect("a wheel").step().map(|_| ())
        };
        let said = with_pin("--pin-diameter 6 --pin-screw M3").expect_err("no room").to_string();
        assert!(said.contains("give --pin-diameter 3, which is then the screw itself, or --pin-mount dowel"), "{said}");
        for right in ["--pin-diameter 3 --pin-screw M3", "--pin-diameter 6 --pin-mount dowel"] {
            assert_eq!(with_pin(right), Ok(()), "{right}");
        }
        let spherical = WheelDesign::new(question(WheelKind::Spherical)).expect("a wheel");
        for file in [spherical.step(), spherical.scad(), spherical.drawings_svg()] {
            let said = file.expect_err("no parts").to_string();
            assert!(said.contains("spherical wheels"), "{said}");
        }
    }

    #[test]
    fn what_one_file_of_parts_refuses_all_refuse_in_the_same_words() {
        for (text, words) in [
            ("--stations 6 --crank-radius 60 --plate-shaft 90", "can't be one piece"),
            ("--stations 6 --type internal --crank-radius 40 --thickness 6 --plate-shaft 70", "can't be one piece"),
            (
                "--stations 6 --crank-radius 60 --thickness 2 --pin-screw M6 --pin-screw-hole nut-trap",
                "only 2 mm thick",
            ),
        ] {
            let design = WheelDesign::new(WheelQuestion::parse(text).expect("a question")).expect("a wheel");
            let of_parts = |file: &&ShapeFile| file.of != MadeOf::Any && !file.name.starts_with("test-piece");
            for file in SHAPE_FILES.iter().filter(of_parts) {
                let said = (file.make)(&design).expect_err(file.name).to_string();
                let first = design.step().expect_err("refused").to_string();
                assert!(said == first && said.contains(words), "{}: {said}; {first}", file.name);
            }
        }
    }

    #[test]
    fn drawings_say_what_is_made_of_what_and_how_large() {
        let text = "--stations 6 --crank-radius 40 --play 0.3 --wheel-material cast-iron --pin-mount dowel";
        let design = WheelDesign::new(WheelQuestion::parse(text).expect("a question")).expect("a wheel");
        let page = design.drawings_html().expect("a page");
        for words in
            ["Geneva wheel, 6 stations, crank radius 40 mm", ">cast iron<", ">steel<", "2 of 5", "@page", ">Assembly<"]
        {
            assert!(page.contains(words), "{words}");
        }
        assert_eq!(page.matches("<svg ").count(), design.drawings().expect("sheets").len());
        assert!(design.drawings_svg().expect("a drawing").contains("viewBox=\"0 0 "));
    }

    #[test]
    fn drawings_for_a_process_tell_its_yield_and_cut_sheet_makes_two_pieces() {
        let page = |more: &str| {
            let text = format!("--stations 6 --crank-radius 25 --wheel-shaft 5 --driver-shaft 5 --thickness 3 {more}");
            let design = WheelDesign::new(WheelQuestion::parse(&text).expect("a question")).expect("a wheel");
            let solids = design.step().expect("solids").matches("MANIFOLD_SOLID_BREP").count();
            (design.drawings_html().expect("a page"), solids)
        };
        let (laser, solids) = page("--process laser --wheel-material acrylic --pin-material acrylic");
        assert!(laser.contains("assemblies") && laser.contains("Process laser: it holds ±0.127"), "{laser}");
        assert!(!laser.contains("Hardness") && !laser.contains("in one piece with"));
        assert_eq!(solids, 4, "wheel, disc, plate and pin");
        let (printed, solids) = page("--process fdm");
        assert!(printed.contains("in one piece with") && solids == 2);
        let text = "--stations 6 --crank-radius 25 --thickness 3 --process laser --driver-pieces one-piece";
        let one_piece = WheelDesign::new(WheelQuestion::parse(text).expect("a question")).expect("a wheel");
        for made in [one_piece.drawings_html(), one_piece.svg_parts(), one_piece.dxf(), one_piece.step()] {
            let said = made.expect_err("a laser cuts through").to_string();
            assert!(said.starts_with("--driver-pieces one-piece: a laser"), "{said}");
        }
        let (routed, solids) = page("--process router --driver-pieces one-piece");
        assert!(routed.contains("in one piece with") && solids == 2);
    }

    #[test]
    fn a_choice_whose_first_name_is_not_always_what_holds_has_an_entry_of_its_own_for_that() {
        let named = |question: &WheelQuestion| {
            let design = WheelDesign::new(question.clone()).expect("a wheel");
            design.part_list().map(|list| format!("{list:?}")).map_err(|error| error.to_string())
        };
        for argument in arguments() {
            let ArgumentSlot::Choice(choice) = argument.place else { continue };
            let differs = |process: Process| {
                let question = "--stations 6 --crank-radius 60 --thickness 8 --wheel-shaft 16 --driver-shaft 8";
                let unsaid =
                    WheelQuestion { process: Some(process), ..WheelQuestion::parse(question).expect("arguments") };
                let mut said = unsaid.clone();
                (choice.set)(&mut said, 0);
                named(&said) != named(&unsaid)
            };
            assert_eq!(Process::ALL.into_iter().any(differs), choice.with_usual.is_some(), "{}", argument.name);
            assert!(choice.on_page().starts_with(choice.names), "{}", argument.name);
        }
    }
}
