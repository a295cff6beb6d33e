//! Actions and commands, carried out: the one arm a command.

mod add;
mod arrange;
mod clipboard;
mod flight;
mod folders;
mod keys;
mod naming;
mod shade;
mod tracks;
mod view;

use super::dialogs::Dialog;
use super::intent::Intent;
use super::{Ask, Editor};
use crate::command::{Command, Keymap};
use crate::manual;
use crate::panel::{Manual, Panel};
use crate::state::{Action, Item, Selection, SpriteMarks, TimeSnap, Tool};
use crate::viewport::Grabbed;
use cloudwright_core::arrange::delete;
use cloudwright_core::arrange::mirror::Axis;
use cloudwright_core::document::{Edit, EditError};
use cloudwright_core::scene::Folder;

impl Editor {
    /// Does what panels and viewport asked for, and shows the outcome in the next frame.
    pub(super) fn carry_out(&mut self, actions: Vec<Action>, context: &egui::Context) {
        if !actions.is_empty() {
            context.request_repaint();
        }
        self.tell_empty_clipboard(context);
        for action in actions {
            match action {
                Action::Command(command) => self.perform(command, context),
                Action::Script(change) => self.change_script(change, context),
                Action::Plugin(origin) => self.ask_plugin(&origin, context),
                Action::Select { items, through, how } => {
                    self.view.selection.choose(items, through, how);
                    self.view.keep_what_is_in(self.session.scene());
                }
                Action::DropGesture => self.session.cancel(),
                Action::LookThrough(id) => self.look_through(id),
                Action::SetFromView(id) => self.set_from_view(id),
                Action::Change { name, edits, live } => self.change(name, edits, live),
                Action::Put { name, edits, made } => {
                    let done = self.session.edit(&name, edits);
                    if done.is_ok() && !made.is_empty() {
                        self.select(Selection::of(made));
                    }
                    self.report(done);
                }
                Action::Preview { name, edits } => {
                    self.previews = true;
                    if !edits.is_empty() {
                        self.change(name, edits, true);
                    }
                }
                Action::Keys { name, rekeyed, live, choose } => self.change_keys(&name, rekeyed, live, choose),
                Action::Timeline(change) => self.change_timeline(change),
                Action::View(change) => self.change_view(change),
                Action::Chart(change) => self.change_chart(change, context),
                Action::Paste(pasted) => self.paste(pasted),
                Action::CancelPending => {
                    self.session.cancel_pending();
                    self.view.keep_what_is_in(self.session.scene());
                }
                Action::GoToKey(path, index) => self.go_to_key(path, index),
                Action::ChooseModel(item) => self.choose_model(item, context),
                Action::JumpTo(count) => {
                    self.session.jump_to(count);
                    self.view.timeline.forget_changes();
                    self.view.keep_what_is_in(self.session.scene());
                }
            }
        }
    }

    fn change(&mut self, name: &str, edits: Vec<Edit>, live: bool) {
        if self.gesture_dropped {
            return;
        }
        if edits.iter().any(|edit| matches!(edit, Edit::TimeOfDay(_))) {
            self.time_play.leave();
        }
        let mut done = self.session.drag_values(name, edits);
        if done.is_ok() && !live {
            done = self.session.commit();
        }
        self.report(done);
    }

    /// Tells why a change was refused.
    pub(in crate::editor) fn report(&mut self, done: Result<(), EditError>) {
        match done {
            Ok(()) => self.toasts.forget_errors(),
            Err(error) => self.tell_error(error.to_string()),
        }
    }

    /// Edits as one undo point; what they made is selected.
    pub(in crate::editor) fn edit_and_select(&mut self, command: Command, edits: Vec<Edit>, selection: Selection) {
        self.edit_as(&command.row().full_label(), edits, selection);
    }

    /// The same under a name that says more than the command's. Whether it was done.
    fn edit_as(&mut self, name: &str, edits: Vec<Edit>, selection: Selection) -> bool {
        let done = self.session.edit(name, edits);
        let is_done = done.is_ok();
        if is_done {
            self.select(selection);
        }
        self.report(done);
        is_done
    }

