//! How much memory the system has left for this process.

/// The bytes that this process may still take: the least of the limit on its address space (`ulimit -v`) and that of its control group
/// (containers), less what it has of them, and of what the machine has left. `None` if nothing is known, as on other systems than Linux.
///
/// # Complexity
/// Five small tables of the kernel are read.
///
/// # Examples
/// ```
/// assert_ne!(coface_allocator::free_memory(), Some(0));
/// ```
pub fn free_memory() -> Option<u64> {
    [free_addresses(), free_of_group(), free_of_machine()].into_iter().flatten().min()
}

/// What is left of the limit on the address space.
fn free_addresses() -> Option<u64> {
    let limits = std::fs::read_to_string("/proc/self/limits").ok()?;
    let row = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let soft: u64 = row.split_whitespace().next()?.parse().ok()?;
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    Some(soft.saturating_sub(kibibytes(&status, "VmSize:")?))
}

/// What is left of the limit of the control group, in which the process is alone as far as it sees.
fn free_of_group() -> Option<u64> {
    let number = |name: &str| {
        let text = std::fs::read_to_string(format!("/sys/fs/cgroup/{name}")).ok()?;
        text.trim().parse::<u64>().ok()
    };
    Some(number("memory.max")?.saturating_sub(number("memory.current")?))
}

/// What the machine can give without swapping.
fn free_of_machine() -> Option<u64> {
    kibibytes(&std::fs::read_to_string("/proc/meminfo").ok()?, "MemAvailable:")
}

/// The row of this name in a table of the kernel, in bytes.
fn kibibytes(table: &str, name: &str) -> Option<u64> {
    let row = table.lines().find_map(|line| line.strip_prefix(name))?;
    let count: u64 = row.split_whitespace().next()?.parse().ok()?;
    count.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_the_kernel_are_read() {
        let table = "MemTotal:       24000000 kB\nMemAvailable:   12000000 kB\n";
        assert_eq!(kibibytes(table, "MemAvailable:"), Some(12_000_000 << 10));
        assert_eq!(kibibytes(table, "SwapFree:"), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_machine_has_some_memory() {
        let free = free_memory().unwrap();
        assert!(free > 1 << 20 && free < 1 << 50, "{free}");
    }
}
