//! The whole report on a file, reading included, as the program gives it.

use super::{Task, Work};

pub(super) const TASK: Task = Task {
    name: "info",
    about: "`coface info --json FILE` from start to exit",
    extension: "obj",
    inputs: &["ico6", "ico7", "ico8"],
    work: Work::Program(&["info", "--json"]),
};
