//! The start page, and what is chosen there.

use super::Editor;
use super::dialogs::Dialog;
use super::done::Done;
use super::files::Ask;
use super::intent::Intent;
use super::preferences::Preference;
use crate::command::Command;
use crate::manual;
use crate::panel::{Manual, StartChoice, StartPage, start_page};
use crate::storage;
use egui::Context;
use std::path::PathBuf;

impl Editor {
    /// Shows it at once; recent scenes come to it when it is known which are still there.
    pub(super) fn show_start_page(&mut self) {
        self.dialogs.open(Dialog::StartPage(Vec::new()));
        let paths = self.disk.settings().recent().to_vec();
        if !paths.is_empty() {
            let there = move || paths.into_iter().filter(|path| storage::is_there(path)).collect();
            self.disk.file_jobs.ask(move || Done::StillThere(there()));
        }
    }

    /// None while it stays open.
    pub(super) fn answer_start_page(&mut self, recent: &[PathBuf], context: &Context) -> Option<()> {
        let page = StartPage {
            recent,
            // Before the picture is there, nothing else is drawn.
            may_draw: self.viewport.picture_time().is_some(),
            at_start: self.disk.settings().start_page,
        };
        match start_page(context, &page, self.thumbnails.get_mut())? {
            StartChoice::AtStart(on) => {
                self.prefer(Preference::StartPage(on), context);
                return None;
            }
            StartChoice::Open(path) => self.want(Intent::OpenFile(path), context),
            StartChoice::OpenOther => self.ask(Ask::Open(self.beside_what()), context),
            StartChoice::Begin(template) => self.want(Intent::Begin(template), context),
            StartChoice::Report => self.perform(Command::WeatherReport, context),
            StartChoice::Tour => self.begin_tour(),
            StartChoice::News => self.manual = Some(Manual::at(manual::NEWS)),
            StartChoice::Close => {}
        }
        Some(())
    }
}
