//! The JSON schema of all answers.

use super::{
    BatchAnswer, CheckAnswer, CochainTestAnswer, CocyclesAnswer, CongruenceAnswer, ConvertAnswer,
    CoverAnswer, CutAnswer, CyclesAnswer, DiagramCurvesAnswer, DiagramDistanceAnswer, DiagramImageAnswer,
    DissolveAnswer, DoubleCoverAnswer, EditAnswer, EulerAnswer, FilledHandlesAnswer, GenerateAnswer,
    HandlesAnswer, HomologyAnswer, HomotopicAnswer, IncidenceAnswer, InfoAnswer, InfoReports,
    IsomorphicAnswer, LoopsAnswer, MapAnswer, PersistenceAnswer, Pi1Answer, PlanarArrangementAnswer,
    PlanarBooleanAnswer, ReduceAnswer, RenderAnswer, RowAnswer, ShardAnswer, SignatureAnswer,
    SimplicesAnswer, SimplifyAnswer, SolidBooleanAnswer, SpatialArrangementAnswer, SubgroupsAnswer,
    ViewAnswer, VineyardAnswer, YinAdvectAnswer, YinCombinationAnswer, YinComparisonAnswer,
    YinCurvatureAnswer, YinCutCellsAnswer, YinInfoAnswer, YinInterfaceAdvectAnswer, YinInterfaceAnswer,
    YinInterfaceComparisonAnswer, YinInterfaceCurvatureAnswer, YinInterfaceCutCellsAnswer,
    YinInterfaceKinksAnswer, YinInterfaceLocateAnswer, YinInterfaceNormalizeAnswer, YinInterfaceSampleAnswer,
    YinKinksAnswer, YinLocateAnswer, YinNormalizeAnswer, YinSampleAnswer, YinSeriesAnswer, YinSetAnswer,
    YinValidationAnswer,
};
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// The one list of verbs and the types of their answers.
macro_rules! answers {
    ($($verb:literal => $answer:ty,)*) => {
        /// The JSON schema (draft 2020-12) of all answers: one property for each verb.
        ///
        /// # Examples
        /// ```
        /// let schema = coface_answers::answer::schema();
        /// assert!(schema.contains("\"info\""));
        /// ```
        pub fn schema() -> String {
            let mut generator = SchemaSettings::draft2020_12().into_generator();
            let mut verbs = Map::new();
            $(verbs.insert($verb.to_owned(), generator.subschema_for::<$answer>().to_value());)*
            let schema = json!({
                "$schema": "https://json-schema.org/draft/2020-12/schema",
                "title": "Answers of coface",
                "description": "For each verb of the program the object that it prints with --json.",
                "type": "object",
                "properties": verbs,
                "$defs": generator.take_definitions(true),
            });
            format!("{schema:#}\n")
        }

        /// Reads a printed answer of a verb into its type and prints it again; `None` for a verb without an answer type.
        #[doc(hidden)]
        pub fn reprinted(verb: &str, printed: &str) -> Option<Result<String, String>> {
            match verb {
                $($verb => {
                    let again = || -> serde_json::Result<Value> {
                        serde_json::to_value(serde_json::from_str::<$answer>(printed)?)
                    };
                    Some(again().map(|value| value.to_string()).map_err(|error| error.to_string()))
                })*
                _ => None,
            }
        }
    };
}

answers! {
    "info" => InfoAnswer,
    "info FILES" => InfoReports,
    "homology" => HomologyAnswer,
    "check" => CheckAnswer,
    "merge" => HomologyAnswer,
    "shard" => ShardAnswer,
    "reduce" => ReduceAnswer,
    "persistence" => PersistenceAnswer,
    "persistence --vineyard" => VineyardAnswer,
    "diagram distance" => DiagramDistanceAnswer,
    "diagram betti" => DiagramCurvesAnswer,
    "diagram image" => DiagramImageAnswer,
    "euler" => EulerAnswer,
    "pi1" => Pi1Answer,
    "loops" => LoopsAnswer,
    "cycles" => CyclesAnswer,
    "cycles --handles" => HandlesAnswer,
    "cycles --fill-handles" => FilledHandlesAnswer,
    "homotopic" => HomotopicAnswer,
    "subgroups" => SubgroupsAnswer,
    "cut" => CutAnswer,
    "edit" => EditAnswer,
    "isomorphic" => IsomorphicAnswer,
    "simplify" => SimplifyAnswer,
    "cover" => CoverAnswer,
    "cover --orientation" => DoubleCoverAnswer,
    "cocycles" => CocyclesAnswer,
    "cocycles --test" => CochainTestAnswer,
    "star" => SimplicesAnswer,
    "closure" => SimplicesAnswer,
    "link" => SimplicesAnswer,
    "boundary" => SimplicesAnswer,
    "interior" => SimplicesAnswer,
    "skeleton" => SimplicesAnswer,
    "incidence" => IncidenceAnswer,
    "view" => ViewAnswer,
    "render" => RenderAnswer,
    "convert" => ConvertAnswer,
    "map" => MapAnswer,
    "generate" => GenerateAnswer,
    "batch" => BatchAnswer,
    "batch (row)" => RowAnswer,
    "batch (signature)" => SignatureAnswer,
    "congruence" => CongruenceAnswer,
    "arrange (plane)" => PlanarArrangementAnswer,
    "arrange (space)" => SpatialArrangementAnswer,
    "boolean (plane)" => PlanarBooleanAnswer,
    "boolean --dissolve" => DissolveAnswer,
    "boolean (space)" => SolidBooleanAnswer,
    "yin info" => YinInfoAnswer,
    "yin meet" => YinCombinationAnswer,
    "yin fit" => YinSetAnswer,
    "yin kinks" => YinKinksAnswer,
    "yin kinks (interface)" => YinInterfaceKinksAnswer,
    "yin compare" => YinComparisonAnswer,
    "yin compare (interface)" => YinInterfaceComparisonAnswer,
    "yin compare --series" => YinSeriesAnswer,
    "yin interface" => YinInterfaceAnswer,
    "yin cut-cells" => YinCutCellsAnswer,
    "yin cut-cells (interface)" => YinInterfaceCutCellsAnswer,
    "yin advect" => YinAdvectAnswer,
    "yin advect --inputs" => YinInterfaceAdvectAnswer,
    "yin locate" => YinLocateAnswer,
    "yin locate (interface)" => YinInterfaceLocateAnswer,
    "yin sample" => YinSampleAnswer,
    "yin sample (interface)" => YinInterfaceSampleAnswer,
    "yin curvature" => YinCurvatureAnswer,
    "yin curvature (interface)" => YinInterfaceCurvatureAnswer,
    "yin validate" => YinValidationAnswer,
    "yin normalize" => YinNormalizeAnswer,
    "yin normalize (interface)" => YinInterfaceNormalizeAnswer,
}
