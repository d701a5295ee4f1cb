//! The names of the groups of surfaces.

use crate::groups::SurfaceGroup;
use crate::homology::AbelianGroup;
use crate::recognition::GroupName;

impl SurfaceGroup {
    /// The name of the group.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2]))?;
    /// assert_eq!(torus.name().to_string(), "Z^2");
    /// assert_eq!(SurfaceGroup::free(3).name().to_string(), "Free(3)");
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> GroupName {
        let count = self.generator_count();
        match (self.relator(), self.is_orientable()) {
            (None, _) if count < 2 => GroupName::Abelian(AbelianGroup::new(count, Vec::new())),
            (None, _) => GroupName::Free(count),
            (Some(_), _) if count == 1 => GroupName::Abelian(AbelianGroup::new(0, vec![2.into()])),
            (Some(_), true) if count == 2 => GroupName::Abelian(AbelianGroup::new(2, Vec::new())),
            (Some(_), is_orientable) => {
                GroupName::Surface { is_orientable, genus: if is_orientable { count / 2 } else { count } }
            }
        }
    }
}
