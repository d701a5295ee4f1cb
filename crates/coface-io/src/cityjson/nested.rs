//! Lists of lists of numbers of any depth, flat.

use serde::de::{Deserialize, Deserializer, SeqAccess, Visitor};
use std::fmt;

/// Lists are at most so deep: a solid of several is the deepest, with four levels of lists below its own.
const DEEPEST: usize = 8;

/// Nested lists of numbers or nulls as one list.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Nested(Vec<u32>);

const OPEN: u32 = u32::MAX;
const CLOSE: u32 = u32::MAX - 1;
const NULL: u32 = u32::MAX - 2;

/// What stands at a place of nested lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token {
    Open,
    Close,
    Null,
    Number(u32),
}

impl Nested {
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// All numbers, whatever lists they are in.
    pub(super) fn numbers(&self) -> impl Iterator<Item = u32> + '_ {
        self.0.iter().copied().filter(|&token| token < NULL)
    }

    pub(super) fn cursor(&self) -> Cursor<'_> {
        Cursor(&self.0)
    }
}

/// A place in nested lists.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor<'a>(&'a [u32]);

impl<'a> Cursor<'a> {
    pub(super) fn peek(&self) -> Option<Token> {
        self.0.first().map(|&token| match token {
            OPEN => Token::Open,
            CLOSE => Token::Close,
            NULL => Token::Null,
            number => Token::Number(number),
        })
    }

    pub(super) fn take(&mut self) -> Option<Token> {
        let token = self.peek()?;
        self.0 = &self.0[1..];
        Some(token)
    }

    /// The numbers of a list that holds nothing else, and goes behind it; `None` if there is another thing here.
    pub(super) fn numbers(&mut self) -> Option<&'a [u32]> {
        let inner = self.0.strip_prefix(&[OPEN])?;
        let length = inner.iter().position(|&token| token >= NULL)?;
        let (numbers, rest) = inner.split_at(length);
        self.0 = rest.strip_prefix(&[CLOSE])?;
        Some(numbers)
    }

    /// Goes behind the end of the list that it is in.
    pub(super) fn leave(&mut self) {
        let mut depth = 1;
        while depth > 0 {
            match self.take() {
                Some(Token::Open) => depth += 1,
                Some(Token::Close) => depth -= 1,
                Some(_) => {}
                None => return,
            }
        }
    }
}

impl<'de> Deserialize<'de> for Nested {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut tokens = Vec::new();
        deserializer.deserialize_any(Level { tokens: &mut tokens, depth: 0 })?;
        Ok(Self(tokens))
    }
}

struct Level<'t> {
    tokens: &'t mut Vec<u32>,
    depth: usize,
}

impl<'de> serde::de::DeserializeSeed<'de> for Level<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Level<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("lists of whole numbers from 0")
    }

    fn visit_unit<E: serde::de::Error>(self) -> Result<(), E> {
        self.tokens.push(NULL);
        Ok(())
    }

    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<(), E> {
        // What is beyond is out of every range.
        self.tokens.push(u32::try_from(number).map_or(NULL - 1, |number| number.min(NULL - 1)));
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        if self.depth == DEEPEST {
            return Err(serde::de::Error::custom("the lists are nested too deep"));
        }
        self.tokens.push(OPEN);
        while list.next_element_seed(Level { tokens: &mut *self.tokens, depth: self.depth + 1 })?.is_some() {}
        self.tokens.push(CLOSE);
        Ok(())
    }
}
