//! Measures tasks on growing inputs.

use crate::arguments::Arguments;
use crate::measure::{growth_exponent, measure};
use crate::store::Store;
use crate::table::Row;
use crate::tasks::{self, Task};
use coface::Error;

/// Measures the named tasks (`homology`, `homology@t3_8`), or all, and prints a line a row and the growth of each task.
///
/// # Errors
/// For an unknown name, or a task that fails.
pub(crate) fn run(names: &[String], arguments: &Arguments) -> Result<(), Error> {
    let mut chosen: Vec<(&Task, Vec<&str>)> = Vec::new();
    for name in names {
        match name.split_once('@') {
            Some((task, input)) => chosen.push((tasks::find(task)?, vec![input])),
            None => {
                let task = tasks::find(name)?;
                chosen.push((task, task.inputs.to_vec()));
            }
        }
    }
    if names.is_empty() {
        chosen = tasks::ALL.iter().map(|task| (task, task.inputs.to_vec())).collect();
    }
    let store = Store::new()?;
    println!("{}", Row::heading());
    for (task, inputs) in chosen {
        let mut points = Vec::new();
        for input in inputs {
            let path = store.file(input, task.extension)?;
            let mut row = Row {
                task: task.name.into(),
                input: input.into(),
                program: "coface".into(),
                runs: Vec::new(),
            };
            for _ in 0..arguments.runs {
                row.runs.push(measure(&mut task.command(&path, arguments.threads)?)?);
            }
            println!("{}", row.to_text());
            if let Some(json) = &arguments.json {
                row.append_to(json)?;
            }
            points.push((row.size(), row.seconds()));
        }
        if let Some(exponent) = growth_exponent(&points) {
            println!("{:<20} grows like size^{exponent:.2}", task.name);
        }
    }
    Ok(())
}
