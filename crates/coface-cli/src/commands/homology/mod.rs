//! `coface homology`: homology and cohomology groups, generators, classes of cycles, products, sequences and maps.

mod cycles;
mod generators;
mod harmonic;
mod maps;
pub(crate) mod parts;
mod products;
mod sequence;

use crate::arguments::{Common, ring};
use crate::chains::GivenChain;
use crate::commands::merge::Question;
use crate::failure::Failure;
use crate::input;
use crate::output::give;
use crate::progress::Progress;
use clap::Args;
use coface::algebra::chains::ChainComplex;
use coface::answers::CellNames;
use coface::answers::answer::HomologyAnswer;
use coface::answers::text;
use coface::answers::{Pair, Producer, homology_of_volume};
use coface::io::{ReadOptions, Structure};
use coface::topology::{AbelianGroup, Coefficients, Homology as Groups, HomologyBasis, homology};
use parts::PartsOptions;
use std::path::{Path, PathBuf};

/// Homology groups: how many components, loops and cavities a model has, and its torsion.
///
/// Exact, over the integers unless --coefficients says otherwise. Over Z/n the "betti" number counts the summands Z/n
/// and "torsion" lists those of smaller order. With --json the answers to the options stand under the keys "generators",
/// "cycles", "sequence", "map", "cup", "intersection_form", "harmonic" and "decomposition".
#[derive(Args)]
pub(crate) struct Homology {
    /// The model; - is standard input
    #[arg(value_name = "INPUT", required_unless_present = "grid")]
    input: Option<PathBuf>,
    /// Z, Q, a prime field or the integers modulo N: z, q, f2, f3, z6, ...
    #[arg(long, value_name = "RING", default_value = "z", value_parser = ring)]
    coefficients: Coefficients,
    /// Cohomology instead of homology
    #[arg(long)]
    cohomology: bool,
    /// Reduced: a point has no homology
    #[arg(long, conflicts_with = "relative")]
    reduced: bool,
    /// Homology relative to a subcomplex: boundary, or a file of cells by the same vertex numbers
    #[arg(long, value_name = "boundary|FILE")]
    relative: Option<PathBuf>,
    /// The long exact sequence of the pair over Z, with the connecting map
    #[arg(long, requires = "relative")]
    sequence: bool,
    /// Short cycles (cocycles with --cohomology) that generate the groups; written to OUT if given, as .json, or as a
    /// picture in .vtk, .obj and other mesh formats
    #[arg(long, value_name = "OUT", num_args = 0..=1)]
    generators: Option<Option<PathBuf>>,
    /// A cycle whose class is wanted, and whether it bounds: cells by their vertices as in "0 1; 1 2; -1*0 2", or a
    /// .json file with [[coefficient,[vertices..]],..]; may be given several times
    #[arg(long, value_name = "CHAIN", conflicts_with_all = ["coefficients", "cohomology"])]
    cycle: Vec<String>,
    /// Cup products of a basis of cohomology in degree P with one in degree Q, in a basis of degree P + Q
    #[arg(long, value_names = ["P", "Q"], num_args = 2, conflicts_with_all = ["relative", "reduced"])]
    cup: Option<Vec<usize>>,
    /// The intersection form of a closed oriented manifold of even dimension: rank, signature, parity, determinant
    #[arg(long, conflicts_with_all = ["relative", "reduced"])]
    intersection_form: bool,
    /// Harmonic representatives of the real cohomology classes, dual to the free generators
    #[arg(long, conflicts_with_all = ["relative", "reduced"])]
    harmonic: bool,
    /// The Hodge decomposition of a real cochain, a .json file with [[value,[vertices..]],..], into its exact, coexact and
    /// harmonic parts
    #[arg(long, value_name = "FILE", conflicts_with_all = ["relative", "reduced"])]
    decompose: Option<PathBuf>,
    /// The map on integral homology of a simplicial map, a .json file with pairs [vertex, image], to the model --target
    #[arg(long, value_name = "FILE", requires = "target", conflicts_with_all = ["relative", "reduced"])]
    map: Option<PathBuf>,
    /// The target of --map
    #[arg(long, value_name = "MODEL", requires = "map")]
    target: Option<PathBuf>,
    #[command(flatten)]
    in_parts: PartsOptions,
}

