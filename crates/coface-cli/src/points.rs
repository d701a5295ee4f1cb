//! How points, distances and graphs become complexes: options that every verb takes.

use crate::arguments::{self, VoxelArguments};
use crate::failure::Failure;
use clap::Args;
use clap::error::ErrorKind;
use coface::complexes::alpha::PeriodicBox;
use coface::complexes::filtered::{IntervalCover, WitnessRule};
use coface::io::{
    AlphaReading, CechReading, FlagReading, Lens, MapperReading, ReadOptions, RipsReading, TableForm,
    WitnessReading,
};

/// What is made of points and graphs.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct PointArguments {
    /// Take points, the rows of a table (.csv, .txt, .npy) or the vertices of a model, as their alpha complex in dimension 1, 2 or 3: the simplices of
    /// the Delaunay triangulation that enter at the value A or before, or all. Values are squared radii, as in GUDHI's AlphaComplex
    #[arg(long, value_name = "A", num_args = 0..=1, global = true, help_heading = "Points and graphs", group = "complex",
          allow_negative_numbers = true, value_parser = super::arguments::number)]
    alpha: Option<Option<f64>>,
    /// The last number of each row is the weight of the point, a squared radius: the simplices are those of the regular triangulation
    #[arg(long, global = true, help_heading = "Points and graphs", requires = "alpha", conflicts_with_all = ["rips", "flag", "cech", "landmarks", "mapper"])]
    weighted: bool,
    /// A and all values are radii instead of squared radii (GUDHI: output_squared_values=False)
    #[arg(long, global = true, help_heading = "Points and graphs", requires = "alpha", conflicts_with_all = ["rips", "flag", "cech", "landmarks", "mapper"])]
    radii: bool,
    /// The points repeat after these lengths, one for each coordinate, as 10,10,12.5 in a crystal or a simulation: the complex is that of a flat torus, with each
    /// simplex once, and has no positions
    #[arg(long, value_name = "LENGTHS", global = true, help_heading = "Points and graphs", requires = "alpha",
          conflicts_with_all = ["rips", "flag", "cech", "landmarks", "mapper"], value_parser = periodic_box)]
    periods: Option<PeriodicBox>,
    /// Take points (any number of coordinates), a table of distances or a sparse matrix of them (.mtx) as their Vietoris-Rips complex: each set of points enters at the largest distance of two
    /// of them. --threshold T ends it at diameter T instead of the enclosing radius, behind which nothing changes
    #[arg(long, global = true, help_heading = "Points and graphs", group = "complex")]
    rips: bool,
    /// Take a graph with values as its flag complex: each set of vertices of which each two are joined enters with its last edge. The input is GraphML with
    /// the key "weight", a square matrix (.mtx), or an edge list (.csv, .txt, .npy) with rows u v value of numbers or names; u v is an edge of the value 1, u u value a vertex that enters at the value, u a
    /// vertex. --threshold T ends it at the value T
    #[arg(long, global = true, help_heading = "Points and graphs", group = "complex")]
    flag: bool,
    /// The edges of the graph have directions, and simplices are lists of vertices with an edge from each to each later one (directed flag complex): u v and v u are
    /// two edges, and make a loop
    #[arg(long, global = true, help_heading = "Points and graphs", requires = "flag", conflicts_with_all = ["alpha", "rips", "cech", "landmarks", "mapper"])]
    directed: bool,
    /// Take points (any number of coordinates) as their Čech complex: each set of points enters at the radius of the smallest ball that holds it, as in GUDHI's
    /// CechComplex. --threshold R ends it at the radius R instead of that of a ball that holds all
    #[arg(long, global = true, help_heading = "Points and graphs", group = "complex")]
    cech: bool,
    /// Take points (any number of coordinates) as witnesses of N landmarks among them, the vertices of a witness complex as in GUDHI's EuclideanWitnessComplex: the first point, then again and
    /// again the one farthest from those before. A set of landmarks enters at the least a with a point that is not farther from them than from others, but for a in
    /// squared distances. --threshold A ends it at the value A
    #[arg(long, value_name = "N", global = true, help_heading = "Points and graphs", group = "complex",
          value_parser = clap::value_parser!(u32).range(1..))]
    landmarks: Option<u32>,
    /// All landmarks of a set are as near to a witness as the nearest one, but for the value (GUDHI: EuclideanStrongWitnessComplex)
    #[arg(long, global = true, help_heading = "Points and graphs", requires = "landmarks", conflicts_with_all = ["alpha", "rips", "cech", "flag", "mapper"])]
    strong: bool,
    /// Take points (any number of coordinates) as their Mapper complex: the range of a function (--lens) is covered by N intervals that overlap; its vertices are the
    /// clusters of points over each, and its simplices the clusters with a point in common. Points within --threshold T are neighbors [default: the least T at which all are
    /// connected]. Classes enter at the means of the function
    #[arg(long, value_name = "N", global = true, help_heading = "Points and graphs", group = "complex",
          value_parser = clap::value_parser!(u32).range(1..=1 << 20))]
    mapper: Option<u32>,
    /// How much of each interval of --mapper lies in the next, from 0 to 0.9 [default: 0.3]
    #[arg(long, value_name = "PART", global = true, help_heading = "Points and graphs", requires = "mapper", conflicts_with_all = ["alpha", "rips", "cech", "flag", "landmarks"],
          value_parser = overlap)]
    overlap: Option<f64>,
    /// The function of --mapper: a coordinate (x, y, z, or its number from 0), the number behind the coordinates in each row (last), or the largest distance to another point
    /// (eccentricity) [default: x]
    #[arg(long, value_name = "FUNCTION", global = true, help_heading = "Points and graphs", requires = "mapper", conflicts_with_all = ["alpha", "rips", "cech", "flag", "landmarks"],
          value_parser = lens)]
    lens: Option<Lens>,
    /// With --rips, --flag, --cech and --landmarks: of persistence the highest degree of classes [default: 1], of a complex the highest dimension of simplices [default: 2]
    #[arg(id = "points_dimension", long = "dimension", value_name = "K", global = true, help_heading = "Points and graphs",
          value_parser = clap::value_parser!(u8).range(..=15))]
    dimension: Option<u8>,
    /// The table has distances: lower or upper (those of a triangle, one row after the other), square, or sparse (rows
    /// i j distance, points from 0 on; all others are infinitely far apart); or points, which is meant without this option
    /// unless the table is symmetric with zeros on its diagonal
    #[arg(long, value_name = "FORM", requires = "rips", global = true, help_heading = "Points and graphs", value_parser = form, conflicts_with_all = ["alpha", "flag", "cech", "landmarks", "mapper"])]
    distances: Option<TableForm>,
    /// The table is a time series, a row for each time: a point is the rows at times t, t + D, t + 2D, .. one after the other
    /// (embedding by delays)
    #[arg(long, value_name = "D", requires = "rips", conflicts_with_all = ["distances", "alpha", "flag", "cech", "landmarks", "mapper"], global = true, help_heading = "Points and graphs",
          value_parser = clap::value_parser!(u32).range(1..))]
    delay: Option<u32>,
    /// How many times a point of a time series has [default: 2]
    #[arg(long, value_name = "N", requires = "delay", global = true, help_heading = "Points and graphs",
          value_parser = clap::value_parser!(u32).range(1..=1000))]
    embedding: Option<u32>,
}

