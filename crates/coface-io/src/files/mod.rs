//! Files of the system: outputs that appear whole or not at all, folders that go with a run, and files that other
//! files name.
//!
//! # Words
//! * A **temporary** file or folder has a random name and is **held** by the process that made it, by a lock that ends
//!   with the process however it ends. One that nobody holds is of no use to anybody: the next run in the same place
//!   removes it.
//! * A **lock** is a file that says that a run works in a folder.
//! * A **companion** is a file that another file names. Files come from strangers, so a companion lies in the folder of
//!   the file that names it, unless the caller says otherwise.

mod companion;
mod fingerprint;
mod hold;
mod lock;
mod output;
mod staged;
mod temporary;

pub(crate) use companion::Companions;
pub use companion::open_regular;
pub use fingerprint::content_hash;
pub use lock::FolderLock;
pub use output::{check_output, replace_file, replace_files, replace_together};
pub use staged::StagedFiles;
pub use temporary::{MadeFolders, TemporaryFolder, abandon_files};
