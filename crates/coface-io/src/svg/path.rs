//! The data of a path: M L H V C S Q T A Z.

use super::curves::Pen;

/// Draws the data of a path.
///
/// # Errors
/// A curve without a tolerance, or what is wrong with the text and at which byte of it.
pub(super) fn draw(data: &str, pen: &mut Pen) -> Result<(), String> {
    let mut words = Words { data: data.as_bytes(), at: 0 };
    let mut command = None;
    // The control point that S and T mirror, with the degree of its curve.
    let mut last_control: Option<(usize, [f64; 2])> = None;
    loop {
        words.skip();
        let Some(&byte) = words.data.get(words.at) else { return Ok(()) };
        if byte.is_ascii_alphabetic() {
            words.at += 1;
            if command.is_none() && !byte.eq_ignore_ascii_case(&b'M') {
                return Err(words.fault("a path must begin with M"));
            }
            command = Some(byte);
        } else {
            // Numbers without a letter go on with the last command, after a move with lines.
            command = match command {
                None => return Err(words.fault("a path must begin with M")),
                Some(b'M') => Some(b'L'),
                Some(b'm') => Some(b'l'),
                Some(b'Z' | b'z') => return Err(words.fault("numbers stand behind Z")),
                command => command,
            };
        }
        let letter = command.unwrap_or(b'M');
        let base = if letter.is_ascii_lowercase() { pen.at } else { [0.0; 2] };
        let mut control = None;
        match letter.to_ascii_uppercase() {
            b'M' => {
                let to = words.point(base)?;
                pen.move_to(to);
            }
            b'L' => {
                let to = words.point(base)?;
                pen.line_to(to);
            }
            b'H' => {
                let to = [base[0] + words.number()?, pen.at[1]];
                pen.line_to(to);
            }
            b'V' => {
                let to = [pen.at[0], base[1] + words.number()?];
                pen.line_to(to);
            }
            b'C' => {
                let controls = [words.point(base)?, words.point(base)?, words.point(base)?];
                pen.curve_to(&controls)?;
                control = Some((3, controls[1]));
            }
            b'S' => {
                let first = mirrored(pen.at, last_control, 3);
                let controls = [first, words.point(base)?, words.point(base)?];
                pen.curve_to(&controls)?;
                control = Some((3, controls[1]));
            }
            b'Q' => {
                let controls = [words.point(base)?, words.point(base)?];
                pen.curve_to(&controls)?;
                control = Some((2, controls[0]));
            }
            b'T' => {
                let controls = [mirrored(pen.at, last_control, 2), words.point(base)?];
                pen.curve_to(&controls)?;
                control = Some((2, controls[0]));
            }
            b'A' => {
                let radii = [words.number()?, words.number()?];
                let angle = words.number()?;
                let (is_large, is_positive) = (words.flag()?, words.flag()?);
                let to = words.point(base)?;
                pen.arc_to(radii, angle, is_large, is_positive, to)?;
            }
            b'Z' => pen.close(),
            _ => {
                let name = char::from(letter);
                words.at -= 1;
                return Err(words.fault(&format!("'{name}' is not a command of a path")));
            }
        }
        last_control = control;
    }
}

/// The mirror image of the last control point if it was one of a curve of this degree, else the point itself.
fn mirrored(at: [f64; 2], last: Option<(usize, [f64; 2])>, degree: usize) -> [f64; 2] {
    match last {
        Some((last_degree, control)) if last_degree == degree => {
            [0, 1].map(|axis| 2.0 * at[axis] - control[axis])
        }
        _ => at,
    }
}

/// Draws the points of a polygon or polyline.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn draw_points(data: &str, is_closed: bool, pen: &mut Pen) -> Result<(), String> {
    let mut words = Words { data: data.as_bytes(), at: 0 };
    let mut is_first = true;
    loop {
        words.skip();
        if words.at == words.data.len() {
            break;
        }
        let point = words.point([0.0; 2])?;
        if std::mem::take(&mut is_first) {
            pen.move_to(point);
        } else {
            pen.line_to(point);
        }
    }
    if is_closed {
        pen.close();
    }
    Ok(())
}

/// The words of a list of numbers.
struct Words<'a> {
    data: &'a [u8],
    at: usize,
}

impl Words<'_> {
    fn skip(&mut self) {
        while self.data.get(self.at).is_some_and(|&byte| byte == b',' || byte.is_ascii_whitespace()) {
            self.at += 1;
        }
    }

    fn fault(&self, what: &str) -> String {
        format!("{what} (character {} of the data)", self.at)
    }

    fn point(&mut self, base: [f64; 2]) -> Result<[f64; 2], String> {
        Ok([base[0] + self.number()?, base[1] + self.number()?])
    }

    /// A number; a sign or a second point begins the next one.
    fn number(&mut self) -> Result<f64, String> {
        self.skip();
        let start = self.at;
        let digits = |words: &mut Self| {
            let from = words.at;
            while words.data.get(words.at).is_some_and(u8::is_ascii_digit) {
                words.at += 1;
            }
            words.at > from
        };
        if matches!(self.data.get(self.at), Some(b'+' | b'-')) {
            self.at += 1;
        }
        let mut any = digits(self);
        if self.data.get(self.at) == Some(&b'.') {
            self.at += 1;
            any |= digits(self);
        }
        if any && matches!(self.data.get(self.at), Some(b'e' | b'E')) {
            let before = self.at;
            self.at += 1;
            if matches!(self.data.get(self.at), Some(b'+' | b'-')) {
                self.at += 1;
            }
            if !digits(self) {
                self.at = before;
            }
        }
        let text = std::str::from_utf8(&self.data[start..self.at]).unwrap_or_default();
        let number = if any { text.parse().ok() } else { None };
        match number.filter(|number: &f64| number.is_finite()) {
            Some(number) => Ok(number),
            None => {
                self.at = start;
                Err(self.fault("a finite number is missing"))
            }
        }
    }

    /// 0 or 1, perhaps with nothing behind it.
    fn flag(&mut self) -> Result<bool, String> {
        self.skip();
        match self.data.get(self.at) {
            Some(flag @ (b'0' | b'1')) => {
                self.at += 1;
                Ok(*flag == b'1')
            }
            _ => Err(self.fault("a flag, 0 or 1, is missing")),
        }
    }
}
