//! Models arranged in space, and Boolean combinations of them.

mod arranged;
mod bent;
mod boolean;
mod cascade;
mod certificate;
mod coarse;
mod coincident;
mod congruent;
mod congruent_boolean;
mod enclosed;
mod facts;
mod glued;
mod graph;
mod inputs;
mod models;
mod mouths;
mod request;
mod scene;
mod scene_arrangement;
mod solid_request;

pub use boolean::SolidBoolean;
pub use coarse::remarks_of_single_precision;
pub use congruent::CongruentScene;
pub use congruent_boolean::CongruentBoolean;
pub use inputs::{InputState, OpenInputs};
pub use request::SpatialRequest;
pub use scene::SpatialScene;
pub use scene_arrangement::SceneArrangement;
pub use solid_request::SolidRequest;
