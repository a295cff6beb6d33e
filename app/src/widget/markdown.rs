//! Text in Markdown as a page to read: headings, paragraphs, lists, tables, code, and strong, slanted and fixed-width words.
//! Pictures and comments are left out, and of a link its words stay.

use crate::theme;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, FontId, Frame, Label, Layout, RichText, Stroke, TextStyle, Ui, vec2};

/// Between the columns of a table, points.
const COLUMN_GAP: f32 = 12.0;

/// What stands beneath each other.
#[derive(Debug, PartialEq)]
enum Block {
    Heading(usize, String),
    Paragraph(String),
    /// With its mark.
    Item(String, String),
    Code(String),
    Table(Vec<Vec<String>>),
}

/// Shows it, as wide as there is room.
pub(crate) fn markdown(ui: &mut Ui, text: &str) {
    for block in blocks(text) {
        match block {
            Block::Heading(rank, words) => {
                ui.add_space(theme::GAP);
                let size = ui.text_style_height(&TextStyle::Body) + [6.0, 4.0, 2.0, 0.0][rank.clamp(1, 4) - 1];
                let words = with_known_glyphs(ui, &TextStyle::Body.resolve(ui.style()), &plain(&words));
                ui.label(RichText::new(words).strong().size(size));
            }
            Block::Paragraph(words) => drop(ui.add(Label::new(job(ui, &words)).wrap())),
            Block::Item(mark, words) => {
                ui.horizontal_top(|ui| {
                    ui.add_space(theme::GAP);
                    ui.label(mark);
                    ui.add(Label::new(job(ui, &words)).wrap());
                });
            }
            Block::Code(code) => {
                let code = with_known_glyphs(ui, &TextStyle::Monospace.resolve(ui.style()), &code);
                Frame::new().fill(ui.visuals().extreme_bg_color).corner_radius(4).inner_margin(8).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    ui.add(Label::new(RichText::new(code).monospace()).wrap());
                });
            }
            Block::Table(rows) => table(ui, &rows),
        }
        ui.add_space(theme::GAP * 0.5);
    }
}

/// Columns share the width by how much stands in them.
fn table(ui: &mut Ui, rows: &[Vec<String>]) {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let weight = |at: usize| {
        let longest = rows.iter().filter_map(|row| row.get(at)).map(|cell| cell.chars().count()).max();
        (longest.unwrap_or(0).clamp(4, 60) as f32).sqrt()
    };
    let weights: Vec<f32> = (0..columns).map(weight).collect();
    let room = ui.available_width() - COLUMN_GAP * columns.saturating_sub(1) as f32;
    let unit = room / weights.iter().sum::<f32>().max(1.0);
    for (at, row) in rows.iter().enumerate() {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = COLUMN_GAP;
            for (cell, weight) in row.iter().zip(&weights) {
                let width = (weight * unit).max(1.0);
                ui.allocate_ui_with_layout(vec2(width, 0.0), Layout::top_down(Align::Min), |ui| {
                    ui.set_width(width);
                    let words = if at == 0 { format!("**{cell}**") } else { cell.clone() };
                    ui.add(Label::new(job(ui, &words)).wrap());
                });
            }
        });
        if at == 0 {
            ui.separator();
        }
    }
}

fn blocks(text: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let begins = line.trim_start();
        if begins.is_empty() || begins.starts_with("<!--") || begins.starts_with("![") {
            continue;
        }
        if begins.starts_with("```") {
            let code: Vec<&str> = lines.by_ref().take_while(|line| !line.trim_start().starts_with("```")).collect();
            blocks.push(Block::Code(code.join("\n")));
        } else if let Some(row) = begins.strip_prefix('|') {
            let row = cells(row);
            let is_rule = row.iter().all(|cell| !cell.is_empty() && cell.chars().all(|letter| "-:".contains(letter)));
            match blocks.last_mut() {
                Some(Block::Table(_)) if is_rule => {}
                Some(Block::Table(rows)) => rows.push(row),
                _ => blocks.push(Block::Table(vec![row])),
            }
        } else if begins.starts_with('#') {
            let words = begins.trim_start_matches('#');
            blocks.push(Block::Heading(begins.len() - words.len(), words.trim().into()));
        } else {
            // A paragraph or an item goes on until something else begins.
            let (mark, first) = item(begins).map_or((None, begins), |(mark, rest)| (Some(mark), rest));
            let mut words = first.trim().to_owned();
            while let Some(more) = lines.next_if(|line| goes_on(line)) {
                words.push(' ');
                words.push_str(more.trim());
            }
            blocks.push(match mark {
                Some(mark) => Block::Item(mark, words),
                None => Block::Paragraph(words),
            });
        }
    }
    blocks
}

fn goes_on(line: &str) -> bool {
    let begins = line.trim_start();
    let other =
        begins.is_empty() || begins.starts_with(['#', '|']) || begins.starts_with("```") || begins.starts_with("![");
    !other && item(begins).is_none()
}

/// The mark of a list's item, and what follows.
fn item(line: &str) -> Option<(String, &str)> {
    if let Some(rest) = line.strip_prefix("- ") {
        return Some(("•".into(), rest));
    }
    let (number, rest) = line.split_once(". ")?;
    (!number.is_empty() && number.len() < 3 && number.bytes().all(|byte| byte.is_ascii_digit()))
        .then(|| (format!("{number}."), rest))
}

