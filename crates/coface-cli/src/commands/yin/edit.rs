//! `coface yin kinks`: kinks listed, inserted, erased and reset.

use super::interface::{self, InterfaceOutput};
use super::places::LISTED;
use super::{SetOptions, give, kinks, knot, pair};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::progress::Progress;
use clap::Args;
use coface::VertexId;
use coface::answers::answer::{YinInterfaceKinksAnswer, YinKinksAnswer};
use coface::answers::{InterfaceKinksRequest, KinkRequest, PlanarInterface, PlanarSet, text};
use coface::yin::KnotIndex;
use std::path::PathBuf;

/// The kinks of a set or an interface: list, insert, erase or reset them.
///
/// A kink is a knot at which the boundary need not be smooth. Between kinks it is one spline: where a kink comes or goes, the splines
/// beside it are fitted again, and everything else stays bit for bit. --reset comes first, then what is erased, then what is inserted. If
/// one fails, nothing is written.
///
/// Kinks of an interface are the vertices at which two edges end that do not go on smoothly into each other; the phases on both sides have them, and
/// junctions stay what they are. A new kink cuts its edge into two, named EDGE:KNOT; their names are the numbers of vertices, which change when
/// kinks go.
///
/// With --json also "complex" (the kinks by their names), and "kink_points": for each its "vertex", "curve", "knot" and "point".
#[derive(Args)]
pub(super) struct Kinks {
    /// The set, or an interface; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
    /// Replace all kinks by these, as --kinks names them, and fit everything again; without a value by none
    #[arg(long, value_name = "KINKS", num_args = 0..=1, default_missing_value = "none", value_parser = kinks)]
    reset: Option<KinkRequest>,
    /// Make a knot a kink: CURVE:KNOT, where the curve is its number or its name; may be given several times
    #[arg(long, value_name = "KNOT", value_parser = place, value_delimiter = ',', allow_hyphen_values = true)]
    insert: Vec<Place>,
    /// Make the knot a kink that is nearest to a point: X,Y; may be given several times
    #[arg(long, value_name = "POINT", value_parser = pair, allow_hyphen_values = true)]
    insert_near: Vec<[f64; 2]>,
    /// Make the kink of this name smooth again; may be given several times
    #[arg(long, value_name = "VERTEX", value_delimiter = ',', value_parser = vertex, allow_hyphen_values = true)]
    erase: Vec<u32>,
    /// Make the kink smooth again that is nearest to a point: X,Y; may be given several times
    #[arg(long, value_name = "POINT", value_parser = pair, allow_hyphen_values = true)]
    erase_near: Vec<[f64; 2]>,
}

/// A knot on a curve that has a number or a name.
#[derive(Clone)]
enum Place {
    Knot(KnotIndex),
    OnNamed(String, u32),
}

fn place(text: &str) -> Result<Place, String> {
    if let Some((name, knot)) = text.rsplit_once(':')
        && let (Err(_), Ok(knot)) = (name.trim().parse::<f64>(), knot.trim().parse())
        && !name.is_empty()
    {
        return Ok(Place::OnNamed(name.to_owned(), knot));
    }
    knot(text).map(Place::Knot)
}

/// The name of a kink, with the v that it is printed with or without.
fn vertex(text: &str) -> Result<u32, String> {
    text.strip_prefix('v').unwrap_or(text).parse().map_err(|_| {
        format!("\"{text}\" is no name of a kink: write its number, such as 3 for v3; `coface yin kinks` lists them")
    })
}

impl Kinks {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        if let Some(found) = self.options.given_interface(&self.input, &[], common, &progress)? {
            return self.run_interface(&found, common, progress);
        }
        let output = self.options.output(common)?;
        let mut planar = self.options.read(&self.input, common, false, &progress)?;
        progress.stage("fitting");
        let name = input::name(&self.input);
        self.change(&mut planar).map_err(|error| error.in_file(name.clone()))?;
        progress.stage("measuring");
        let answer = YinKinksAnswer::new(name, planar.kink_points(), planar.answer()?);
        give(&planar, "Kinks", answer, &self.options, output, common, progress)
    }

    /// The same of an interface, whose kinks are vertices.
    fn run_interface(
        &self,
        found: &PlanarInterface,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        let output = InterfaceOutput::new(&self.options, common)?;
        progress.stage("fitting");
        let name = input::name(&self.input);
        let inserted = self.insert.iter().map(|place| match place {
            Place::Knot(at) => Ok(*at),
            Place::OnNamed(edge, _) => Err(Failure::new(format!(
                "{name}: the edges of an interface have no names, as \"{edge}\" would be; write EDGE:KNOT, both numbered from 0, or a point with --insert-near"
            ))),
        });
        let request = InterfaceKinksRequest {
            reset: self.reset.clone(),
            inserted: inserted.collect::<Result<_, _>>()?,
            inserted_near: self.insert_near.clone(),
            erased: self.erase.clone(),
            erased_near: self.erase_near.clone(),
        };
        let changed = found.with_kinks(&request).map_err(|error| error.in_file(name.clone()))?;
        progress.stage("measuring");
        let answer = changed.kinks_answer(std::slice::from_ref(&name))?;
        let inputs = std::slice::from_ref(&self.input);
        let text = || kinks_page(&answer);
        interface::give_answer(&changed, &answer, text, inputs, &output, common, progress)
    }

    fn change(&self, planar: &mut PlanarSet) -> Result<(), coface::Error> {
        if let Some(request) = &self.reset {
            planar.reset_kinks(request)?;
        }
        // Names and places are those of before, so that their order does not count.
        let mut inserted = Vec::with_capacity(self.insert.len() + self.insert_near.len());
        for place in &self.insert {
            inserted.push(match place {
                Place::Knot(at) => *at,
                Place::OnNamed(name, knot) => KnotIndex { curve: planar.curve_of_name(name)?, knot: *knot },
            });
        }
        let set = planar.set_mut();
        for &point in &self.insert_near {
            inserted.push(set.nearest_knot(point)?.ok_or_else(|| {
                coface::Error::invalid("the set has no curves, and so no knots; leave out --insert-near")
            })?);
        }
        let mut erased: Vec<VertexId> = self.erase.iter().map(|&vertex| VertexId::from_u32(vertex)).collect();
        for &point in &self.erase_near {
            erased.push(
                set.nearest_kink(point)?
                    .ok_or_else(|| coface::Error::invalid("the set has no kinks; leave out --erase-near"))?,
            );
        }
        set.erase_kinks(&erased)?;
        set.insert_kinks(&inserted)?;
        Ok(())
    }
}

/// The page of an interface with its kinks.
fn kinks_page(answer: &YinInterfaceKinksAnswer) -> String {
    let mut page = interface::page("Kinks", &answer.interface);
    let name = |phase: Option<u32>| match phase {
        Some(phase) => answer.interface.phases[phase as usize].name.clone(),
        None => "outside".to_owned(),
    };
    let count = answer.kink_points.len();
    let mut facts = vec![("kinks".to_owned(), text::grouped(count), String::new())];
    for kink in answer.kink_points.iter().take(LISTED) {
        let [x, y] = kink.point.map(text::number);
        let [left, right] = kink.phases.map(name);
        let gloss =
            format!("at ({x}, {y}), knot {} of edge {} between {left} and {right}", kink.knot, kink.edge);
        facts.push((String::new(), format!("v{}", kink.vertex), gloss));
    }
    if count > LISTED {
        facts.push((String::new(), format!("and {} more", text::grouped(count - LISTED)), String::new()));
    }
    page.push_str(&text::facts("Kinks one by one", &facts));
    page
}
