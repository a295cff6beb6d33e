//! The program under another name, for tests and benches that run plugins: they are not `cloudwright` themselves, and find
//! only their own package's programs (`Host::at(env!("CARGO_BIN_EXE_script_host"))`).

fn main() -> std::process::ExitCode {
    cloudwright::cli::run(std::env::args_os())
}
