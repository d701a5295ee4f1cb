//! A global allocator that counts the memory a program holds, keeps it below a limit, and calls a function of the program where there is not
//! enough, so that the program ends with a message and its temporary files removed instead of being aborted.
//!
//! # Words
//! * The memory that is **held** is the sum of the sizes of all allocations that are not freed yet, in bytes. Stacks, code and mapped files are
//!   not among them.
//! * A **shortage** is an allocation that the limit does not allow, or that the system does not give.
//!
//! # What it costs
//! Two additions to a counter an allocation; what asks for memory in large arrays does not notice.
//!
//! # Examples
//! ```
//! use coface_allocator::CountingAllocator;
//!
//! #[global_allocator]
//! static ALLOCATOR: CountingAllocator = CountingAllocator::new();
//!
//! let before = ALLOCATOR.held();
//! let array = vec![1u8; 1000];
//! assert_eq!(ALLOCATOR.held() - before, 1000);
//! drop(array);
//! assert_eq!(ALLOCATOR.held(), before);
//! assert!(ALLOCATOR.peak() >= before + 1000);
//! ```

mod system;

pub use system::free_memory;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// What happened where memory did not suffice.
///
/// # Examples
/// ```
/// let shortage = coface_allocator::Shortage { asked: 4096, limit: Some(1000) };
/// assert!(shortage.limit.is_some());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shortage {
    /// The size in bytes of the allocation that could not be had.
    pub asked: usize,
    /// The limit in bytes that it would have passed; `None` where the system had no more.
    pub limit: Option<usize>,
}

/// What a program does at a shortage; it ends the program. It may allocate a little.
pub type EndOfMemory = fn(Shortage) -> !;

/// The allocator of the system, which counts what it gives.
///
/// # Examples
/// See the [first page](crate).
#[derive(Debug)]
pub struct CountingAllocator {
    held: AtomicUsize,
    peak: AtomicUsize,
    limit: AtomicUsize,
    at_shortage: OnceLock<EndOfMemory>,
    is_ending: AtomicBool,
}

impl CountingAllocator {
    /// An allocator without a limit.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_allocator::CountingAllocator::new().held(), 0);
    /// ```
    pub const fn new() -> Self {
        Self::limited(usize::MAX)
    }

    /// An allocator that lets no more than so many bytes be held at once, from the start of the program.
    ///
    /// # Examples
    /// ```
    /// use coface_allocator::CountingAllocator;
    /// #[global_allocator]
    /// static ALLOCATOR: CountingAllocator = CountingAllocator::limited(64 << 20);
    /// assert!(Vec::<u8>::new().try_reserve(65 << 20).is_err());
    /// ```
    pub const fn limited(bytes: usize) -> Self {
        Self {
            held: AtomicUsize::new(0),
            peak: AtomicUsize::new(0),
            limit: AtomicUsize::new(bytes),
            at_shortage: OnceLock::new(),
            is_ending: AtomicBool::new(false),
        }
    }

    /// The bytes that are held now.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_allocator::CountingAllocator::new().held(), 0);
    /// ```
    pub fn held(&self) -> usize {
        self.held.load(Ordering::Relaxed)
    }

    /// The most bytes that were held at once, since the start or the last [`Self::restart_peak`].
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_allocator::CountingAllocator::new().peak(), 0);
    /// ```
    pub fn peak(&self) -> usize {
        self.peak.load(Ordering::Relaxed)
    }

    /// Makes the bytes that are held now the peak.
    ///
    /// # Examples
    /// ```
    /// let allocator = coface_allocator::CountingAllocator::new();
    /// allocator.restart_peak();
    /// assert_eq!(allocator.peak(), allocator.held());
    /// ```
    pub fn restart_peak(&self) {
        self.peak.store(self.held(), Ordering::Relaxed);
    }

    /// Calls `end` at every shortage from now on; without it an allocation fails, which aborts most programs. Only the first call counts.
    /// `end` is called once; other threads that meet a shortage then wait for the end.
    ///
    /// # Examples
    /// ```
    /// let allocator = coface_allocator::CountingAllocator::new();
    /// allocator.end_at_shortage(|shortage| panic!("{} bytes could not be had", shortage.asked));
    /// ```
    pub fn end_at_shortage(&self, end: EndOfMemory) {
        // A second function changes nothing.
        let _ = self.at_shortage.set(end);
    }

    /// Lets no more than so many bytes be held at once.
    ///
    /// # Examples
    /// ```
    /// coface_allocator::CountingAllocator::new().limit_to(1 << 30);
    /// ```
    pub fn limit_to(&self, bytes: usize) {
        self.limit.store(bytes, Ordering::Relaxed);
    }

    /// Counts so many bytes more; the result says whether they may be had.
    fn take(&self, bytes: usize) -> bool {
        let before = self.held.fetch_add(bytes, Ordering::Relaxed);
        let held = before.saturating_add(bytes);
        if held > self.peak.load(Ordering::Relaxed) {
            self.peak.fetch_max(held, Ordering::Relaxed);
        }
        let limit = self.limit.load(Ordering::Relaxed);
        if held > limit {
            self.give_back(bytes);
            self.end(Shortage { asked: bytes, limit: Some(limit) });
            return false;
        }
        true
    }

    fn give_back(&self, bytes: usize) {
        self.held.fetch_sub(bytes, Ordering::Relaxed);
    }

    /// The system has no memory for what was counted.
    fn refused(&self, bytes: usize) {
        self.give_back(bytes);
        self.end(Shortage { asked: bytes, limit: None });
    }

    /// Ends the program, if it says how.
    fn end(&self, shortage: Shortage) {
        let Some(end) = self.at_shortage.get() else { return };
        if self.is_ending.swap(true, Ordering::Relaxed) {
            if shortage.limit.is_none() {
                // Not even the little that the end needs: the allocation fails.
                return;
            }
            loop {
                std::thread::park();
            }
        }
        self.limit.store(usize::MAX, Ordering::Relaxed);
        end(shortage)
    }
}

