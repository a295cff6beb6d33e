//! The `cloudwright` program: everything is in the library, so that tests reach it.

fn main() -> std::process::ExitCode {
    cloudwright::cli::run(std::env::args_os())
}
