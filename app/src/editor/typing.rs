//! What is typed across fields comes to each of them, however slow the frames are.
//!
//! egui moves the focus at the beginning of a frame, and gives all of the frame's letters to the field that has it then.
//! Where a frame takes long, `400⇥60⇥` may come in one: the figures of two fields would go into one of them, or into a third.
//! So a Tab has a frame of its own, and what comes after it waits for the next.

use egui::{Context, Event, Key, Plugin, RawInput};

/// Holds events back.
#[derive(Debug, Default)]
pub(super) struct Typing {
    held: Vec<Event>,
}

impl Plugin for Typing {
    fn debug_name(&self) -> &'static str {
        "typing"
    }

    fn input_hook(&mut self, context: &Context, input: &mut RawInput) {
        let mut events = std::mem::take(&mut self.held);
        events.append(&mut input.events);
        self.held = events.split_off(of_this_frame(&events));
        input.events = events;
        if !self.held.is_empty() {
            context.request_repaint();
        }
    }
}

/// How many of the events come now.
fn of_this_frame(events: &[Event]) -> usize {
    let is_tab = |event: &Event| matches!(event, Event::Key { key: Key::Tab, pressed: true, .. });
    match events.iter().position(is_tab) {
        Some(0) => 1,
        Some(at) => at,
        None => events.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::Modifiers;

    fn tab() -> Event {
        let (key, modifiers) = (Key::Tab, Modifiers::NONE);
        Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers }
    }

    #[test]
    fn a_tab_has_a_frame_of_its_own_and_nothing_is_lost_or_overtakes() {
        let text = |text: &str| Event::Text(text.into());
        let typed = [text("4"), text("0"), tab(), tab(), text("6"), tab(), text("3")];
        let (mut typing, context, mut frames) = (Typing::default(), Context::default(), Vec::new());
        let mut coming = vec![typed[..5].to_vec(), Vec::new(), typed[5..].to_vec()].into_iter();
        for _ in 0..8 {
            let mut input = RawInput { events: coming.next().unwrap_or_default(), ..RawInput::default() };
            typing.input_hook(&context, &mut input);
            frames.push(input.events);
        }
        assert_eq!(frames.concat(), typed);
        for frame in &frames {
            assert!(frame.len() == 1 || !frame.contains(&tab()), "{frame:?}");
        }
        assert!(frames[7].is_empty(), "as soon as can be");
    }
}
