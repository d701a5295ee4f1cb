//! The vertices and edges of a file, before they are a graph.

use super::{FileGraph, Labels};
use crate::scanner::quoted;
use crate::{Place, Remark, RemarkCode};
use coface_algebra::Error;
use std::collections::HashMap;

/// The cure of rows that are none.
pub(super) const FORM: &str = "write rows u v value for edges and u u value for vertices: u and v are whole numbers from 0 on, or names that are no numbers";

/// Vertices and edges as they stand in a file, one after the other.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// What vertices are called, in the order of the file.
    names: Vec<Box<str>>,
    places: HashMap<Box<str>, u32>,
    /// From, to, the value and the line.
    edges: Vec<Row>,
    /// Values of vertices.
    births: Vec<(u32, f64, Option<u64>)>,
    /// Edges of a vertex with itself that are no values: how many, and the line of the first.
    loops: (usize, Option<u64>),
    /// Whether edges have directions that are left out without `--directed`.
    pub(super) has_directions: bool,
    pub(super) remarks: Vec<Remark>,
}

#[derive(Clone, Copy, Debug)]
struct Row {
    from: u32,
    to: u32,
    value: f64,
    line: Option<u64>,
    /// Whether it leads in both directions.
    is_double: bool,
}

/// An error at a line, if there are lines.
pub(super) fn at(error: Error, line: Option<u64>) -> Error {
    match line {
        Some(line) => error.at_line(line),
        None => error,
    }
}

impl Rows {
    /// The vertex that is called so.
    pub(super) fn vertex(&mut self, name: &str) -> u32 {
        if let Some(&place) = self.places.get(name) {
            return place;
        }
        let place = self.names.len() as u32;
        self.names.push(name.into());
        self.places.insert(name.into(), place);
        place
    }

    /// How many vertices there are so far.
    pub(super) fn vertex_count(&self) -> usize {
        self.names.len()
    }

    /// The vertex that is called so, if there is one.
    pub(super) fn known(&self, name: &str) -> Option<u32> {
        self.places.get(name).copied()
    }

    /// Adds an edge, in both directions or one.
    pub(super) fn push_edge(
        &mut self,
        (from, to): (u32, u32),
        value: f64,
        line: Option<u64>,
        is_double: bool,
    ) -> Result<(), Error> {
        if !value.is_finite() {
            let (from, to) = (self.shown(from), self.shown(to));
            let error = Error::invalid(format!("the value of the edge from {from} to {to} is {value}"));
            return Err(at(error.with_cure("give the edge a finite value, or leave it out"), line));
        }
        // A negative zero becomes a zero.
        self.edges.push(Row { from, to, value: value + 0.0, line, is_double });
        Ok(())
    }

    /// Adds the value at which a vertex enters.
    pub(super) fn push_birth(&mut self, vertex: u32, value: f64, line: Option<u64>) -> Result<(), Error> {
        if !value.is_finite() {
            let error = Error::invalid(format!("the value of vertex {} is {value}", self.shown(vertex)));
            return Err(at(error.with_cure("give the vertex a finite value, or none"), line));
        }
        self.births.push((vertex, value + 0.0, line));
        Ok(())
    }

    /// Adds a loop, which is passed over.
    pub(super) fn push_loop(&mut self, line: Option<u64>) {
        self.loops = (self.loops.0 + 1, self.loops.1.or(line));
    }

    /// Adds a row of numbers.
    pub(super) fn push_numbers(&mut self, row: &[f64], line: Option<u64>) -> Result<(), Error> {
        let fault = |message: String| Err(at(Error::invalid(message).with_cure(FORM), line));
        let ends = &row[..row.len().min(2)];
        let is_vertex =
            |number: &&f64| **number >= 0.0 && number.fract() == 0.0 && **number < f64::from(u32::MAX);
        if let Some(number) = ends.iter().find(|number| !is_vertex(number)) {
            return fault(format!("{number} is no vertex"));
        }
        let ends: Vec<u32> = ends.iter().map(|&number| self.vertex(&(number as u32).to_string())).collect();
        match (&ends[..], row.get(2), row.len()) {
            (&[_], ..) => Ok(()),
            (&[i, j], value, 2 | 3) => self.push_row(i, j, value.copied(), line),
            _ => fault(format!("the row has {} numbers", row.len())),
        }
    }

    /// Adds an edge, or the value of a vertex that stands twice.
    pub(super) fn push_row(
        &mut self,
        i: u32,
        j: u32,
        value: Option<f64>,
        line: Option<u64>,
    ) -> Result<(), Error> {
        match value {
            Some(value) if i == j => self.push_birth(i, value, line),
            None if i == j => Ok(()),
            value => self.push_edge((i, j), value.unwrap_or(1.0), line, false),
        }
    }

    /// A vertex for a message.
    pub(super) fn shown(&self, vertex: u32) -> String {
        let name = &self.names[vertex as usize];
        if as_number(name).is_some() { name.to_string() } else { quoted(name.as_bytes()) }
    }

