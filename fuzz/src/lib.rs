//! What all fuzz targets share: the memory that one input may take, one thread, and the call of a check of `coface_fuzz_checks`.

use coface_allocator::CountingAllocator;

#[doc(hidden)]
pub use {coface_fuzz_checks as checks, libfuzzer_sys};

/// No input of 64 KiB needs as much memory as this: an allocation beyond it fails, and the run ends with the input that asked for it.
const MOST_BYTES: usize = 512 << 20;

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator::new();

/// Called once before the first input: sets the limit of memory, and lets all parallel work run on the thread that asks for it, so that runs
/// repeat and no time goes into waking threads.
pub fn prepare() {
    ALLOCATOR.limit_to(MOST_BYTES);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread();
    pool.build_global().expect("nothing has run in parallel yet");
}

/// The fuzz target of a check.
#[macro_export]
macro_rules! target {
    ($name:ident) => {
        $crate::libfuzzer_sys::fuzz_target!(init: $crate::prepare(), |bytes: &[u8]| {
            $crate::checks::$name(bytes);
        });
    };
}
