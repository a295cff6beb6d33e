//! Menus by keyboard: Alt and the underlined letter opens one, F10 the first, left and right go to the neighbours. Within a
//! menu, egui itself goes up and down.

use crate::command::Menu;
use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, Context, FocusDirection, Id, Key, Modifiers, Popup, Response, Stroke, TextStyle, Ui};

/// A menu is measured before it is shown, and only then has entries that may get the focus.
const FRAMES: u8 = 3;

/// What was open in the last frame, and how soon its first entry gets the focus.
#[derive(Debug, Clone, Copy, Default)]
struct Open {
    menu: Option<Menu>,
    enter_in: u8,
}

/// Its name, with the letter that opens it underlined.
pub(super) fn name(ui: &Ui, menu: Menu) -> LayoutJob {
    let plain = TextFormat::simple(TextStyle::Button.resolve(ui.style()), Color32::PLACEHOLDER);
    let marked = TextFormat { underline: Stroke::new(1.0, ui.visuals().text_color()), ..plain.clone() };
    let letter = menu.shortcut(ui.ctx()).map(|keys| keys.logical_key.name().to_lowercase());
    let at = letter.and_then(|letter| menu.name().to_lowercase().find(&letter));
    let mut job = LayoutJob::default();
    for (here, letter) in menu.name().char_indices() {
        job.append(letter.encode_utf8(&mut [0; 4]), 0.0, if Some(here) == at { marked.clone() } else { plain.clone() });
    }
    job
}

/// The menu that keys ask for. Asked before the commands' keys, of which F would take Alt+F.
pub(crate) fn wanted_menu(context: &Context) -> Option<Menu> {
    let mut state: Open = context.data(|data| data.get_temp(id())).unwrap_or_default();
    if state.enter_in > 0 {
        state.enter_in -= 1;
        context.data_mut(|data| data.insert_temp(id(), state));
        if state.enter_in == 0 {
            context.memory_mut(|memory| memory.move_focus(FocusDirection::Down));
        }
        context.request_repaint();
    }
    let shortcuts: Vec<_> = Menu::ALL.iter().map(|menu| (*menu, menu.shortcut(context))).collect();
    context.input_mut(|input| {
        let by_letter = shortcuts.iter().find(|(_, keys)| keys.is_some_and(|keys| input.consume_shortcut(&keys)));
        if let Some((menu, _)) = by_letter {
            return Some(*menu);
        }
        if input.consume_key(Modifiers::NONE, Key::F10) {
            return Menu::ALL.first().copied();
        }
        let at = Menu::ALL.iter().position(|menu| Some(*menu) == state.menu)?;
        // There, right and left go into submenus and out of them.
        let has_submenus = state.menu == Some(Menu::Plugins);
        let right = !has_submenus && input.consume_key(Modifiers::NONE, Key::ArrowRight);
        let left = !has_submenus && input.consume_key(Modifiers::NONE, Key::ArrowLeft);
        let count = Menu::ALL.len();
        let to = (at + usize::from(right) + count - usize::from(left)) % count;
        (to != at).then(|| Menu::ALL[to])
    })
}

/// Opens the menu of that button, and goes to its first entry.
pub(super) fn open(ui: &Ui, button: &Response) {
    Popup::open_id(ui.ctx(), Popup::default_response_id(button));
    button.request_focus();
    ui.data_mut(|data| data.get_temp_mut_or_default::<Open>(id()).enter_in = FRAMES);
    ui.ctx().request_repaint();
}

/// Remembers which one is open.
pub(super) fn keep(ui: &Ui, menu: Option<Menu>) {
    ui.data_mut(|data| data.get_temp_mut_or_default::<Open>(id()).menu = menu);
}

fn id() -> Id {
    Id::unique("menus by keyboard")
}
