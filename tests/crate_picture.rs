//! Does the picture in the document on the architecture show the crates as their manifests have them? The picture is drawn from
//! the manifests and written anew where it stands otherwise.

use std::collections::{BTreeMap, BTreeSet};

/// Width of the picture, heights of a floor and a box, room between boxes and around names, and width of a letter, in pixels.
const WIDTH: f64 = 640.0;
const FLOOR: f64 = 72.0;
const BOX: f64 = 36.0;
const GAP: f64 = 16.0;
const LETTER: f64 = 13.0;
/// How often the floors are put in order from top to bottom and back.
const SWEEPS: usize = 400;

/// The crates, each with those that it uses.
type Crates = BTreeMap<String, BTreeSet<String>>;

/// What a floor holds: the box of a crate, or a place without a name where an arrow passes by on its way to a lower floor.
struct Spot {
    name: String,
    floor: usize,
    width: f64,
    x: f64,
}

/// The spots, in no order, and each arrow as the spots through which it leads.
#[derive(Default)]
struct Layout {
    spots: Vec<Spot>,
    arrows: Vec<Vec<usize>>,
    lowest: usize,
}

/// Our crates by their manifests: what they use beside their tests.
fn crates() -> Crates {
    let mut crates = Crates::new();
    for (path, text) in crate::files("crates", &["/Cargo.toml"]) {
        let manifest: toml::Table = text.parse().expect("TOML");
        let used = manifest.get("dependencies").and_then(|used| used.as_table());
        let names = used.into_iter().flat_map(|used| used.keys());
        let own = names.filter_map(|name| name.strip_prefix("geneva-")).map(str::to_owned).collect();
        let folder = path.parent().and_then(|folder| folder.file_name()).expect("a crate's folder");
        crates.insert(folder.to_string_lossy().into_owned(), own);
    }
    crates
}

/// All crates that a crate uses, also by a detour.
fn reached(crates: &Crates, name: &str) -> BTreeSet<String> {
    let used = &crates[name];
    used.iter().cloned().chain(used.iter().flat_map(|below| reached(crates, below))).collect()
}

/// The crates without what they use by a detour, too.
fn arrows(crates: &Crates) -> Crates {
    let direct = |used: &BTreeSet<String>| {
        let detours: BTreeSet<_> = used.iter().flat_map(|below| reached(crates, below)).collect();
        used.difference(&detours).cloned().collect()
    };
    crates.iter().map(|(name, used)| (name.clone(), direct(used))).collect()
}

/// The floor of a crate: one below the lowest crate that uses it, from zero at the top.
fn floor(crates: &Crates, name: &str) -> usize {
    let users = crates.iter().filter(|(_, used)| used.contains(name));
    users.map(|(user, _)| floor(crates, user) + 1).max().unwrap_or(0)
}

impl Layout {
    /// Boxes and arrows, in the order of all that was tried in which the arrows are shortest.
    fn new(arrows: &Crates) -> Self {
        let mut layout = Self::default();
        let add = |layout: &mut Self, floor, name: &str| {
            let width = if name.is_empty() { 0.0 } else { LETTER * name.len() as f64 + GAP };
            layout.lowest = layout.lowest.max(floor);
            layout.spots.push(Spot { name: name.to_owned(), floor, width, x: 0.0 });
            layout.spots.len() - 1
        };
        let boxes: BTreeMap<_, _> =
            arrows.keys().map(|name| (name, add(&mut layout, floor(arrows, name), name))).collect();
        for (user, name) in arrows.iter().flat_map(|(user, used)| used.iter().map(move |name| (user, name))) {
            let between = floor(arrows, user) + 1..floor(arrows, name);
            let passed: Vec<_> = between.map(|floor| add(&mut layout, floor, "")).collect();
            layout.arrows.push([vec![boxes[user]], passed, vec![boxes[name]]].concat());
        }
        let (lowest, mut best) = (layout.lowest, (f64::INFINITY, Vec::new()));
        for sweep in 0..SWEEPS {
            if sweep % 10 == 0 {
                // Another order to begin with.
                layout.spots.iter_mut().enumerate().for_each(|(at, spot)| spot.x = (at * (sweep + 1) % 97) as f64);
            }
            (0..=lowest).chain((0..lowest).rev()).for_each(|floor| layout.arrange(floor));
            if layout.length() < best.0 {
                best = (layout.length(), layout.spots.iter().map(|spot| spot.x.round()).collect());
            }
        }
        layout.spots.iter_mut().zip(best.1).for_each(|(spot, x)| spot.x = x);
        layout
    }

    /// The pieces of arrows from one floor to the next.
    fn pieces(&self) -> impl Iterator<Item = (usize, usize)> {
        self.arrows.iter().flat_map(|through| through.windows(2)).map(|pair| (pair[0], pair[1]))
    }

    /// How far the arrows lead sideways: the less, the fewer cross.
    fn length(&self) -> f64 {
        self.pieces().map(|(from, to)| (self.spots[from].x - self.spots[to].x).abs()).sum()
    }

