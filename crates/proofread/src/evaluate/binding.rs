//! Values that a text gives to names, such as `m = 5.0 kg`.

use crate::evaluate::expression::{Evaluator, NameValues};
use crate::evaluate::printed::Mode;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::SideValue;
use crate::join::chain::{Chain, Relation};
use crate::token::{Token, TokenKind};
use std::collections::HashMap;

/// Which values of names are put into formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NamePolicy {
    /// None.
    #[default]
    Never,
    /// Of names to which the whole document gives one value.
    Once,
    /// Of all names; inside an example or a section, the latest value counts.
    Always,
}

/// The name that a side is, if it is nothing else.
pub(crate) fn single_name(side: &[Token]) -> Option<&str> {
    let mut tokens = side.iter().filter(|token| !token.is_space());
    match (tokens.next(), tokens.next()) {
        (Some(Token { kind: TokenKind::Name(name) | TokenKind::Word(name), .. }), None) if name != "π" => Some(name),
        _ => None,
    }
}

/// The name to which a chain gives a value, and the value if it can be read.
pub(crate) fn assignment(chain: &Chain) -> Option<(&str, Option<SideValue>)> {
    let named = chain.sides.windows(2).find(|pair| pair[1].relation != Some(Relation::Other));
    let name = single_name(&named?.first()?.tokens)?;
    let related = chain.sides.iter().all(|side| side.relation != Some(Relation::Other));
    let last = chain.sides.last()?;
    let value = Evaluator::new(Mode::Result, ReadingChoices::USUAL, None).evaluate_side(&last.tokens).ok();
    Some((name, value.filter(|value| related && !value.parts.is_vector())))
}

/// The values of names so far.
#[derive(Debug, Default)]
pub(crate) struct KnownNames {
    scopes: HashMap<u32, NameValues>,
    /// For each name, its value if there is one alone.
    once: HashMap<String, Option<SideValue>>,
}

/// Most names that are kept.
const MOST: usize = 20_000;

impl KnownNames {
    /// Notes what a chain assigns, before anything is compared.
    pub(crate) fn count_assignment(&mut self, chain: &Chain) {
        let Some((name, value)) = assignment(chain) else { return };
        if self.once.len() >= MOST {
            return;
        }
        match self.once.get_mut(name) {
            Some(known) => {
                let same = |(a, b): (&SideValue, &SideValue)| a.dimension == b.dimension && a.meets(b, 0.0);
                if !known.as_ref().zip(value.as_ref()).is_some_and(same) {
                    *known = None;
                }
            }
            None => drop(self.once.insert(name.to_owned(), value)),
        }
    }

    /// Notes what a chain assigns, for what follows in its scope.
    pub(crate) fn learn(&mut self, chain: &Chain, scope: u32, name_policy: NamePolicy) {
        let Some((name, value)) = assignment(chain) else { return };
        let value = match name_policy {
            NamePolicy::Never => return,
            NamePolicy::Once => self.once.get(name).cloned().flatten(),
            NamePolicy::Always => value,
        };
        if !self.scopes.contains_key(&scope) {
            // Scopes follow each other; what is over is forgotten.
            self.scopes.clear();
        }
        let known = self.scopes.entry(scope).or_default();
        match value {
            Some(value) if known.len() < MOST => drop(known.insert(name.to_owned(), value)),
            _ => drop(known.remove(name)),
        }
    }

    /// The values to use in a scope.
    pub(crate) fn in_scope(&self, scope: u32) -> Option<&NameValues> {
        self.scopes.get(&scope).filter(|known| !known.is_empty())
    }
}
