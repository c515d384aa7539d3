//! What a formula says, as a tree.

/// A formula, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A number.
    Number(f64),
    /// A name, in one spelling.
    Name(String),
    /// A column of two coordinates.
    Column(Box<Node>, Box<Node>),
    /// A function of two arguments that has a letter for its name.
    Call(String, Box<Node>, Box<Node>),
    /// A sign, a function or the rate of change of something.
    Of(Function, Box<Node>),
    /// Two things joined.
    Two(Joint, Box<Node>, Box<Node>),
}

/// What can be done to one thing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Function {
    Minus,
    /// The sign that stands for both.
    PlusMinus,
    Degrees,
    Size,
    Root,
    Sine,
    Cosine,
    Tangent,
    Secant,
    ArcSine,
    ArcCosine,
    ArcTangent,
    /// d/dt of what follows.
    Rate,
}

/// How two things are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Joint {
    Plus,
    Times,
    Cross,
    Over,
    Power,
}

/// A chain of equal things; of one alone if it says nothing.
pub type Chain = Vec<Node>;

/// A display: its number, if it has one, and its chains.
#[derive(Clone, Debug, PartialEq)]
pub struct Display {
    pub tag: Option<String>,
    pub chains: Vec<Chain>,
}

/// Two things joined.
pub fn join(joint: Joint, left: Node, right: Node) -> Node {
    Node::Two(joint, Box::new(left), Box::new(right))
}

/// Every name in it, as at an instant that is named.
pub fn at(node: Node, instant: &str) -> Node {
    let inside = |node: Box<Node>| Box::new(at(*node, instant));
    match node {
        Node::Number(_) => node,
        Node::Name(name) => Node::Name(format!("{name} at {instant}")),
        Node::Column(first, second) => Node::Column(inside(first), inside(second)),
        Node::Call(name, first, second) => Node::Call(name, inside(first), inside(second)),
        Node::Of(function, of) => Node::Of(function, inside(of)),
        Node::Two(joint, left, right) => Node::Two(joint, inside(left), inside(right)),
    }
}
