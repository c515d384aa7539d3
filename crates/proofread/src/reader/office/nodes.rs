//! Elements of XML as a tree, for formulas.

use super::super::tags::{Tag, decode_entities, next_tag};

/// Deepest nesting of elements that is kept; what is nested deeper is left out, and the formula is not read whole.
const DEEPEST: usize = 100;
/// Most elements of a formula.
const MOST: usize = 20_000;

/// An element with its attributes as they are written.
#[derive(Debug)]
pub(super) struct Node<'t> {
    pub name: String,
    tag: Tag<'t>,
    pub children: Vec<Node<'t>>,
    /// The text right in it.
    pub text: String,
}

impl<'t> Node<'t> {
    fn new(tag: Tag<'t>) -> Self {
        Self { name: tag.name.clone(), tag, children: Vec::new(), text: String::new() }
    }

    /// The value of an attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        self.tag.attribute(name)
    }

    /// The first child with this name.
    pub(super) fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.name == name)
    }

    /// The attribute `val` of a child of the child that has the properties.
    pub(super) fn property(&self, properties: &str, name: &str) -> Option<&str> {
        self.child(properties)?.child(name)?.attribute("val")
    }

    /// Whether the child that has the properties has one that is on: it is there, and its value does not say otherwise.
    pub(super) fn is_on(&self, properties: &str, name: &str) -> bool {
        let Some(of) = self.child(properties).and_then(|of| of.child(name)) else { return false };
        !matches!(of.attribute("val"), Some("0" | "off" | "false"))
    }
}

/// The text between tags, with entities as the characters that they name.
pub(super) fn decoded(text: &str) -> String {
    decode_entities(text, 0).into_iter().map(|sign| sign.c).collect()
}

/// The element that a tag opens, the byte behind it, and whether all of it is in the tree.
pub(super) fn parse<'t>(xml: &'t str, open: Tag<'t>) -> (Node<'t>, usize, bool) {
    let mut at = open.end;
    if open.empty {
        return (Node::new(open), at, true);
    }
    let mut stack = vec![Node::new(open)];
    let (mut count, mut whole, mut left_out) = (0usize, true, 0usize);
    loop {
        let Some(tag) = next_tag(xml, at) else {
            at = xml.len();
            break;
        };
        if let (Some(current), 0) = (stack.last_mut(), left_out) {
            current.text += &decoded(xml.get(at..tag.start).unwrap_or_default());
        }
        at = tag.end;
        if tag.closes {
            if left_out > 0 {
                left_out -= 1;
                continue;
            }
            // Elements close in their order, or the file is broken.
            if stack.len() == 1 {
                break;
            }
            close(&mut stack);
            continue;
        }
        count += 1;
        if count > MOST || stack.len() > DEEPEST || left_out > 0 {
            whole = false;
            left_out += usize::from(!tag.empty);
        } else if tag.empty {
            if let Some(current) = stack.last_mut() {
                current.children.push(Node::new(tag));
            }
        } else {
            stack.push(Node::new(tag));
        }
    }
    while stack.len() > 1 {
        close(&mut stack);
    }
    let node = stack.swap_remove(0);
    (node, at, whole)
}

fn close<'t>(stack: &mut Vec<Node<'t>>) {
    if let Some(done) = stack.pop()
        && let Some(parent) = stack.last_mut()
    {
        parent.children.push(done);
    }
}

/// The byte behind an element in which others of its name may be.
pub(super) fn end_of(xml: &str, open: &Tag<'_>) -> usize {
    let (mut at, mut depth) = (open.end, usize::from(!open.empty));
    while depth > 0
        && let Some(tag) = next_tag(xml, at)
    {
        at = tag.end;
        if tag.name == open.name && !tag.empty {
            depth = if tag.closes { depth - 1 } else { depth + 1 };
        }
    }
    if depth > 0 { xml.len() } else { at }
}

/// The text in a part of a file, without its tags.
pub(super) fn plain_text(xml: &str) -> String {
    let (mut out, mut at) = (String::new(), 0);
    while let Some(tag) = next_tag(xml, at) {
        out += xml.get(at..tag.start).unwrap_or_default();
        at = tag.end;
    }
    out + xml.get(at..).unwrap_or_default()
}