    /// Whether a command has something to work on now.
    pub fn can(&self, command: Command) -> bool {
        let document = self.session.document();
        let scene = document.scene();
        let selection = &self.view.selection;
        let (clouds, boxes) = (selection.clouds().count(), selection.boxes().count());
        match command {
            Command::RunAgain => self.plugins.can_run_again(),
            Command::OpenPluginFolder => self.disk.folders().is_some(),
            Command::Layouts => !self.disk.settings().layouts.is_empty(),
            Command::OpenRecent => !self.disk.settings().recent().is_empty(),
            Command::Revert => self.session.path().is_some() && document.is_modified(),
            Command::Undo => document.undo_name().is_some() || document.is_open(),
            Command::KeepHour | Command::SceneHour => self.time_play.time_h().is_some(),
            Command::Redo => document.redo_name().is_some(),
            Command::AddBox | Command::PlaceModel | Command::PlaceMany | Command::Reroll | Command::AutoGroup => {
                selection.model(scene).is_some()
            }
            Command::CopyLevels => selection.model(scene).is_some(),
            Command::RenderFlight => self.can_film(),
            Command::FitLight | Command::ThinOut => !scene.clouds.is_empty(),
            Command::PasteLevels => selection.model(scene).is_some() && self.copied_levels.is_some(),
            Command::DuplicateOwn | Command::MakeOwn => clouds > 0,
            Command::MirrorX | Command::MirrorY | Command::MirrorZ => boxes > 0 || clouds > 0,
            Command::Join => clouds > 1,
            Command::Split | Command::FitSprites => boxes > 0,
            Command::NewGroup | Command::Ungroup | Command::ResetSprites => {
                boxes > 0 || selection.sprites().next().is_some()
            }
            Command::NewFolder => clouds > 0,
            Command::MoveToFolder => clouds > 0 && !scene.folders.is_empty(),
            Command::LeaveFolder => {
                selection.clouds().any(|id| scene.cloud(id).is_some_and(|each| each.folder.is_some()))
            }
            Command::SelectFolder => !self.folders_at_work().is_empty(),
            Command::Solo => clouds > 0 || selection.all::<Folder>().next().is_some() || !self.view.solo.is_empty(),
            Command::Duplicate => {
                !matches!(selection.primary(), None | Some(Item::Model(_) | Item::Group(..) | Item::Sprite(..)))
            }
            Command::Delete | Command::Hide | Command::Lock => !selection.is_empty(),
            Command::SelectNone | Command::FrameSelection => !selection.is_empty(),
            Command::GrabPlace | Command::GrabTurn | Command::GrabSize => !selection.is_empty(),
            Command::FrameAll => !self.session.derived().clouds().is_empty(),
            Command::LookThrough | Command::AlignCamera => !scene.cameras.is_empty(),
            Command::KeyAfterLast | Command::KeyAtClock | Command::AddAircraft => self.clock.path(scene).is_some(),
            Command::AddKeys | Command::PreviousKey | Command::NextKey | Command::SelectAllKeys => {
                !scene.tracks.is_empty()
            }
            Command::SelectKeysBefore | Command::SelectKeysAfter | Command::FitTimeline => !scene.tracks.is_empty(),
            Command::SelectNoKeys => !self.view.timeline.tracks.is_empty(),
            Command::ClearMarks => self.clock.marks().is_some(),
            Command::Cut | Command::Copy => self.can_copy(),
            Command::Rename => self.renamable().next().is_some(),
            Command::RemoveUnusedModels => !delete::unused_models(scene).is_empty(),
            Command::DeleteKeys
            | Command::CutKeys
            | Command::CopyKeys
            | Command::DuplicateKeys
            | Command::MirrorKeys => self.has_keys(),
            Command::SlowKeys | Command::QuickenKeys | Command::KeysStep | Command::KeysLinear => self.has_keys(),
            Command::KeysSmooth | Command::KeysFlat | Command::KeysFree => self.has_keys(),
            Command::EndsBefore | Command::EndsAfter => self.has_keys(),
            Command::ClearKeys => self.selection_has_keys(),
            _ => true,
        }
    }

