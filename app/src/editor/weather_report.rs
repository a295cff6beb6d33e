//! A sky from weather reports: asked for, made off the frame, shown as it would be, and one undo point or nothing.

use super::Editor;
use super::trial::{Trial, Try};
use crate::panel::{self, Answer, Said, WeatherChosen, WeatherForm};
use crate::reports::{self, Line, MOST_TIME, Made, MakeError, Making, make, reading, words};
use crate::state::Selection;
use crate::widget::MOST_CHARACTERS;
use crate::worker::Latest;
use cloudwright_core::document::{Document, Edit, SavedMark};
use cloudwright_core::reported::Told;
use cloudwright_core::scene::{Date, Scene};
use cloudwright_scripts::{Fault, Patience};
use std::sync::Arc;
use std::time::Instant;

/// What is being asked, and what was chosen last.
#[derive(Default)]
pub(super) struct WeatherReport {
    asked: Option<Asked>,
    /// Until the window is closed.
    chosen: WeatherChosen,
}

struct Asked {
    is_new: bool,
    read: Read,
    tries: Trial<Wanted, Result<Sky, MakeError>>,
    /// The state that all tries begin with, and what was selected in it.
    before: SavedMark,
    selection: Selection,
    /// What the scene shows.
    made: Option<Made>,
    /// It was said to be done; the try that it waits for goes on.
    confirmed: bool,
    /// Why the last try came to nothing.
    error: Option<String>,
}

/// What was read, and of what.
#[derive(Default)]
struct Read {
    of: WeatherChosen,
    lines: Vec<Line>,
    /// Why it is no text of reports.
    none: Option<String>,
    /// All of it, if all could be read.
    told: Option<Arc<[Told]>>,
    date: Option<Date>,
}

/// What a try is of.
#[derive(Clone, PartialEq)]
struct Wanted {
    told: Arc<[Told]>,
    making: Making,
}

/// What a try has come to.
struct Sky {
    made: Made,
    name: String,
    edits: Vec<Edit>,
}

impl WeatherReport {
    pub(super) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }

    /// Another document has come.
    pub(super) fn leave(&mut self) {
        self.asked = None;
    }
}

impl Read {
    fn new(chosen: &WeatherChosen) -> Self {
        let of = chosen.clone();
        let (lines, none) = match reports::lines(&chosen.text) {
            Ok(lines) => (lines, None),
            Err(error) => (Vec::new(), Some(error.to_string())),
        };
        let mut placed = lines.clone();
        reading::put_stations(&mut placed, |station| reading::place_of(chosen.places.get(station)?));
        let told = reading::told(&placed).ok().filter(|told| !told.is_empty()).map(Arc::from);
        Self { of, date: lines.iter().find_map(|line| line.date), lines, none, told }
    }

    fn is_of(&self, chosen: &WeatherChosen) -> bool {
        self.of.text == chosen.text && self.of.places == chosen.places
    }

    fn wanted(&self, chosen: &WeatherChosen) -> Option<Wanted> {
        let WeatherChosen { keeps_clouds, moves_site, speed, seed, .. } = *chosen;
        let making = Making { speed, seed, keeps_clouds, moves_site, date: self.date };
        Some(Wanted { told: Arc::clone(self.told.as_ref()?), making })
    }
}

impl Asked {
    fn form(&self, units: crate::units::Units) -> WeatherForm<'_> {
        let is_cut = self.read.of.text.chars().count() >= MOST_CHARACTERS;
        let cut = "Here the window's text ends; `cloudwright weather --file` reads more.";
        WeatherForm {
            lines: self.read.none.as_deref().map_or(Ok(&self.read.lines), Err),
            is_new: self.is_new,
            made: self.made.as_ref(),
            said: Said {
                error: self.error.as_deref(),
                printed: &[],
                runs: self.tries.takes_long(),
                notice: is_cut.then_some(cut),
            },
            can_do: self.read.told.is_some(),
            units,
        }
    }
}

impl Editor {
    pub(super) fn ask_weather_report(&mut self, context: &egui::Context) {
        if let Err(error) = self.session.commit() {
            return self.tell_error(error.to_string());
        }
        match tries(Arc::new(self.session.scene().clone()), context) {
            Ok(tries) => {
                self.weather.asked = Some(Asked {
                    is_new: true,
                    read: Read::new(&self.weather.chosen),
                    tries,
                    before: self.session.document().mark(),
                    selection: self.view.selection.clone(),
                    made: None,
                    confirmed: false,
                    error: None,
                });
                context.request_repaint();
            }
            Err(error) => self.tell_error(format!("The system gives no thread: {error}")),
        }
    }