impl Default for CountingAllocator {
    fn default() -> Self {
        Self::new()
    }
}

// SAFETY: every block comes from the allocator of the system and goes back to it with the layout it was made by; a null pointer is returned
// where there is none. Counting allocates nothing and does not unwind; `end` does not return.
unsafe impl GlobalAlloc for CountingAllocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if !self.take(layout.size()) {
            return std::ptr::null_mut();
        }
        // SAFETY: the caller keeps the contract of this function, which is that of the system's.
        let block = unsafe { System.alloc(layout) };
        if block.is_null() {
            self.refused(layout.size());
        }
        block
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        if !self.take(layout.size()) {
            return std::ptr::null_mut();
        }
        // SAFETY: as above.
        let block = unsafe { System.alloc_zeroed(layout) };
        if block.is_null() {
            self.refused(layout.size());
        }
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the block came from the system with this layout.
        unsafe { System.dealloc(block, layout) };
        self.give_back(layout.size());
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let more = size.saturating_sub(layout.size());
        if more > 0 && !self.take(more) {
            return std::ptr::null_mut();
        }
        // SAFETY: the block came from the system with this layout, and the caller vouches for the new size.
        let new = unsafe { System.realloc(block, layout, size) };
        if new.is_null() {
            self.refused(more);
        } else if size < layout.size() {
            self.give_back(layout.size() - size);
        }
        new
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_given_is_counted_until_it_comes_back() {
        let allocator = CountingAllocator::new();
        let layout = Layout::from_size_align(100, 8).unwrap();
        // SAFETY: the layout is not empty, and the block goes back with the layout of its size.
        let block = unsafe { allocator.alloc(layout) };
        assert_eq!((allocator.held(), allocator.peak()), (100, 100));
        // SAFETY: as above.
        let block = unsafe { allocator.realloc(block, layout, 300) };
        assert_eq!((allocator.held(), allocator.peak()), (300, 300));
        let larger = Layout::from_size_align(300, 8).unwrap();
        // SAFETY: as above.
        let block = unsafe { allocator.realloc(block, larger, 50) };
        assert_eq!((allocator.held(), allocator.peak()), (50, 300));
        allocator.restart_peak();
        // SAFETY: as above.
        unsafe { allocator.dealloc(block, Layout::from_size_align(50, 8).unwrap()) };
        assert_eq!((allocator.held(), allocator.peak()), (0, 50));
    }

    #[test]
    fn beyond_the_limit_nothing_is_given() {
        let allocator = CountingAllocator::new();
        allocator.limit_to(150);
        let layout = Layout::from_size_align(100, 8).unwrap();
        // SAFETY: the layouts are not empty, and each block goes back with its layout.
        let block = unsafe { allocator.alloc(layout) };
        // SAFETY: as above.
        assert!(unsafe { allocator.alloc(layout) }.is_null());
        // SAFETY: as above.
        assert!(unsafe { allocator.alloc_zeroed(layout) }.is_null());
        // SAFETY: as above; a block that cannot grow stays as it was.
        assert!(unsafe { allocator.realloc(block, layout, 200) }.is_null());
        assert_eq!(allocator.held(), 100);
        // SAFETY: as above.
        unsafe { allocator.dealloc(block, layout) };
        assert_eq!(allocator.held(), 0);
    }

    #[test]
    #[should_panic(expected = "120 bytes beyond 100")]
    fn a_shortage_is_told() {
        let allocator = CountingAllocator::new();
        allocator.end_at_shortage(|shortage| {
            panic!("{} bytes beyond {}", shortage.asked, shortage.limit.unwrap_or_default())
        });
        allocator.limit_to(100);
        allocator.take(120);
    }
}
