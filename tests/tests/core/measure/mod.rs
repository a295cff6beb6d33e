//! The figures that methods are judged by, against oracles, closed forms and a published tool.

mod counts;
mod coverage;
mod errors;
mod flip;
mod flip_plain;
mod order;
mod overdraw;
mod stability;
