//! Rhai scripts: plugins that make clouds, looks and weather.
//!
//! A script says what it is by a literal ([`description`]) that is read before a line of it runs. It runs once
//! ([`host`]) and records edits (`recorder`); the host hands them on as one transaction, or nothing at all. The program
//! has it run in a process of its own ([`caged`]), whose memory is bounded and which may die. Sprites and pixels are never
//! computed in a script. It knows the core and nothing of the renderers, files or windows.

pub mod bindings;
pub mod caged;
pub mod description;
pub mod error;
pub mod host;
pub mod limits;
mod literal;
pub mod manual;
pub mod parameter;
mod recorder;
pub mod shipped;

pub use description::{Description, PluginKind};
pub use error::{Fault, Place, ScriptError};
pub use host::{Outcome, Plugin};
pub use limits::{Patience, TimeOf};
pub use parameter::{Parameter, ParameterKind, ParameterValue, Values};
