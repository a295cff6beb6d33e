//! The editor's window, frame by frame.
//!
//! A frame runs from top to bottom of `Editor::ui`: answers that arrived, keys, panels, their actions, viewport, its
//! actions, dialogs. Panels only read and return actions; what they change shows in the viewport of the same frame.
//! Selection, camera and layout are view state and never saved.

mod action;
mod autosave;
mod carry_out;
mod desk;
mod dialogs;
mod file_flow;
mod files;
mod on_disk;
mod remember;
mod save_flow;
mod selection;
mod session;
mod starter;
mod window;

pub(crate) use action::Action;
pub use files::{Ask, FileDialogs, NativeDialogs, Reply};
pub use selection::Selection;
pub(crate) use selection::box_of;
pub use session::Session;
pub(crate) use starter::scene as starter_scene;
pub use window::open_window;

use crate::command;
use crate::panel;
use crate::renderer::RendererChoice;
use crate::storage::Folders;
use crate::theme;
use crate::viewport::Viewport;
use desk::Desk;
use dialogs::Dialogs;
use eframe::egui_wgpu::RenderState;
pub(crate) use file_flow::Intent;
use files::Waiting;
use std::path::PathBuf;

/// The editor: an open document, how it is looked at, and what is being asked.
pub struct Editor {
    session: Session,
    selection: Selection,
    viewport: Viewport,
    file_dialogs: Box<dyn FileDialogs>,
    desk: Desk,
    waiting: Option<Waiting>,
    after_save: Option<Intent>,
    dialogs: Dialogs,
    notice: Option<Notice>,
    /// Esc was pressed: the rest of this gesture is ignored.
    gesture_dropped: bool,
    quitting: bool,
    title: String,
}

/// A line in the status bar.
#[derive(Debug, Clone)]
pub(crate) struct Notice {
    pub(crate) text: String,
    pub(crate) is_error: bool,
}

/// What an editor starts with.
pub struct Start {
    /// A scene to open; a new one if there is none. Problems of the file are shown in the window.
    pub scene: Option<PathBuf>,
    /// What draws the viewport.
    pub renderer: RendererChoice,
    /// The window's device.
    pub device: Option<RenderState>,
    /// How file names are asked for.
    pub file_dialogs: Box<dyn FileDialogs>,
    /// Where settings and unsaved work are kept; none to remember nothing.
    pub folders: Option<Folders>,
}

impl Editor {
    /// An editor for a window.
    pub fn new(context: &egui::Context, start: Start) -> Self {
        let Start { scene: path, renderer, device, file_dialogs, folders } = start;
        theme::install(context);
        let (desk, notice) = Desk::new(context, folders);
        let session = Session::new(starter::scene(), None, None);
        let mut editor = Self {
            viewport: Viewport::new(context, &session, renderer, device),
            session,
            selection: Selection::Nothing,
            file_dialogs,
            desk,
            waiting: None,
            after_save: None,
            dialogs: Dialogs::default(),
            notice: None,
            gesture_dropped: false,
            quitting: false,
            title: String::new(),
        };
        editor.recall(context);
        if let Some(path) = path {
            editor.open_path(&path);
        }
        if let Some(notice) = notice {
            editor.tell_error(notice);
        }
        editor.offer_recovery();
        editor
    }

    /// The open document with its derived clouds.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// What is selected.
    pub fn selection(&self) -> Selection {
        self.selection
    }

    /// Selects something else.
    pub fn select(&mut self, selection: Selection) {
        self.selection = selection.still_in(self.session.scene());
    }

    pub(crate) fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { text: text.into(), is_error: false });
    }

    pub(crate) fn tell_error(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { text: text.into(), is_error: true });
    }

    /// Esc takes an open gesture back; what the pointer still does until it is let go is ignored.
    fn drop_gesture_on_escape(&mut self, context: &egui::Context) {
        if self.session.document().is_open() && context.input(|input| input.key_pressed(egui::Key::Escape)) {
            self.session.cancel();
            self.gesture_dropped = true;
            context.stop_dragging();
        }
    }

    /// A gesture ends when no button is down, whichever widget it began in.
    fn end_gesture_on_release(&mut self, context: &egui::Context) {
        if context.input(|input| input.pointer.any_down()) {
            return;
        }
        self.gesture_dropped = false;
        if self.session.document().is_open()
            && let Err(error) = self.session.commit()
        {
            self.tell_error(error.to_string());
        }
    }

    fn show_title(&mut self, context: &egui::Context) {
        let mark = if self.session.document().is_modified() { "• " } else { "" };
        let title = format!("{mark}{} — Cloudwright", self.display_name());
        if title != self.title {
            context.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    fn panels(&mut self, ui: &mut egui::Ui) -> Vec<Action> {
        let mut actions = Vec::new();
        let state = |command| panel::CommandState {
            enabled: self.can(command),
            on: command == command::Command::ShowBoxes && self.viewport.show_all_boxes,
        };
        egui::Panel::top("menus").frame(theme::bar(ui)).show(ui, |ui| panel::menu_bar(ui, &state, &mut actions));
        egui::Panel::top("tools").frame(theme::bar(ui)).show(ui, |ui| {
            panel::toolbar(ui, &state, &mut actions);
        });
        egui::Panel::bottom("status").frame(theme::bar(ui)).show(ui, |ui| {
            panel::status(ui, &self.session, &self.viewport, self.notice.as_ref());
        });
        egui::Panel::left("outline").default_size(theme::OUTLINE_WIDTH).frame(theme::side(ui)).show(ui, |ui| {
            panel::outline(ui, self.session.scene(), self.selection, &mut actions);
        });
        egui::Panel::right("inspector").default_size(theme::INSPECTOR_WIDTH).frame(theme::side(ui)).show(ui, |ui| {
            panel::inspector(ui, &self.session, self.selection, &mut actions);
        });
        actions
    }
}

impl eframe::App for Editor {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        self.take_up_what_is_done(&context);
        self.answer_file_dialogs(&context);
        self.take_dropped_files(&context);
        self.answer_close_request(&context);
        self.drop_gesture_on_escape(&context);
        let mut actions: Vec<Action> = Vec::new();
        if !self.dialogs.is_open() {
            actions.extend(command::pressed(&context).into_iter().map(Action::Command));
        }
        actions.extend(self.panels(ui));
        self.carry_out(actions, &context);
        let mut actions = Vec::new();
        egui::CentralPanel::no_frame().show(ui, |ui| {
            self.viewport.show(ui, &self.session, self.selection, &mut actions);
        });
        self.carry_out(actions, &context);
        self.end_gesture_on_release(&context);
        self.show_dialogs(&context);
        dialogs::show_drop_target(&context);
        self.show_title(&context);
        self.autosave(&context);
        self.watch_file(&context);
        self.remember_look(&context);
    }

    fn on_exit(&mut self) {
        self.leave();
    }
}
