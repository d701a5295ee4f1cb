//! What a model has beside its cells, groups and data, as a text: for copies of models in other processes, which hold cells as arrays.

use crate::feature_table::FeatureTable;
use crate::group::Roles;
use crate::volume::VoxelFrame;
use crate::{Model, Remark};
use coface_algebra::Error;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct Kept {
    /// For each group its roles, and the number by which its file refers to it.
    groups: Vec<(u8, Option<i32>)>,
    features: Option<KeptFeatures>,
    /// The bits of the steps from voxel to voxel, and of the center of the first one.
    frame: Option<(Bits, Option<[u64; 3]>)>,
    remarks: Vec<Remark>,
    is_pseudomanifold: bool,
}

type Bits = [[u64; 3]; 3];

#[derive(Serialize, Deserialize)]
pub(crate) struct KeptFeatures {
    /// Properties and ids.
    pub(crate) texts: Vec<(String, String)>,
    pub(crate) of_lines: Vec<u32>,
    pub(crate) of_points: Vec<u32>,
    pub(crate) of_polygons: Vec<u32>,
}

impl Model {
    /// The roles of groups, features, remarks and the frame of voxels as a text, which [`Self::with_kept`] takes.
    #[doc(hidden)]
    pub fn kept(&self) -> String {
        let frame = self.frame.map(|frame| {
            let (steps, origin) = frame.numbers();
            (steps.map(|step| step.map(f64::to_bits)), origin.map(|point| point.map(f64::to_bits)))
        });
        let kept = Kept {
            groups: self.groups.iter().map(|group| (group.roles.0, group.number)).collect(),
            features: (!self.features.is_empty()).then(|| self.features.kept()),
            frame,
            remarks: self.remarks.clone(),
            is_pseudomanifold: self.is_pseudomanifold,
        };
        serde_json::to_string(&kept).expect("its keys are texts")
    }

    /// The model with what [`Self::kept`] of a model with the same cells, groups and data says.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for another text, and for features that are none of its cells.
    #[doc(hidden)]
    pub fn with_kept(mut self, text: &str) -> Result<Self, Error> {
        let kept: Kept = serde_json::from_str(text).map_err(|fault| {
            Error::invalid(format!("what was kept of a model is damaged: {fault}"))
                .with_cure("keep the model again")
        })?;
        for (group, (roles, number)) in self.groups.iter_mut().zip(kept.groups) {
            (group.roles, group.number) = (Roles(roles), number);
        }
        if let Some(features) = kept.features {
            self.features = FeatureTable::of_kept(features);
        }
        if let Some((steps, origin)) = kept.frame {
            let numbers = |bits: [u64; 3]| bits.map(f64::from_bits);
            self.frame = VoxelFrame::new(steps.map(numbers), origin.map(numbers));
        }
        (self.remarks, self.is_pseudomanifold) = (kept.remarks, kept.is_pseudomanifold);
        self.check()?;
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roles_features_and_ids_are_kept() -> Result<(), Error> {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\no wall\nusemtl brick\nf 1 2 3\n";
        let wall = crate::obj::read(text.as_bytes())?;
        let mut bare = wall.clone();
        bare.groups
            .iter_mut()
            .for_each(|group| *group = crate::Group::new(&group.name, group.kind, group.members.clone()));
        assert_ne!(bare, wall);
        assert_eq!(bare.with_kept(&wall.kept())?, wall);
        let text = r#"{"type":"FeatureCollection","features":[
            {"type":"Feature","id":7,"properties":{"lanes":2},"geometry":{"type":"LineString","coordinates":[[0,0],[1,0]]}},
            {"type":"Feature","id":"n","properties":{},"geometry":{"type":"Point","coordinates":[3,0]}}]}"#;
        let map = crate::geojson::read(text.as_bytes())?;
        let bare = Model { features: FeatureTable::default(), ..map.clone() };
        assert_ne!(bare, map);
        assert_eq!(bare.with_kept(&map.kept())?, map);
        // Features of other cells are refused, and so is a text of something else.
        assert!(wall.clone().with_kept(&map.kept()).is_err());
        assert!(wall.with_kept("{}").is_err());
        Ok(())
    }
}
