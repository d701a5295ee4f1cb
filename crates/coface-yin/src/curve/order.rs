//! How many coefficients the polynomials of a curve have.

use coface_algebra::Error;
use std::fmt;

/// The order of a curve: the number of coefficients of its polynomials, one more than their degree. Orders are even: 2 for
/// polylines, 4 for cubic splines, 6 and 8.
///
/// # Examples
/// ```
/// use coface_yin::Order;
/// assert_eq!(Order::CUBIC.degree(), 3);
/// assert_eq!(Order::new(2)?, Order::LINEAR);
/// assert!(Order::new(3).is_err());
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Order(u8);

impl Order {
    /// Polylines.
    pub const LINEAR: Self = Self(2);
    /// Cubic splines.
    pub const CUBIC: Self = Self(4);
    /// The highest order.
    pub const HIGHEST: Self = Self(8);

    /// An order by its number.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the number is 2, 4, 6 or 8.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Order;
    /// assert_eq!(Order::new(4)?, Order::CUBIC);
    /// assert!(Order::new(3).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(order: usize) -> Result<Self, Error> {
        match order {
            2 | 4 | 6 | 8 => Ok(Self(order as u8)),
            _ => Err(Error::invalid(format!("there are no curves of order {order}"))
                .with_cure("take order 2 for polylines, or 4, 6 or 8 for splines of degree 3, 5 or 7")),
        }
    }

    /// The number of coefficients.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Order;
    /// assert_eq!(Order::CUBIC.value(), 4);
    /// ```
    pub fn value(self) -> usize {
        usize::from(self.0)
    }

    /// The degree of the polynomials.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Order;
    /// assert_eq!(Order::CUBIC.degree(), 3);
    /// ```
    pub fn degree(self) -> usize {
        self.value() - 1
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
