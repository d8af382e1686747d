//! The `technolog` program; its code is in [`cli`].

mod cli;

/// A plan makes very many small notes: with this allocator it is a fifth faster than with that of the system.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    cli::main()
}