    pub(super) fn show_weather_report(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.weather.asked.take() else { return };
        // Whatever ended the gesture meanwhile (a save, an undo) has answered.
        if asked.made.is_some() && !self.session.document().is_open() {
            return self.view.keep_what_is_in(self.session.scene());
        }
        // What else was changed meanwhile stays, and is what the sky is made for.
        if self.session.document().mark() != asked.before {
            return self.ask_weather_report(context);
        }
        let mut chosen = std::mem::take(&mut self.weather.chosen);
        let answer = panel::ask_weather(context, &asked.form(self.disk.settings().units), &mut chosen);
        asked.is_new = false;
        if !asked.read.is_of(&chosen) {
            asked.read = Read::new(&chosen);
        }
        let wanted = asked.read.wanted(&chosen);
        self.weather.chosen = chosen;
        match answer {
            Some(Answer::Cancel) => return self.take_weather_back(&mut asked),
            Some(Answer::Do) => asked.confirmed = true,
            None => {}
        }
        let Some(wanted) = wanted else {
            asked.tries.forget();
            asked.confirmed = false;
            asked.error = None;
            self.take_weather_back(&mut asked);
            self.weather.asked = Some(asked);
            return;
        };
        if let Some(ended) = asked.tries.keep_up(&wanted, context) {
            self.show_sky(&mut asked, ended, context);
        }
        if asked.confirmed && asked.tries.is_of(&wanted) {
            return self.keep_sky(asked.made.as_ref());
        }
        self.weather.asked = Some(asked);
    }

    /// Leaves the scene as it was.
    fn take_weather_back(&mut self, asked: &mut Asked) {
        if asked.made.take().is_some() {
            self.session.cancel();
            self.select(asked.selection.clone());
        }
    }

    /// Brings the scene to what a try came to; to what it was before if that is nothing.
    fn show_sky(&mut self, asked: &mut Asked, ended: Result<Sky, MakeError>, context: &egui::Context) {
        // The table of covers comes with it.
        context.request_repaint();
        self.take_weather_back(asked);
        let shown = ended.map_err(|error| error.to_string()).and_then(|Sky { made, name, edits }| {
            self.session.drag(&name, edits).map_err(|error| error.to_string())?;
            Ok(made)
        });
        match shown {
            Ok(made) => {
                asked.made = Some(made);
                asked.error = None;
            }
            Err(error) => {
                self.session.cancel();
                asked.confirmed = false;
                asked.error = Some(error);
            }
        }
        self.view.keep_what_is_in(self.session.scene());
    }

    /// What the scene shows becomes an undo point; the covers are told.
    fn keep_sky(&mut self, made: Option<&Made>) {
        let done = self.session.commit();
        if let (Ok(()), Some(made)) = (&done, made) {
            self.tell(in_short(made));
        }
        self.report(done);
    }
}

/// Tries on `scene`.
fn tries(scene: Arc<Scene>, context: &egui::Context) -> std::io::Result<Trial<Wanted, Result<Sky, MakeError>>> {
    let wake = context.clone();
    let work = move |Try { wanted: Wanted { told, making }, cancelled }: Try<Wanted>| {
        let patience = Patience { cancelled, until: Some(Instant::now() + MOST_TIME) };
        let mut document = Document::new(Scene::clone(&scene));
        match make(&mut document, &told, &making, &patience) {
            Err(MakeError::Plugin { error, .. }) if error.fault == Fault::Cancelled => None,
            Err(error) => Some(Err(error)),
            Ok(made) => {
                let name = document.undo_name().unwrap_or_default().to_owned();
                Some(Ok(Sky { made, name, edits: document.last_edits() }))
            }
        }
    };
    Latest::start_beside_the_window("weather", work, move || wake.request_repaint()).map(Trial::by)
}

/// `The sky as reported: cumulus 3.4 of 3.5 oktas, altocumulus 5.9 of 6.0 oktas`.
fn in_short(made: &Made) -> String {
    let covers = made.layers.iter().filter_map(|made| {
        let cover = made.fullest()?;
        let name = words::name(&made.layer.genus);
        Some(format!("{name} {:.1} of {:.1} oktas", cover.measured_oktas, cover.asked_oktas))
    });
    let covers: Vec<String> = covers.collect();
    let covers = if covers.is_empty() { "no clouds".into() } else { covers.join(", ") };
    format!("The sky as reported: {covers}")
}
