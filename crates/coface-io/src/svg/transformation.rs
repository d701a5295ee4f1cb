//! Affine maps of the plane as SVG writes them.

/// The map of (x, y) to (a x + c y + e, b x + d y + f).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transformation {
    pub(super) a: f64,
    pub(super) b: f64,
    pub(super) c: f64,
    pub(super) d: f64,
    pub(super) e: f64,
    pub(super) f: f64,
}

impl Transformation {
    pub(super) const IDENTITY: Self = Self { a: 1.0, b: 0.0, c: 0.0, d: 1.0, e: 0.0, f: 0.0 };

    pub(super) fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        if *self == Self::IDENTITY {
            return [x, y];
        }
        [self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f]
    }

    /// The map of directions.
    pub(super) fn direction(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.a * x + self.c * y, self.b * x + self.d * y]
    }

    /// Its six numbers.
    pub(super) fn bits(&self) -> [u64; 6] {
        [self.a, self.b, self.c, self.d, self.e, self.f].map(f64::to_bits)
    }

    /// First `inner`, then this map.
    pub(super) fn after(&self, inner: &Self) -> Self {
        let [a, b] = self.direction([inner.a, inner.b]);
        let [c, d] = self.direction([inner.c, inner.d]);
        let [e, f] = self.point([inner.e, inner.f]);
        Self { a, b, c, d, e, f }
    }

    /// The product of a list such as `translate(1 2) rotate(90)`.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let mut product = Self::IDENTITY;
        let mut rest = text.trim();
        while !rest.is_empty() {
            let Some((name, behind)) = rest.split_once('(') else {
                return Err(format!("\"{rest}\" is not a transformation"));
            };
            let Some((inner, behind)) = behind.split_once(')') else {
                return Err(format!("a parenthesis of \"{rest}\" is not closed"));
            };
            let numbers = inner
                .split(|c: char| c == ',' || c.is_ascii_whitespace())
                .filter(|word| !word.is_empty())
                .map(|word| word.parse().ok().filter(|x: &f64| x.is_finite()))
                .collect::<Option<Vec<f64>>>()
                .ok_or_else(|| format!("\"{inner}\" are not all numbers"))?;
            let step = Self::named(name.trim(), &numbers)
                .ok_or_else(|| format!("\"{name}({inner})\" is not a transformation"))?;
            product = product.after(&step);
            rest = behind.trim_start_matches(|c: char| c == ',' || c.is_ascii_whitespace());
        }
        Ok(product)
    }

    fn named(name: &str, numbers: &[f64]) -> Option<Self> {
        let identity = Self::IDENTITY;
        Some(match (name, numbers) {
            ("matrix", &[a, b, c, d, e, f]) => Self { a, b, c, d, e, f },
            ("translate", &[e]) => Self { e, ..identity },
            ("translate", &[e, f]) => Self { e, f, ..identity },
            ("scale", &[a]) => Self { a, d: a, ..identity },
            ("scale", &[a, d]) => Self { a, d, ..identity },
            ("rotate", &[angle]) => Self::rotation(angle),
            ("rotate", &[angle, x, y]) => {
                let there = Self { e: x, f: y, ..identity };
                let back = Self { e: -x, f: -y, ..identity };
                there.after(&Self::rotation(angle)).after(&back)
            }
            ("skewX", &[angle]) => Self { c: angle.to_radians().tan(), ..identity },
            ("skewY", &[angle]) => Self { b: angle.to_radians().tan(), ..identity },
            _ => return None,
        })
    }

    /// The rotation by an angle in degrees; exact for right angles.
    pub(super) fn rotation(angle: f64) -> Self {
        let (sine, cosine) = match angle.rem_euclid(360.0) {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            _ => angle.to_radians().sin_cos(),
        };
        Self { a: cosine, b: sine, c: -sine, d: cosine, e: 0.0, f: 0.0 }
    }
}
