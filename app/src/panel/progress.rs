//! How far work off the frame has come, with a way to stop it: seen only when it takes a while.

use crate::state::{Action, Session};
use crate::widget::work_bar;
use egui::{Button, Ui};
use std::time::Duration;

/// What is done sooner needs no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// Button, bar and words, laid out from the right.
pub(crate) fn progress(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    let Some(pending) = session.pending().filter(|pending| pending.since.elapsed() >= PATIENCE) else { return };
    let cancel = ui.add_enabled(pending.can_cancel, Button::new("Cancel").small());
    if cancel.on_hover_text("Stops, and takes back the change that asked for it.").clicked() {
        actions.push(Action::CancelPending);
    }
    let bar = work_bar(ui, "Progress", pending.done);
    ui.ctx().accesskit_node_builder(bar.id, |node| node.set_description(pending.what.clone()));
    ui.label(pending.what);
}
