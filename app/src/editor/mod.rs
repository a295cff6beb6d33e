//! The editor's window, frame by frame.
//!
//! A frame runs from top to bottom of `Editor::ui`: answers that arrived, keys, bars and panels (the viewport is one),
//! their actions, dialogs. Panels only read and return actions; what they change shows in the next frame.
//! Selection, camera and layout are view state and never saved.

mod appending;
mod autosave;
mod charting;
mod dialogs;
mod disk;
mod done;
mod exchange;
mod file_flow;
mod files;
mod fit_light;
mod flight;
mod intent;
mod layout;
mod layouts;
mod on_disk;
mod perform;
mod place_many;
mod plugins;
mod preferences;
mod progress;
mod recording;
mod remember;
mod rendering;
mod report;
mod save_flow;
mod script;
mod start;
mod start_page;
mod thinning;
mod time_play;
mod toasts;
mod tour;
mod trial;
mod typing;
mod weather_report;
mod window;

pub use files::{Ask, FileDialogs, NativeDialogs, Reply};
pub use start::Start;
pub use window::open_window;

use crate::command::{self, Command, Menu};
use crate::opening::Elsewhere;
use crate::panel::{self, Manual, Palette, Panel};
use crate::renderer::RendererChoice;
use crate::starter::starter_scene;
use crate::state::{Action, Charting, Clock, CommandState, Offered, Reading, Selection, Session, TimePlay, ViewState};
use crate::storage::Folders;
use crate::theme;
use crate::thumbnail::Thumbnails;
use crate::viewport::Viewport;
use crate::visible;
use cloudwright_core::scene::{Camera, CameraId, ColorLevels};
use dialogs::Dialogs;
use disk::Disk;
use exchange::{Arriving, Leaving};
use files::Waiting;
use fit_light::FittingLight;
use intent::Intent;
use layout::Layout;
use place_many::PlaceMany;
use plugins::Plugins;
use recording::Recording;
use rendering::{Copying, Filming, Rendering};
use script::Writing;
use std::cell::RefCell;
use std::time::Duration;
use thinning::Thinning;
use toasts::Toasts;
use weather_report::WeatherReport;

/// The editor: an open document, how it is looked at, and what is being asked.
pub struct Editor {
    session: Session,
    view: ViewState,
    viewport: Viewport,
    layout: Layout,
    palette: Option<Palette>,
    manual: Option<Manual>,
    /// The step that is shown.
    tour: Option<usize>,
    place_many: Option<PlaceMany>,
    plugins: Plugins,
    writing: Writing,
    thinning: Option<Thinning>,
    fitting_light: FittingLight,
    weather: WeatherReport,
    leaving: Leaving,
    arriving: Arriving,
    rendering: Rendering,
    filming: Filming,
    copying: Copying,
    /// What draws pictures, as it was asked for.
    renderer: RendererChoice,
    time_play: TimePlay,
    clock: Clock,
    charting: Charting,
    recording: Option<Recording>,
    /// The camera that was looked through last by the key.
    last_camera: Option<CameraId>,
    copied_levels: Option<ColorLevels>,
    /// What was copied last, and where the models that it names lie.
    copied_from: Option<(String, Elsewhere)>,
    file_dialogs: Box<dyn FileDialogs>,
    disk: Disk,
    waiting: Option<Waiting>,
    after_save: Option<Intent>,
    dialogs: Dialogs,
    /// To be written when its file is named.
    report_text: Option<String>,
    toasts: Toasts,
    /// Shared by dialogs and panels that show pictures to choose from, which only read all else.
    thumbnails: RefCell<Thumbnails>,
    /// Esc was pressed: the rest of this gesture is ignored.
    gesture_dropped: bool,
    /// A panel asked in this frame for what it shows as a preview.
    previews: bool,
    /// It did so in the frame before.
    previewed: bool,
    quitting: bool,
    title: String,
}