    fn has_keys(&self) -> bool {
        !self.view.timeline.tracks.is_empty()
    }

    /// Whether what a command switches is switched on.
    pub(super) fn is_on(&self, command: Command) -> bool {
        let view = &self.view;
        match command {
            Command::SelectTool => view.tool == Tool::Select,
            Command::MoveTool => view.tool == Tool::Move,
            Command::RotateTool => view.tool == Tool::Rotate,
            Command::ScaleTool => view.tool == Tool::Scale,
            Command::BoxTool => view.tool == Tool::Box,
            Command::SwitchKeymap => self.disk.settings().keymap == Keymap::Blender,
            Command::Snap => view.snap.on,
            Command::KeepFill => view.keep_fill,
            Command::ShowBoxes => view.show_all_boxes,
            Command::SpriteMarks => view.sprite_marks != SpriteMarks::Off,
            Command::GroupView => view.group_view,
            Command::Orthographic => self.viewport.is_orthographic(),
            Command::QuadView => view.quad,
            Command::Haze => view.haze,
            Command::AllSprites => view.all_sprites,
            Command::CameraPicture => view.camera_picture,
            Command::Solo => !view.solo.is_empty(),
            Command::PlayTime => self.time_play.runs(),
            Command::PlayFlight => self.clock.plays(),
            Command::LoopFlight => self.clock.loops(),
            Command::AutoKey => view.timeline.auto_key,
            Command::RippleKeys => view.timeline.ripple,
            Command::SnapKeys => view.timeline.snap != TimeSnap::Off,
            Command::CurveView => view.timeline.curves,
            Command::BoardFlight => self.clock.boards(),
            Command::RecordFlight => self.recording.is_some(),
            _ => false,
        }
    }

