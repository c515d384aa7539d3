//! Formulas of Word, in Office Math Markup Language (ECMA-376, part 1, section 22.1), as MathML.

use super::formula::{self, Leaf, Letters, accent, bracketed, element, element_shown_as, leaves};
use super::nodes::Node;
use super::page::MadePage;
use crate::token::MathFunction;

/// Elements that only hold others.
const HOLDERS: [&str; 20] = [
    "omath",
    "omathpara",
    "e",
    "num",
    "den",
    "deg",
    "sub",
    "sup",
    "fname",
    "lim",
    "box",
    "borderbox",
    "ins",
    "moveto",
    "hyperlink",
    "smarttag",
    "sdt",
    "sdtcontent",
    "customxml",
    "fldsimple",
];
/// Elements that print nothing.
const SILENT: [&str; 11] = [
    "del",
    "movefrom",
    "bookmarkstart",
    "bookmarkend",
    "prooferr",
    "commentrangestart",
    "commentrangeend",
    "permstart",
    "permend",
    "lastrenderedpagebreak",
    "sdtendpr",
];

/// Adds a formula; one that is not whole says so.
pub(super) fn add(page: &mut MadePage, of: &Node<'_>, is_whole: bool) {
    if is_linear(of) {
        // Written with the signs of the linear format, and not built up.
        return of.children.iter().for_each(|run| page.characters(&run_text(run)));
    }
    page.tags("<math>");
    let mut translation = Translation { page, rows: 0, is_label: false };
    translation.node(of);
    if !is_whole {
        translation.page.tags("<unknown-nesting/>");
    }
    page.tags("</math>");
}

/// Whether a formula is one line of characters in which signs stand for what is to be built up.
fn is_linear(of: &Node<'_>) -> bool {
    let is_run = |node: &Node<'_>| node.name == "r";
    of.children.iter().all(is_run)
        && of.children.iter().any(|run| run_text(run).contains(['^', '_', '\\', '√', '┤', '├', '▒', '〖']))
}

fn run_text(run: &Node<'_>) -> String {
    run.children.iter().filter(|child| child.name == "t").map(|child| child.text.as_str()).collect()
}

struct Translation<'p> {
    page: &'p mut MadePage,
    /// In how many arrays of equations it is, where `&` stands for an edge.
    rows: usize,
    /// Whether it is in the number of an equation, behind `#`.
    is_label: bool,
}