impl Homology {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.in_parts.are_given() {
            return self.in_parts.run(
                self.input.as_deref().unwrap_or(Path::new("")),
                &self.question_of_parts()?,
                common,
            );
        }
        let given: Vec<GivenChain> =
            self.cycle.iter().map(|argument| GivenChain::read(argument)).collect::<Result<_, _>>()?;
        let progress = Progress::start(common.quiet);
        let input = self.input.as_deref().ok_or_else(|| Failure::new("no model is named"))?;
        let loaded = input::read(input, common.reading(), &progress)?;
        if let Some(Structure::Volume(volume)) = loaded.model.structure()
            && self.is_groups_alone()
        {
            progress.stage("computing homology");
            let integral = homology_of_volume(volume).map_err(|error| error.in_file(loaded.name.clone()))?.1;
            let groups = self.groups(&integral);
            drop(progress);
            let object = self.object(&loaded.name, &groups);
            return give(common, &object, &self.page(&loaded.name, &groups));
        }
        let (name, producer) = input::identify(loaded, &progress)?;
        let whole = producer.chain_complex()?;
        let pair = self.pair(&producer, &whole, &progress)?;
        let complex = pair.as_ref().map_or(&whole, Pair::chains);
        let augmented = if self.reduced { Some(complex.augmented()?) } else { None };
        let complex = augmented.as_ref().unwrap_or(complex);
        let naming = CellNames::of(&producer).within(pair.as_ref()).augmented(self.reduced);
        progress.stage("computing homology");
        let needs_basis = self.generators.is_some() || self.harmonic || !given.is_empty();
        let basis = needs_basis.then(|| HomologyBasis::new(complex));
        let integral = basis.as_ref().map_or_else(|| homology(complex), HomologyBasis::homology);
        let groups = self.groups(&integral);
        let mut object = self.object(&name, &groups);
        let mut page = self.page(&name, &groups);
        if let (Some(basis), Some(place)) = (&basis, &self.generators) {
            progress.stage("finding generators");
            let found = generators::find(basis, &naming, self.coefficients, self.cohomology);
            let generators = generators::answer(&found, &naming);
            if let Some(place) = place {
                generators::save(place, &found, &naming, &whole, &generators)?;
            }
            object.generators = Some(generators);
            page += &generators::list(&found, self.cohomology, &naming);
        }
        if let Some(basis) = basis.as_ref().filter(|_| !given.is_empty()) {
            progress.stage("finding classes");
            let mut verdicts = Vec::new();
            for (argument, given) in self.cycle.iter().zip(&given) {
                let verdict = cycles::verdict(given, basis, &naming, &whole)
                    .map_err(|error| error.in_file(format!("--cycle \"{argument}\"")))?;
                page += &format!("    {argument}: {}\n", verdict.words);
                verdicts.push(verdict.object);
            }
            object.cycles = Some(verdicts);
        }
        if let Some(pair) = pair.as_ref().filter(|_| self.sequence) {
            progress.stage("computing the long exact sequence");
            let (value, words) = sequence::answer(&whole, pair)?;
            object.sequence = Some(value);
            page += &words;
        }
        if let Some(&[p, q]) = self.cup.as_deref() {
            progress.stage("multiplying cocycles");
            let (value, words) = products::cup(&producer, p, q, self.coefficients)
                .map_err(|error| error.in_file(name.clone()))?;
            object.cup = Some(value);
            page += &words;
        }
        if self.intersection_form {
            progress.stage("computing the intersection form");
            let (value, words) = products::form(&producer).map_err(|error| error.in_file(name.clone()))?;
            object.intersection_form = Some(value);
            page += &words;
        }
        if let Some(basis) = basis.as_ref().filter(|_| self.harmonic) {
            progress.stage("solving for harmonic cochains");
            let (value, words) = harmonic::cochains(basis, &naming)?;
            object.harmonic = Some(value);
            page += &words;
        }
        if let Some(file) = &self.decompose {
            progress.stage("decomposing the cochain");
            let (value, words) = harmonic::decomposition(complex, &naming, file)?;
            object.decomposition = Some(value);
            page += &words;
        }
        if let (Some(map), Some(target)) = (&self.map, &self.target) {
            let target = input::read(target, ReadOptions::default(), &progress)?;
            progress.stage("computing the induced map");
            let (value, words) = maps::answer(&producer, map, target)?;
            object.map = Some(value);
            page += &words;
        }
        drop(progress);
        give(common, &object, &page)
    }

    /// What is asked of a complex in parts, if parts answer all of it.
    fn question_of_parts(&self) -> Result<Question, Failure> {
        let others = [
            ("--reduced", self.reduced),
            ("--relative", self.relative.is_some()),
            ("--cycle", !self.cycle.is_empty()),
            ("--cup", self.cup.is_some()),
            ("--intersection-form", self.intersection_form),
            ("--harmonic", self.harmonic),
            ("--decompose", self.decompose.is_some()),
            ("--map", self.map.is_some()),
        ];
        if let Some((option, _)) = others.iter().find(|(_, is_given)| *is_given) {
            return Err(Failure::new(format!(
                "{option} needs the whole complex in memory; leave --parts, --memory and --work away"
            )));
        }
        let Self { coefficients, cohomology, generators, .. } = self;
        Ok(Question { coefficients: *coefficients, cohomology: *cohomology, generators: generators.clone() })
    }

    /// Whether nothing but groups is asked for, of the whole.
    fn is_groups_alone(&self) -> bool {
        self.relative.is_none()
            && !self.reduced
            && self.generators.is_none()
            && self.cycle.is_empty()
            && self.cup.is_none()
            && !self.intersection_form
            && !self.harmonic
            && self.decompose.is_none()
            && self.map.is_none()
    }

    fn object(&self, name: &str, groups: &[AbelianGroup]) -> HomologyAnswer {
        HomologyAnswer::of(name, self.coefficients, self.cohomology, groups)
    }

    /// The pair with a subcomplex, if one is named.
    fn pair(
        &self,
        producer: &Producer,
        whole: &ChainComplex,
        progress: &Progress,
    ) -> Result<Option<Pair>, Failure> {
        let Some(part) = &self.relative else { return Ok(None) };
        if part.as_os_str() == "boundary" {
            return Ok(Some(Pair::with_boundary(producer, whole)?));
        }
        let part = input::read(part, ReadOptions::default(), progress)?;
        let pair = Pair::with_model(producer, whole, &part.model);
        Ok(Some(pair.map_err(|error| error.in_file(part.name))?))
    }

    /// The groups asked for, from degree 0 of the model on.
    fn groups(&self, integral: &Groups) -> Vec<AbelianGroup> {
        let groups = match self.cohomology {
            true => integral.dual(self.coefficients),
            false => integral.with_coefficients(self.coefficients),
        };
        groups.groups()[usize::from(self.reduced).min(groups.groups().len())..].to_vec()
    }

    fn page(&self, name: &str, groups: &[AbelianGroup]) -> String {
        let what = match (self.reduced, self.cohomology) {
            (false, false) => "homology",
            (false, true) => "cohomology",
            (true, false) => "reduced homology",
            (true, true) => "reduced cohomology",
        };
        let pair =
            self.relative.as_ref().map_or(String::new(), |pair| format!(", relative to {}", pair.display()));
        let symbol = if self.cohomology { "H^" } else { "H_" };
        let title = format!("{what} of {name} over {}{pair}", self.coefficients);
        text::groups(&title, groups, symbol, self.coefficients)
    }
}
