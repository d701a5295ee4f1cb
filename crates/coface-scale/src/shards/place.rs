//! Where a shard belongs.

use coface_algebra::Error;

/// Which complex a shard, or what is left of several, is of, and where in its tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShardPlace {
    /// A number that the complex and its parts have and others have not: a hash of what they are made from.
    pub complex: u64,
    /// The number of shards, 1 at least.
    pub part_count: u32,
    /// How many neighbors are merged at once, 2 at least.
    pub fan_in: u32,
    /// 0 for shards and what is left of one.
    pub level: u32,
    /// The number among those of the level.
    pub number: u32,
}

impl ShardPlace {
    /// The place of a shard.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for no parts, a number that is not below their count, and a fan-in below 2.
    ///
    /// # Examples
    /// Ten shards merged by fours: ten, three, one.
    /// ```
    /// use coface_scale::shards::ShardPlace;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let place = ShardPlace::new(7, 10, 4, 9)?;
    /// assert_eq!([0, 1, 2, 3].map(|level| place.width(level)), [10, 3, 1, 1]);
    /// assert_eq!(place.at(1, 2).children(), 8..10);
    /// # Ok(()) }
    /// ```
    pub fn new(complex: u64, part_count: u32, fan_in: u32, number: u32) -> Result<Self, Error> {
        if part_count == 0 {
            return Err(Error::invalid("a complex cannot be cut into 0 parts").with_cure("ask for 1 or more"));
        }
        if fan_in < 2 {
            return Err(Error::invalid(format!("parts cannot be merged by groups of {fan_in}"))
                .with_cure("take a fan-in of 2 or more"));
        }
        if number >= part_count {
            return Err(Error::invalid(format!("there is no part {number} among {part_count}"))
                .with_cure("number the parts from 0"));
        }
        Ok(Self { complex, part_count, fan_in, level: 0, number })
    }

    /// Another place in the same tree.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardPlace;
    /// let place = ShardPlace::new(7, 10, 4, 9)?;
    /// assert_eq!(place.at(1, 2).level, 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn at(self, level: u32, number: u32) -> Self {
        Self { level, number, ..self }
    }

    /// How many there are of a level; from some level on it is one.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardPlace;
    /// let place = ShardPlace::new(7, 10, 4, 9)?;
    /// assert_eq!([0, 1, 2].map(|level| place.width(level)), [10, 3, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn width(self, level: u32) -> u32 {
        // Beyond 32 levels one is left whatever the fan-in.
        (0..level.min(32)).fold(self.part_count, |width, _| width.div_ceil(self.fan_in))
    }

    /// The numbers of those of the level below that are merged here.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardPlace;
    /// let place = ShardPlace::new(7, 10, 4, 9)?;
    /// assert_eq!(place.at(1, 2).children(), 8..10);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn children(self) -> std::ops::Range<u32> {
        let below = u64::from(self.width(self.level.saturating_sub(1)));
        let first = u64::from(self.number) * u64::from(self.fan_in);
        first.min(below) as u32..(first + u64::from(self.fan_in)).min(below) as u32
    }

    /// What it is called in messages.
    pub(super) fn name(self) -> String {
        match self.level {
            0 => format!("part {}", self.number),
            level => format!("part {} of level {level}", self.number),
        }
    }

    /// The numbers in a container.
    pub(super) fn to_meta(self) -> [u64; 5] {
        [self.complex, self.part_count.into(), self.fan_in.into(), self.level.into(), self.number.into()]
    }

    /// The place with these numbers, if it can be.
    pub(super) fn from_meta(meta: &[u64]) -> Option<Self> {
        let &[complex, part_count, fan_in, level, number] = meta else { return None };
        let place =
            Self::new(complex, u32::try_from(part_count).ok()?, u32::try_from(fan_in).ok()?, 0).ok()?;
        let place = place.at(u32::try_from(level).ok()?, u32::try_from(number).ok()?);
        (place.number < place.width(place.level)).then_some(place)
    }
}
