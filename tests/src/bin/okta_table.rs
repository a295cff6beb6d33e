//! Prints as Markdown what becomes of a file of weather reports: how many are read, which groups are not, and by how much
//! the sky that is made of each differs from what its groups ask for.
//!
//! `cargo run --release -p cloudwright-tests --bin okta_table -- tests/reports/metars.txt > assets/charts/reports.md`

use cloudwright::reports::{Line, MakeError, Making, lines, make, reading};
use cloudwright_core::document::Document;
use cloudwright_core::reported::Genus;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::Patience;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::ExitCode;
use std::time::Instant;

/// What a report's group says is known to half an okta.
const TOLERANCE_OKTAS: f64 = 0.5;

/// Of one layer of one report.
struct Measured {
    genus: Genus,
    asked_oktas: f64,
    error_oktas: f64,
    line: usize,
}

/// What became of all.
#[derive(Default)]
struct Table {
    layers: Vec<Measured>,
    read: usize,
    cloudless: usize,
    /// Layers that nothing was to be made for: fog below eye level.
    without_clouds: usize,
    refused: Vec<String>,
    seconds: Vec<f64>,
}

fn main() -> ExitCode {
    // The plugins run in processes of this program.
    if std::env::args_os().nth(1).is_some_and(|arg| arg == "script-host") {
        return cloudwright::cli::run(std::env::args_os());
    }
    match tabled() {
        Ok(text) => match std::io::stdout().lock().write_all(text.as_bytes()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(_) => ExitCode::FAILURE,
        },
        Err(message) => {
            let _ = writeln!(std::io::stderr(), "error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn tabled() -> Result<String, String> {
    let file = std::env::args().nth(1).ok_or("name a file of reports, a line each")?;
    let text = std::fs::read_to_string(&file).map_err(|error| format!("{file}: {error}"))?;
    let lines = lines(&text).map_err(|error| format!("{file}: {error}"))?;
    let mut table = Table::default();
    for (index, line) in lines.iter().enumerate() {
        table.take(line).map_err(|error| format!("{file}:{}: {error}", line.number))?;
        if (index + 1).is_multiple_of(50) {
            let _ = writeln!(std::io::stderr(), "{} of {}", index + 1, lines.len());
        }
    }
    table.seconds.sort_by(f64::total_cmp);
    let _ = writeln!(
        std::io::stderr(),
        "a report takes {:.2} s in the median, {:.2} s at the 95th percentile",
        at(&table.seconds, 0.5),
        at(&table.seconds, 0.95)
    );
    Ok(table.markdown())
}

impl Table {
    fn take(&mut self, line: &Line) -> Result<(), MakeError> {
        let told = match reading::told(std::slice::from_ref(line)) {
            Ok(told) => told,
            Err((number, refused)) => {
                self.refused.push(format!("line {number}: {refused}"));
                return Ok(());
            }
        };
        self.read += 1;
        let making = Making { speed: 600.0, seed: 1, keeps_clouds: false, moves_site: true, date: line.date };
        let began = Instant::now();
        // Nobody waits: a busy machine changes no figure.
        let patience = Patience { until: None, ..Patience::usual() };
        let made = make(&mut Document::new(Scene::default()), &told, &making, &patience)?;
        self.seconds.push(began.elapsed().as_secs_f64());
        self.cloudless += usize::from(made.layers.is_empty());
        for layer in &made.layers {
            self.without_clouds += usize::from(layer.plugin.is_none());
            self.layers.extend(layer.cover.iter().map(|cover| Measured {
                genus: layer.layer.genus,
                asked_oktas: cover.asked_oktas,
                error_oktas: cover.measured_oktas - cover.asked_oktas,
                line: line.number,
            }));
        }
        Ok(())
    }

    fn markdown(&self) -> String {
        let mut genera: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for layer in &self.layers {
            let errors = genera.entry(format!("{:?}", layer.genus)).or_default();
            errors.push(layer.error_oktas.abs());
        }
        let mut all: Vec<f64> = self.layers.iter().map(|layer| layer.error_oktas.abs()).collect();
        let mut text = format!(
            "# Skies of real reports\n\n{} reports: {} are read and become skies, {} of them without clouds; {} are \
             refused. {} layers of\nfog lie below eye level and are left to the haze.\n\nOktas that a layer covers, measured \
             from below, against those that its group asks for:\n\n| kind | layers | median error | 95 % | largest | over \
             {TOLERANCE_OKTAS} |\n|---|---|---|---|---|---|\n",
            self.read + self.refused.len(),
            self.read,
            self.cloudless,
            self.refused.len(),
            self.without_clouds,
        );
        for (name, errors) in &mut genera {
            row(&mut text, name, errors);
        }
        row(&mut text, "all", &mut all);
        let far: Vec<&Measured> =
            self.layers.iter().filter(|layer| layer.error_oktas.abs() > TOLERANCE_OKTAS).collect();
        if !far.is_empty() {
            text.push_str("\nFurther off:\n\n");
            for Measured { genus, asked_oktas, error_oktas, line } in far {
                let _ = writeln!(
                    text,
                    "- line {line}: {genus:?}, {:.1} oktas for {asked_oktas:.1}",
                    asked_oktas + error_oktas
                );
            }
        }
        if !self.refused.is_empty() {
            text.push_str("\nRefused:\n\n");
            for refused in &self.refused {
                let _ = writeln!(text, "- {refused}");
            }
        }
        text
    }
}

fn row(text: &mut String, name: &str, errors: &mut [f64]) {
    errors.sort_by(f64::total_cmp);
    let over = errors.iter().filter(|error| **error > TOLERANCE_OKTAS).count();
    let [median, most, largest] = [0.5, 0.95, 1.0].map(|share| at(errors, share));
    let _ = writeln!(text, "| {name} | {} | {median:.2} | {most:.2} | {largest:.2} | {over} |", errors.len());
}

/// What `share` of sorted values are not above; 0 if there are none.
fn at(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((last as f64 * share).ceil() as usize).copied().unwrap_or_default()
}
