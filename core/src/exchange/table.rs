//! The table of formats.

use super::format::Corners;
use super::format::{Reader, to_read, to_write};
use super::{
    ChoiceError, Format, Part, cld, cry_cloud, flightgear, flightgear_voxels, glb, sprites, usd, volume, web, wpr,
};
use crate::formats;

/// All of them, in the order in which they are listed.
pub static FORMATS: &[Format] = &[
    Format {
        name: "json",
        title: "Sprites as JSON",
        endings: &["json"],
        about: "each sprite with its cloud, for tools and scripts; --shaded adds corners with their light",
        carries: &[Part::Sprites, Part::Groups, Part::ColorLevels],
        corners: Corners::Asked,
        write_options: &[],
        read_options: &[],
        write: Some(sprites::write_json),
        read: None,
    },
    Format {
        name: "csv",
        title: "Sprites as a table",
        endings: &["csv"],
        about: "a line a sprite, for spreadsheets; --shaded adds corners with their light",
        carries: &[Part::Sprites, Part::Groups],
        corners: Corners::Asked,
        write_options: &[],
        read_options: &[],
        write: Some(sprites::write_csv),
        read: None,
    },
    Format {
        name: "glb",
        title: "glTF 2.0, binary",
        endings: &["glb"],
        about: "clouds, cameras and flights for Blender, engines and web pages; files from here give their scene back",
        carries: &[
            Part::Sprites,
            Part::Groups,
            Part::ColorLevels,
            Part::Formation,
            Part::Motion,
            Part::Atlas,
            Part::Light,
            Part::Cameras,
            Part::Paths,
        ],
        corners: Corners::Always,
        write_options: glb::WRITE_OPTIONS,
        read_options: glb::READ_OPTIONS,
        write: Some(glb::write),
        read: Some(Reader { read: glb::read, knows: glb::looks_like, max_bytes: glb::MAX_BYTES }),
    },
    Format {
        name: "usd",
        title: "OpenUSD",
        endings: &["usda", "usdz"],
        about: "clouds, cameras and flights for Blender, Houdini and renderers; as text with the sheet beside it, or in one file",
        carries: &[Part::Sprites, Part::Formation, Part::Motion, Part::Atlas, Part::Light, Part::Cameras, Part::Paths],
        corners: Corners::Always,
        write_options: usd::WRITE_OPTIONS,
        read_options: &[],
        write: Some(usd::write),
        read: None,
    },
    Format {
        name: "web",
        title: "Web page",
        endings: &["html"],
        about: "one file to fly through in any browser with WebGL 2, at any time of day, with the scene's clock",
        carries: &[
            Part::Sprites,
            Part::Groups,
            Part::ColorLevels,
            Part::Formation,
            Part::Weather,
            Part::Motion,
            Part::Atlas,
            Part::Light,
            Part::Ground,
            Part::Cameras,
        ],
        corners: Corners::Always,
        write_options: &[],
        read_options: &[],
        write: Some(web::write),
        read: None,
    },
    Format {
        name: "cld",
        title: "Flight Simulator 2004 cloud",
        endings: &["cld"],
        about: "a file for each cloud, of sprites one by one; comes in as sprites placed by hand",
        carries: &[Part::Sprites, Part::Groups, Part::ColorLevels],
        corners: Corners::None,
        write_options: cld::WRITE_OPTIONS,
        read_options: cld::READ_OPTIONS,
        write: Some(cld::write),
        read: Some(Reader { read: cld::read, knows: formats::cld::looks_like, max_bytes: formats::cld::MAX_BYTES }),
    },
    Format {
        name: "cryengine",
        title: "CryEngine or Lumberyard cloud",
        endings: &["xml"],
        about: "a file for each cloud, of square sprites one by one; comes in as sprites placed by hand",
        carries: &[Part::Sprites],
        corners: Corners::None,
        write_options: &[],
        read_options: &[],
        write: Some(cry_cloud::write),
        read: Some(Reader {
            read: cry_cloud::read,
            knows: formats::cry_cloud::looks_like,
            max_bytes: formats::cry_cloud::MAX_BYTES,
        }),
    },
    Format {
        name: "flightgear",
        title: "FlightGear clouds and layers",
        endings: &["cloudlayers.xml", "xml"],
        about: "kinds of cloud, how large and of how many sprites; its layers come in as clouds side by side",
        carries: &[Part::ColorLevels, Part::Layers],
        corners: Corners::None,
        write_options: &[],
        read_options: &[],
        write: Some(flightgear::write),
        read: Some(Reader {
            read: flightgear::read,
            knows: formats::flightgear::looks_like,
            max_bytes: formats::flightgear::MAX_BYTES,
        }),
    },
    Format {
        name: "wpr",
        title: "Microsoft Flight Simulator weather preset",
        endings: &["wpr"],
        about: "measured layers with wind and air, for the weather of 2020 and 2024; comes in as a sky made by plugins",
        carries: &[Part::Layers, Part::Weather],
        corners: Corners::None,
        write_options: wpr::WRITE_OPTIONS,
        read_options: &[],
        write: Some(wpr::write),
        read: Some(Reader { read: wpr::read, knows: formats::wpr::looks_like, max_bytes: formats::wpr::MAX_BYTES }),
    },
    Format {
        name: "vol",
        title: "Mitsuba 3 volumes",
        endings: &["vol"],
        about: "a grid of extinction for each cloud, and a scene of them that the path tracer renders as it is",
        carries: &[Part::Formation, Part::Motion, Part::Atlas, Part::Light],
        corners: Corners::Always,
        write_options: volume::VOL_OPTIONS,
        read_options: &[],
        write: Some(volume::write_vol),
        read: None,
    },
    Format {
        name: "vdb",
        title: "OpenVDB volumes",
        endings: &["vdb"],
        about: "a sparse grid of extinction for each cloud, for Blender, Houdini and others",
        carries: &[Part::Formation, Part::Motion, Part::Atlas],
        corners: Corners::None,
        write_options: volume::VDB_OPTIONS,
        read_options: &[],
        write: Some(volume::write_vdb),
        read: None,
    },
    Format {
        name: "flightgear-voxels",
        title: "FlightGear cloud voxels",
        endings: &["voxels.png"],
        about: "a picture of slices for each cloud, as FlightGear shows clouds after 2024",
        carries: &[Part::Formation, Part::Atlas],
        corners: Corners::None,
        write_options: flightgear_voxels::WRITE_OPTIONS,
        read_options: &[],
        write: Some(flightgear_voxels::write),
        read: None,
    },
];

impl Format {
    /// The format that `named` says, or else the one that a file of that name is written as.
    ///
    /// # Errors
    /// If there is none, or it is only read.
    pub fn to_write(named: Option<&str>, file_name: &str) -> Result<&'static Self, ChoiceError> {
        to_write(FORMATS, named, file_name)
    }

    /// The format that `named` says, or else the one that a file of that name is that begins with those `bytes`, up to
    /// [`super::HEAD_BYTES`] of them.
    ///
    /// # Errors
    /// If there is none, or it is only written.
    pub fn to_read(named: Option<&str>, file_name: &str, bytes: &[u8]) -> Result<&'static Self, ChoiceError> {
        to_read(FORMATS, named, file_name, bytes)
    }
}
