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

/// So far a layer may be beyond the oktas that its group stands for: FEW for 1 to 2, SCT for 3 to 4, BKN for 5 to 7.
const TOLERANCE_OKTAS: f64 = 0.5;

/// Of one layer of one report.
struct Measured {
    genus: Genus,
    /// What its group stands for, from and to.
    group_oktas: [f64; 2],
    asked_oktas: f64,
    measured_oktas: f64,
    line: usize,
}

impl Measured {
    /// How far it is from the middle of its group.
    fn error_oktas(&self) -> f64 {
        (self.measured_oktas - self.asked_oktas).abs()
    }

    /// How far it is beyond its group, 0 within.
    fn beyond_oktas(&self) -> f64 {
        let [from, to] = self.group_oktas;
        (from - self.measured_oktas).max(self.measured_oktas - to).max(0.0)
    }
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
                group_oktas: layer.layer.cover.map_or([cover.asked_oktas; 2], |group| group.oktas().map(f64::from)),
                asked_oktas: cover.asked_oktas,
                measured_oktas: cover.measured_oktas,
                line: line.number,
            }));
        }
        Ok(())
    }

    fn markdown(&self) -> String {
        let mut genera: BTreeMap<String, Vec<&Measured>> = BTreeMap::new();
        for layer in &self.layers {
            genera.entry(format!("{:?}", layer.genus)).or_default().push(layer);
        }
        let mut text = format!(
            "# Skies of real reports\n\n{} reports: {} are read and become skies, {} of them without clouds; {} are \
             refused. {} layers of\nfog lie below eye level and are left to the haze.\n\nOktas that each layer covers, \
             measured from below: how far they are from the middle of its group, and how many are\nmore than \
             {TOLERANCE_OKTAS} beyond all that the group stands for.\n\n| kind | layers | median error | 95 % | largest | \
             beyond |\n|---|---|---|---|---|---|\n",
            self.read + self.refused.len(),
            self.read,
            self.cloudless,
            self.refused.len(),
            self.without_clouds,
        );
        for (name, layers) in &genera {
            row(&mut text, name, layers);
        }
        let all: Vec<&Measured> = self.layers.iter().collect();
        row(&mut text, "all", &all);
        let far: Vec<&Measured> = all.into_iter().filter(|layer| layer.beyond_oktas() > TOLERANCE_OKTAS).collect();
        if !far.is_empty() {
            text.push_str("\nBeyond:\n\n");
            for Measured { genus, asked_oktas, measured_oktas, line, .. } in far {
                let _ = writeln!(text, "- line {line}: {genus:?}, {measured_oktas:.1} oktas for {asked_oktas:.1}");
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

fn row(text: &mut String, name: &str, layers: &[&Measured]) {
    let mut errors: Vec<f64> = layers.iter().map(|layer| layer.error_oktas()).collect();
    errors.sort_by(f64::total_cmp);
    let beyond = layers.iter().filter(|layer| layer.beyond_oktas() > TOLERANCE_OKTAS).count();
    let [median, most, largest] = [0.5, 0.95, 1.0].map(|share| at(&errors, share));
    let _ = writeln!(text, "| {name} | {} | {median:.2} | {most:.2} | {largest:.2} | {beyond} |", errors.len());
}

/// What `share` of sorted values are not above; 0 if there are none.
fn at(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((last as f64 * share).ceil() as usize).copied().unwrap_or_default()
}