/// A row's cells; a bar behind a backslash is one of the text.
fn cells(row: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut letters = row.trim_end().trim_end_matches('|').chars().peekable();
    while let Some(letter) = letters.next() {
        match (letter, cells.last_mut()) {
            ('\\', Some(cell)) if letters.peek() == Some(&'|') => cell.extend(letters.next()),
            ('|', _) => cells.push(String::new()),
            (letter, Some(cell)) => cell.push(letter),
            _ => {}
        }
    }
    cells.into_iter().map(|cell| cell.trim().to_owned()).collect()
}

/// How a piece of a line stands out.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Manner {
    Plain,
    Strong,
    Slanted,
    Fixed,
}

/// The pieces of a line.
fn pieces(words: &str) -> Vec<(Manner, String)> {
    let mut pieces: Vec<(Manner, String)> = Vec::new();
    let mut rest = words;
    let marks = [("**", Manner::Strong), ("`", Manner::Fixed), ("*", Manner::Slanted)];
    while let Some(letter) = rest.chars().next() {
        let marked = marks.iter().find_map(|(mark, manner)| {
            let (inner, after) = rest.strip_prefix(mark)?.split_once(mark)?;
            // A star before a space is a star.
            let begins = inner.chars().next().is_some_and(|first| !first.is_whitespace());
            begins.then_some((*manner, inner, after))
        });
        let linked = || {
            let (inner, after) = rest.strip_prefix('[')?.split_once("](")?;
            Some((Manner::Plain, inner, after.split_once(')')?.1))
        };
        if let Some((manner, inner, after)) = marked.or_else(linked) {
            pieces.push((manner, inner.into()));
            rest = after;
            continue;
        }
        match pieces.last_mut() {
            Some((Manner::Plain, piece)) => piece.push(letter),
            _ => pieces.push((Manner::Plain, letter.into())),
        }
        rest = &rest[letter.len_utf8()..];
    }
    pieces
}

fn plain(words: &str) -> String {
    pieces(words).into_iter().map(|(_, piece)| piece).collect()
}

/// What the fonts can't show has something like it, or a dot.
pub(crate) fn with_known_glyphs(ui: &Ui, font: &FontId, piece: &str) -> String {
    if piece.is_ascii() {
        return piece.into();
    }
    ui.ctx().fonts_mut(|fonts| {
        let mut known = |letter: char| match letter {
            letter if fonts.has_glyph(font, letter) => letter,
            '▸' => '›',
            'ꟻ' => 'F',
            _ => '·',
        };
        piece.chars().map(&mut known).collect()
    })
}

fn job(ui: &Ui, words: &str) -> LayoutJob {
    let (text, strong) = (ui.visuals().text_color(), ui.visuals().strong_text_color());
    let body = TextStyle::Body.resolve(ui.style());
    let fixed = FontId::monospace(body.size - 1.0);
    let mut job = LayoutJob::default();
    for (manner, piece) in pieces(words) {
        let piece = with_known_glyphs(ui, &body, &piece);
        let format = match manner {
            Manner::Plain => TextFormat::simple(body.clone(), text),
            Manner::Strong => TextFormat::simple(body.clone(), strong),
            Manner::Slanted => TextFormat { italics: true, ..TextFormat::simple(body.clone(), text) },
            Manner::Fixed => TextFormat {
                background: ui.visuals().extreme_bg_color,
                underline: Stroke::NONE,
                ..TextFormat::simple(fixed.clone(), strong)
            },
        };
        job.append(&piece, 0.0, format);
    }
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_falls_into_blocks() {
        let text = "# Title\n\n<!-- not this -->\nOne\ntwo.\n- a **b**\n  c\n- d\n2. e\n\n| x | y |\n|---|---|\n| 1 \\| 2 | `3` |\n\n```\nlet a = 1;\n\nb\n```\n![no](picture.png)\nEnd";
        let want = vec![
            Block::Heading(1, "Title".into()),
            Block::Paragraph("One two.".into()),
            Block::Item("•".into(), "a **b** c".into()),
            Block::Item("•".into(), "d".into()),
            Block::Item("2.".into(), "e".into()),
            Block::Table(vec![vec!["x".into(), "y".into()], vec!["1 | 2".into(), "`3`".into()]]),
            Block::Code("let a = 1;\n\nb".into()),
            Block::Paragraph("End".into()),
        ];
        assert_eq!(blocks(text), want);
    }

    #[test]
    fn words_stand_out_as_they_are_marked() {
        let want = [
            (Manner::Plain, "a "),
            (Manner::Strong, "b"),
            (Manner::Plain, " "),
            (Manner::Fixed, "c*d*"),
            (Manner::Plain, ", "),
            (Manner::Slanted, "e"),
            (Manner::Plain, " "),
            (Manner::Plain, "f 2 * 3 ** "),
        ];
        let got = pieces("a **b** `c*d*`, *e* [f](g) 2 * 3 ** ");
        let got: Vec<(Manner, &str)> = got.iter().map(|(manner, piece)| (*manner, piece.as_str())).collect();
        assert_eq!(got, want);
    }
}
