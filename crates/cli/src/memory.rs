//! What the allocator does with memory that is freed.

/// Bytes of the block below.
const BLOCK: usize = 30 << 20;

/// Lets the allocator keep what is freed for what is asked for next: level after level asks for as much again, and memory that was given back comes page by
/// page, each filled with zeros first.
///
/// The allocator of glibc gives the end of its memory back where more is free than twice the largest block that it has mapped by itself and seen freed, up to
/// 32 MiB (`M_MMAP_THRESHOLD` and `M_TRIM_THRESHOLD` in mallopt(3)). This is such a block; nothing touches it, so that it takes no memory anywhere. Where there
/// is no room for it, nothing changes.
pub(crate) fn keep_what_is_freed() {
    let mut block = Vec::<u8>::new();
    let room = block.try_reserve_exact(BLOCK);
    drop(std::hint::black_box((block, room)));
}