    /// The graph of the rows.
    pub(super) fn graph(mut self, directed: bool) -> Result<FileGraph, Error> {
        let labels = self.renumbered();
        let edges = self.edges_once(directed);
        let births = self.births_of_all(&edges)?;
        for row in &edges {
            let last = if births[row.from as usize] < births[row.to as usize] { row.to } else { row.from };
            let birth = births[last as usize];
            if row.value < birth {
                let [from, to, last] = [row.from, row.to, last].map(|vertex| self.shown(vertex));
                let message = format!(
                    "the edge of {from} and {to} enters at {}, before vertex {last}, at {birth}",
                    row.value
                );
                let error =
                    Error::invalid(message).with_cure("give each edge at least the values of its vertices");
                return Err(at(error, row.line));
            }
        }
        if let (1.., line) = self.loops {
            let count = self.loops.0;
            let what = if count == 1 {
                "1 edge of a vertex with itself was".to_owned()
            } else {
                format!("{count} edges of vertices with themselves were")
            };
            let remark =
                Remark::new(RemarkCode::InputReading, format!("{what} left out: simplices have none"));
            self.remarks.push(remark.at(count, line.map(Place::line)));
        }
        if self.has_directions && !directed {
            let message =
                "the edges have directions, which were left out: --directed takes the directed flag complex";
            self.remarks.push(Remark::new(RemarkCode::InputReading, message));
        }
        let edges = edges.into_iter().map(|row| (row.from, row.to, row.value)).collect();
        Ok(FileGraph { births, edges, labels, remarks: self.remarks })
    }

    /// Numbers vertices in the order of their numbers, if all have some; else they keep the order of the file.
    fn renumbered(&mut self) -> Labels {
        let numbers: Option<Vec<u32>> = self.names.iter().map(|name| as_number(name)).collect();
        let Some(numbers) = numbers else {
            return Labels::Names(self.names.iter().map(|name| name.to_string()).collect());
        };
        let mut order: Vec<u32> = (0..numbers.len() as u32).collect();
        order.sort_unstable_by_key(|&place| numbers[place as usize]);
        let mut new = vec![0; numbers.len()];
        for (place, &old) in order.iter().enumerate() {
            new[old as usize] = place as u32;
        }
        for row in &mut self.edges {
            (row.from, row.to) = (new[row.from as usize], new[row.to as usize]);
        }
        for birth in &mut self.births {
            birth.0 = new[birth.0 as usize];
        }
        self.names = order.iter().map(|&old| std::mem::take(&mut self.names[old as usize])).collect();
        Labels::Numbers(order.iter().map(|&old| numbers[old as usize]).collect())
    }

    /// Each edge once, with its smallest value.
    fn edges_once(&mut self, directed: bool) -> Vec<Row> {
        let mut edges = std::mem::take(&mut self.edges);
        if directed {
            let back = |row: &Row| Row { from: row.to, to: row.from, ..*row };
            let backwards: Vec<Row> = edges.iter().filter(|row| row.is_double).map(back).collect();
            edges.extend(backwards);
        } else {
            for row in &mut edges {
                (row.from, row.to) = (row.from.min(row.to), row.from.max(row.to));
            }
        }
        edges.sort_by(|a, b| {
            let ends = (a.from, a.to).cmp(&(b.from, b.to));
            ends.then(a.value.total_cmp(&b.value)).then(a.line.cmp(&b.line))
        });
        let (mut count, mut first) = (0, None);
        edges.dedup_by(|other, one| {
            let is_same = (other.from, other.to) == (one.from, one.to);
            if is_same && other.value > one.value {
                count += 1;
                if first.is_none_or(|(line, _)| other.line < line) {
                    first = Some((other.line, (one.from, one.to)));
                }
            }
            is_same
        });
        if let Some((line, (from, to))) = first {
            let what = if count == 1 { "1 edge is".to_owned() } else { format!("{count} edges are") };
            let (from, to) = (self.shown(from), self.shown(to));
            let message = format!(
                "{what} given again with another value; the smaller value was taken, first for the edge of {from} and {to}"
            );
            self.remarks
                .push(Remark::new(RemarkCode::InputReading, message).at(count, line.map(Place::line)));
        }
        edges
    }

    /// The value at which each vertex enters: the given one, or 0, or that of its first edge if that is sooner.
    fn births_of_all(&self, edges: &[Row]) -> Result<Vec<f64>, Error> {
        let mut births = vec![0f64; self.names.len()];
        for row in edges {
            for vertex in [row.from, row.to] {
                let birth = &mut births[vertex as usize];
                *birth = birth.min(row.value);
            }
        }
        let mut given: Vec<Option<f64>> = vec![None; births.len()];
        for &(vertex, value, line) in &self.births {
            let at_vertex = vertex as usize;
            if let Some(other) = given[at_vertex].filter(|&other| other != value) {
                let message = format!("vertex {} has two values, {other} and {value}", self.shown(vertex));
                return Err(at(Error::invalid(message).with_cure("give each vertex one value"), line));
            }
            given[at_vertex] = Some(value);
            births[at_vertex] = value;
        }
        Ok(births)
    }
}

/// The number that a name is.
fn as_number(name: &str) -> Option<u32> {
    let is_plain = name.bytes().all(|byte| byte.is_ascii_digit()) && (name == "0" || !name.starts_with('0'));
    name.parse().ok().filter(|&number| is_plain && number < u32::MAX)
}
