//! The chart's files: figures and pictures in, JSON, drawings and a page out. Needs no GPU and no display.

mod example;
mod front;
mod heat;
mod markup;
mod page;
mod plot;
mod report;