    /// Does a command of the table, if it has something to work on.
    pub fn perform(&mut self, command: Command, context: &egui::Context) {
        if !self.can(command) {
            return;
        }
        match command {
            Command::New => self.dialogs.open(Dialog::New { has_focus: false }),
            Command::Open => self.ask(Ask::Open(self.beside_what()), context),
            Command::Append => self.ask(Ask::Append(self.beside_what()), context),
            Command::Import => self.ask(Ask::Arrive(self.beside_what()), context),
            Command::Export => self.ask_leaving(),
            Command::RenderPicture => self.ask_rendering(),
            Command::RenderFlight => self.ask_filming(),
            Command::CopyPicture => self.copy_picture(context),
            Command::OpenRecent => self.list_recent(context),
            Command::Save => self.save(context),
            Command::SaveAs => self.save_as(context),
            Command::Revert => self.dialogs.open(Dialog::Revert),
            Command::Quit => self.want(Intent::Quit, context),
            Command::Undo => self.undo(),
            Command::Redo => self.redo(),
            Command::SelectAll => self.select_all(),
            Command::SelectNone => self.select(Selection::default()),
            Command::Cut => self.cut(context),
            Command::Copy => self.copy(context),
            Command::Paste | Command::PasteKeys => Self::ask_clipboard(context),
            Command::Rename => self.rename(),
            Command::RemoveUnusedModels => self.remove_unused_models(),
            Command::Duplicate => self.duplicate(),
            Command::DuplicateOwn => self.duplicate_own(),
            Command::MakeOwn => self.make_own(),
            Command::MirrorX => self.mirror(command, Axis::X),
            Command::MirrorY => self.mirror(command, Axis::Y),
            Command::MirrorZ => self.mirror(command, Axis::Z),
            Command::Join => self.join(),
            Command::Split => self.split(),
            Command::Reroll => self.reroll(),
            Command::FitSprites => self.fit_sprites(),
            Command::ResetSprites => self.reset_sprites(),
            Command::Delete => self.delete(),
            Command::AddCloud => self.add_cloud(),
            Command::AddPreset => self.dialogs.open(Dialog::Preset),
            Command::PlaceModel => self.place_model(),
            Command::PlaceMany => self.ask_place_many(),
            Command::FitLight => self.ask_fit_light(),
            Command::ThinOut => self.ask_thinning(),
            Command::AddBox => self.add_box(),
            Command::AddCamera => self.add_camera(),
            Command::NewGroup => self.new_group(),
            Command::Ungroup => self.ungroup(),
            Command::AutoGroup => self.auto_group(),
            Command::CopyLevels => self.copy_levels(),
            Command::PasteLevels => self.paste_levels(),
            Command::FrameSelection => {
                self.viewport.frame(&self.view.selection, &self.session, self.clock.time_s());
            }
            Command::FrameAll => {
                self.viewport.frame(&Selection::default(), &self.session, self.clock.time_s());
            }
            Command::TopView
            | Command::BottomView
            | Command::FrontView
            | Command::BackView
            | Command::RightView
            | Command::LeftView => {
                self.viewport.look_from(command, &self.view.selection, &self.session, self.clock.time_s());
            }
            Command::Orthographic => self.viewport.toggle_orthographic(),
            Command::LookThrough => self.look_through_next(),
            Command::AlignCamera => self.align_camera(),
            Command::Hide => self.toggle_hidden(),
            Command::Solo => self.toggle_solo(),
            Command::NewFolder => self.new_folder(),
            Command::MoveToFolder => self.ask_folder(),
            Command::LeaveFolder => self.put_into_folder(None),
            Command::SelectFolder => self.select_folder(),
            Command::Lock => self.toggle_locked(),
            Command::ShowAll => self.show_all(),
            Command::ShowBoxes => self.view.show_all_boxes ^= true,
            Command::SpriteMarks => self.view.sprite_marks = self.view.sprite_marks.next(),
            Command::GroupView => self.view.group_view ^= true,
            Command::QuadView => self.view.quad ^= true,
            Command::Haze => self.view.haze ^= true,
            Command::AllSprites => self.view.all_sprites ^= true,
            Command::CameraPicture => self.view.camera_picture ^= true,
            Command::SwitchTheme => self.switch_theme(context),
            Command::SwitchUnits => self.switch_units(context),
            Command::SwitchKeymap => self.switch_keymap(context),
            Command::Palette => self.palette = Some(Default::default()),
            Command::SelectTool => self.view.tool = Tool::Select,
            Command::MoveTool => self.view.tool = Tool::Move,
            Command::RotateTool => self.view.tool = Tool::Rotate,
            Command::ScaleTool => self.view.tool = Tool::Scale,
            Command::GrabPlace => self.grab(Grabbed::Place),
            Command::GrabTurn => self.grab(Grabbed::Turn),
            Command::GrabSize => self.grab(Grabbed::Size),
            Command::BoxTool => self.view.tool = Tool::Box,
            Command::Snap => self.view.snap.on ^= true,
            Command::KeepFill => self.view.keep_fill ^= true,
            Command::PlayTime => self.toggle_time(),
            Command::KeepHour => self.keep_hour(),
            Command::SceneHour => drop(self.time_play.leave()),
            Command::PlayFlight => self.toggle_flight(),
            Command::LoopFlight => self.clock.toggle_loop(),
            Command::BoardFlight => self.toggle_boarding(),
            Command::FlightStart => self.seek(0.0),
            Command::FlightEnd => self.seek(f64::INFINITY),
            Command::SecondBack => self.seek(self.clock.time_s() - 1.0),
            Command::SecondOn => self.seek(self.clock.time_s() + 1.0),
            Command::AddPath => self.add_path(),
            Command::AddAircraft => self.add_aircraft(),
            Command::KeyAfterLast => self.key_after_last(),
            Command::KeyAtClock => self.key_at_clock(),
            Command::RecordFlight => self.toggle_recording(),
            Command::WeatherReport => self.ask_weather_report(context),
            Command::RunAgain => self.run_again(context),
            Command::OpenPluginFolder => self.open_plugin_folder(),
            Command::OutlinePanel => self.layout.bring_up(Panel::Outline),
            Command::InspectorPanel => self.layout.bring_up(Panel::Inspector),
            Command::LevelsPanel => self.layout.bring_up(Panel::ColorLevels),
            Command::GroupsPanel => self.layout.bring_up(Panel::ShadingGroups),
            Command::FlightPanel => self.layout.bring_up(Panel::Flight),
            Command::KeyValue => self.key_value(context),
            Command::AutoKey => self.view.timeline.auto_key ^= true,
            Command::RippleKeys => self.view.timeline.ripple ^= true,
            Command::SnapKeys => self.view.timeline.snap = self.view.timeline.snap.next(),
            Command::EndsBefore | Command::EndsAfter => self.cycle_ends(command),
            Command::ClearKeys => self.clear_keys(),
            Command::PreviousKey => self.seek_key(false),
            Command::NextKey => self.seek_key(true),
            Command::AddKeys => self.add_keys(),
            Command::DeleteKeys
            | Command::DuplicateKeys
            | Command::MirrorKeys
            | Command::SlowKeys
            | Command::QuickenKeys
            | Command::KeysStep
            | Command::KeysLinear
            | Command::KeysSmooth
            | Command::KeysFlat
            | Command::KeysFree => self.work_on_keys(command),
            Command::CutKeys => self.cut_keys(context),
            Command::CopyKeys => self.copy_keys(context),
            Command::SelectAllKeys => self.select_keys(|_| true),
            Command::SelectNoKeys => self.view.timeline.choose_none(),
            Command::SelectKeysBefore => {
                let clock_s = self.clock.time_s();
                self.select_keys(|time_s| time_s <= clock_s);
            }
            Command::SelectKeysAfter => {
                let clock_s = self.clock.time_s();
                self.select_keys(|time_s| time_s >= clock_s);
            }
            Command::MarkIn => self.mark(false),
            Command::MarkOut => self.mark(true),
            Command::ClearMarks => self.clock.set_marks(None),
            Command::CurveView => self.view.timeline.curves ^= true,
            Command::FitTimeline => self.view.timeline.fit += 1,
            Command::TimelinePanel => self.layout.bring_up(Panel::Timeline),
            Command::ScriptPanel => self.layout.bring_up(Panel::Script),
            Command::ChartPanel => self.layout.bring_up(Panel::Chart),
            Command::SkyPanel => self.layout.bring_up(Panel::Sky),
            Command::HistoryPanel => self.layout.bring_up(Panel::History),
            Command::ProblemsPanel => self.layout.bring_up(Panel::Problems),
            Command::ResetLayout => self.layout.reset(),
            Command::SaveLayout => self.ask_layout_name(),
            Command::Layouts => self.list_layouts(),
            Command::Preferences => self.dialogs.open(Dialog::Preferences),
            Command::StartPage => self.show_start_page(),
            Command::Manual => self.manual = Some(Manual::at(manual::FIRST)),
            Command::WhatsNew => self.manual = Some(Manual::at(manual::NEWS)),
            Command::Tour => self.begin_tour(),
            Command::ReportProblem => self.ask_report(),
            Command::About => self.dialogs.open(Dialog::About),
        }
    }

    /// The selection follows the pointer over the picture, which must be there for that.
    fn grab(&mut self, grabbed: Grabbed) {
        if !self.layout.shows(Panel::Viewport) {
            self.layout.bring_up(Panel::Viewport);
        }
        self.viewport.grab(grabbed);
    }

    fn undo(&mut self) {
        self.session.undo();
        self.view.timeline.forget_changes();
        self.view.keep_what_is_in(self.session.scene());
    }

    fn redo(&mut self) {
        self.session.redo();
        self.view.timeline.forget_changes();
        self.view.keep_what_is_in(self.session.scene());
    }
}
