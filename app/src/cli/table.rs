//! The subcommands, and what stands before them.

use super::{chart, check, export, fit_light, fly, formats, import, info, new, plugins, render, run, thin, weather};
use crate::renderer::RendererChoice;
use clap::Parser;
use std::path::PathBuf;

#[derive(Debug, Parser)]
#[command(
    name = "cloudwright",
    version,
    about = "An editor for clouds made of sprites, and its command line",
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    after_help = "Examples:
  cloudwright                                   open the editor on a new scene
  cloudwright fair_weather.cloudscene           open the editor on that scene
  cloudwright new sky.cloudscene
  cloudwright render fair_weather.cloudscene -o sky.png
  cloudwright fly fair_weather.cloudscene --path through -o through.mp4
  cloudwright chart fair_weather.cloudscene -o chart
  cloudwright check *.cloudscene
  cloudwright run scatter_clouds -o sky.cloudscene

Exit codes: 0 done, 1 problems found, 2 unusable input, 3 could not do it."
)]
pub(super) struct Arguments {
    /// Scene to open in the editor; a new one if there is none
    #[arg(value_name = "SCENE")]
    pub(super) scene: Option<PathBuf>,
    /// What draws the editor's viewport [default: as in its preferences, which are auto at first]
    #[arg(long, value_enum)]
    pub(super) renderer: Option<RendererChoice>,
    #[command(subcommand)]
    pub(super) command: Option<Subcommand>,
}

#[derive(Debug, clap::Subcommand)]
pub(super) enum Subcommand {
    /// Write a new scene
    New(new::Arguments),
    /// Draw a scene as a PNG
    Render(render::Arguments),
    /// Draw a flight along a camera path, or weather from one camera, as PNG files or a video
    Fly(fly::Arguments),
    /// Chart what methods of drawing cost against what they get wrong
    Chart(chart::Arguments),
    /// List the problems of scenes
    Check(check::Arguments),
    /// Count a scene's models, boxes and sprites, and list its tracks
    Info(info::Arguments),
    /// Write a scene for other tools
    Export(export::Arguments),
    /// Take what another tool made into a scene
    Import(import::Arguments),
    /// List the formats that scenes leave as and come from
    Formats(formats::Arguments),
    /// Drop the sprites that a scene can do without
    Thin(thin::Arguments),
    /// Light clouds as nearly as they can be as a path tracer does
    FitLight(fit_light::Arguments),
    /// Have a plugin make clouds, a look or weather
    Run(run::Arguments),
    /// List the plugins, or tell what can be set of one
    Plugins(plugins::Arguments),
    /// Give a scene the wind, air and hour of weather reports
    Weather(weather::Arguments),
    /// Run one plugin, as asked on stdin; the program starts this itself
    #[command(hide = true)]
    ScriptHost,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_table_is_sound() {
        Arguments::command().debug_assert();
    }
}
