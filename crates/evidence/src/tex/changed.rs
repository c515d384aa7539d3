//! What two formulas differ in: the smallest parts that are not the same, as TeX.
//!
//! A misprint makes no difference where the part that it changes has the same value as before. So it is asked whether an
//! equation of the two parts holds, by whoever reads the formula.

use super::reader::UPRIGHT;
use super::tree::{By, Function, Joint, Node};
use super::{Display, GREEK};

/// The equation that must hold for a change to mean the same: the changed part as it was, and as it is. A part that is
/// differentiated counts by its derivative. None if the formulas are the same, if one of them cannot be read, or if the part
/// cannot be written.
pub fn changed_part(was: &str, is: &str) -> Option<String> {
    let [was, is] = [was, is].map(|tex| Display::read_part(tex).ok());
    let sides = |display: Display| display.chains.into_iter().flatten().collect::<Vec<Node>>();
    let (was, is) = (sides(was?), sides(is?));
    let differing: Vec<_> = was.iter().zip(&is).filter(|(was, is)| was != is).collect();
    let [(was, is)] = differing[..] else { return None };
    let (was, is) = smallest(was, is);
    Some(format!("{} = {}", written(was)?, written(is)?))
}

/// Goes down as long as one part alone differs, but not into what is differentiated.
fn smallest<'a>(was: &'a Node, is: &'a Node) -> (&'a Node, &'a Node) {
    match (was, is) {
        (Node::Of(Function::Rate(_), _), _) => (was, is),
        (Node::Of(one, of), Node::Of(other, to)) if one == other => smallest(of, to),
        (Node::Two(one, a, b), Node::Two(other, x, y)) if one == other => match (a == x, b == y) {
            (true, false) => smallest(b, y),
            (false, true) => smallest(a, x),
            _ => (was, is),
        },
        _ => (was, is),
    }
}

/// A part of a formula as TeX that is read as the same part; none for what no source has.
fn written(node: &Node) -> Option<String> {
    use {Function::*, Joint::*};
    let bracket = |node: &Node| Some(format!("({})", written(node)?));
    Some(match node {
        Node::Number(digits, 0) => digits.to_string(),
        Node::Number(digits, places) => format!(r"({digits}/{})", 10_i64.checked_pow(*places)?),
        Node::Name(name) => name_written(name)?,
        Node::Of(function, of) => {
            let of = bracket(of)?;
            match function {
                Minus => format!("(-{of})"),
                Degrees => format!(r"{of}^\circ"),
                Size => format!(r"\left|{of}\right|"),
                Root => format!(r"\sqrt{{{of}}}"),
                Sine => format!(r"\sin{of}"),
                Cosine => format!(r"\cos{of}"),
                Tangent => format!(r"\tan{of}"),
                Secant => format!(r"\sec{of}"),
                Rate(By::Time) => format!(r"\frac{{d}}{{dt}}{of}"),
                _ => return None,
            }
        }
        Node::Two(joint, left, right) => {
            let (left, right) = (bracket(left)?, bracket(right)?);
            match joint {
                Plus => format!("{left} + {right}"),
                Times => format!("{left}{right}"),
                Cross => format!(r"{left}\times{right}"),
                Over => format!(r"\frac{{{left}}}{{{right}}}"),
                Power => format!("{left}^{{{right}}}"),
                Column | Slope => return None,
            }
        }
    })
}

/// A name from its one spelling.
fn name_written(name: &str) -> Option<String> {
    let end = name.find(['\'', '_', '^', '′']).unwrap_or(name.len());
    let (base, mut hung) = name.split_at(end);
    let greek = format!(r"\{base}");
    let mut tex = match base {
        "pi" => greek,
        _ if base.starts_with(UPRIGHT) => format!(r"\mathrm{{{}}}", base.trim_start_matches(UPRIGHT)),
        _ if GREEK.contains(&greek.as_str()) => greek,
        _ if base.chars().count() == 1 => base.to_owned(),
        _ if base.chars().all(char::is_alphabetic) => format!(r"\text{{{base}}}"),
        _ => return None,
    };
    for (dots, accent) in [("''", "ddot"), ("'", "dot")] {
        if let Some(rest) = hung.strip_prefix(dots) {
            (tex, hung) = (format!(r"\{accent}{{{tex}}}"), rest);
        }
    }
    while let Some(mark) = hung.chars().next() {
        let rest = &hung[mark.len_utf8()..];
        let end = if mark == '′' { 0 } else { rest.find(['_', '^', '′']).unwrap_or(rest.len()) };
        tex += &match mark {
            '′' => "'".to_owned(),
            '_' | '^' => format!("{mark}{{{}}}", &rest[..end]),
            _ => return None,
        };
        hung = &rest[end..];
    }
    Some(tex)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_part_is_written_as_it_is_read() {
        let part = |was, is| changed_part(was, is).expect("a part");
        for (was, is, expected) in [
            (r"\phi_0 = x", r"\phi = x", r"\phi_{0} = \phi"),
            (r"y = \sin^2 (2\theta) + 1", r"y = \cos^2 (2\theta) + 1", r"\sin((2)(\theta)) = \cos((2)(\theta))"),
            (
                r"y = r \frac{d}{dt}(a - 1)",
                r"y = r \frac{d}{dt}(a - 2)",
                r"\frac{d}{dt}((a) + ((-(1)))) = \frac{d}{dt}((a) + ((-(2))))",
            ),
            (r"a_2^n = \ddot{\theta}_0 r", r"a_2^n = \ddot{\theta}_0 ", r"(\ddot{\theta}_{0})(r) = \ddot{\theta}_{0}"),
        ] {
            assert_eq!(part(was, is), expected);
            assert!(Display::read(expected).is_ok(), "{expected}");
        }
        assert_eq!(changed_part("a = b", "a = b"), None);
    }
}
