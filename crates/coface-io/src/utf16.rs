//! Text in UTF-16, as some programs and shells of Windows write it, told by the mark that it begins with.

use std::io::{self, Read};

/// How the two bytes of a unit follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    Little,
    Big,
}

/// Whether a file that begins like this is text in UTF-16: the mark, and behind it a character of ASCII.
pub(crate) fn is_utf16(start: &[u8]) -> bool {
    order(start).is_some()
}

fn order(start: &[u8]) -> Option<Order> {
    match start {
        [0xff, 0xfe, 1..0x80, 0, ..] => Some(Order::Little),
        [0xfe, 0xff, 0, 1..0x80, ..] => Some(Order::Big),
        _ => None,
    }
}

/// The text of a stream in UTF-16 as UTF-8, without its mark. What is no character becomes U+FFFD, the sign for that.
#[derive(Debug)]
pub(crate) struct Utf8Of<R> {
    input: R,
    order: Order,
    /// Bytes that are no whole character yet.
    bytes: Vec<u8>,
    /// Text that has not been given, from this place on.
    text: Vec<u8>,
    at: usize,
    has_ended: bool,
}

/// So many bytes are decoded at once.
const BLOCK: usize = 1 << 14;

impl<R: Read> Utf8Of<R> {
    /// The text of a stream that begins like this, all of which is in the stream.
    pub(crate) fn new(start: &[u8], mut input: R) -> io::Result<Self> {
        let order = order(start).unwrap_or(Order::Little);
        input.read_exact(&mut [0; 2])?;
        Ok(Self { input, order, bytes: Vec::new(), text: Vec::new(), at: 0, has_ended: false })
    }

    /// Decodes the next block.
    fn decode(&mut self) -> io::Result<()> {
        let count = self.input.by_ref().take(BLOCK as u64).read_to_end(&mut self.bytes)?;
        self.has_ended = count == 0;
        let unit = |bytes: [u8; 2]| match self.order {
            Order::Little => u16::from_le_bytes(bytes),
            Order::Big => u16::from_be_bytes(bytes),
        };
        let (pairs, odd) = self.bytes.as_chunks::<2>();
        let mut units: Vec<u16> = pairs.iter().map(|&bytes| unit(bytes)).collect();
        let mut kept = odd.to_vec();
        if self.has_ended {
            // Half of a unit.
            units.extend((!kept.is_empty()).then_some(0xdc00));
            kept.clear();
        } else if units.last().is_some_and(|unit| (0xd800..0xdc00).contains(unit)) {
            // The second half of this character comes with the next block.
            units.pop();
            kept.splice(..0, pairs[pairs.len() - 1]);
        }
        let text: String = char::decode_utf16(units)
            .map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
        (self.text, self.at, self.bytes) = (text.into_bytes(), 0, kept);
        Ok(())
    }
}

impl<R: Read> Read for Utf8Of<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        while self.at == self.text.len() && !self.has_ended {
            self.decode()?;
        }
        let count = (&self.text[self.at..]).read(out)?;
        self.at += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn text_of(bytes: &[u8]) -> String {
        let mut text = String::new();
        Utf8Of::new(bytes, bytes).unwrap().read_to_string(&mut text).unwrap();
        text
    }

    fn written(text: &str, order: Order) -> Vec<u8> {
        let units = std::iter::once(0xfeff).chain(text.encode_utf16());
        units
            .flat_map(|unit| match order {
                Order::Little => unit.to_le_bytes(),
                Order::Big => unit.to_be_bytes(),
            })
            .collect()
    }

    #[test]
    fn faults_are_the_sign_for_them() {
        assert_eq!(text_of(b"\xff\xfeO\0F"), "O\u{fffd}");
        assert_eq!(text_of(b"\xff\xfeO\0\x00\xd8F\0"), "O\u{fffd}F");
        assert_eq!(text_of(b"\xff\xfeO\0\x00\xd8"), "O\u{fffd}");
        assert_eq!(text_of(b"\xff\xfe"), "");
    }

    #[test]
    fn characters_across_blocks_are_whole() {
        for shift in 0..3 {
            let text = ["a".repeat(shift), "\u{1f600}".repeat(BLOCK)].concat();
            assert_eq!(text_of(&written(&text, Order::Little)), text);
        }
    }

    proptest! {
        #[test]
        fn text_comes_back(text in "[a-zA-Z]\\PC{0,40}", is_little: bool) {
            let bytes = written(&text, if is_little { Order::Little } else { Order::Big });
            prop_assert!(is_utf16(&bytes));
            prop_assert_eq!(text_of(&bytes), text);
        }
    }
}