impl Editor {
    /// An editor for a window.
    pub fn new(context: &egui::Context, start: Start) -> Self {
        let Start { scene: path, start_page, renderer, device, file_dialogs, folders } = start;
        theme::install(context);
        context.add_plugin(typing::Typing::default());
        let plugins = Plugins::new(context, folders.as_ref().map(Folders::plugins));
        let (disk, notices) = Disk::new(context, folders);
        let session = Session::new(starter_scene(), None);
        let mut editor = Self {
            viewport: Viewport::new(context, &session, renderer, device),
            session,
            view: ViewState::default(),
            layout: Layout::default(),
            palette: None,
            manual: None,
            tour: None,
            place_many: None,
            plugins,
            writing: Writing::new(context),
            thinning: None,
            fitting_light: FittingLight::default(),
            weather: WeatherReport::default(),
            leaving: Leaving::default(),
            arriving: Arriving::default(),
            rendering: Rendering::default(),
            filming: Filming::default(),
            copying: Copying::default(),
            renderer,
            time_play: TimePlay::default(),
            clock: Clock::default(),
            charting: Charting::default(),
            recording: None,
            last_camera: None,
            copied_levels: None,
            copied_from: None,
            file_dialogs,
            disk,
            waiting: None,
            after_save: None,
            dialogs: Dialogs::default(),
            report_text: None,
            toasts: Toasts::default(),
            thumbnails: RefCell::new(Thumbnails::new(context)),
            gesture_dropped: false,
            previews: false,
            previewed: false,
            quitting: false,
            title: String::new(),
        };
        editor.recall(context);
        if let Some(path) = path {
            editor.open_path(&path);
        }
        if start_page {
            editor.show_start_page();
        }
        for notice in notices {
            editor.tell_error(notice);
        }
        editor.offer_recovery();
        editor
    }

    /// The open document with its derived clouds.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// How the scene is looked at.
    pub fn view(&self) -> &ViewState {
        &self.view
    }

    /// Where it is looked at from.
    pub fn camera(&self) -> &Camera {
        self.viewport.camera()
    }

    /// What the viewport's last picture took.
    pub fn picture_time(&self) -> Option<Duration> {
        self.viewport.picture_time()
    }

    /// What is selected.
    pub fn selection(&self) -> &Selection {
        &self.view.selection
    }

    /// Selects something else.
    pub fn select(&mut self, selection: Selection) {
        self.view.selection = selection;
        self.view.keep_what_is_in(self.session.scene());
    }

    /// Whether something before the window waits for an answer.
    fn is_asking(&self) -> bool {
        let asks = self.palette.is_some() || self.place_many.is_some() || self.thinning.is_some();
        let exchanges = self.leaving.is_asking()
            || self.arriving.is_asking()
            || self.rendering.is_asking()
            || self.filming.is_asking()
            || self.fitting_light.is_asking();
        asks || exchanges || self.asks_by_showing() || self.dialogs.is_open()
    }

    /// Whether a question shows what would come of it as an open gesture, until it is answered.
    fn asks_by_showing(&self) -> bool {
        self.plugins.is_asking() || self.weather.is_asking()
    }

    pub(crate) fn tell(&mut self, text: impl AsRef<str>) {
        self.toasts.say(text.as_ref(), false);
    }

    pub(crate) fn tell_error(&mut self, text: impl AsRef<str>) {
        self.toasts.say(text.as_ref(), true);
    }

    /// Esc takes an open gesture back; what the pointer still does until it is let go is ignored.
    fn drop_gesture_on_escape(&mut self, context: &egui::Context) {
        // There, Esc may end the typing in a field.
        let is_gesture = self.session.document().is_open() && !self.asks_by_showing();
        if is_gesture && context.input(|input| input.key_pressed(egui::Key::Escape)) {
            self.session.cancel();
            self.gesture_dropped = true;
            context.stop_dragging();
        }
    }

    /// A gesture ends when no button is down, whichever widget it began in; but for a tool's that goes on till a click.
    fn end_gesture_on_release(&mut self, context: &egui::Context) {
        self.session.keep_past_within(self.disk.settings().undo_mb);
        let previews = std::mem::take(&mut self.previews);
        if std::mem::replace(&mut self.previewed, previews) && !previews {
            self.session.cancel();
        }
        if previews {
            return;
        }
        if context.input(|input| input.pointer.any_down()) || self.viewport.holds_gesture() {
            return;
        }
        self.gesture_dropped = false;
        if self.place_many.is_some() || self.asks_by_showing() {
            return;
        }
        if self.session.document().is_open()
            && let Err(error) = self.session.commit()
        {
            self.tell_error(error.to_string());
        }
    }

