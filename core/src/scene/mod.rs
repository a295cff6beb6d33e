//! What is saved: a scene of cloud models, their placements, light, ground, cameras and flights.
//!
//! Plain values without behaviour; only [`crate::document`] changes a scene that is open. Positions are f64 metres,
//! right-handed, +y up, x east, −z north. Names of fields are the file's, see [`crate::formats::scene_file`].

mod aircraft;
mod camera;
mod camera_path;
mod category;
mod cloud;
mod cloud_box;
mod color_levels;
mod daily_table;
mod folder;
mod formation;
mod ids;
mod kinds;
mod list;
mod listed;
mod look;
mod model;
mod prop;
mod shading_group;
mod sun;
mod thing;
mod track;
mod weather;

pub use aircraft::Aircraft;
pub use camera::Camera;
pub use camera_path::{CameraPath, PathKey};
pub use category::Category;
pub use cloud::Cloud;
pub use cloud_box::{CloudBox, SpriteEdit};
pub use color_levels::{ColorLevel, ColorLevels, level_color};
pub use daily_table::{DailyKey, DailyTable};
pub use folder::Folder;
pub use formation::{Formation, FormationChange, HowFarFormed};
pub use ids::*;
pub(crate) use kinds::kinds;
pub use list::List;
pub use listed::{ForKind, Listed, for_each_kind};
pub use look::{Ground, Sky, Tuning};
pub use model::{CloudModel, CullRadius};
pub use prop::Prop;
pub use shading_group::{GroupCenter, GroupLight, ShadingGroup};
pub use sun::{Date, Site, Sun};
pub use thing::{InScene, PoseMut, Thing};
pub use track::{Beyond, Handles, KeyValue, Leaves, Track, TrackKey};
pub use weather::{Region, Weather};

use rustc_hash::FxHashMap;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A whole scene, as in one `.cloudscene` file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// For people.
    pub name: String,
    /// The id that the next new thing gets. Ids are not given twice, but for those that undo took back.
    pub next_id: IdCounter,
    /// Local civil hours in [0, 24).
    pub time_of_day_h: f64,
    /// Where on Earth, and on which day.
    #[serde(rename = "place")]
    pub site: Site,
    /// Where the sun comes from.
    #[serde(default)]
    pub sun: Sun,
    /// Light, air and exposure.
    pub sky: Sky,
    /// The air that clouds move in.
    #[serde(default, skip_serializing_if = "Weather::is_default")]
    pub weather: Weather,
    /// What lies below; none for a scene in empty air.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<Ground>,
    /// A sheet of 4 × 4 sprite tiles of the scene's own: a PNG beside the scene file. None for the built-in one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub atlas: Option<String>,
    /// Named views. The first is the one a picture is drawn from unless told otherwise.
    #[serde(default)]
    pub cameras: List<Camera>,
    /// Kinds of cloud: defined once, placed often.
    #[serde(default)]
    pub models: List<CloudModel>,
    /// What clouds are kept together in.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub folders: List<Folder>,
    /// The models' placements.
    #[serde(default)]
    pub clouds: List<Cloud>,
    /// Flights for a camera.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub paths: List<CameraPath>,
    /// Aircraft that fly along the paths.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub aircraft: List<Aircraft>,
    /// Models that stand: terrain, towers.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub props: List<Prop>,
    /// What the scene's clock moves.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub tracks: List<Track>,
}

impl Scene {
    /// The model of that id.
    pub fn model(&self, id: ModelId) -> Option<&CloudModel> {
        self.models.with_id(id)
    }

    /// All models by their ids, for whoever looks up many.
    pub fn models_by_id(&self) -> FxHashMap<ModelId, &CloudModel> {
        self.models.iter().map(|model| (model.id, model)).collect()
    }

    /// The cloud of that id.
    pub fn cloud(&self, id: CloudId) -> Option<&Cloud> {
        self.clouds.with_id(id)
    }

    /// The camera of that name.
    pub fn camera_named(&self, name: &str) -> Option<&Camera> {
        self.cameras.iter().find(|camera| camera.name == name)
    }

    /// The path of that id.
    pub fn path(&self, id: PathId) -> Option<&CameraPath> {
        self.paths.with_id(id)
    }

    /// The path of that name.
    pub fn path_named(&self, name: &str) -> Option<&CameraPath> {
        self.paths.iter().find(|path| path.name == name)
    }
}

impl Default for Scene {
    /// An empty summer's day over Puget Sound, with one camera that looks north from a light aircraft's height.
    fn default() -> Self {
        let mut next_id = IdCounter::default();
        let camera = Camera::new(CameraId::new(&mut next_id), "main", glam::DVec3::new(0.0, 600.0, 4000.0));
        Self {
            name: "Untitled".into(),
            next_id,
            time_of_day_h: 12.0,
            site: Site::default(),
            sun: Sun::default(),
            sky: Sky::default(),
            weather: Weather::default(),
            ground: Some(Ground::default()),
            atlas: None,
            cameras: vec![camera].into(),
            models: List::new(),
            folders: List::new(),
            clouds: List::new(),
            paths: List::new(),
            aircraft: List::new(),
            props: List::new(),
            tracks: List::new(),
        }
    }
}