/// The sides of a periodic box, with commas between them.
fn periodic_box(sides: &str) -> Result<PeriodicBox, String> {
    let sides: Result<Vec<f64>, String> =
        sides.split(',').map(|side| arguments::number(side.trim())).collect();
    PeriodicBox::new(&sides?).map_err(|error| error.to_string())
}

fn overlap(part: &str) -> Result<f64, String> {
    let part = arguments::number(part)?;
    IntervalCover::new(1, part).map(|_| part).map_err(|error| error.to_string())
}

fn lens(name: &str) -> Result<Lens, String> {
    Ok(match name {
        "x" => Lens::Coordinate(0),
        "y" => Lens::Coordinate(1),
        "z" => Lens::Coordinate(2),
        "last" => Lens::Last,
        "eccentricity" => Lens::Eccentricity,
        number => Lens::Coordinate(
            number
                .parse()
                .map_err(|_| "give x, y, z, the number of a coordinate, last or eccentricity".to_owned())?,
        ),
    })
}

fn form(name: &str) -> Result<TableForm, String> {
    TableForm::from_name(name).map_err(|error| error.to_string())
}

impl PointArguments {
    /// How points are read as their alpha complex, if they are to be.
    pub(crate) fn alpha(self) -> Option<AlphaReading> {
        let bound = self.alpha?;
        Some(AlphaReading { bound, weighted: self.weighted, radii: self.radii, periods: self.periods })
    }

