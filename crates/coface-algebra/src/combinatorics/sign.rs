//! Signs: orientations relative to a reference.

use std::fmt;

/// An orientation: the same as the reference, or opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// The orientation of the reference.
    Plus,
    /// The opposite orientation.
    Minus,
}

impl Sign {
    /// The sign of $(-1)^i$: plus when `exponent` is even.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// assert_eq!([0, 1, 2].map(Sign::power_of_minus_one), [Sign::Plus, Sign::Minus, Sign::Plus]);
    /// ```
    pub fn power_of_minus_one(exponent: usize) -> Self {
        if exponent.is_multiple_of(2) { Self::Plus } else { Self::Minus }
    }

    /// +1 or -1.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::Sign::Minus.to_i32(), -1);
    /// ```
    pub fn to_i32(self) -> i32 {
        match self {
            Self::Plus => 1,
            Self::Minus => -1,
        }
    }

    /// The product of two signs.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// assert_eq!(Sign::Minus.times(Sign::Minus), Sign::Plus);
    /// ```
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        if self == other { Self::Plus } else { Self::Minus }
    }

    /// The opposite sign.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// assert_eq!(Sign::Plus.opposite(), Sign::Minus);
    /// ```
    #[must_use]
    pub fn opposite(self) -> Self {
        self.times(Self::Minus)
    }
}

impl fmt::Display for Sign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Plus => "+",
            Self::Minus => "-",
        })
    }
}