    fn show_title(&mut self, context: &egui::Context) {
        let mark = if self.session.document().is_modified() { "• " } else { "" };
        let title = visible::one_line(&format!("{mark}{} — Cloudwright", self.display_name()));
        if title != self.title {
            context.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    fn state_of(&self, command: Command) -> CommandState {
        let document = self.session.document();
        let on_what = match command {
            Command::Undo => document.undo_name(),
            Command::Redo => document.redo_name(),
            _ => None,
        };
        CommandState { enabled: self.can(command), on: self.is_on(command), on_what: on_what.map(Into::into) }
    }

    /// Bars and panels, with that menu to be opened. What they ask for.
    fn panels(&mut self, ui: &mut egui::Ui, menu: Option<Menu>) -> Vec<Action> {
        let mut actions = Vec::new();
        let state = |command| self.state_of(command);
        egui::Panel::top("menus").frame(theme::bar(ui)).show(ui, |ui| {
            panel::menu_bar(ui, &state, self.plugins.library(), menu, &mut actions);
        });
        egui::Panel::top("tools").frame(theme::bar(ui)).show(ui, |ui| panel::toolbar(ui, &state, &mut actions));
        // Asked only where a menu may be open: some commands look through all that is selected.
        let may_show = egui::Popup::is_any_open(ui.ctx()) || ui.input(|input| input.pointer.secondary_released());
        let offered = Offered::new(command::context::all().filter(|_| may_show), state);
        let Self {
            session,
            view,
            viewport,
            layout,
            thumbnails,
            time_play,
            clock,
            charting,
            recording,
            copied_levels,
            disk,
            plugins,
            writing,
            manual,
            ..
        } = self;
        let reading = Reading {
            session,
            view,
            thumbnails,
            time_play,
            clock,
            charting,
            copied_levels: copied_levels.as_ref(),
            view_heading_deg: viewport.camera().heading_deg,
            levels_shown: layout.shows(Panel::ColorLevels),
            is_recording: recording.is_some(),
            flight_shown: layout.shows(Panel::Flight),
            script: &writing.script,
            library: plugins.library(),
            picture_size: disk.settings().picture.size(),
            offered: &offered,
            units: disk.settings().units,
        };
        egui::Panel::bottom("status").frame(theme::bar(ui)).show(ui, |ui| {
            let drawn = panel::Drawn {
                renderer: viewport.renderer_name(),
                time: viewport.picture_time(),
                overdraw: viewport.overdraw(),
            };
            panel::status(ui, &reading, &drawn, disk.saving, &mut actions);
        });
        egui::CentralPanel::no_frame().show(ui, |ui| {
            let (asked, chosen) = layout.show(ui, &offered, |panel, ui| match panel {
                Panel::Viewport => viewport.show(ui, &reading, &mut actions),
                other => other.show(ui, &reading, &mut actions),
            });
            if let Some(panel) = asked {
                *manual = Some(Manual::at(panel.name()));
            }
            actions.extend(chosen.map(Action::Command));
        });
        actions
    }

    fn show_manual(&mut self, context: &egui::Context) {
        if self.manual.as_mut().is_some_and(|manual| !manual.show(context)) {
            self.manual = None;
        }
    }

    fn show_palette(&mut self, context: &egui::Context) {
        let Some(mut palette) = self.palette.take() else { return };
        match palette.show(context, &|command| self.state_of(command), self.plugins.library()) {
            Some(Some(action)) => self.carry_out(vec![action], context),
            Some(None) => {}
            None => self.palette = Some(palette),
        }
    }
}

impl eframe::App for Editor {
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        theme::clear_color(visuals)
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        self.take_up_what_is_done(&context);
        self.keep_script(&context);
        self.tell_whether_work_is_kept();
        self.answer_file_dialogs(&context);
        self.take_dropped_files(&context);
        self.answer_close_request(&context);
        self.drop_gesture_on_escape(&context);
        self.run_time(&context);
        self.leave_solo_on_escape(&context);
        self.run_clock(&context);
        self.keep_chart(&context);
        let mut actions: Vec<Action> = Vec::new();
        let mut menu = None;
        if !self.is_asking() && !self.viewport.has_keys() {
            menu = panel::wanted_menu(&context);
            actions.extend(command::pressed(&context).into_iter().map(Action::Command));
            actions.extend(command::pasted(&context).map(Action::Paste));
        }
        self.session.mute(self.view.timeline.muted(self.clock.time_s()));
        actions.extend(self.panels(ui, menu));
        self.record(&context);
        self.carry_out(actions, &context);
        self.end_gesture_on_release(&context);
        self.session.keep_up(&context);
        self.show_dialogs(&context);
        dialogs::show_drop_target(&context);
        self.show_palette(&context);
        self.show_place_many(&context);
        self.show_thinning(&context);
        self.show_fit_light(&context);
        self.show_weather_report(&context);
        self.show_leaving(&context);
        self.show_arriving(&context);
        self.show_rendering(&context);
        self.show_filming(&context);
        self.keep_copying(&context);
        self.show_plugin(&context);
        self.show_last_run(&context);
        self.show_manual(&context);
        self.show_tour(&context);
        self.toasts.show(&context, self.layout.picture_place(&context));
        self.show_title(&context);
        self.autosave(&context);
        self.watch_file(&context);
        self.keep_plugins(&context);
        self.remember_look(&context);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.leave();
    }
}