    /// Puts the spots of a floor in the order of what they are tied to, each as near to the middle of that as its neighbours allow.
    fn arrange(&mut self, floor: usize) {
        let wanted = |at: usize| {
            let tied = self.pieces().filter(|(from, to)| at == *from || at == *to);
            let others: Vec<_> = tied.map(|(from, to)| self.spots[from + to - at].x).collect();
            others.iter().sum::<f64>() / others.len().max(1) as f64
        };
        let spots = (0..self.spots.len()).filter(|at| self.spots[*at].floor == floor);
        let mut row: Vec<_> = spots.map(|at| (wanted(at), at)).collect();
        row.sort_by(|one, other| one.0.total_cmp(&other.0));
        // From the left none is nearer than it may be; then all move by the mean of what that cost, and back into the picture.
        let (mut end, mut moved, mut least) = (f64::NEG_INFINITY, 0.0, f64::INFINITY);
        for (wanted, at) in &row {
            let half = self.spots[*at].width / 2.0;
            let x = wanted.max(end + GAP + half);
            (end, moved, least) = (x + half, moved + x - wanted, least.min(x - half - 1.0));
            self.spots[*at].x = x;
        }
        let back = (moved / row.len() as f64).min(least).max(end - WIDTH + 1.0);
        row.iter().for_each(|(_, at)| self.spots[*at].x -= back);
    }

    /// The picture: arrows first, and the boxes over them.
    fn svg(&self, description: &str) -> String {
        let top = |spot: &Spot| spot.floor as f64 * FLOOR + 1.0;
        let (down, mut lines, mut boxes) = (format!("v{BOX}"), String::new(), String::new());
        for through in &self.arrows {
            let ends = through.iter().map(|at| format!("{} {}{down}", self.spots[*at].x, top(&self.spots[*at])));
            let path = ends.collect::<Vec<_>>().join("L");
            let path = path.trim_end_matches(&down).replacen(&down, &format!("m0 {BOX}"), 1);
            lines += &format!("<path d=\"M{path}\"/>\n");
        }
        for spot @ Spot { name, width, x, .. } in self.spots.iter().filter(|spot| !spot.name.is_empty()) {
            let (left, y) = (x - width / 2.0, top(spot));
            boxes += &format!("<path d=\"M{left} {y}h{width}v{BOX}h-{width}z\" stroke=\"currentColor\"/>\n");
            boxes += &format!("<text x=\"{x}\" y=\"{}\" fill=\"currentColor\">{name}</text>\n", y + 25.0);
        }
        let height = self.lowest as f64 * FLOOR + BOX + 2.0;
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="480" class="diagram" role="img" aria-labelledby="crates-title crates-desc" font-family="sans-serif" font-size="22">
<title id="crates-title">The crates and what each of them uses</title>
<desc id="crates-desc">{description}</desc>
<style>svg{{color:#111}}@media (prefers-color-scheme:dark){{svg{{color:#ddd}}}}</style>
<marker id="crates-head" viewBox="0 0 10 8" refX="10" refY="4" markerWidth="10" markerHeight="8" orient="auto"><path d="M0 0L10 4L0 8z" fill="currentColor"/></marker>
<g fill="none" stroke="currentColor" marker-end="url(#crates-head)">
{lines}</g>
<g fill="#5b9bd526" text-anchor="middle">
{boxes}</g></svg>
"##
        )
    }
}

/// What the arrows say, in words, from the top.
fn description(arrows: &Crates) -> String {
    let names: BTreeSet<_> = arrows.keys().map(|name| (floor(arrows, name), name)).collect();
    let words = |used: &BTreeSet<String>| used.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
    let using = names.iter().map(|(_, name)| (name, &arrows[*name])).filter(|(_, used)| !used.is_empty());
    using.map(|(name, used)| format!("{name} uses {}.", words(used))).collect::<Vec<_>>().join(" ")
}

#[test]
fn the_picture_of_the_crates_is_drawn_from_their_manifests() {
    let arrows = arrows(&crates());
    let picture = Layout::new(&arrows).svg(&description(&arrows));
    let stood = crate::book_sources::stood_written("book/crates.svg", &picture);
    assert!(stood, "book/crates.svg stands anew, as the manifests have it: look at the difference and test again");
}

#[test]
fn the_arrows_lead_down_to_all_that_a_crate_uses_and_no_box_is_on_another() {
    let all = crates();
    let arrows = arrows(&all);
    for (name, used) in &all {
        assert_eq!(reached(&arrows, name), reached(&all, name), "{name}");
        assert!(used.iter().all(|below| floor(&arrows, below) > floor(&arrows, name)), "{name}");
    }
    let edges = |spot: &Spot| (spot.floor, spot.x - spot.width / 2.0, spot.x + spot.width / 2.0);
    let mut edges: Vec<_> = Layout::new(&arrows).spots.iter().map(edges).collect();
    edges.sort_by(|one, other| one.partial_cmp(other).expect("numbers"));
    assert!(edges.windows(2).all(|pair| pair[0].0 < pair[1].0 || pair[0].2 < pair[1].1), "{edges:?}");
    assert!(edges.iter().all(|(_, left, right)| *left >= 0.0 && *right <= WIDTH), "{edges:?}");
}

#[test]
fn a_detour_takes_the_place_of_an_arrow() {
    let uses = [("top", "low middle"), ("middle", "low"), ("low", "")];
    let all = uses.map(|(name, used)| (name.to_owned(), used.split_whitespace().map(str::to_owned).collect())).into();
    assert_eq!(description(&arrows(&all)), "top uses middle. middle uses low.");
}