impl Translation<'_> {
    fn nodes(&mut self, of: &[Node<'_>]) {
        // A word may be in several runs, a letter in each.
        let mut word: Option<Leaf> = None;
        for node in of {
            let only = if node.name == "r" && node.child("br").is_none() { run_leaves(node) } else { Vec::new() };
            match (only.as_slice(), &mut word) {
                ([leaf], Some(word)) if leaf.is_word() => word.text += &leaf.text,
                ([leaf], None) if leaf.is_word() => word = Some(leaf.clone()),
                _ => {
                    word.take().iter().for_each(|word| self.leaf(word));
                    match only.as_slice() {
                        [leaf] if leaf.is_word() => word = Some(leaf.clone()),
                        _ => self.node(node),
                    }
                }
            }
        }
        word.iter().for_each(|word| self.leaf(word));
    }

    fn child(&mut self, of: &Node<'_>, name: &str) {
        of.child(name).into_iter().for_each(|child| self.node(child));
    }

    /// An argument as one element of MathML, in brackets on the line where it is not short.
    fn argument(&mut self, of: &Node<'_>, name: &str) {
        let (rows, is_label) = (self.rows, self.is_label);
        bracketed(self.page, &mut |page| Translation { page, rows, is_label }.child(of, name));
    }

    fn leaf(&mut self, leaf: &Leaf) {
        if self.rows > 0 && leaf.text == "&" {
            return;
        }
        self.is_label |= self.rows > 0 && leaf.text == "#";
        if self.is_label {
            // The number of an equation is no part of it.
            self.page.shown(&leaf.text);
        } else {
            formula::add(self.page, leaf);
        }
    }

    fn node(&mut self, of: &Node<'_>) {
        let name = of.name.as_str();
        match name {
            "r" => self.run(of),
            _ if HOLDERS.contains(&name) => self.nodes(&of.children),
            "f" => self.fraction(of),
            "rad" => self.radical(of),
            "nary" => self.nary(of),
            "d" => self.delimiters(of),
            "ssup" => self.scripts(of, "msup", &["sup"]),
            "ssub" => self.scripts(of, "msub", &["sub"]),
            "ssubsup" => self.scripts(of, "msubsup", &["sub", "sup"]),
            "spre" => {
                self.page.tags("<msubsup><mrow></mrow>");
                self.script(of, "sub", "_");
                self.script(of, "sup", "^");
                self.page.tags("</msubsup>");
                self.child(of, "e");
            }
            "func" => {
                let runs = of.child("fname").map_or(&[][..], |name| name.children.as_slice());
                let name: String = runs.iter().filter(|run| run.name == "r").map(run_text).collect();
                if MathFunction::from_name(name.trim()).is_some() {
                    element(self.page, "mi", name.trim());
                } else {
                    self.child(of, "fname");
                }
                self.page.shown(" ");
                self.child(of, "e");
            }
            "acc" => {
                let sign = of.property("accpr", "chr").unwrap_or("\u{302}").to_owned();
                self.over(of, accent(&sign));
            }
            "bar" if of.property("barpr", "pos") == Some("top") => self.over(of, "¯"),
            "limupp" => {
                self.page.tags("<mover>");
                self.argument(of, "e");
                self.script(of, "lim", "^");
                self.page.tags("</mover>");
            }
            "limlow" => {
                self.page.tags("<munder>");
                self.argument(of, "e");
                self.script(of, "lim", "_");
                self.page.tags("</munder>");
            }
            "phant" if matches!(of.property("phantpr", "show"), Some("0" | "off" | "false")) => {
                self.page.tags("<mspace/>");
                self.page.shown(" ");
            }
            "phant" | "bar" => self.child(of, "e"),
            "groupchr" => {
                let is_top = of.property("groupchrpr", "pos") == Some("top");
                let sign = of.property("groupchrpr", "chr").unwrap_or("\u{23df}").to_owned();
                let name = if is_top { "mover" } else { "munder" };
                self.page.tags(&format!("<{name}>"));
                self.argument(of, "e");
                element_shown_as(self.page, "mo", &sign, "");
                self.page.tags(&format!("</{name}>"));
            }
            "m" => self.table(
                "<mtable notation=\"matrix\">",
                of.children.iter().filter(|row| row.name == "mr").map(|row| row.children.as_slice()),
            ),
            "eqarr" => {
                self.rows += 1;
                let rows = of.children.iter().filter(|row| row.name == "e");
                self.table("<mtable>", rows.map(std::slice::from_ref));
                self.rows -= 1;
            }
            _ if SILENT.contains(&name) || name.ends_with("pr") => {}
            _ if of.children.is_empty() && of.text.trim().is_empty() => {}
            _ => {
                // Told as unread by its name.
                let name: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
                self.page.tags(&format!("<unknown-{name}>"));
                self.page.characters(&of.text);
                self.page.tags(&format!("</unknown-{name}>"));
            }
        }
    }

    fn run(&mut self, of: &Node<'_>) {
        for leaf in run_leaves(of) {
            self.leaf(&leaf);
        }
        if of.child("br").is_some() {
            self.page.tags("<mspace linebreak=\"newline\"/>");
            self.page.shown(" ");
        }
    }

    fn fraction(&mut self, of: &Node<'_>) {
        let kind = of.property("fpr", "type").unwrap_or("bar");
        let open = if kind == "noBar" { "<mfrac linethickness=\"0\">" } else { "<mfrac>" };
        self.page.tags(open);
        self.argument(of, "num");
        self.page.shown(if kind == "noBar" { "¦" } else { "/" });
        self.argument(of, "den");
        self.page.tags("</mfrac>");
    }

    fn radical(&mut self, of: &Node<'_>) {
        let has_degree = !of.is_on("radpr", "deghide") && of.child("deg").is_some_and(|deg| !deg.children.is_empty());
        if !has_degree {
            self.page.shown("√");
            self.page.tags("<msqrt>");
            self.argument(of, "e");
            return self.page.tags("</msqrt>");
        }
        // In MathML the degree comes last, on the line first.
        let degree: String = of
            .child("deg")
            .into_iter()
            .flat_map(|deg| &deg.children)
            .flat_map(run_leaves)
            .map(|leaf| leaf.text)
            .collect();
        let at = self.page.text.len();
        self.page.shown(&format!("{degree}√"));
        self.page.tags("<mroot><mrow>");
        self.argument(of, "e");
        self.page.tags("</mrow>");
        if of
            .child("deg")
            .is_some_and(|deg| deg.children.iter().all(|node| matches!(node.name.as_str(), "r" | "ctrlpr")))
        {
            self.page.tags("<mrow>");
            formula::add_at(self.page, &leaves(&degree, Letters::Italic), at);
            self.page.tags("</mrow>");
        } else {
            self.page.shown(" to the root ");
            self.argument(of, "deg");
        }
        self.page.tags("</mroot>");
    }

    fn nary(&mut self, of: &Node<'_>) {
        let sign = of.property("narypr", "chr").unwrap_or("∫").to_owned();
        self.page.tags("<msubsup>");
        element(self.page, "mo", &sign);
        self.script(of, "sub", "_");
        self.script(of, "sup", "^");
        self.page.tags("</msubsup>");
        self.page.shown(" ");
        self.child(of, "e");
    }

    fn delimiters(&mut self, of: &Node<'_>) {
        let sign = |name: &str, usual: &str| {
            let given = of.child("dpr").and_then(|of| of.child(name));
            given.map_or(usual, |of| of.attribute("val").unwrap_or_default()).to_owned()
        };
        let [open, close, between] = [sign("begchr", "("), sign("endchr", ")"), sign("sepchr", "|")];
        let bracket = |translation: &mut Self, sign: &str| {
            if !sign.is_empty() {
                element(translation.page, "mo", sign);
            }
        };
        bracket(self, &open);
        for (at, part) in of.children.iter().filter(|child| child.name == "e").enumerate() {
            if at > 0 {
                bracket(self, &between);
            }
            self.node(part);
        }
        bracket(self, &close);
    }

    /// A script of an element of MathML, which may be empty.
    fn script(&mut self, of: &Node<'_>, name: &str, mark: &str) {
        let is_there =
            of.child(name).is_some_and(|of| !of.children.is_empty()) && !of.is_on("narypr", &format!("{name}hide"));
        if is_there {
            self.page.shown(mark);
            self.argument(of, name);
        } else {
            self.page.tags("<mrow></mrow>");
        }
    }

    /// Something with an index or an exponent, which belongs to the last sign of what it stands behind.
    fn scripts(&mut self, of: &Node<'_>, name: &str, scripts: &[&str]) {
        let base = of.child("e").map_or(&[][..], |base| base.children.as_slice());
        let runs: Vec<Leaf> = base.iter().filter(|run| run.name == "r").flat_map(run_leaves).collect();
        let is_line = base.iter().all(|node| node.name == "r" || node.name.ends_with("pr"));
        let last = runs.iter().rposition(|leaf| !formula::is_space(leaf));
        match last.filter(|_| is_line) {
            Some(last) => {
                runs[..last].iter().for_each(|leaf| self.leaf(leaf));
                self.page.tags(&format!("<{name}><mrow>"));
                self.leaf(&runs[last]);
                self.page.tags("</mrow>");
            }
            None => {
                self.page.tags(&format!("<{name}>"));
                self.argument(of, "e");
            }
        }
        for script in scripts {
            self.script(of, script, if *script == "sub" { "_" } else { "^" });
        }
        self.page.tags(&format!("</{name}>"));
    }

    fn over(&mut self, of: &Node<'_>, sign: &str) {
        self.page.tags("<mover><mrow>");
        self.child(of, "e");
        self.page.tags("</mrow>");
        // A line above digits says that they go on.
        element_shown_as(self.page, "mo", sign, if sign == "¯" { "\u{305}" } else { "" });
        self.page.tags("</mover>");
    }

    fn table<'n, 't: 'n>(&mut self, open: &str, rows: impl Iterator<Item = &'n [Node<'t>]>) {
        self.page.tags(open);
        for (at, row) in rows.enumerate() {
            self.page.shown(if at > 0 { "; " } else { "" });
            self.page.tags("<mtr>");
            for (at, cell) in row.iter().filter(|cell| cell.name == "e").enumerate() {
                self.page.shown(if at > 0 { "  " } else { "" });
                self.page.tags("<mtd>");
                self.node(cell);
                self.page.tags("</mtd>");
            }
            self.page.tags("</mtr>");
            self.is_label = false;
        }
        self.page.tags("</mtable>");
    }
}

/// The leaves of a run, with its letters as they are printed.
fn run_leaves(of: &Node<'_>) -> Vec<Leaf> {
    let properties = || of.children.iter().filter(|child| child.name == "rpr").flat_map(|of| &of.children);
    let is_normal = properties().any(|of| of.name == "nor" && !matches!(of.attribute("val"), Some("0" | "off")));
    let style = properties().find(|of| of.name == "sty").and_then(|of| of.attribute("val"));
    let letters = match style {
        _ if is_normal => Letters::Text,
        Some("p" | "b") => Letters::Upright,
        _ => Letters::Italic,
    };
    let text: String = of
        .children
        .iter()
        .map(|child| match child.name.as_str() {
            "t" => child.text.clone(),
            "sym" => formula::symbol(child.attribute("char")).to_string(),
            "tab" => " ".to_owned(),
            "nobreakhyphen" => "-".to_owned(),
            _ => String::new(),
        })
        .collect();
    if text.is_empty() { Vec::new() } else { leaves(&text, letters) }
}
