//! Values as bytes.

use coface_check::Fault;
use serde_json::{Map, Number, Value};

/// Values lie in each other at most so deep.
const DEPTH: usize = 64;

const NULL: u8 = 0;
const FALSE: u8 = 1;
const TRUE: u8 = 2;
const FROM_ZERO: u8 = 3;
const NEGATIVE: u8 = 4;
const DOUBLE: u8 = 5;
const TEXT: u8 = 6;
const LIST: u8 = 7;
const OBJECT: u8 = 8;
const NUMBERS: u8 = 9;

/// Appends a number from 0, seven bits a byte from the lowest on; all bytes but the last have the highest bit.
fn write_number(mut number: u64, out: &mut Vec<u8>) {
    while number > 0x7f {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}

fn write_text(text: &str, out: &mut Vec<u8>) {
    write_number(text.len() as u64, out);
    out.extend_from_slice(text.as_bytes());
}

/// Appends a value.
pub(crate) fn write(value: &Value, out: &mut Vec<u8>) {
    match value {
        Value::Null => out.push(NULL),
        Value::Bool(is_true) => out.push(if *is_true { TRUE } else { FALSE }),
        Value::Number(number) => match (number.as_u64(), number.as_i64(), number.as_f64()) {
            (Some(number), ..) => {
                out.push(FROM_ZERO);
                write_number(number, out);
            }
            (_, Some(number), _) => {
                out.push(NEGATIVE);
                write_number(!number as u64, out);
            }
            (.., number) => {
                out.push(DOUBLE);
                out.extend_from_slice(&number.unwrap_or_default().to_le_bytes());
            }
        },
        Value::String(text) => {
            out.push(TEXT);
            write_text(text, out);
        }
        Value::Array(items) => {
            let numbers: Option<Vec<u64>> = items.iter().map(Value::as_u64).collect();
            out.push(if numbers.is_some() { NUMBERS } else { LIST });
            write_number(items.len() as u64, out);
            match numbers {
                Some(numbers) => numbers.into_iter().for_each(|number| write_number(number, out)),
                None => items.iter().for_each(|item| write(item, out)),
            }
        }
        Value::Object(items) => {
            out.push(OBJECT);
            write_number(items.len() as u64, out);
            for (key, item) in items {
                write_text(key, out);
                write(item, out);
            }
        }
    }
}

/// The bytes that are left to read.
pub(crate) struct Reader<'a>(pub(crate) &'a [u8]);

impl Reader<'_> {
    fn take(&mut self, count: usize) -> Result<&[u8], Fault> {
        let (taken, rest) = self
            .0
            .split_at_checked(count)
            .ok_or_else(|| Fault::new("certificate", "the binary form ends early"))?;
        self.0 = rest;
        Ok(taken)
    }

    fn number(&mut self) -> Result<u64, Fault> {
        let mut number = 0u64;
        for shift in (0..64).step_by(7) {
            let byte = self.take(1)?[0];
            let bits = u64::from(byte & 0x7f);
            if bits << shift >> shift != bits || (byte == 0 && shift > 0) {
                break;
            }
            number |= bits << shift;
            if byte & 0x80 == 0 {
                return Ok(number);
            }
        }
        Err(Fault::new("certificate", "a number of the binary form has more than 64 bits, or zeros in front"))
    }

    /// A number of items, each of which takes a byte at least: a claim takes no memory.
    fn count(&mut self) -> Result<usize, Fault> {
        let count = usize::try_from(self.number()?).ok().filter(|count| *count <= self.0.len());
        count.ok_or_else(|| Fault::new("certificate", "the binary form names more items than it has bytes"))
    }

    fn text(&mut self) -> Result<String, Fault> {
        let count = self.count()?;
        let text = std::str::from_utf8(self.take(count)?);
        text.map(str::to_owned)
            .map_err(|_| Fault::new("certificate", "a text of the binary form is no UTF-8"))
    }

    /// The next value.
    pub(crate) fn value(&mut self, depth: usize) -> Result<Value, Fault> {
        let fault = |message: &str| Err(Fault::new("certificate", message));
        if depth > DEPTH {
            return fault("values of the binary form lie too deep in each other");
        }
        Ok(match self.take(1)?[0] {
            NULL => Value::Null,
            FALSE => false.into(),
            TRUE => true.into(),
            FROM_ZERO => self.number()?.into(),
            NEGATIVE => match i64::try_from(self.number()?) {
                Ok(number) => (!number).into(),
                Err(_) => return fault("a number of the binary form has more than 64 bits"),
            },
            DOUBLE => {
                let mut bytes = [0; 8];
                bytes.copy_from_slice(self.take(8)?);
                match Number::from_f64(f64::from_le_bytes(bytes)) {
                    Some(number) => Value::Number(number),
                    None => return fault("a number of the binary form is not finite"),
                }
            }
            TEXT => self.text()?.into(),
            NUMBERS => {
                (0..self.count()?).map(|_| self.number().map(Value::from)).collect::<Result<_, _>>()?
            }
            LIST => (0..self.count()?).map(|_| self.value(depth + 1)).collect::<Result<_, _>>()?,
            OBJECT => {
                let mut items = Map::new();
                for _ in 0..self.count()? {
                    let key = self.text()?;
                    if items.insert(key, self.value(depth + 1)?).is_some() {
                        return fault("an object of the binary form has a key twice");
                    }
                }
                Value::Object(items)
            }
            _ => return fault("the binary form has a value of no kind"),
        })
    }
}