    /// How points are read as their Vietoris-Rips complex, if they are to be.
    pub(crate) fn rips(self, threshold: Option<f64>) -> Option<RipsReading> {
        let delay = self.delay.map(|delay| (delay as usize, self.embedding.unwrap_or(2) as usize));
        let reading = RipsReading { form: self.distances, delay, threshold, dimension: self.dimension() };
        self.rips.then_some(reading)
    }

    /// How a graph is read as its flag complex, if it is to be.
    pub(crate) fn flag(self, threshold: Option<f64>) -> Option<FlagReading> {
        self.flag.then_some(FlagReading { directed: self.directed, threshold, dimension: self.dimension() })
    }

    /// How points are read as their Čech complex, if they are to be.
    pub(crate) fn cech(self, radius: Option<f64>) -> Option<CechReading> {
        self.cech.then_some(CechReading { radius, dimension: self.dimension() })
    }

    /// How points are read as witnesses of landmarks, if they are to be.
    pub(crate) fn witness(self, bound: Option<f64>) -> Option<WitnessReading> {
        let landmarks = self.landmarks? as usize;
        let rule = if self.strong { WitnessRule::Strong } else { WitnessRule::Weak };
        Some(WitnessReading { landmarks, rule, bound, dimension: self.dimension() })
    }

    /// How points are read as their Mapper complex, if they are to be.
    pub(crate) fn mapper(self, threshold: Option<f64>) -> Option<MapperReading> {
        let intervals = self.mapper? as usize;
        let cover = match self.overlap {
            None => MapperReading::of_count(intervals).map(|reading| reading.cover),
            Some(overlap) => IntervalCover::new(intervals, overlap),
        };
        let cover = cover.expect("numbers have been looked at");
        Some(MapperReading { cover, lens: self.lens.unwrap_or(Lens::Coordinate(0)), threshold })
    }

    /// The highest dimension or degree.
    pub(crate) fn dimension(self) -> Option<usize> {
        self.dimension.map(usize::from)
    }

    /// How inputs are read, up to a threshold.
    pub(crate) fn reading(self, options: ReadOptions, threshold: Option<f64>) -> ReadOptions {
        options
            .alpha(self.alpha())
            .rips(self.rips(threshold))
            .flag(self.flag(threshold))
            .cech(self.cech(threshold))
            .witness(self.witness(threshold))
            .mapper(self.mapper(threshold))
    }

    /// The option that makes a complex of the input, if there is one.
    pub(crate) fn given(self) -> Option<&'static str> {
        let given = [
            ("--alpha", self.alpha.is_some()),
            ("--rips", self.rips),
            ("--flag", self.flag),
            ("--cech", self.cech),
            ("--landmarks", self.landmarks.is_some()),
            ("--mapper", self.mapper.is_some()),
        ];
        given.into_iter().find(|&(_, is_given)| is_given).map(|(name, _)| name)
    }

    /// Refuses options of complexes that are made of points or graphs where none is, and those of voxels where one is.
    pub(crate) fn check(self, voxels: &VoxelArguments) -> Result<(), Failure> {
        match (self.given(), voxels.rule_given()) {
            (None, _) | (_, None) => {}
            (Some("--alpha"), Some(option)) => {
                return Err(Failure::new(format!(
                    "{option} is for volumes; to end the alpha complex at the value A give --alpha A"
                )));
            }
            (Some(_), Some("--threshold")) => {}
            (Some(given), Some(option)) => {
                return Err(Failure::new(format!(
                    "{option} is for volumes; to end the complex of {given} give --threshold T"
                )));
            }
        }
        if self.dimension.is_some() && matches!(self.given(), None | Some("--alpha" | "--mapper")) {
            let message = "--dimension is for complexes of points and graphs; give --rips, --cech, --landmarks or --flag";
            return Err(Failure::Usage(ErrorKind::MissingRequiredArgument, message.to_owned()));
        }
        Ok(())
    }

    /// Refuses points and graphs for what takes files as they are.
    pub(crate) fn refuse(self, verb: &str) -> Result<(), Failure> {
        match self.given() {
            None => Ok(()),
            Some(option) => {
                let given = if ["--landmarks", "--mapper"].contains(&option) {
                    format!("{option} N")
                } else {
                    option.to_owned()
                };
                Err(Failure::new(format!(
                    "coface {verb} takes no {option}; write the complex first: coface convert INPUT {given} -o COMPLEX.json"
                )))
            }
        }
    }
}
